#include "chapters/08_deep_contacts/experiments/bent_bars.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// To the left of a direction in the plane z = 0.
Vec3 left_of(const Vec3& direction) { return Vec3::UnitZ().cross(direction).normalized(); }

}  // namespace

TetrahedralMesh bent_bar(double length, double thickness, double width, std::array<int, 3> cells,
                         const std::function<CurvePoint(double)>& curve)
{
    TetrahedralMesh mesh = bar({length, thickness, width}, cells);
    for (Vec3& x : mesh.nodes) {
        const CurvePoint at = curve(x.x() + length / 2);
        x = at.place + x.y() * at.left + x.z() * Vec3::UnitZ();
    }
    return mesh;
}

TetrahedralMesh upright_strip(double length, double thickness, double width, std::array<int, 3> cells,
                              double tilt)
{
    const Vec3 up(std::sin(tilt), std::cos(tilt), 0);
    return bent_bar(length, thickness, width, cells, [&](double s) {
        return CurvePoint{s * up, left_of(up)};
    });
}

TetrahedralMesh spiral(double inner_radius, double pitch, double length, double thickness, double width,
                       std::array<int, 3> cells)
{
    const double growth = pitch / full_turn;  // of the radius with the angle
    return bent_bar(length, thickness, width, cells, [&](double s) {
        const double angle = (std::sqrt(inner_radius * inner_radius + 2 * growth * s) - inner_radius) /
                             growth,
                     radius = inner_radius + growth * angle;
        const Vec3 out(std::cos(angle), std::sin(angle), 0), on(-out.y(), out.x(), 0);
        return CurvePoint{radius * out, left_of(radius * on + growth * out)};
    });
}

}  // namespace enduring::chapter08
