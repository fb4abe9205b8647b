#include "chapters/solvers/chapter_solver.hpp"

#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/04_friction/solver.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/input/input_error.hpp"

#include <memory>

namespace enduring::solvers {
namespace {

//! [chapter_2]
/// Chapter 1 for planes; crossings of features are found and listed. Held, as no layer answers them yet.
Solver detection_without_response(const ContactParameters& parameters)
{
    const auto detection = std::make_shared<CrossingDetection>();
    Solver solver = chapter01_solver(parameters);
    solver.name = "chapter 2";
    solver.append(StepStage::detect, {"crossings", [detection](World& world, Contacts& contacts, double) {
        const std::size_t first_new = contacts.size();
        detection->find_candidates(world);
        detection->append_entries(world, contacts);
        for (std::size_t i = first_new; i < contacts.size(); ++i)
            contacts[i].hold(true);
    }});
    return solver;
}
//! [chapter_2]

}  // namespace

Solver chapter_solver(int chapter, const ContactParameters& parameters)
{
    switch (chapter) {
    case 1: return chapter01_solver(parameters);
    case 2: return detection_without_response(parameters);
    case 3: return chapter03_solver(parameters);
    case 4: return chapter04_solver(parameters);
    case 5: return chapter05_solver(parameters);
    case 6: return chapter06_solver(parameters);
    default: throw InputError("chapter " + std::to_string(chapter) + " has no solver; 1 to 6 have");
    }
}

}  // namespace enduring::solvers
