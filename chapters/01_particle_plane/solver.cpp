#include "chapters/01_particle_plane/solver.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"

namespace enduring {

//! [solver]
Solver chapter01_solver(const ContactParameters& parameters)
{
    const auto detect_planes = [](World& world, Contacts& contacts, double) {
        detect_plane_contacts(world, contacts);
    };
    const auto resolve_planes = [](World& world, Contacts& contacts, double) {
        resolve_plane_contacts(world, contacts);
    };
    const auto push_out = [law = plane_law(parameters), k = parameters.stiffness](
                              World& world, Contacts& contacts, double dt) {
        push_apart(world, contacts, law, k, dt);
    };
    return {"chapter 1",
            {{"resolve planes", resolve_planes}},
            {{"detect planes", detect_planes}},
            {{"push out of planes", push_out}}};
}
//! [solver]

}  // namespace enduring
