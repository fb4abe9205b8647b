#include "exercises/05_categorisation/4_borrowed_normals.hpp"
#include "common/geometry/box_shapes.hpp"
#include "exercises/checking.hpp"

namespace enduring {
namespace {

constexpr ContactCategory regular = ContactCategory::regular, hooked = ContactCategory::hooked;

/// A flat strip of two rows: vertex i of the first row at 2 i, of the
/// second at 2 i + 1; each cell two triangles.
SurfaceTopology strip(int cells)
{
    std::vector<Face> faces;
    for (int i = 0; i < cells; ++i) {
        faces.push_back({2 * i, 2 * i + 1, 2 * i + 2});
        faces.push_back({2 * i + 2, 2 * i + 1, 2 * i + 3});
    }
    return {2 * (cells + 1), faces};
}

const Vec3 leaning_left(-0.6, 0.8, 0), leaning_right(0.6, 0.8, 0);

void expect_normal(const std::string& what, const std::optional<Vec3>& got, const Vec3& expected)
{
    expect_that(what + " has a normal", got.has_value());
    if (got)
        expect(what, *got, expected, 1e-12);
}

}  // namespace

TEST_CASE("regular: a regular vertex keeps its own normal, whatever its neighbours say")
{
    const SurfaceTopology surface = strip(3);
    const std::vector<BuriedVertex> buried = {
        {0, leaning_left, regular}, {2, leaning_right, regular}, {4, Vec3::UnitX(), hooked}};
    given("a strip; vertex 0 regular (-0.6, 0.8, 0), vertex 2 regular (0.6, 0.8, 0), vertex 4 hooked");
    const auto normals = borrowed_normals(surface, buried);
    expect("how many normals there are", normals.size(), 3, 0);
    if (normals.size() != 3)
        return;
    expect_normal("normal of vertex 0", normals[0], leaning_left);
    expect_normal("normal of vertex 2", normals[1], leaning_right);
}

TEST_CASE("hooked: it borrows from a regular neighbour")
{
    const SurfaceTopology surface = strip(3);
    const std::vector<BuriedVertex> buried = {{4, Vec3::UnitX(), hooked}, {2, leaning_right, regular}};
    given("a strip; vertex 4 hooked, its neighbour 2 regular (0.6, 0.8, 0)");
    expect_normal("normal of vertex 4", borrowed_normals(surface, buried)[0], leaning_right);
}

TEST_CASE("nearest: all regular vertices of the nearest ring count, each once, and farther ones do not")
{
    const SurfaceTopology surface = strip(6);
    std::vector<BuriedVertex> row;
    for (int i = 0; i < 7; ++i)
        row.push_back({2 * i, Vec3::UnitX(), hooked});
    row[0] = {0, leaning_left, regular};
    row[6] = {12, leaning_right, regular};
    given("a row of seven, the first regular (-0.6, 0.8, 0), the last regular (0.6, 0.8, 0)");
    const auto normals = borrowed_normals(surface, row);
    expect_normal("normal of the third", normals[2], leaning_left);
    expect_normal("normal of the middle one", normals[3], Vec3::UnitY());
    expect_normal("normal of the fifth", normals[4], leaning_right);
    if (normals[3])
        say("a row of seven, regular at its ends: the middle one borrows ", readable(*normals[3]),
            " from both");

    // Some vertices of the second ring can be reached over two of the first: they count once.
    const SurfaceMesh grid = plane_grid(2, 2, {2, 2});
    const SurfaceTopology square(static_cast<int>(grid.vertices.size()), grid.faces);
    const auto around = square.edges_around_vertex(0);
    std::vector<BuriedVertex> corner = {{0, Vec3::UnitX(), hooked}};
    for (const int edge : around) {
        const auto [v0, v1] = square.edges()[edge];
        corner.push_back({v0 == 0 ? v1 : v0, Vec3::UnitX(), hooked});
    }
    const std::size_t ring_end = corner.size();
    for (int vertex = 1; vertex < square.vertex_count(); ++vertex) {
        bool known = false;
        for (std::size_t i = 0; i < ring_end; ++i)
            known |= corner[i].vertex == vertex;
        if (!known)
            corner.push_back({vertex, corner.size() == ring_end ? leaning_left : leaning_right, regular});
    }
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = ring_end; i < corner.size(); ++i) {
        bool near = false;
        for (const int edge : square.edges_around_vertex(corner[i].vertex))
            for (std::size_t j = 1; j < ring_end; ++j) {
                const auto [v0, v1] = square.edges()[edge];
                near |= v0 == corner[j].vertex || v1 == corner[j].vertex;
            }
        if (near)
            sum += corner[i].normal;
    }
    given("a square of 2 by 2 cells; the corner and its neighbours hooked, all others regular");
    expect_normal("normal of the corner", borrowed_normals(square, corner)[0], sum.normalized());
}

TEST_CASE("unknown: a vertex without a label borrows as a hooked one does, and lends nothing")
{
    const SurfaceTopology surface = strip(3);
    const std::vector<BuriedVertex> row = {
        {0, leaning_left, regular}, {2, Vec3::UnitX(), ContactCategory::unknown}, {4, Vec3::UnitZ(), hooked}};
    given("a row of three: regular (-0.6, 0.8, 0), unknown (1, 0, 0), hooked (0, 0, 1)");
    const auto normals = borrowed_normals(surface, row);
    expect_normal("normal of the unknown one", normals[1], leaning_left);
    expect_normal("normal of the hooked one", normals[2], leaning_left);
}

TEST_CASE("reach: the walk is as long as it has to be")
{
    for (const int rings : {2, 3, 4, 5, 10, 40}) {
        const SurfaceTopology surface = strip(rings);
        std::vector<BuriedVertex> row = {{0, leaning_left, regular}};
        for (int i = 1; i <= rings; ++i)
            row.push_back({2 * i, Vec3::UnitX(), hooked});
        given("a row with a regular vertex (-0.6, 0.8, 0) at one end and ", rings, " hooked ones behind it");
        expect_normal("normal of the last", borrowed_normals(surface, row).back(), leaning_left);
    }
}

TEST_CASE("reach: one vertex that is not buried is enough to end the walk")
{
    const std::vector<BuriedVertex> gap = {{0, leaning_left, regular}, {4, Vec3::UnitX(), hooked}};
    given("a strip; vertex 0 regular, vertex 4 hooked, vertices 1, 2 and 3 between them not buried");
    expect_that("vertex 4 has no normal", !borrowed_normals(strip(6), gap)[1].has_value());
}

TEST_CASE("reach: the walk goes over buried vertices only")
{
    const SurfaceTopology surface = strip(6);
    const std::vector<BuriedVertex> gap = {{0, leaning_left, regular}, {8, Vec3::UnitX(), hooked}};
    given("a strip; vertex 0 regular, vertex 8 hooked, nothing buried between them");
    expect_that("vertex 8 has no normal", !borrowed_normals(surface, gap)[1].has_value());
}

TEST_CASE("reach: normals that cancel, and hooked vertices alone, lend nothing")
{
    const SurfaceTopology surface = strip(3);
    const std::vector<BuriedVertex> opposite = {
        {0, Vec3::UnitX(), regular}, {2, Vec3::UnitY(), hooked}, {4, Vec3(-1, 0, 0), regular}};
    given("a hooked vertex between two regular ones with opposite normals, and no others");
    expect_that("it has no normal", !borrowed_normals(surface, opposite)[1].has_value());
    const std::vector<BuriedVertex> alone = {{0, Vec3::UnitX(), hooked},
                                             {2, Vec3::UnitX(), ContactCategory::unknown}};
    given("a hooked vertex and, next to it, one without a label; no others");
    for (const auto& normal : borrowed_normals(surface, alone))
        expect_that("there is no normal", !normal.has_value());
}

TEST_CASE("reach: a ring whose normals cancel is the last")
{
    const SurfaceTopology surface = strip(3);
    const std::vector<BuriedVertex> row = {{0, Vec3::UnitX(), regular},
                                           {2, Vec3::UnitY(), hooked},
                                           {4, Vec3(-1, 0, 0), regular},
                                           {6, Vec3::UnitY(), regular}};
    given("a row of four: regular (1, 0, 0), hooked, regular (-1, 0, 0), regular (0, 1, 0)");
    expect_that("the hooked one has no normal", !borrowed_normals(surface, row)[1].has_value());
}

}  // namespace enduring
