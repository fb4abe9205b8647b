#include "chapters/03_penalty_impulses/experiments/exact_impulse.hpp"
#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "chapters/03_penalty_impulses/penetration.hpp"

#include <algorithm>

namespace enduring::chapter03 {
namespace {

/// A vertex and a triangle of side 2 around the origin in y = 0, at both ends of a step.
struct ShapeCase {
    std::string panel, what;
    PairVertices t0, t1;

    PairStep step() const { return {vertex_face_instant(t0), vertex_face_instant(t1)}; }
};

PairVertices vertex_above_triangle(const Vec3& vertex)
{
    return {vertex, Vec3(-1, 0, -1), Vec3(-1, 0, 1), Vec3(1, 0, 0)};
}

ShapeCase straight(std::string panel, std::string what, double height_t0, double height_t1)
{
    return {std::move(panel), std::move(what), vertex_above_triangle({0, height_t0, 0}),
            vertex_above_triangle({0, height_t1, 0})};
}

/// The triangle sways about its own axis while the vertex passes beside it: a cubic with two dips below zero.
ShapeCase two_visits(std::string panel)
{
    ShapeCase c{std::move(panel), "a face that sways: inside twice", vertex_above_triangle({0.45, 0.005, 0}),
                vertex_above_triangle({-0.45, 0.01, 0})};
    c.t0[1].y() = c.t0[2].y() = -0.06;
    c.t0[3].y() = 0.06;
    c.t1[1].y() = c.t1[2].y() = 0.08;
    c.t1[3].y() = -0.08;
    return c;
}

std::vector<ShapeCase> cases()
{
    return {straight("a", "falling in", 0.04, -0.08), straight("b", "sinking", -0.02, -0.08),
            straight("c", "rising out", -0.08, 0.04), straight("d", "rising", -0.08, -0.02), two_visits("e")};
}

double depth_at(const PairStep& step, double tau)
{
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    return penetration_depth(normal, step)(tau) / normal(tau).norm();
}

}  // namespace

/// Thesis figure 5.1: the area that each method takes for the area under the depth.
void impulse_shape(const RunOptions&, Report& report)
{
    Table curves({"panel", "tau", "depth_mm", "inside_mm", "dpf_mm"});
    Table areas({"panel", "motion", "exact_mm", "cpf_mm", "dpf_mm", "intervals"});
    for (const ShapeCase& c : cases()) {
        const PairStep step = c.step();
        const double dpf = -std::min(0.0, depth_at(step, 1));
        for (int i = 0; i <= 200; ++i) {
            const double tau = i / 200.0, depth = depth_at(step, tau);
            curves.add({c.panel, tau, 1000 * depth, -1000 * std::min(0.0, depth), 1000 * dpf});
        }
        const Bernstein<double, 3> depth = penetration_depth(contact_normal(step), step);
        areas.add({c.panel, c.what, 1000 * exact_impulse(step, 0, 1, 1).norm(),
                   1000 * continuous_impulse(step, 0, 1, 1).norm(),
                   1000 * discrete_impulse(step.t1, 1, 1).norm(),
                   static_cast<long>(penetration_intervals(depth).size())});
    }
    report.table("impulse_shape", curves);
    report.table("impulse_areas", areas);
    report.page_table("impulse_areas", areas, 4);
    report.plot("chapters/03_penalty_impulses/plots/impulse_shape.gp");
}

}  // namespace enduring::chapter03
