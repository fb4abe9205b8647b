#include "common/simulation/turning_body.hpp"

#include <utility>

namespace enduring {
namespace {

Quaternion turn(const Vec3& angle)
{
    return Quaternion(Eigen::AngleAxisd(angle.norm(), angle.stableNormalized()));
}

}  // namespace

TurningBody::TurningBody(std::string name, const SurfaceMesh& mesh, const Vec3& centre,
                         const Vec3& angular_velocity)
    : Body(std::move(name), SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces)),
      centre_(centre), angular_velocity_(angular_velocity), at_first_(mesh.vertices)
{
    positions_t0_ = positions_t1_ = mesh.vertices;
    measure();
}

void TurningBody::predict(const Vec3&, double dt)
{
    // from the beginning: rounding does not add up
    const Quaternion until_then = turn((time_ + dt) * angular_velocity_);
    for (std::size_t i = 0; i < at_first_.size(); ++i)
        positions_t1_[i] = centre_ + until_then * (at_first_[i] - centre_);
}

void TurningBody::commit(double dt)
{
    time_ += dt;
    positions_t0_ = positions_t1_;
}

void TurningBody::visit_state(StateArchive& archive)
{
    Body::visit_state(archive);
    archive(time_);
}

Vec3 TurningBody::velocity(int vertex) const
{
    return angular_velocity_.cross(positions_t0_[vertex] - centre_);
}

Vec3 TurningBody::turned_back(const Vec3& point) const
{
    return centre_ + turn(-time_ * angular_velocity_) * (point - centre_);
}

}  // namespace enduring
