#include "chapters/10_self_contact/experiments/bent_bars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter10 {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

/// To the left of a direction in the plane z = 0.
Vec3 left_of(const Vec3& direction) { return Vec3::UnitZ().cross(direction).normalized(); }

}  // namespace

TetrahedralMesh bent_bar(double length, double thickness, double width, std::array<int, 3> cells,
                         const std::function<CurvePoint(double)>& curve)
{
    TetrahedralMesh mesh = bar({length, thickness, width}, cells);
    for (Vec3& x : mesh.nodes) {
        const CurvePoint at = curve(x.x() + length / 2);
        x = at.place + x.y() * at.left + x.z() * at.up;
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
    const double growth = pitch / whole_turn;  // of the radius with the angle
    return bent_bar(length, thickness, width, cells, [&](double s) {
        const double angle = (std::sqrt(inner_radius * inner_radius + 2 * growth * s) - inner_radius) /
                             growth,
                     radius = inner_radius + growth * angle;
        const Vec3 out(std::cos(angle), std::sin(angle), 0), on(-out.y(), out.x(), 0);
        return CurvePoint{radius * out, left_of(radius * on + growth * out)};
    });
}

TetrahedralMesh hairpin(double gap, std::array<int, 3> cells)
{
    constexpr double bend = 0.02, thick = 0.01, leg = 0.2, inner = bend - 0.5 * thick;
    // towards each other, until the inner corners of the ends have this gap
    const double lean = std::atan(inner / leg) - std::asin(0.5 * gap / std::hypot(inner, leg)),
                 half_arc = bend * (whole_turn / 4 + lean), half = half_arc + leg;
    return bent_bar(2 * half, thick, 0.03, cells, [&](double along) {
        const double s = along - half, on_arc = std::clamp(s, -half_arc, half_arc), angle = on_arc / bend;
        const Vec3 direction(std::sin(angle), std::cos(angle), 0), left = left_of(direction);
        return CurvePoint{bend * left + (s - on_arc) * direction, left};
    });
}

TetrahedralMesh ring(double radius, double thickness, double width, std::array<int, 3> cells)
{
    const TetrahedralMesh opened = bent_bar(whole_turn * radius, thickness, width, cells, [&](double s) {
        const Vec3 out(std::cos(s / radius), std::sin(s / radius), 0);
        return CurvePoint{radius * out, -out};
    });
    TetrahedralMesh closed{{}, opened.elements};  // the last node of each row along the bar is its first
    const int in_row = cells[0] + 1;
    for (std::size_t node = 0; node < opened.nodes.size(); ++node)
        if (static_cast<int>(node) % in_row < cells[0])
            closed.nodes.push_back(opened.nodes[node]);
    for (auto& element : closed.elements)
        for (int& node : element)
            node = node / in_row * cells[0] + node % in_row % cells[0];
    return closed;
}

TetrahedralMesh crossed_bar(double thickness, double width, std::array<int, 3> cells)
{
    constexpr double leg = 0.2, bend = 0.08, round = 0.75 * whole_turn * bend;
    return bent_bar(2 * leg + round, thickness, width, cells, [&](double s) {
        const double angle = std::clamp((s - leg) / bend, 0.0, 0.75 * whole_turn);
        // negative on the first leg, positive on the second
        const double past = s - leg - angle * bend;
        const Vec3 along(std::cos(angle), std::sin(angle), 0), left(-std::sin(angle), std::cos(angle), 0);
        return CurvePoint{past * along - bend * left, left};
    });
}

namespace {

/// Points along the middle of the knotted rope, close to each other.
std::vector<Vec3> knot_line(double size, double arm, double thickness)
{
    constexpr int fine = 2000;
    constexpr double cut = 0.69;    // where the lowest loop leads straight down
    constexpr double apart = 1.2;   // strands that cross, more than a thickness from middle to middle
    const double scale = size / 3;  // the trefoil's loops reach 3
    std::vector<Vec3> line;
    for (int i = 0; i <= fine; ++i) {
        const double t = cut + (whole_turn - 2 * cut) * i / fine + std::numbers::pi;
        line.emplace_back(scale * (std::sin(t) + 2 * std::sin(2 * t)),
                          scale * (std::cos(t) - 2 * std::cos(2 * t)), -apart * thickness * std::sin(3 * t));
    }
    const double bend = 1.2 * scale;
    const auto lead_away = [&](double side) {  // a quarter of a circle downwards and away, and the arm
        const Vec3 start = line.back();
        for (int i = 1; i <= fine; ++i) {
            const double angle = whole_turn / 4 * i / fine;
            line.push_back(start + bend * Vec3(side * (1 - std::cos(angle)), -std::sin(angle), 0));
        }
        const Vec3 end = line.back();
        for (int i = 1; i <= fine; ++i)
            line.push_back(end + Vec3(side * arm * i / fine, 0, 0));
    };
    lead_away(-1);
    std::reverse(line.begin(), line.end());
    lead_away(1);
    return line;
}

}  // namespace

TetrahedralMesh overhand_knot(double size, double arm, double thickness, int cells)
{
    const std::vector<Vec3> line = knot_line(size, arm, thickness);
    std::vector<double> arc{0};
    for (std::size_t i = 1; i < line.size(); ++i)
        arc.push_back(arc.back() + (line[i] - line[i - 1]).norm());
    return bent_bar(arc.back(), thickness, thickness, {cells, 1, 1}, [&](double s) {
        const auto next = std::upper_bound(arc.begin() + 1, arc.end() - 1, s) - arc.begin();
        const auto i = static_cast<std::size_t>(next);
        const Vec3 along = (line[i] - line[i - 1]).normalized(), left = left_of(along);
        const double part = (s - arc[i - 1]) / (arc[i] - arc[i - 1]);
        return CurvePoint{lerp(line[i - 1], line[i], part), left, along.cross(left)};
    });
}

}  // namespace enduring::chapter10
