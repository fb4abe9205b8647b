#include "chapters/02_collision_detection/experiments/gallery_cases.hpp"

namespace enduring::chapter02 {

std::vector<GalleryCase> gallery_cases()
{
    const Vec3 f0(-1, 0, 0.8), f1(1.1, 0.1, 0.6), f2(0, 0, -1.1), lift(0, 0.15, 0);
    const VertexFaceStep through{{-0.5, 1, 0.2},    f0,        f1,        f2,
                                 {0.5, -0.8, -0.1}, f0 + lift, f1 + lift, f2 + lift};
    const VertexFaceStep beside{{1.3, 0.9, -0.9},  f0,        f1,        f2,
                                {0.9, -0.7, -0.5}, f0 + lift, f1 + lift, f2 + lift};

    const EdgeEdgeStep crossing{{-1, 0.7, 0.2},  {1, 0.9, -0.2},  {0, 0, 1},   {0.2, 0.1, -1},
                                {-1, -0.6, 0.2}, {1, -0.9, -0.2}, {0, 0.1, 1}, {0.2, 0.2, -1}};

    // The face tilts while the vertex flies along it: their distance is
    // (1 - 2 tau)^2, a double root at one half.
    const VertexFaceStep grazing{{1, 0, 0},  {-1, 0, -1}, {-1, 0, 1}, {1, 1, 0},
                                 {-1, 0, 0}, {-1, 1, -1}, {-1, 1, 1}, {1, -2, 0}};
    return {{"vertex_face", through, 0.5},
            {"edge_edge", crossing, 0.5},
            {"near_miss", beside, 0.5},
            {"grazing", grazing, 0.5}};
}

namespace {

std::vector<Vec3> points_of(const VertexFaceStep& s, double tau)
{
    return {at_time(s.v_t0, s.v_t1, tau), at_time(s.f0_t0, s.f0_t1, tau), at_time(s.f1_t0, s.f1_t1, tau),
            at_time(s.f2_t0, s.f2_t1, tau)};
}

std::vector<Vec3> points_of(const EdgeEdgeStep& s, double tau)
{
    return {at_time(s.ea0_t0, s.ea0_t1, tau), at_time(s.ea1_t0, s.ea1_t1, tau),
            at_time(s.eb0_t0, s.eb0_t1, tau), at_time(s.eb1_t0, s.eb1_t1, tau)};
}

}  // namespace

std::vector<Vec3> points_at(const GalleryCase& one, double tau)
{
    return std::visit([tau](const auto& step) { return points_of(step, tau); }, one.step);
}

}  // namespace enduring::chapter02
