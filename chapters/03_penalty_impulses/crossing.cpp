#include "chapters/03_penalty_impulses/crossing.hpp"

#include "chapters/02_collision_detection/impact_weights.hpp"
#include "common/geometry/tolerances.hpp"

namespace enduring {
namespace {

PairVertices start_of(const VertexFaceStep& s) { return {s.v_t0, s.f0_t0, s.f1_t0, s.f2_t0}; }
PairVertices end_of(const VertexFaceStep& s) { return {s.v_t1, s.f0_t1, s.f1_t1, s.f2_t1}; }
PairVertices start_of(const EdgeEdgeStep& s) { return {s.ea0_t0, s.ea1_t0, s.eb0_t0, s.eb1_t0}; }
PairVertices end_of(const EdgeEdgeStep& s) { return {s.ea0_t1, s.ea1_t1, s.eb0_t1, s.eb1_t1}; }

PairVertices vertices_at(const PairVertices& t0, const PairVertices& t1, double time)
{
    PairVertices x;
    for (std::size_t i = 0; i < 4; ++i)
        x[i] = at_time(t0[i], t1[i], time);
    return x;
}

/// Sides closer to parallel than this have no normal that rounding leaves alone.
bool has_normal(const PairInstant& pair)
{
    const double lengths = pair.side_1.norm() * pair.side_2.norm();
    return pair.side_1.cross(pair.side_2).norm() > tolerance::trusted_sine * lengths && lengths > 0;
}

/// The sign with which the depth leaves zero: 1 falling, -1 rising. The first Bernstein coefficient of the
/// rest of the step that differs from the first decides, so a touch at rest is judged by what follows.
double falling(const PairStep& step, double time)
{
    const Bernstein<double, 3> rest = penetration_depth(contact_normal(step), step).from(time);
    const auto& c = rest.coefficients;
    for (const double later : {c[1], c[2], c[3]})
        if (later != c[0])
            return later < c[0] ? 1 : -1;
    return 0;
}

}  // namespace

Crossing crossing_at(const VertexFaceStep& step, double time)
{
    const PairVertices t0 = start_of(step), t1 = end_of(step), x = vertices_at(t0, t1, time);
    if (!has_normal(vertex_face_instant(x)))
        return {time, 0, {}};
    const auto [w0, w1, w2] = impact_weights(step, time);
    return {time, falling({vertex_face_instant(t0), vertex_face_instant(t1)}, time), {1, -w0, -w1, -w2}};
}

Crossing crossing_at(const EdgeEdgeStep& step, double time)
{
    const PairVertices t0 = start_of(step), t1 = end_of(step), x = vertices_at(t0, t1, time);
    if (!has_normal(edge_edge_instant(x, 1)))
        return {time, 0, {}};
    const auto [s, t] = impact_weights(step, time);
    return {time, falling({edge_edge_instant(t0, 1), edge_edge_instant(t1, 1)}, time), {1 - s, s, t - 1, -t}};
}

bool enters_edge(const EdgeEdgeStep& step, const Crossing& crossing, const Vec3& outward)
{
    const PairVertices x = vertices_at(start_of(step), end_of(step), crossing.time);
    const PairInstant pair = edge_edge_instant(x, crossing.orientation);
    return crossing.orientation != 0 && pair.side_1.cross(pair.side_2).dot(outward) >= 0;
}

}  // namespace enduring
