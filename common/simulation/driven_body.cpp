#include "common/simulation/driven_body.hpp"

#include <utility>

namespace enduring {

DrivenBody::DrivenBody(std::string name, const SurfaceMesh& mesh, const Vec3& centre, GivenMotion motion,
                       double time)
    : Body(std::move(name), topology_of(mesh)), centre_(centre), motion_(std::move(motion)),
      placed_(mesh.vertices)
{
    set_time(time);
    positions_t0_ = mesh.vertices;
    measure();
    place(time, placed_, positions_t0_);
    positions_t1_ = positions_t0_;
}

//! [place]
/// By the time alone, so rounding does not add up, and parts of a step lead to the same place as the whole
/// one.
void DrivenBody::place(double time, const std::vector<Vec3>& placed, std::vector<Vec3>& positions) const
{
    const GivenPlace now = motion_.at(time);
    const Quaternion turned = now.rotation();
    const Vec3 centre = centre_ + now.displacement;
    for (std::size_t i = 0; i < placed.size(); ++i)
        positions[i] = centre + turned * (placed[i] - centre_);
}
//! [place]

Pose DrivenBody::pose(double time) const
{
    const GivenPlace now = motion_.at(time);
    const Quaternion turned = now.rotation();
    return {centre_ + now.displacement - turned * centre_, turned};
}

void DrivenBody::predict(const Vec3&, double dt) { update_prediction(dt); }

void DrivenBody::update_prediction(double dt)
{
    place(time_ + dt, placed_, positions_t1_);
    place(time_, contact_placed_, contact_t0_);
    place(time_ + dt, contact_placed_, contact_t1_);
}

void DrivenBody::commit(double dt)
{
    set_time(time_ + dt);
    positions_t0_ = positions_t1_;
    contact_t0_ = contact_t1_;
}

Vec3 DrivenBody::velocity(int vertex) const
{
    const GivenPlace now = motion_.at(time_);
    const Vec3 from_centre = positions_t0_[static_cast<std::size_t>(vertex)] - (centre_ + now.displacement);
    return now.velocity + now.angular_velocity.cross(from_centre);
}

Vec3 DrivenBody::brought_back(const Vec3& point) const
{
    const GivenPlace now = motion_.at(time_);
    return centre_ + now.rotation().conjugate() * (point - (centre_ + now.displacement));
}

}  // namespace enduring
