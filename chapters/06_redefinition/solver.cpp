#include "chapters/06_redefinition/solver.hpp"

#include "chapters/01_particle_plane/normal_response.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/penalty_law.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/06_redefinition/redefinition_passes.hpp"

#include <memory>

namespace enduring {

//! [solver]
Solver chapter06_solver(const ContactParameters& parameters)
{
    const auto detection = std::make_shared<CrossingDetection>();
    Solver solver = chapter01_solver(parameters);
    solver.name = "chapter 6";
    solver.refresh.push_back({"follow pairs", [](World& world, Contacts& contacts, double) {
        follow_enduring_pairs(world, contacts);
    }});
    solver.detect.push_back({"broad phase", [detection](World& world, Contacts&, double) {
        detection->find_candidates(world);
    }});
    solver.detect.push_back({"new pairs", [detection](World& world, Contacts& contacts, double) {
        detect_new_pairs(world, *detection, contacts);
    }});
    solver.respond = {{"impulses", [law = normal_law(parameters), k = parameters.stiffness](World& world, Contacts& contacts, double dt) {
        push_apart(world, contacts, law, k, dt);
    }}};
    add_friction(solver, parameters.friction);
    solver.finish.push_back({"resolve pairs", [detection](World& world, Contacts& contacts, double) {
        resolve_pairs_that_left(world, *detection, contacts);
    }});
    return solver;
}
//! [solver]

}  // namespace enduring
