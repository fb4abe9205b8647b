#include "chapters/06_redefinition/baseline/discrete_solver.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/06_redefinition/baseline/discrete_detection.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <memory>

namespace enduring {

//! [push_to_closest_points]
void push_to_closest_points(const World& world, Contacts& contacts, double stiffness, double dt)
{
    for (Contact& contact : contacts) {
        if (!contact.waiting())
            continue;
        if (contact.on_plane()) {
            contact.impulse = discrete_on_plane(pair_step(world, contact), 0,
                                                pair_stiffness(world, contact, stiffness), dt);
            continue;
        }
        Vec3 out = Vec3::Zero();  // q - p
        for (int i = 0; i < 4; ++i)
            out -= contact.weights[i] * contact_vertex(world, contact, i, 1);
        contact.impulse = stiffness * dt * out;
    }
}
//! [push_to_closest_points]

Solver discrete_solver(const ContactParameters& parameters)
{
    const auto detection = std::make_shared<DiscreteDetection>();
    Solver solver = chapter01_solver(parameters);
    solver.name = "discrete";
    solver.append(StepStage::detect, "closest points", [detection](World& world, Contacts& contacts, double) {
        detection->update_inside_vertices(world, contacts);
    });
    solver.replace("push out of planes", "impulses",
                   [stiffness = parameters.stiffness](World& world, Contacts& contacts, double dt) {
                       push_to_closest_points(world, contacts, stiffness, dt);
                   });
    return solver;
}

}  // namespace enduring
