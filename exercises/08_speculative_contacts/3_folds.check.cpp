#include "exercises/08_speculative_contacts/3_folds.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <numbers>

using namespace enduring;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// An edge along z; the left face is level and faces up, the right one rises by an angle (or falls, if it is negative).
/// The left face lies towards +x.
FoldedEdge fold_by(double degrees, double skew = 0)
{
    return {{0, 0, 0},
            {0, 0, 2},
            {3, 0, 1 + skew},
            {-2 * std::cos(degrees * degree), 2 * std::sin(degrees * degree), 1 - skew}};
}

FoldedEdge placed(FoldedEdge edge, double scale, const Quaternion& turn, const Vec3& by = Vec3::Zero())
{
    for (Vec3* x : {&edge.p, &edge.q, &edge.left, &edge.right})
        *x = turn * (scale * *x) + by;
    return edge;
}

/// The same edge, told from its other end.
FoldedEdge reversed(const FoldedEdge& edge) { return {edge.q, edge.p, edge.right, edge.left}; }

Quaternion random_turn(RandomInputs& random)
{
    const Vec3 axis = random.direction();
    return Quaternion(Eigen::AngleAxisd(random.number(-180, 180) * degree, axis));
}

/// A roof of this angle on each side, its edge along z.
FoldedEdge roof(double degrees)
{
    return {{0, 0, -1},
            {0, 0, 1},
            {std::cos(degrees * degree), -std::sin(degrees * degree), 0},
            {-std::cos(degrees * degree), -std::sin(degrees * degree), 0}};
}

FoldedEdge turned(const FoldedEdge& edge, double degrees, const Vec3& axis)
{
    return placed(edge, 1, Quaternion(Eigen::AngleAxisd(degrees * degree, axis)));
}

}  // namespace

TEST_CASE("into: at right angles to the edge, in the face, away from the edge, of unit length")
{
    RandomInputs random(1);
    for (const double degrees : {-100.0, -20.0, 0.0, 60.0})
        for (const double skew : {0.0, 5.0}) {
            const Quaternion turn = random_turn(random);
            const FoldedEdge edge = placed(fold_by(degrees, skew), 0.01, turn, {1, 2, 3});
            given("an edge that folds by ", degrees,
                  " degrees, with third corners that stand beside its middle");
            expect("into the left face", into_left(edge), turn * Vec3::UnitX(), 1e-9);
            expect("into the right face", into_right(edge),
                   turn * Vec3(-std::cos(degrees * degree), std::sin(degrees * degree), 0), 1e-9);
        }
}

TEST_CASE("fold: the sine of its angle, positive in a valley, in any size and from both ends")
{
    RandomInputs random(2);
    for (const double degrees : {-150.0, -90.0, -10.0, 0.0, 1.0, 45.0, 120.0})
        for (const double scale : {1e-3, 1.0, 100.0}) {
            const FoldedEdge edge = placed(fold_by(degrees, 0.7), scale, random_turn(random));
            given("an edge that folds by ", degrees, " degrees, of ", 2 * scale, " m");
            expect("fold", fold_of(edge), std::sin(degrees * degree), 1e-9);
            expect("fold, from its other end", fold_of(reversed(edge)), std::sin(degrees * degree), 1e-9);
        }
    say("the edge of a cube folds by ", fold_of(fold_by(-90)));
}

TEST_CASE("kind: ridge, flat or valley, with a least sine")
{
    const auto expect_kind = [](double degrees, double least, FoldKind expected) {
        given("an edge that folds by ", degrees, " degrees, least sine ", least);
        expect_that("its kind is right", kind_of(fold_by(degrees), least) == expected);
    };
    expect_kind(-90, 1e-4, FoldKind::ridge);
    expect_kind(-0.1, 1e-4, FoldKind::ridge);
    expect_kind(-0.1, 1e-2, FoldKind::flat);
    expect_kind(0, 1e-4, FoldKind::flat);
    expect_kind(0.1, 1e-2, FoldKind::flat);
    expect_kind(0.1, 1e-4, FoldKind::valley);
    expect_kind(90, 1e-4, FoldKind::valley);
}

TEST_CASE("can push: the directions between the two normals of a ridge, and none of another edge")
{
    for (const double degrees : {-120.0, -60.0, -5.0, 0.0, 30.0})
        for (double angle = 5; angle < 360; angle += 7.3) {
            // The normals are at 90 degrees and at 90 - degrees.
            const bool expected = degrees < -1 && 90 <= angle && angle <= 90 - degrees;
            const Vec3 direction(std::cos(angle * degree), std::sin(angle * degree), 0);
            given("an edge that folds by ", degrees, " degrees, direction at ", angle, " degrees");
            expect_that(expected ? "it can push" : "it cannot push",
                        can_push(fold_by(degrees), direction, 1e-4, 1e-9) == expected);
        }
}

TEST_CASE("can push: the sine widens the cone on both sides, but never into the body")
{
    const auto is_in = [](double degrees, double sine) {
        const Vec3 direction(std::cos(degrees * degree), std::sin(degrees * degree), 0);
        return can_push(fold_by(-90), direction, 1e-4, sine);
    };
    given("the edge of a cube: normals at 90 and at 180 degrees");
    expect_that("80 degrees with a sine of 0.2: yes", is_in(80, 0.2));
    expect_that("76 degrees with a sine of 0.2: no", !is_in(76, 0.2));
    expect_that("190 degrees with a sine of 0.2: yes", is_in(190, 0.2));
    expect_that("194 degrees with a sine of 0.2: no", !is_in(194, 0.2));
    expect_that("315 degrees, into the body, with a sine of 0.99: no", !is_in(315, 0.99));
    given("a thin edge: normals at 90 and at 260 degrees, direction at 80 degrees, sine 0.2");
    expect_that("it can push: one face looks that way, although the mean of both does not",
                can_push(fold_by(-170), {std::cos(80 * degree), std::sin(80 * degree), 0}, 1e-4, 0.2));
    given("an edge that folds by -3 degrees, direction at 90 degrees; least sine 0.1, and 0.01");
    expect_that("with 0.1 it is flat and cannot push", !can_push(fold_by(-3), Vec3::UnitY(), 0.1, 1e-4));
    expect_that("with 0.01 it is a ridge and can push", can_push(fold_by(-3), Vec3::UnitY(), 0.01, 1e-4));
    given("edges that fold by 5 and by 0 degrees, direction at 90 degrees");
    expect_that("a shallow valley with a sine of 0.2: no", !can_push(fold_by(5), Vec3::UnitY(), 1e-4, 0.2));
    expect_that("a flat edge with a sine of 0.2: no", !can_push(fold_by(0), Vec3::UnitY(), 1e-4, 0.2));
}

TEST_CASE(
    "pair: the normal of a keel on a roof points up, out of the roof, from whichever ends they are told")
{
    for (const double about : {90.0, 40.0, -40.0, 135.0}) {
        const FoldedEdge below = roof(45),
                         above = turned(turned(roof(45), 180, Vec3::UnitX()), about, Vec3::UnitY());
        for (const FoldedEdge& a : {above, reversed(above)})
            for (const FoldedEdge& b : {below, reversed(below)}) {
                given("a keel across a roof, turned by ", about, " degrees about y");
                const auto up = normal_of_pair(a, b, 1e-4, 0.2, 1e-4),
                           down = normal_of_pair(b, a, 1e-4, 0.2, 1e-4);
                expect_that("there is a normal", up.has_value() && down.has_value());
                if (up && down) {
                    expect("normal, keel A, roof B", *up, Vec3(0, 1, 0), 1e-9);
                    expect("normal, roof A, keel B", *down, Vec3(0, -1, 0), 1e-9);
                }
            }
    }
}

TEST_CASE("pair: the size of the edges does not matter, and nearly parallel ones still have a normal")
{
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3})
        for (const double about : {0.3, -0.3, 90.0}) {
            const FoldedEdge below = placed(roof(45), scale, Quaternion::Identity()),
                             above = placed(
                                 turned(turned(roof(45), 180, Vec3::UnitX()), about, Vec3::UnitY()), scale,
                                 Quaternion::Identity());
            given("edges of ", 2 * scale, " m, a keel across a roof, turned by ", about,
                  " degrees about y; edges of less than a sine of 1e-4 are parallel");
            const auto normal = normal_of_pair(above, below, 1e-4, 0.2, 1e-4);
            expect_that("there is a normal", normal.has_value());
            if (normal)
                expect("normal", *normal, Vec3(0, 1, 0), 1e-9);
        }
}

TEST_CASE("pair: the sine widens the cones of both edges")
{
    const FoldedEdge below = roof(45), keel = turned(turned(roof(45), 180, Vec3::UnitX()), 90, Vec3::UnitY());
    for (const double lean : {50.0, -50.0}) {
        // One of its normals leans by 95 degrees then; sin(5 degrees) is 0.087.
        const FoldedEdge leaning_roof = turned(below, lean, Vec3::UnitZ()),
                         leaning_keel = turned(keel, lean, Vec3::UnitX());
        for (const double sine : {0.05, 0.2}) {
            given("a keel across a roof of 45 degrees; one of the two leans by ", lean, " degrees; sine ",
                  sine);
            const std::string expected = sine > 0.1 ? "there is a normal" : "there is none";
            expect_that(expected + " where the roof leans",
                        normal_of_pair(keel, leaning_roof, 1e-4, sine, 1e-4).has_value() == (sine > 0.1));
            expect_that(expected + " where the keel leans",
                        normal_of_pair(leaning_keel, below, 1e-4, sine, 1e-4).has_value() == (sine > 0.1));
        }
    }
}

TEST_CASE("pair: no normal for parallel edges, for valleys, for flat ones, and for two roofs side by side")
{
    const FoldedEdge below = roof(45), keel = turned(turned(roof(45), 180, Vec3::UnitX()), 90, Vec3::UnitY());
    given("a keel along a roof, turned by 0.001 degrees");
    expect_that("there is none",
                !normal_of_pair(turned(turned(roof(45), 180, Vec3::UnitX()), 0.001, Vec3::UnitY()), below,
                                1e-4, 0.2, 1e-4));
    given("a keel across a valley, across a flat side");
    expect_that("there is none across a valley", !normal_of_pair(keel, roof(-45), 1e-4, 0.2, 1e-4));
    expect_that("there is none across a flat side", !normal_of_pair(keel, roof(0), 1e-4, 0.2, 1e-4));
    expect_that("there is none the other way round", !normal_of_pair(roof(-45), keel, 1e-4, 0.2, 1e-4));
    given("two roofs that both look up, one across the other");
    expect_that("there is none",
                !normal_of_pair(turned(roof(45), 90, Vec3::UnitY()), below, 1e-4, 0.2, 1e-4));
}

TEST_CASE("pair: of the twelve edges of a cube that stands on an edge, across a roof, one has pairs")
{
    const FoldedEdge below = roof(45);
    // A cube's edges: three directions, and in each four quadrants in which its two faces lie.
    int count = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const double s : {1.0, -1.0})
            for (const double t : {1.0, -1.0}) {
                const Vec3 along = Vec3::Unit(axis), u = Vec3::Unit((axis + 1) % 3),
                           v = Vec3::Unit((axis + 2) % 3);
                // Into its two faces: -s u and -t v. The left one of an edge along `along` has the normal along x into.
                FoldedEdge edge{-along, along, -s * u, -t * v};
                if (along.cross(-s * u).dot(t * v) < 0)
                    std::swap(edge.left, edge.right);
                const FoldedEdge standing = turned(edge, 45, Vec3::UnitX());
                count += normal_of_pair(standing, below, 1e-4, 0.05, 1e-4).has_value();
            }
    given("a cube turned by 45 degrees about x, on a roof along z");
    expect("edges with a pair", count, 1, 0);
    say("a cube that stands on an edge, across a roof: ", count, " of 12 edges");
}
