#include "chapters/04_friction/friction_contact.hpp"

#include "chapters/04_friction/mass_splitting_friction.hpp"
#include "chapters/04_friction/surface_turn.hpp"
#include "common/simulation/contact_geometry.hpp"

namespace enduring {
namespace {

/// Velocity of p against q as the bodies predict it, each at its fixed place on its feature.
Vec3 relative_velocity(const World& world, const Contact& contact)
{
    Vec3 velocity = Vec3::Zero();
    for (int i = 0; i < contact.vertex_count(); ++i)
        velocity += contact.weights[i] * body_of_vertex(world, contact, i).velocity(contact.vertices[i]);
    return velocity;
}

void friction_impulses(const World&, Contacts&, const NoFriction&, double) {}

void friction_impulses(const World& world, Contacts& contacts, const MassSplitting& friction, double dt)
{
    mass_splitting_friction(world, contacts, friction, dt);
}

void friction_impulses(const World& world, Contacts& contacts, const YamaneNakamura& friction, double dt)
{
    for (Contact& contact : contacts) {
        if (!pushes_now(contact))
            continue;
        const double normal_impulse = contact.impulse.norm();
        const TangentPlane plane(contact.impulse / normal_impulse);
        const FrictionImpulse answer = yamane_nakamura(
            {plane.of(contact.spring.stretch), plane.of(relative_velocity(world, contact)), normal_impulse},
            friction, dt);
        contact.friction = plane.in_space(answer.impulse);
        contact.spring.slip = answer.slip;
    }
}

/// Where p lies against its anchor when the pair has let go: on it (p_ref := p, below 5.22), or near it.
Vec3 after_slip(const Contact& contact, const Vec3& stretch, const FrictionParameters& friction, double dt)
{
    const auto* lagging = std::get_if<MassSplitting>(&friction);
    if (!lagging)
        return Vec3::Zero();
    const double longest = stretch_after_slip(contact.spring.slip, contact.friction.norm(), *lagging, dt),
                 length = stretch.norm();
    return length > longest ? Vec3(stretch * (longest / length)) : stretch;
}

}  // namespace

//! [compute_friction_impulses]
void compute_friction_impulses(const World& world, Contacts& contacts, const FrictionParameters& friction,
                               double dt)
{
    for (Contact& contact : contacts)
        if (contact.waiting())
            contact.spring.slip = 0;
    std::visit([&](const auto& model) { friction_impulses(world, contacts, model, dt); }, friction);
}
//! [compute_friction_impulses]

//! [move_anchors]
void move_friction_anchors(const World& world, Contacts& contacts, const FrictionParameters& friction,
                           double dt)
{
    for (Contact& contact : contacts) {
        const Mat3 turn = surface_turn(world, contact);
        contact.spring.stretch = turn * contact.spring.stretch;
        if (contact.held())
            continue;
        const double normal_impulse = contact.impulse.norm();
        if (normal_impulse <= least_impulse) {
            contact.spring.stretch.setZero();
            continue;
        }
        const TangentPlane plane(contact.impulse / normal_impulse);
        const Vec3 stretch =
            plane.projected(contact.spring.stretch + motion_on_surface(world, contact, turn));
        contact.spring.stretch = contact.spring.slip > 0 ? after_slip(contact, stretch, friction, dt)
                                                         : stretch;
    }
}
//! [move_anchors]

//! [add_friction]
void add_friction(Solver& solver, const FrictionParameters& friction)
{
    if (std::holds_alternative<NoFriction>(friction))
        return;
    solver.append(StepStage::respond, "friction", [friction](World& world, Contacts& contacts, double dt) {
        compute_friction_impulses(world, contacts, friction, dt);
    });
    solver.append(StepStage::finish, "move friction anchors",
                  [friction](World& world, Contacts& contacts, double dt) {
                      move_friction_anchors(world, contacts, friction, dt);
                  });
}
//! [add_friction]

}  // namespace enduring
