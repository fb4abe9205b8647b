#include "chapters/03_penalty_impulses/solver.hpp"

#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/penalty_contact.hpp"

#include <memory>

namespace enduring {

//! [solver]
Solver chapter03_solver(const ContactParameters& parameters)
{
    const auto detection = std::make_shared<CrossingDetection>();
    Solver solver = chapter01_solver(parameters);
    solver.name = "chapter 3";
    solver.refresh.push_back({"resolve pairs", [](World& world, Contacts& contacts, double) {
        resolve_separated_pairs(world, contacts);
    }});
    solver.detect.push_back({"broad phase", [detection](World& world, Contacts&, double) {
        detection->find_candidates(world);
    }});
    solver.detect.push_back({"queries", [detection](World& world, Contacts& contacts, double) {
        detection->append_entries(world, contacts);
    }});
    solver.respond.push_back({"impulses", [parameters](World& world, Contacts& contacts, double dt) {
        push_pairs_apart(world, contacts, parameters.method, parameters.stiffness, dt);
    }});
    return solver;
}
//! [solver]

}  // namespace enduring
