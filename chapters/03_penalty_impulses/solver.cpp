#include "chapters/03_penalty_impulses/solver.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/02_collision_detection/solver.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/penalty_law.hpp"

#include <memory>

namespace enduring {

//! [solver]
Solver chapter03_solver(const ContactParameters& parameters)
{
    const auto detection = std::make_shared<CrossingDetection>();
    Solver solver = chapter02_solver(parameters);
    solver.name = "chapter 3";
    solver.append(StepStage::refresh, "resolve pairs",
                  [](World& world, Contacts& contacts, double) { resolve_separated_pairs(world, contacts); });
    solver.replace("broad phase", "broad phase",
                   [detection](World& world, Contacts&, double) { detection->find_candidates(world); });
    solver.replace("queries", "queries", [detection](World& world, Contacts& contacts, double) {
        detection->append_entries(world, contacts);
    });
    solver.replace(
        "push out of planes", "impulses",
        [law = normal_law(parameters), k = parameters.stiffness](
            World& world, Contacts& contacts, double dt) { push_apart(world, contacts, law, k, dt); });
    return solver;
}
//! [solver]

}  // namespace enduring
