#include "chapters/03_penalty_impulses/crossing.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// A vertex that goes straight from one height to another beside the middle of a resting triangle in y = 0.
VertexFaceStep falling_vertex(double y_t0, double y_t1)
{
    const Vec3 f0(-1, 0, -1), f1(-1, 0, 3), f2(3, 0, -1);
    return {Vec3(0, y_t0, 0), f0, f1, f2, Vec3(0, y_t1, 0), f0, f1, f2};
}

/// Edge a along x at one height and then at another, over edge b along z in y = 0.
EdgeEdgeStep falling_edge(double y_t0, double y_t1)
{
    return {Vec3(-1, y_t0, 0.2), Vec3(1, y_t0, 0.2), Vec3(0, 0, -1), Vec3(0, 0, 1),
            Vec3(-1, y_t1, 0.2), Vec3(1, y_t1, 0.2), Vec3(0, 0, -1), Vec3(0, 0, 1)};
}

const Vec3 b_below_a(0, 2, 0), a_below_b(0, -2, 0);  // outward of B minus outward of A

auto entering(const EdgeEdgeStep& step, const Vec3& outward)
{
    return find_entry(step, [=](const Crossing& crossing) { return enters_edge(step, crossing, outward); });
}

}  // namespace

TEST_CASE("crossing: a vertex enters through the front of a face and not through its back")
{
    const auto entry = find_entry(falling_vertex(1, -3), enters_face);
    REQUIRE(entry);
    CHECK(entry->time == doctest::Approx(0.25).epsilon(1e-9));
    const PairWeights expected{1, -0.5, -0.25, -0.25};
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(entry->weights[i] == doctest::Approx(expected[i]).epsilon(1e-9));
    // leaves: an outgoing crossing creates nothing
    CHECK_FALSE(find_entry(falling_vertex(-1, 3), enters_face));
    CHECK_FALSE(find_entry(falling_vertex(1, 0.5), enters_face));
}

TEST_CASE("crossing: a vertex that lies in the face and sinks enters at once")
{
    const auto entry = find_entry(falling_vertex(0, -1), enters_face);
    REQUIRE(entry);
    CHECK(entry->time == 0);
    CHECK_FALSE(find_entry(falling_vertex(0, 1), enters_face));
}

TEST_CASE(
    "crossing: a vertex that has no speed towards the face at first enters where the face tilts up against it")
{
    // At (x, 0, 0) the face rises as 0.4 tau x; the vertex glides along x =
    // 0.5 tau, so the depth falls with tau squared.
    const VertexFaceStep step{{0, 0, 0},   {-1, 0, -1},    {-1, 0, 3},    {3, 0, -1},
                              {0.5, 0, 0}, {-1, -0.4, -1}, {-1, -0.4, 3}, {3, 1.2, -1}};
    const auto entry = find_entry(step, enters_face);
    REQUIRE(entry);
    CHECK(entry->time < 1e-9);
}

TEST_CASE("crossing: after one that leads out, the query is asked for the rest of the step")
{
    // A face that sways while the vertex passes over it: inside, outside, inside again.
    VertexFaceStep step = falling_vertex(0.005, 0.01);
    step.v_t0.x() = 0.45;
    step.v_t1.x() = -0.45;
    step.f0_t0 = {-1, -0.06, -1};
    step.f1_t0 = {-1, -0.06, 1};
    step.f2_t0 = {1, 0.06, 0};
    step.f0_t1 = {-1, 0.08, -1};
    step.f1_t1 = {-1, 0.08, 1};
    step.f2_t1 = {1, -0.08, 0};
    const auto first = time_of_impact(step);
    REQUIRE(first);
    const auto entry = find_entry(step, enters_face);
    REQUIRE(entry);
    CHECK(crossing_at(step, *first).orientation == -1);
    CHECK(entry->orientation == 1);
    CHECK(entry->time > *first + 0.1);
}

TEST_CASE("crossing: an edge pair gets the normal that points from B to A")
{
    const auto from_above = entering(falling_edge(1, -1), b_below_a);
    REQUIRE(from_above);
    CHECK(from_above->time == doctest::Approx(0.5).epsilon(1e-9));
    const PairInstant above = edge_edge_instant(
        {Vec3(-1, 1, 0.2), Vec3(1, 1, 0.2), Vec3(0, 0, -1), Vec3(0, 0, 1)}, from_above->orientation);
    CHECK(above.side_1.cross(above.side_2).y() > 0);

    const auto from_below = entering(falling_edge(-1, 1), a_below_b);
    REQUIRE(from_below);
    CHECK(from_below->orientation == -from_above->orientation);
}

TEST_CASE("crossing: an edge pair that parts is not an entry seen backwards")
{
    CHECK_FALSE(entering(falling_edge(-1, 1), b_below_a));
    CHECK_FALSE(entering(falling_edge(1, -1), a_below_b));
}

TEST_CASE("crossing: p and q of an edge pair are where the edges meet")
{
    const auto entry = entering(falling_edge(1, -1), b_below_a);
    REQUIRE(entry);
    const PairWeights expected{0.5, 0.5, -0.4, -0.6};
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(entry->weights[i] == doctest::Approx(expected[i]).epsilon(1e-9));
}

TEST_CASE("crossing: parallel edges and needles have no normal, so no entry")
{
    EdgeEdgeStep parallel = falling_edge(1, -1);
    parallel.eb0_t0 = parallel.eb0_t1 = Vec3(-1, 0, 0.2);
    parallel.eb1_t0 = parallel.eb1_t1 = Vec3(1, 0, 0.2);
    CHECK_FALSE(entering(parallel, b_below_a));
    VertexFaceStep needle = falling_vertex(1, -1);
    needle.f1_t0 = needle.f1_t1 = Vec3(0, 0, 0);
    needle.f2_t0 = needle.f2_t1 = Vec3(1, 0, 1);
    CHECK_FALSE(find_entry(needle, enters_face));
}

TEST_CASE("crossing: edges and faces thinner than a ten-thousandth still have a normal, so an entry")
{
    EdgeEdgeStep thin = falling_edge(1, -1);
    thin.eb0_t0 = thin.eb0_t1 = Vec3(-1, 0, 0.2 - 1e-4);
    thin.eb1_t0 = thin.eb1_t1 = Vec3(1, 0, 0.2 + 1e-4);
    const auto entry = entering(thin, b_below_a);
    REQUIRE(entry);
    CHECK(entry->time == doctest::Approx(0.5).epsilon(1e-9));
    CHECK(entry->weights[0] == doctest::Approx(0.5).epsilon(1e-9));

    VertexFaceStep needle{{0.5, 1, 0},  {-1, 0, -1e-4}, {-1, 0, 1e-4}, {2, 0, 0},
                          {0.5, -1, 0}, {-1, 0, -1e-4}, {-1, 0, 1e-4}, {2, 0, 0}};
    CHECK(find_entry(needle, enters_face));
}
