#include "chapters/07_implicit_contact/grain_friction.hpp"

#include "common/simulation/body_pose.hpp"

#include <Eigen/LU>

namespace enduring {
namespace {

/// @param direction  in the world
Mat3 stretch_of(const Vec3& direction, double across, const Vec3& normal)
{
    const Vec3 side = normal.cross(direction).stableNormalized();  // at right angles to the grain
    return Mat3::Identity() + (across - 1) * side * side.transpose();
}

}  // namespace

//! [grain_of]
std::optional<Mat3> grain_of(const World& world, const Contact& contact, const Vec3& normal)
{
    const Body& a = *world.bodies[static_cast<std::size_t>(contact.body_a)];
    const auto number_of_b = static_cast<std::size_t>(contact.body_b);
    const bool on_plane = contact.on_plane();
    const Grain& of_b = on_plane ? world.planes[number_of_b].grain : world.bodies[number_of_b]->grain();
    if (!a.grain().any() && !of_b.any())
        return std::nullopt;
    Mat3 grain = Mat3::Identity();
    if (a.grain().any())
        grain = stretch_of(committed_pose(a).orientation * a.grain().direction, a.grain().across, normal);
    if (of_b.any()) {
        const Vec3 direction =
            on_plane ? of_b.direction
                     : Vec3(committed_pose(*world.bodies[number_of_b]).orientation * of_b.direction);
        grain = stretch_of(direction, of_b.across, normal) * grain;
    }
    return grain;
}
//! [grain_of]

Vec3 stretch_on_grain(const Mat3& grain, const Vec3& stretch, const Vec3& moved)
{
    return grain.transpose().inverse() * stretch + grain * moved;
}

}  // namespace enduring
