#include "common/simulation/whole_motion.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

const Vec3 size(0.4, 0.2, 0.3), velocity(3, -1, 2), turn(5, 2, -4);

DeformableSettings soft_settings()
{
    DeformableSettings settings;
    settings.material = {1e5, 0.3, 1000};
    settings.position = {7, 8, 9};
    settings.velocity = velocity;
    settings.angular_velocity = turn;
    return settings;
}

}  // namespace

TEST_CASE("whole motion: a rigid brick and a soft one, moved alike, have the same")
{
    const RigidBody rigid("brick", box(size), mass_properties(box(size), 1000), velocity, turn);
    const DeformableBody soft("bar", bar(size, {3, 2, 2}), soft_settings());
    const WholeMotion of_rigid = whole_motion(rigid).value(), of_soft = whole_motion(soft).value();
    CHECK(of_soft.mass == doctest::Approx(of_rigid.mass));
    CHECK((of_soft.centre - of_rigid.centre - Vec3(7, 8, 9)).norm() < 1e-12);
    CHECK((of_soft.inertia - of_rigid.inertia).norm() < 1e-9 * of_rigid.inertia.norm());
    CHECK((of_soft.momentum - of_rigid.momentum).norm() < 1e-9 * of_rigid.momentum.norm());
    CHECK((of_soft.spin - of_rigid.spin).norm() < 1e-9 * of_rigid.spin.norm());
}

TEST_CASE("whole motion: who moves as a whole has that motion, and a soft body keeps its own parts' motion")
{
    RigidBody rigid("brick", box(size), mass_properties(box(size), 1000), velocity, turn);
    DeformableBody soft("bar", bar(size, {3, 2, 2}), soft_settings());
    soft.apply_impulse(0, Vec3(1, 2, 3));  // now its parts move against each other
    const auto inner_energy = [&] {
        const WholeMotion whole = whole_motion(soft).value();
        return soft.energy(Vec3::Zero()).kinetic - whole.momentum.squaredNorm() / (2 * whole.mass) -
               whole.spin.dot(whole.inertia.inverse() * whole.spin) / 2;
    };
    const double inner = inner_energy();
    CHECK(inner > 0.01);
    for (Body* const body : {static_cast<Body*>(&rigid), static_cast<Body*>(&soft)}) {
        move_as_a_whole(*body, Vec3(1, 2, 3), Vec3(-4, 5, 6));
        const WholeMotion whole = whole_motion(*body).value();
        CHECK((whole.momentum / whole.mass - Vec3(1, 2, 3)).norm() < 1e-12);
        CHECK((whole.inertia.inverse() * whole.spin - Vec3(-4, 5, 6)).norm() < 1e-9);
        CHECK(body->positions_t1()[0] == body->positions_t0()[0]);
    }
    CHECK(inner_energy() == doctest::Approx(inner).epsilon(1e-9));
}

TEST_CASE("whole motion: what is held has none of its own")
{
    RigidBody rigid("brick", box(size), mass_properties(box(size), 1000));
    FreeDirections free;
    free.translation = Vec3(1, 0, 1);
    rigid.hold(free);
    CHECK(!whole_motion(rigid));
    DeformableSettings settings = soft_settings();
    settings.velocity = settings.angular_velocity = Vec3::Zero();
    settings.fixed_nodes = {0};
    CHECK(!whole_motion(DeformableBody("bar", bar(size, {1, 1, 1}), settings)));
}
