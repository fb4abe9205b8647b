#include "chapters/02_collision_detection/slabs.hpp"
#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/contact.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace enduring;

namespace {

/// A surface that is turned, stands somewhere and moves.
struct Moving {
    SurfaceTopology topology;
    std::vector<Vec3> t0, t1;

    Moving(const SurfaceMesh& mesh, const Quaternion& turn, const Vec3& place, const Vec3& travel)
        : topology(topology_of(mesh))
    {
        for (const Vec3& x : mesh.vertices) {
            t0.push_back(place + turn * x);
            t1.push_back(t0.back() + travel);
        }
    }
    SurfaceStep step() const { return {topology, t0, t1}; }
    SweptBox box(double margin) const
    {
        SweptBox all = SweptBox::empty();
        for (int vertex = 0; vertex < topology.vertex_count(); ++vertex)
            all = all | vertex_box(step(), vertex);
        return all.grown_by(margin);
    }
};

bool keep_apart(const Moving& a, const Moving& b, double margin)
{
    const std::array<SweptBox, 2> boxes{a.box(margin), b.box(margin)};
    return BodySlabs(boxes, [&](std::size_t i) { return slabs_along_faces((i == 0 ? a : b).step(), margin); })
        .keep_apart(0, 1);
}

struct AnyTouch {
    const SurfaceStep &a, &b;
    bool touch = false;
    void vertex_face(int v, int f) { touch = touch || time_of_impact(vertex_face_step(a, v, b, f)); }
    void face_vertex(int f, int v) { touch = touch || time_of_impact(vertex_face_step(b, v, a, f)); }
    void edge_edge(int e, int g) { touch = touch || time_of_impact(edge_edge_step(a, e, b, g)); }
};

bool touch(const Moving& a, const Moving& b)
{
    const SurfaceStep step_a = a.step(), step_b = b.step();
    AnyTouch any{step_a, step_b};
    visit_all_pairs(step_a, step_b, any);
    return any.touch;
}

}  // namespace

TEST_CASE("slabs: what touches is never kept apart, and what lies beside a tilted plate mostly is")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1, 1);
    const auto vector = [&] { return Vec3(in(random), in(random), in(random)); };
    const SurfaceMesh plate = box({4, 0.05, 4}), ball = sphere(0.2, 1), cube = box({0.3, 0.3, 0.3});
    int apart = 0, kept_apart = 0;
    for (int i = 0; i < 400; ++i) {
        const Quaternion turn = Quaternion(1, in(random), in(random), in(random)).normalized();
        const Moving a(plate, turn, Vec3::Zero(), 0.2 * vector());
        const Moving b(i % 2 == 0 ? ball : cube, Quaternion::Identity(), 1.2 * vector(), 0.2 * vector());
        if (!a.box(0).overlaps(b.box(0)))
            continue;
        const bool any = touch(a, b);
        CAPTURE(i);
        CHECK(!(any && keep_apart(a, b, 0)));
        apart += !any;
        kept_apart += keep_apart(a, b, 0);
    }
    CHECK(apart > 100);
    CHECK(kept_apart > 0.7 * apart);
}

TEST_CASE("slabs: they reach as far as the margins, and rounding takes nothing off what lies on them")
{
    const SurfaceMesh cube = box({1, 1, 1});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int i = 0; i < 100; ++i) {
        const Quaternion any = Quaternion(in(random), in(random), in(random), in(random)).normalized(),
                         turn = i == 0 ? Quaternion::Identity() : any;
        const Vec3 up = turn * Vec3::UnitY(), place(1e3 * in(random), 1e3, 1e3 * in(random));
        const Moving below(cube, turn, place, Vec3::Zero());
        CAPTURE(i);
        // face on face, but for the last digits
        CHECK_FALSE(keep_apart(below, Moving(cube, turn, place + up, Vec3::Zero()), 0));
        // both margins reach over the gap; a box may reach farther than its margin, along its diagonal
        CHECK_FALSE(keep_apart(below, Moving(cube, turn, place + 1.0199 * up, Vec3::Zero()), 0.01));
    }
}

TEST_CASE("slabs: a body of many faces has none, nor has one without faces")
{
    const Moving ball(sphere(1, 2), Quaternion::Identity(), Vec3::Zero(), Vec3::Zero());
    CHECK(slabs_along_faces(ball.step(), 0).empty());
    const Moving points({sphere(1, 1).vertices, {}, {}}, Quaternion::Identity(), Vec3::Zero(), Vec3::Zero());
    CHECK(slabs_along_faces(points.step(), 0).empty());
    const Moving brick(box({1, 2, 3}), Quaternion::Identity(), Vec3::Zero(), Vec3::Zero());
    CHECK(slabs_along_faces(brick.step(), 0).size() == 3);
}
