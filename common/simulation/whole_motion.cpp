#include "common/simulation/whole_motion.hpp"

#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <Eigen/Cholesky>

namespace enduring {
namespace {

bool is_free(const RigidBody& body) { return body.motion().free_directions().hold_none(); }

bool is_free(const DeformableBody& body) { return body.elastic().inverse_masses().minCoeff() > 0; }

/// About the centre of mass, by the consistent mass matrix.
Mat3 inertia_of(const ElasticBody& elastic)
{
    const NodalVectors levers = elastic.positions().colwise() - elastic.centre_of_mass();
    const Mat3 spread = levers * elastic.mass_matrix() * levers.transpose();
    return spread.trace() * Mat3::Identity() - spread;
}

}  // namespace

std::optional<WholeMotion> whole_motion(const Body& body)
{
    WholeMotion whole{body.mass(), {}, {}, body.linear_momentum(), {}};
    if (const auto* const rigid = dynamic_cast<const RigidBody*>(&body); rigid && is_free(*rigid)) {
        whole.centre = rigid->motion().centre();
        whole.inertia = rigid->motion().inverse_inertia().inverse();
    } else if (const auto* const soft = dynamic_cast<const DeformableBody*>(&body); soft && is_free(*soft)) {
        whole.centre = soft->elastic().centre_of_mass();
        whole.inertia = inertia_of(soft->elastic());
    } else {
        return {};
    }
    whole.spin = body.angular_momentum(whole.centre);
    return whole;
}

void move_as_a_whole(Body& body, const Vec3& velocity, const Vec3& turn)
{
    if (auto* const rigid = dynamic_cast<RigidBody*>(&body))
        return rigid->move_with(velocity, turn);
    auto& soft = dynamic_cast<DeformableBody&>(body);
    const WholeMotion before = whole_motion(body).value();
    const Vec3 faster = velocity - before.momentum / before.mass,
               turning = turn - before.inertia.llt().solve(before.spin);
    NodalVectors velocities = soft.elastic().velocities();
    for (int node = 0; node < soft.elastic().node_count(); ++node)
        velocities.col(node) += faster + turning.cross(soft.elastic().positions().col(node) - before.centre);
    soft.take_velocities(velocities, 1);  // the time tells where its vertices would go, but it stands
    soft.stand_still();
}

}  // namespace enduring
