#include "chapters/09_deep_contacts/experiments/overlap_shape.hpp"
#include "chapters/09_deep_contacts/intersection_curve.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <set>

using namespace enduring;

namespace {

using Shape = OverlapShape;

SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by)
{
    for (Vec3& x : mesh.vertices)
        x += by;
    return mesh;
}

SurfaceMesh standing_on_a_corner()
{
    SurfaceMesh cube = box({1, 1, 1});
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1), Vec3(0.1, -1, 0.05));
    for (Vec3& x : cube.vertices)
        x = turn * x + Vec3(0.013, 0.8, 0.021);
    return cube;
}

/// Two boxes of 1 m to 2 m, anywhere near each other; cells are not cubes.
std::pair<Shape, Shape> random_boxes(int seed)
{
    RandomInputs random(static_cast<unsigned>(seed));
    const auto one = [&] {
        SurfaceMesh mesh = box(random.point(1, 2), {2, 3, 2});
        const Vec3 axis = random.point(-1, 1), place = random.point(-0.8, 0.8);
        const Eigen::Quaterniond turn(Eigen::Vector4d(axis.x(), axis.y(), axis.z(), 1.1).normalized());
        for (Vec3& x : mesh.vertices)
            x = turn * x + place;
        return Shape(mesh);
    };
    return {one(), one()};
}

/// The faces (of A, of B) between which a piercing lies.
std::set<std::pair<int, int>> faces_at(const Piercing& piercing, const Shape& a, const Shape& b)
{
    std::set<std::pair<int, int>> faces;
    for (const int face : (piercing.edge_of_a ? a : b).topology().faces_at_edge(piercing.edge))
        if (face >= 0)
            faces.emplace(piercing.face_of_a(face), piercing.face_of_b(face));
    return faces;
}

/// Whether a piece of curve runs between two piercings: along one face of A and one of B.
bool are_joined(const Piercing& one, const Piercing& other, const Shape& a, const Shape& b)
{
    const auto there = faces_at(other, a, b);
    for (const auto& faces : faces_at(one, a, b))
        if (there.count(faces))
            return true;
    return false;
}

void expect_whole_curves(const Intersection& crossing, const Shape& a, const Shape& b)
{
    std::vector<int> times(crossing.piercings.size(), 0);
    for (const IntersectionCurve& curve : crossing.curves) {
        const std::size_t count = curve.piercings.size();
        for (std::size_t i = 0; i < count; ++i) {
            ++times[static_cast<std::size_t>(curve.piercings[i])];
            const bool last = i + 1 == count;
            if (last && !curve.closed)
                break;
            const Piercing
                &now = crossing.piercings[static_cast<std::size_t>(curve.piercings[i])],
                &next = crossing.piercings[static_cast<std::size_t>(curve.piercings[last ? 0 : i + 1])];
            expect_that("piercing " + std::to_string(i) +
                            " of the curve and the next one lie on one face of A and on one of B",
                        are_joined(now, next, a, b));
        }
    }
    for (std::size_t i = 0; i < times.size(); ++i)
        expect("curves through piercing " + std::to_string(i), times[i], 1, 0);
}

int closed_ones(const Intersection& crossing)
{
    return static_cast<int>(std::count_if(crossing.curves.begin(), crossing.curves.end(),
                                          [](const IntersectionCurve& curve) { return curve.closed; }));
}

int count_of(const Intersection& crossing) { return static_cast<int>(crossing.curves.size()); }

}  // namespace

TEST_CASE("curve: a corner in a floor has one, around its three edges")
{
    const Shape cube(standing_on_a_corner()), floor(box({4, 0.5, 4}));
    const Intersection crossing = trace_intersection(cube.still(), floor.still());
    given("a cube of 1 m that stands on a corner, in a floor");
    expect("curves", count_of(crossing), 1, 0);
    expect("closed ones", closed_ones(crossing), 1, 0);
    expect_whole_curves(crossing, cube, floor);
    say("a corner in a floor: ", crossing.curves.size(), " curve through ", crossing.piercings.size(),
        " piercings");
}

TEST_CASE(
    "curve: piercings that follow each other share a face of A and a face of B, and each is passed once")
{
    int curves = 0;
    for (int seed = 0; seed < 60; ++seed) {
        const auto [a, b] = random_boxes(seed);
        const Intersection crossing = trace_intersection(a.still(), b.still());
        given("two boxes at a random place, number ", seed);
        expect("closed curves", closed_ones(crossing), count_of(crossing), 0);
        expect_whole_curves(crossing, a, b);
        curves += count_of(crossing);
    }
    given("60 pairs of boxes at random places");
    expect_that("there are 40 curves at least", curves >= 40);
}

TEST_CASE("curves: a bar through a wall has two")
{
    const Shape bar(moved(box({4, 0.5, 0.5}, {4, 1, 1}), {0.017, 0.1, 0.03})),
        wall(box({0.5, 3, 3}, {1, 3, 3}));
    const Intersection crossing = trace_intersection(bar.still(), wall.still());
    given("a bar of 4 m through a wall of 0.5 m");
    expect("curves", count_of(crossing), 2, 0);
    expect("closed ones", closed_ones(crossing), 2, 0);
    expect_whole_curves(crossing, bar, wall);
    say("a bar through a wall: ", crossing.curves.size(), " curves");
}

TEST_CASE("curves: they close where edges lie on edges and faces in faces")
{
    for (const Vec3& by : {Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(-1, 0, 0.5)}) {
        const Shape a(box({1, 1, 1}, {2, 2, 2})), b(moved(box({1, 1, 1}, {2, 2, 2}), by));
        const Intersection crossing = trace_intersection(a.still(), b.still());
        given("a cube of 1 m, and the same one moved by ", readable(by), " m");
        expect("closed curves", closed_ones(crossing), count_of(crossing), 0);
        expect_whole_curves(crossing, a, b);
    }
    say("a cube in a cube of its size: all curves close");
}

TEST_CASE("curves: over the border of an open sheet one ends, at its first and at its last piercing")
{
    const Shape sheet(plane_grid(2, 2, {3, 3}));
    for (const double size : {1.0, 0.3}) {
        const Shape cube(moved(box({size, size, size}), {1.013, 0.1, 0.017}));
        const Intersection crossing = trace_intersection(cube.still(), sheet.still());
        given("a cube of ", size, " m over the border of an open sheet");
        expect("curves", count_of(crossing), 1, 0);
        expect("closed ones", closed_ones(crossing), 0, 0);
        expect_whole_curves(crossing, cube, sheet);
        if (crossing.curves.empty() || crossing.curves[0].piercings.empty())
            continue;
        for (const int end : {crossing.curves[0].piercings.front(), crossing.curves[0].piercings.back()}) {
            const Piercing& piercing = crossing.piercings[static_cast<std::size_t>(end)];
            expect_that("an end lies on an edge of the sheet that has one face",
                        !piercing.edge_of_a && sheet.topology().faces_at_edge(piercing.edge)[1] < 0);
        }
    }
}

TEST_CASE(
    "curves: the corner of an open sheet in the middle of a face has one that ends, at the borders beside")
{
    const Shape sheet(plane_grid(2, 2, {3, 3}));
    for (const double side :
         {1.0, -1.0}) {  // one of the corners has one triangle of the sheet, the other two
        const Vec3 corner(side, 0, 1), outwards = corner.normalized();
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(EIGEN_PI / 4, Vec3::UnitY()));
        SurfaceMesh mesh = box({4, 4, 4});
        for (Vec3& x : mesh.vertices)
            x = turn * x + corner + 1.8 * outwards + Vec3(0.013, 1.1, 0);
        const Shape cube(mesh);
        const Intersection crossing = trace_intersection(cube.still(), sheet.still());
        given("a corner of an open sheet, 0.2 m deep in one face of a cube of 4 m");
        expect("curves", count_of(crossing), 1, 0);
        expect("closed ones", closed_ones(crossing), 0, 0);
        expect_whole_curves(crossing, cube, sheet);
    }
}

TEST_CASE("curves: in whatever order the piercings come, they are the same")
{
    const auto [a, b] = random_boxes(7);
    const auto as_sets = [](const Intersection& crossing) {
        std::set<std::set<std::tuple<bool, int, int>>> curves;
        for (const IntersectionCurve& curve : crossing.curves) {
            std::set<std::tuple<bool, int, int>> one;
            for (const int i : curve.piercings) {
                const Piercing& piercing = crossing.piercings[static_cast<std::size_t>(i)];
                one.emplace(piercing.edge_of_a, piercing.edge, piercing.face);
            }
            curves.insert(one);
        }
        return curves;
    };
    std::vector<Piercing> piercings = find_piercings(a.still(), b.still());
    const auto before = as_sets(join_piercings(piercings, a.still(), b.still()));
    RandomInputs random(3);
    for (int trial = 0; trial < 5; ++trial) {
        random.shuffle(piercings);
        const Intersection crossing = join_piercings(piercings, a.still(), b.still());
        given("the same ", piercings.size(), " piercings, shuffled");
        expect_that("the curves pass the same piercings", as_sets(crossing) == before);
        expect_whole_curves(crossing, a, b);
    }
}

TEST_CASE("curves: of two, the one with the first piercing comes first")
{
    const Shape bar(moved(box({4, 0.5, 0.5}, {4, 1, 1}), {0.017, 0.1, 0.03})),
        wall(box({0.5, 3, 3}, {1, 3, 3}));
    const Intersection crossing = trace_intersection(bar.still(), wall.still());
    given("a bar of 4 m through a wall of 0.5 m");
    int least = -1;
    for (const IntersectionCurve& curve : crossing.curves) {
        const int first = *std::min_element(curve.piercings.begin(), curve.piercings.end());
        expect("where the curve begins", curve.piercings.front(), first, 0);
        expect_that("it is later than the curve before", first > least);
        least = first;
    }
}

TEST_CASE("curve: around the tip of a tetrahedron in one large face it has three piercings, and closes")
{
    SurfaceMesh mesh = tetrahedron(1);
    const Vec3 tip = mesh.vertices[0], turned_by = -tip.normalized();
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(-turned_by, Vec3(0.05, -1, 0.03));
    for (Vec3& x : mesh.vertices)
        x = turn * (x - tip) + Vec3(0.7, 0.15, -0.4);
    const Shape above(mesh), floor(box({4, 0.5, 4}));
    const Intersection crossing = trace_intersection(above.still(), floor.still());
    given("a tetrahedron of 1 m whose tip is 10 cm deep in a face of a floor");
    expect("piercings", crossing.piercings.size(), 3, 0);
    expect("curves", count_of(crossing), 1, 0);
    expect("closed ones", closed_ones(crossing), 1, 0);
    expect_whole_curves(crossing, above, floor);
}

TEST_CASE("curves: what does not cross has none")
{
    const Shape a(box({1, 1, 1})), b(moved(box({1, 1, 1}), {3, 0, 0})), inside(box({0.5, 0.5, 0.5}));
    given("two cubes apart, and one inside the other");
    expect("curves of cubes apart", count_of(trace_intersection(a.still(), b.still())), 0, 0);
    expect("curves of a cube inside another", count_of(trace_intersection(inside.still(), a.still())), 0, 0);
}
