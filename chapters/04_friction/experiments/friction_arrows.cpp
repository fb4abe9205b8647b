#include "chapters/04_friction/experiments/friction_arrows.hpp"

#include "common/simulation/contact_geometry.hpp"

namespace enduring::chapter04 {

MarkContacts friction_arrows(double metres_per_newton, double dt)
{
    return [=](Stage& stage, const World& world, const Contacts& contacts) {
        for (const Contact& contact : contacts) {
            const Vec3 p = contact_geometry(world, contact, 0).p;
            if (contact.friction.norm() > 0)
                stage.segments.push_back({p, p + metres_per_newton / dt * contact.friction,
                                          palette::colliding_vertex, 5, true, false});
        }
    };
}

}  // namespace enduring::chapter04
