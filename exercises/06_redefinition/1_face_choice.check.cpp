#include "chapters/06_redefinition/face_choice.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring::small_worlds {
namespace {

/// A square in y = 0 that looks up: face 0 where z > x, face 1 where z < x.
SurfaceMesh square()
{
    return {{Vec3(-1, 0, -1), Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(1, 0, -1)}, {{0, 1, 2}, {0, 2, 3}}};
}

/// The same square upright, looking along +x.
SurfaceMesh wall()
{
    return {{Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(0, 1, 1), Vec3(0, -1, 1)}, {{0, 1, 2}, {0, 2, 3}}};
}

std::string name(FaceVerdict verdict)
{
    constexpr const char* names[] = {"above", "deep", "beside", "hooked", "fit"};
    return names[static_cast<int>(verdict)];
}

/// The verdict on one face for a tip at a place.
FaceTrial tried(const SurfaceMesh& mesh, const Vec3& place, int face, const FaceLimits& limits = {})
{
    const World world = tip_and(mesh, place);
    return try_face(PairSurfaces(world, 1, 0, 0), 0, face, limits);
}

void expect_verdict(const FaceTrial& trial, FaceVerdict expected)
{
    expect_that("the verdict is " + name(expected) + "; yours is " + name(trial.verdict),
                trial.verdict == expected);
}

}  // namespace

TEST_CASE("above: a vertex over the face, or exactly in it, and a face without area")
{
    given("a tip 0.1 m over face 1 of a square");
    expect_verdict(tried(square(), {0.3, 0.1, -0.3}, 1), FaceVerdict::above);
    given("a tip exactly in face 1 of a square");
    expect_verdict(tried(square(), {0.3, 0, -0.3}, 1), FaceVerdict::above);
    given("a tip 0.1 m over the square, asked of face 0, where its foot overshoots by 0.3");
    expect_verdict(tried(square(), {0.3, 0.1, -0.3}, 0), FaceVerdict::above);
    given("a tip 0.1 m below a face whose corners lie on a line");
    expect_verdict(tried({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, {{0, 1, 2}}}, {0.3, -0.1, 0}, 0),
                   FaceVerdict::above);
}

TEST_CASE("fit: a vertex below a face with its foot on it, and the trial tells foot and depth")
{
    given("a tip 0.1 m below face 1 of a square");
    const FaceTrial trial = tried(square(), {0.3, -0.1, -0.3}, 1);
    expect_verdict(trial, FaceVerdict::fit);
    expect("face", trial.face, 1, 0);
    expect("depth", trial.foot.depth, -0.1, 1e-12, "m");
    expect("overshoot", trial.overshoot, 0.0, 1e-12);
}

TEST_CASE("beside: a foot outside the face counts only below the tolerance")
{
    // On face 0 the foot of (0.3, -0.3) has the weight -0.3 for the corner (-1, 1).
    given("a tip 0.1 m below face 1, asked of face 0, where its foot overshoots by 0.3");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 0), FaceVerdict::beside);
    given("the same tip asked of face 0, tolerance 0.29");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 0, {.tolerance = 0.29}), FaceVerdict::beside);
    given("the same tip asked of face 0, tolerance 0.31");
    const FaceTrial trial = tried(square(), {0.3, -0.1, -0.3}, 0, {.tolerance = 0.31});
    expect_verdict(trial, FaceVerdict::fit);
    expect("overshoot", trial.overshoot, 0.3, 1e-12);
}

TEST_CASE("beside: an overshoot as large as the tolerance is beside")
{
    // Every number on the way is a sum of a few powers of two, so the overshoot is 0.25 in every bit.
    given(
        "a tip 0.125 m below face 1, asked of face 0, where its foot overshoots by 0.25, and the tolerance is 0.25");
    expect_verdict(tried(square(), {0.25, -0.125, -0.25}, 0, {.tolerance = 0.25}), FaceVerdict::beside);
}

TEST_CASE("order: a face that is both beside and deep is beside")
{
    given(
        "a tip 0.1 m below face 1, asked of face 0, where its foot overshoots by 0.3, and at most 0.09 m allowed");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 0, {.deepest = 0.09}), FaceVerdict::beside);
}

TEST_CASE("order: a face that is both hooked and beside, or hooked and deep, is not told as hooked")
{
    given("a tip that looks down, 0.1 m behind an upright wall that looks along x, its foot beside face 0");
    expect_verdict(tried(wall(), {-0.1, -0.2, 0.1}, 0), FaceVerdict::beside);
    given("a tip that looks down, 0.1 m behind face 0 of that wall, and at most 0.09 m allowed");
    expect_verdict(tried(wall(), {-0.1, 0.2, -0.1}, 0, {.deepest = 0.09}), FaceVerdict::deep);
}

TEST_CASE("deep: a penetration as large as the deepest is not deep")
{
    given("a tip 0.125 m below face 1, and at most 0.125 m allowed");
    expect_verdict(tried(square(), {0.25, -0.125, -0.25}, 1, {.deepest = 0.125}), FaceVerdict::fit);
}

TEST_CASE("size: millimetres and kilometres have the same verdicts")
{
    for (const double size : {1e-3, 1.0, 1e3}) {
        SurfaceMesh floor = square();
        for (Vec3& vertex : floor.vertices)
            vertex *= size;
        given("a tip below a square of sides ", 2 * size, " m, by a twentieth of that");
        expect_verdict(tried(floor, size * Vec3(0.3, -0.1, -0.3), 1), FaceVerdict::fit);
        expect_verdict(tried(floor, size * Vec3(0.3, -0.1, -0.3), 0), FaceVerdict::beside);
        expect_verdict(tried(floor, size * Vec3(0.3, 0.1, -0.3), 1), FaceVerdict::above);
        given("the same, and a little less allowed");
        expect_verdict(tried(floor, size * Vec3(0.3, -0.1, -0.3), 1, {.deepest = 0.09 * size}),
                       FaceVerdict::deep);
    }
}

TEST_CASE("deep: a face that is too far away")
{
    given("a tip 0.1 m below face 1, and at most 0.09 m allowed");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.deepest = 0.09}), FaceVerdict::deep);
    given("a tip 0.1 m below face 1, and at most 0.11 m allowed");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.deepest = 0.11}), FaceVerdict::fit);
}

TEST_CASE("deep: a face that looks more than 135 degrees away from where the pair came in")
{
    given("a tip below face 1, which looks up; its pair came in through a face that looks down, (0, -3, 0)");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.came_through = Vec3(0, -3, 0)}),
                   FaceVerdict::deep);
    given(
        "a tip below face 1, which looks up; its pair came in through a face 138 degrees from that, (0.9, -1, 0)");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.came_through = Vec3(0.9, -1, 0)}),
                   FaceVerdict::deep);
    given(
        "a tip below face 1, which looks up; its pair came in through a face 132 degrees from that, (0.1, -0.09, 0)");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.came_through = Vec3(0.1, -0.09, 0)}),
                   FaceVerdict::fit);
}

TEST_CASE("deep: of the two normals the angle counts, and not the lengths")
{
    given(
        "a tip below face 1, which looks up; its pair came in through a large face 101 degrees from that, (5, -1, 0)");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.came_through = Vec3(5, -1, 0)}), FaceVerdict::fit);
    given(
        "a tip below face 1, which looks up; its pair came in through a small face that looks down, (0, -0.1, 0)");
    expect_verdict(tried(square(), {0.3, -0.1, -0.3}, 1, {.came_through = Vec3(0, -0.1, 0)}),
                   FaceVerdict::deep);
}

TEST_CASE("hooked: a face that would push a tip that looks down to the side")
{
    given("a tip that looks down, 0.1 m behind an upright wall that looks along x");
    expect_verdict(tried(wall(), {-0.1, 0.2, -0.1}, 0), FaceVerdict::hooked);
}

TEST_CASE("better: on the face before beside it, and then the smaller penetration")
{
    const auto trial = [](double depth, double overshoot) {
        return FaceTrial{0, {{0, 0, 0}, depth}, overshoot, FaceVerdict::fit};
    };
    given("0.2 m deep on its face, and 0.1 m deep beside its face");
    expect_that("the one on its face is better", is_better(trial(-0.2, 0), trial(-0.1, 0.01)));
    expect_that("and not the other way round", !is_better(trial(-0.1, 0.01), trial(-0.2, 0)));
    given("0.1 m and 0.2 m deep, both on their faces");
    expect_that("the one 0.1 m deep is better", is_better(trial(-0.1, 0), trial(-0.2, 0)));
    expect_that("and not the other way round", !is_better(trial(-0.2, 0), trial(-0.1, 0)));
    given("both beside their faces: 0.1 m deep with an overshoot of 0.2, and 0.2 m deep with one of 0.1");
    expect_that("the one 0.1 m deep is better, though farther beside",
                is_better(trial(-0.1, 0.2), trial(-0.2, 0.1)));
    expect_that("and the one 0.2 m deep is not", !is_better(trial(-0.2, 0.1), trial(-0.1, 0.2)));
}

TEST_CASE("better: of two equal ones neither is")
{
    const FaceTrial one{0, {{0, 0, 0}, -0.25}, 0, FaceVerdict::fit},
        beside{0, {{0, 0, 0}, -0.25}, 0.5, FaceVerdict::fit};
    given("0.25 m deep, both on their faces");
    expect_that("neither is better", !is_better(one, one));
    given("0.25 m deep, both beside their faces");
    expect_that("neither is better", !is_better(beside, beside));
}

TEST_CASE("choice: positions are those of the moment tau")
{
    // In the step the tip rises from 0.1 m under the face to 0.3 m over it.
    const World world = tip_and(square(), {0.3, -0.1, -0.3}, {0, 0.4, 0});
    world.bodies[1]->predict(Vec3::Zero(), 1);
    for (const double tau : {0.0, 0.125}) {
        given("a tip that rises from 0.1 m below face 1 to 0.3 m over it, at tau = ", tau);
        const auto choice = find_face(world, on_face(world, 0), tau, all_corners, {});
        expect_that("a face is found", choice.has_value());
        if (choice)
            expect("depth", choice->foot.depth, -0.1 + 0.4 * tau, 1e-12, "m");
    }
    given("the same, at tau = 1");
    expect_that("no face is found", !find_face(world, on_face(world, 0), 1, all_corners, {}).has_value());
}

TEST_CASE("choice: only the faces around the given corners are asked")
{
    // Face 1 has the corners 0, 2 and 3; of the pair's own face, 0, 1 and 2, corner 1 is its own alone.
    const World world = tip_and(square(), {0.3, -0.1, -0.3});
    given("a tip below face 1, its pair with face 0, asked around the one corner that face 1 has not");
    expect_that("no face is found",
                !find_face(world, on_face(world, 0), 0, Corners{false, true, false}, {}).has_value());
    given("the same, asked around no corner");
    expect_that("no face is found",
                !find_face(world, on_face(world, 0), 0, Corners{false, false, false}, {}).has_value());
    for (const std::size_t corner : {0, 2}) {
        Corners around{false, false, false};
        around[corner] = true;
        given("the same, asked around corner ", corner);
        expect_that("a face is found", find_face(world, on_face(world, 0), 0, around, {}).has_value());
    }
}

TEST_CASE("choice: the face above the vertex is found, and none where none fits")
{
    const World below = tip_and(square(), {0.3, -0.1, -0.3}), above = tip_and(square(), {0.3, 0.1, -0.3});
    given("a tip 0.1 m below face 1, its pair still with face 0");
    const auto choice = find_face(below, on_face(below, 0), 0, all_corners, {});
    expect_that("a face is found", choice.has_value());
    if (choice) {
        expect("face", choice->face, 1, 0);
        say("the tip at (0.3, -0.1, -0.3) m belongs to face ", choice->face, ", at a depth of ",
            -choice->foot.depth, " m");
    }
    given("a tip 0.1 m over the square");
    expect_that("no face is found", !find_face(above, on_face(above, 0), 0, all_corners, {}).has_value());
}

TEST_CASE("choice: of two faces that fit, the one with the smaller penetration")
{
    // A roof with sides at 45 degrees; the third face, the pair's own, touches both.
    const SurfaceMesh roof{{Vec3(0, 0, -2), Vec3(0, 0, 2), Vec3(3, -3, 0), Vec3(-3, -3, 0), Vec3(0, 0.5, 4)},
                           {{0, 1, 2}, {1, 0, 3}, {1, 4, 2}}};
    for (const double x : {0.4, -0.4}) {
        const World world = tip_and(roof, {x, -1.5, 0});
        given("a roof with its ridge along z and sides at 45 degrees, a tip at x = ", x,
              " m, 1.5 m below the ridge");
        const auto choice = find_face(world, on_face(world, 2), 0, all_corners, {});
        expect_that("a face is found", choice.has_value());
        if (choice)
            expect("face", choice->face, x > 0 ? 0 : 1, 0);
    }
}

}  // namespace enduring::small_worlds
