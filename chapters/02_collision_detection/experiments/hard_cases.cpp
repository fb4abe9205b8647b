#include "chapters/02_collision_detection/experiments/hard_cases.hpp"

#include <cmath>

namespace enduring::chapter02 {
namespace {

/// The corners of a face that does not move; its edges lie along no axis.
struct Corners {
    Vec3 f0{-1, -1, 0}, f1{2, -1, 0}, f2{-1, 3, 0};
};

/// A vertex that moves from one place to another, and a face at rest.
VertexFaceStep past_a_resting_face(const Vec3& v_t0, const Vec3& v_t1, const Corners& f = {})
{
    return {v_t0, f.f0, f.f1, f.f2, v_t1, f.f0, f.f1, f.f2};
}

VertexFaceStep scaled(const VertexFaceStep& s, double factor)
{
    return {factor * s.v_t0, factor * s.f0_t0, factor * s.f1_t0, factor * s.f2_t0,
            factor * s.v_t1, factor * s.f0_t1, factor * s.f1_t1, factor * s.f2_t1};
}

VertexFaceStep shifted(const VertexFaceStep& s, const Vec3& by)
{
    return {s.v_t0 + by, s.f0_t0 + by, s.f1_t0 + by, s.f2_t0 + by,
            s.v_t1 + by, s.f0_t1 + by, s.f1_t1 + by, s.f2_t1 + by};
}

/// A vertex that runs along x while the face tilts about y against it: its
/// height over the face is (tau - 1/2)^2 - depth.
VertexFaceStep tangent(double depth)
{
    const auto face = [](double x, double y, double tilt) { return Vec3(x, y, tilt * x); };
    return {{0.5, 0, -depth},  face(-2, -2, -0.5), face(2, -2, -0.5), face(0, 2, -0.5),
            {-0.5, 0, -depth}, face(-2, -2, 0.5),  face(2, -2, 0.5),  face(0, 2, 0.5)};
}

EdgeEdgeStep onto_a_resting_edge(const Vec3& a0, const Vec3& a1, const Vec3& travel, const Vec3& b0,
                                 const Vec3& b1)
{
    return {a0, a1, b0, b1, a0 + travel, a1 + travel, b0, b1};
}

std::vector<HardCase> vertices_and_faces()
{
    const VertexFaceStep ordinary = past_a_resting_face({0, 0, 1}, {0, 0, -1});
    const double root = std::sqrt(0x1p-20);
    return {
        {"ordinary: the vertex falls through the face", ordinary, 0.5},
        {"coordinates of 1e-15", scaled(ordinary, 0x1p-50), 0.5},
        {"coordinates of 1e-90", scaled(ordinary, 0x1p-300), 0.5},
        {"coordinates of 1e9, details of 1e-6", shifted(scaled(ordinary, 0x1p-20), Vec3::Constant(0x1p30)),
         0.5},
        {"coplanar throughout: the vertex slides into the face", past_a_resting_face({-2, 0, 0}, {0, 0, 0}),
         0.5},
        {"coplanar throughout: the vertex slides past the face",
         past_a_resting_face({-2, 0, 0}, {-2, 2, 0}),
         {}},
        {"resting: the vertex lies on the face throughout", past_a_resting_face({0, 0, 0}, {0.5, 0, 0}), 0.0},
        {"the face has collapsed to a line, and the vertex hits it",
         past_a_resting_face({1, 1, 1}, {1, 1, -1}, {{0, 0, 0}, {4, 4, 0}, {2, 2, 0}}), 0.5},
        {"a sliver of width 1e-12",
         past_a_resting_face({1, 1, 1}, {1, 1, -1}, {{0, 0, 0}, {4, 4, 0}, {2, 2 - 0x1p-40, 0}}), 0.5},
        {"through a corner, exactly", past_a_resting_face({-1, 3, 1}, {-1, 3, -1}), 0.5},
        {"past an edge by 1e-12", past_a_resting_face({0, -1 - 0x1p-40, 1}, {0, -1 - 0x1p-40, -1}), {}},
        {"tangent: touches and leaves again", tangent(0), 0.5},
        {"almost tangent: turns back 1e-18 before it touches", tangent(-0x1p-60), {}},
        {"almost tangent: dips in by 1e-6", tangent(0x1p-20), 0.5 - root},
        {"touches at the very end of the step", past_a_resting_face({0, 0, 1}, {0, 0, 0}), 1.0},
    };
}

std::vector<HardCase> edges()
{
    return {
        {"parallel edges: one falls on the other",
         onto_a_resting_edge({0, 0, 1}, {2, 2, 1}, {0, 0, -2}, {1, 1, 0}, {3, 3, 0}), 0.5},
        {"parallel edges: one slides along the other's line",
         onto_a_resting_edge({-4, -4, 0}, {-2, -2, 0}, {4, 4, 0}, {0, 0, 0}, {2, 2, 0}), 0.5},
        {"parallel edges: they pass at 1e-15",
         onto_a_resting_edge({-1, 0, 0x1p-50}, {1, 0, 0x1p-50}, {0, 2, 0}, {-1, 1, 0}, {1, 1, 0}),
         {}},
        {"coplanar throughout: the edges sweep across each other",
         onto_a_resting_edge({-3, 0, 0}, {-2, 1, 0}, {4, 0, 0}, {0, 0, 0}, {0, 2, 0}), 0.5},
        {"an edge of length 0 falls on an edge",
         onto_a_resting_edge({1, 1, 1}, {1, 1, 1}, {0, 0, -2}, {0, 0, 0}, {3, 3, 0}), 0.5},
    };
}

}  // namespace

std::vector<HardCase> hard_cases()
{
    std::vector<HardCase> all = vertices_and_faces();
    for (HardCase& c : edges())
        all.push_back(std::move(c));
    return all;
}

}  // namespace enduring::chapter02
