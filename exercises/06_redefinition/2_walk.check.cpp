#include "exercises/06_redefinition/2_walk.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <stdexcept>

namespace enduring {
namespace {

/// A mesh at rest.
struct Still {
    SurfaceMesh mesh;
    SurfaceTopology topology{static_cast<int>(mesh.vertices.size()), mesh.faces};
    SurfaceMoment surface() const { return {{topology, mesh.vertices, mesh.vertices}, 0}; }
};

Vec3 point_of(const Still& still, const Walk& walk)
{
    const Face& face = still.mesh.faces[walk.face];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        sum += walk.weights[i] * still.mesh.vertices[face[i]];
    return sum;
}

}  // namespace

TEST_CASE("weights: they sum to 1 and put the foot below the point")
{
    const Still one{{{Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3)}, {{0, 1, 2}}}};
    const Vec3 point(0.5, 1.5, 2);
    given("the face (1, 0, 0), (0, 2, 0), (0, 0, 3) m, the point (0.5, 1.5, 2) m");
    const auto [w0, w1, w2] = foot_weights(one.surface(), 0, point);
    expect("sum of the weights", w0 + w1 + w2, 1.0, 1e-12);
    const Vec3 way = point - Vec3(w0, 2 * w1, 3 * w2);
    expect("way from foot to point, across the face's normal", Vec3(way.cross(Vec3(6, 3, 2))), Vec3(0, 0, 0),
           1e-12, "m");
    expect("distance of the foot from the plane 6 x + 3 y + 2 z = 6", 6 * w0 + 6 * w1 + 6 * w2, 6.0, 1e-12);
}

TEST_CASE("weights: a face without area is refused")
{
    const Still line{{{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)}, {{0, 1, 2}}}};
    bool refused = false;
    try {
        foot_weights(line.surface(), 0, Vec3(1, 0, 0));
    } catch (const std::domain_error&) {
        refused = true;
    }
    expect_that("corners on a line throw std::domain_error", refused);
}

TEST_CASE("walk: on a flat floor it ends below the point, from every face to everywhere")
{
    RandomInputs random(6);
    for (const GridDiagonals diagonals :
         {GridDiagonals::same, GridDiagonals::alternating, GridDiagonals::crossed}) {
        const Still floor{plane_grid(4, 4, {6, 6}, diagonals)};
        for (int face = 0; face < static_cast<int>(floor.mesh.faces.size()); face += 5) {
            const double x = random.number(-1.9, 1.9), z = random.number(-1.9, 1.9);
            const Vec3 point(x, -0.2, z);
            given("a floor of 6 by 6 cells, from face ", face, " to the point ", readable(point), " m");
            const auto walk = walk_to_foot(floor.surface(), face, point);
            expect_that("the walk arrives", walk.has_value());
            if (walk)
                expect("foot", point_of(floor, *walk), Vec3(point.x(), 0, point.z()), 1e-12, "m");
        }
    }
}

TEST_CASE("walk: who is there already crosses nothing, and who goes straight crosses two edges a cell")
{
    const Still floor{plane_grid(12, 2, {12, 2})};
    given("a floor of 12 by 2 cells of 1 m");
    const Vec3 begin(-5.9, 0, 0.5), end(5.9, 0, 0.5);
    const auto here = walk_to_foot(floor.surface(), 0, begin);
    expect_that("the walk from face 0 to (-5.9, 0, 0.5) m arrives", here.has_value());
    if (!here)
        return;
    const auto again = walk_to_foot(floor.surface(), here->face, begin),
               there = walk_to_foot(floor.surface(), here->face, end);
    expect_that("from there, the walk to the same point arrives", again.has_value());
    expect_that("from there, the walk to (5.9, 0, 0.5) m arrives", there.has_value());
    if (!again || !there)
        return;
    expect("edges crossed without moving", again->crossed, 0, 0);
    // 11 borders between cells and the diagonals of 12: the first or the last is not
    // crossed where the way begins or ends beyond it.
    expect("edges crossed along the row", there->crossed, 23, 1);
    say("from one end of 12 cells to the other: ", there->crossed, " edges crossed");
}

TEST_CASE("walk: of two negative weights the most negative shows the way")
{
    // The point lies beyond two edges of face 0. Across one is face 1, which holds its foot; across the other
    // face 2, and then an open border.
    const Face orders[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    for (const Face& corners : orders) {
        const Still fan{{{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(6, 0, -3), Vec3(1, 0, 1)},
                         {corners, {0, 2, 3}, {2, 1, 4}}}};
        const Vec3 point(1.7, -0.1, -0.6);
        given(
            "a face with corners at (0, 0, 0), (0, 0, 1), (1, 0, 0) m, where the foot has the weights -0.1, -0.6 and 1.7; the face's list begins with corner ",
            corners[0], " of these");
        const auto walk = walk_to_foot(fan.surface(), 0, point);
        expect_that("the walk arrives", walk.has_value());
        if (walk) {
            expect("face", walk->face, 1, 0);
            expect("edges crossed", walk->crossed, 1, 0);
        }
    }
}

TEST_CASE("walk: a foot within 1e-12 of the face is on it, and one farther out is not")
{
    const Still two{{{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 0, -1)}, {{0, 1, 2}, {0, 2, 3}}}};
    for (const double beyond : {5e-13, 2e-12, 1e-9}) {
        given(
            "two faces that meet in the line z = 0, from face 0 to a point whose foot has one weight there of -",
            beyond);
        const auto walk = walk_to_foot(two.surface(), 0, Vec3(0.5, 0.1, -beyond));
        expect_that("the walk arrives", walk.has_value());
        if (walk)
            expect("edges crossed", walk->crossed, beyond < 1e-12 ? 0 : 1, 0);
    }
}

TEST_CASE("walk: `most` edges may be crossed, and not one more")
{
    const Still floor{plane_grid(12, 2, {12, 2})};
    const Vec3 begin(-5.9, 0, 0.5), end(0.1, 0, 0.5);
    given("a floor of 12 by 2 cells of 1 m, a way of 6 m along a row");
    const auto here = walk_to_foot(floor.surface(), 0, begin);
    const auto there = here ? walk_to_foot(floor.surface(), here->face, end) : std::nullopt;
    expect_that("the walk arrives when 100 edges are allowed", there.has_value());
    if (!there)
        return;
    const int needed = there->crossed;
    given("a floor of 12 by 2 cells of 1 m, a way of 6 m along a row that crosses ", needed, " edges");
    expect_that("it arrives when just so many are allowed",
                walk_to_foot(floor.surface(), here->face, end, needed).has_value());
    expect_that("it does not when one less is",
                !walk_to_foot(floor.surface(), here->face, end, needed - 1).has_value());
    expect_that("with none allowed, who is there already has arrived",
                walk_to_foot(floor.surface(), here->face, begin, 0).has_value());
}

TEST_CASE("walk: above a ridge it goes to and fro, and there is no answer")
{
    // Each slope has the point beyond its upper edge, over the other slope.
    const Still roof{
        {{Vec3(0, 0, -2), Vec3(0, 0, 2), Vec3(-2, -2, 0), Vec3(2, -2, 0)}, {{0, 2, 1}, {0, 1, 3}}}};
    for (const double height : {0.1, 1.0})
        for (const int face : {0, 1}) {
            given("two slopes of 45 degrees that meet in a ridge, a point ", height,
                  " m above it, from face ", face);
            expect_that("the walk has no end",
                        !walk_to_foot(roof.surface(), face, Vec3(0.01, height, 0)).has_value());
        }
}

TEST_CASE("size: weights and ways are the same from micrometres to kilometres")
{
    const Still floor{plane_grid(4, 4, {6, 6})};
    for (const double size : {1e-6, 1e-3, 1e3}) {
        const Still sized{plane_grid(4 * size, 4 * size, {6, 6})};
        for (const Vec3& point : {Vec3(1.3, -0.2, 0.7), Vec3(-1.9, 0.4, 1.1)}) {
            given("a floor of ", 4 * size, " m, from face 5 to the point ", readable(point), " times ", size,
                  " m");
            const auto walk = walk_to_foot(sized.surface(), 5, size * point),
                       same = walk_to_foot(floor.surface(), 5, point);
            expect_that("the walk arrives", walk.has_value() && same.has_value());
            if (walk && same) {
                expect("edges crossed, as of 4 m", walk->crossed, same->crossed, 0);
                expect("foot over size", Vec3(point_of(sized, *walk) / size), Vec3(point.x(), 0, point.z()),
                       1e-9);
            }
        }
    }
}

TEST_CASE("moment: of a surface that moves in the step it is the place at the moment that counts")
{
    const SurfaceMesh start = plane_grid(4, 4, {6, 6});
    const SurfaceTopology topology(static_cast<int>(start.vertices.size()), start.faces);
    std::vector<Vec3> end = start.vertices;
    for (Vec3& x : end)
        x = 2 * x + Vec3(1, 0.5, -0.5);
    for (const double tau : {0.25, 0.5, 1.0}) {
        Still now{start};
        for (std::size_t i = 0; i < end.size(); ++i)
            now.mesh.vertices[i] = (1 - tau) * start.vertices[i] + tau * end[i];
        const Vec3 point = tau * Vec3(1, 0.5, -0.5) + Vec3(0.9, -0.3, 0.7);
        given("a floor that moves and grows, at tau ", tau, ", from face 7 to the point ", readable(point),
              " m");
        const auto walk = walk_to_foot({{topology, start.vertices, end}, tau}, 7, point);
        expect_that("the walk arrives", walk.has_value());
        if (walk)
            expect("foot", point_of(now, *walk), Vec3(point.x(), 0.5 * tau, point.z()), 1e-12, "m");
    }
}

TEST_CASE("walk: over an open border, or too far, there is no answer")
{
    const Still floor{plane_grid(12, 2, {12, 2})};
    given("a floor of 12 by 2 m, the point (7, 0, 0) m beyond its border");
    expect_that("the walk has no end", !walk_to_foot(floor.surface(), 0, Vec3(7, 0, 0)).has_value());
    given("a floor of 12 by 2 m, from face 0 to the point (5.9, 0, 0.5) m at the other end, at most 5 edges");
    expect_that("the walk has no end", !walk_to_foot(floor.surface(), 0, Vec3(5.9, 0, 0.5), 5).has_value());
}

TEST_CASE("walk: around a sphere it finds the face that looks at the point")
{
    const Still ball{sphere(1, 2)};
    const Vec3 point = Vec3(0.3, -0.8, 0.5).normalized() * 0.95;
    given(
        "a sphere of radius 1 m, from its face 0 to a point 0.95 m from its centre in the direction (0.3, -0.8, 0.5)");
    const auto near = walk_to_foot(ball.surface(), 0, point);
    expect_that("the walk arrives", near.has_value());
    if (near)
        expect_that("the foot lies within 0.1 m of the point", (point_of(ball, *near) - point).norm() < 0.1);
    given("a sphere of radius 1 m, from its face 17 to a point 0.1 m below that face");
    const auto here = walk_to_foot(ball.surface(), 17, ball.surface().face_normal(17).normalized() * 0.9);
    expect_that("the walk arrives, and crosses one edge at most", here.has_value() && here->crossed <= 1);
}

}  // namespace enduring
