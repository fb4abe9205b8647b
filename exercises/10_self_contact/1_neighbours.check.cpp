#include "exercises/10_self_contact/1_neighbours.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/surface_topology.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "exercises/checking.hpp"

#include <numbers>
#include <set>

using namespace enduring;

namespace {

/// A soft body of tetrahedra at rest, its surface's vertices first.
SoftShape soft_shape(const TetrahedralMesh& mesh)
{
    const ExtractedSurface surface = surface_of(mesh);
    std::vector<int> place(mesh.nodes.size(), -1);
    SoftShape shape;
    for (const int node : surface.nodes)
        place[node] = shape.surface_vertices++;
    int next = shape.surface_vertices;
    for (int& of_node : place)
        if (of_node < 0)
            of_node = next++;
    shape.rest.resize(mesh.nodes.size());
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
        shape.rest[place[node]] = mesh.nodes[node];
    shape.now = shape.rest;
    shape.faces = surface.mesh.faces;
    const SurfaceTopology topology(shape.surface_vertices, surface.mesh.faces);
    shape.edges.assign(topology.edges().begin(), topology.edges().end());
    std::set<std::array<int, 2>> bonds;
    for (const auto& element : mesh.elements)
        for (const auto& [i, j] : tetrahedron_edges) {
            const auto [low, high] = std::minmax(place[element[i]], place[element[j]]);
            bonds.insert({low, high});
        }
    shape.bonds.assign(bonds.begin(), bonds.end());
    return shape;
}

/// The vertex of the surface that is nearest to a place at rest.
int vertex_at(const SoftShape& shape, const Vec3& place)
{
    int nearest = 0;
    for (int v = 1; v < shape.surface_vertices; ++v)
        if ((shape.rest[v] - place).norm() < (shape.rest[nearest] - place).norm())
            nearest = v;
    return nearest;
}

/// A wall of cells of 0.1 m, so thick, in the plane z = 0.
SoftShape wall(double thickness, int cells_through = 1)
{
    return soft_shape(bar({0.6, 0.4, thickness}, {6, 4, cells_through}));
}

/// A plate that is bent at rest to two walls, upwards from a bend, so far apart from middle to middle.
SoftShape two_walls(double apart)
{
    TetrahedralMesh mesh = bar({1, 0.05, 0.2}, {10, 1, 2});
    for (Vec3& x : mesh.nodes)
        if (std::abs(x.x()) > 0.05)
            x = Vec3(x.x() < 0 ? x.y() - apart / 2 : apart / 2 - x.y(), std::abs(x.x()), x.z());
    return soft_shape(mesh);
}

/// A straight strip that is bent now, by the angle over its length, and lies straight at rest.
SoftShape bent_strip(double angle)
{
    constexpr double length = 0.6;
    SoftShape shape = soft_shape(bar({length, 0.02, 0.06}, {12, 1, 1}));
    const double radius = length / angle;
    for (Vec3& x : shape.now) {
        const double turned = x.x() / radius;
        x = Vec3((radius - x.y()) * std::sin(turned), radius - (radius - x.y()) * std::cos(turned), x.z());
    }
    return shape;
}

bool share(std::span<const int> one, std::span<const int> other, const Neighbours& neighbours)
{
    bool found = false;
    for (const int u : one)
        for (const int v : other)
            found = found || neighbours[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)];
    return found;
}

/// A table in which only a vertex is its own neighbour, and those that are named.
Neighbours table_with(int vertices, const std::vector<std::array<int, 2>>& more = {})
{
    const auto count = static_cast<std::size_t>(vertices);
    Neighbours table(count, std::vector<bool>(count));
    for (std::size_t v = 0; v < count; ++v)
        table[v][v] = true;
    for (const auto& [u, v] : more)
        table[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)] =
            table[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)] = true;
    return table;
}

/// Two triangles above each other, by a gap; they share nothing.
SoftShape two_triangles(double gap)
{
    SoftShape shape;
    shape.rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, gap}, {1, 0, gap}, {0, 1, gap}};
    shape.now = shape.rest;
    shape.surface_vertices = 6;
    shape.faces = {{0, 1, 2}, {3, 5, 4}};
    shape.edges = {{0, 1}, {0, 2}, {1, 2}, {3, 4}, {3, 5}, {4, 5}};
    shape.bonds = shape.edges;
    return shape;
}

}  // namespace

TEST_CASE("neighbours: a vertex itself, and the two ends of each edge")
{
    const SoftShape shape = wall(0.1);
    const Neighbours table = find_neighbours(shape);
    given("a wall of cells of 0.1 m, one cell thick");
    REQUIRE(table.size() == static_cast<std::size_t>(shape.surface_vertices));
    bool itself = true, ends = true;
    for (int v = 0; v < shape.surface_vertices; ++v)
        itself = itself && table[v][v];
    for (const auto& [u, v] : shape.edges)
        ends = ends && table[u][v] && table[v][u];
    expect_that("each vertex is a neighbour of itself", itself);
    expect_that("the ends of each edge are neighbours, asked from either end", ends);
}

TEST_CASE("neighbours: through a thin wall they are, many edges apart along the surface")
{
    for (const int cells : {1, 2}) {
        const SoftShape shape = wall(0.05, cells);
        const Neighbours table = find_neighbours(shape);
        const int front = vertex_at(shape, {0, 0, 0.025}), back = vertex_at(shape, {0, 0, -0.025}),
                  far = vertex_at(shape, {0.3, 0, -0.025});
        given("a wall of cells of 0.1 m, 5 cm thick, with ", cells, " cells through its thickness");
        expect_that("the middles of its two sides are neighbours", table[front][back]);
        expect_that("the middle of the one side and an end of the other are none", !table[front][far]);
    }
    const SoftShape thick = wall(0.4);
    given("a wall of cells of 0.1 m, 40 cm thick with one cell");
    const Neighbours table = find_neighbours(thick);
    const int front = vertex_at(thick, {0, 0, 0.2});
    expect_that("what is 30 cm apart along its side is no neighbour: none of its longest edges lies there",
                !table[vertex_at(thick, {-0.3, 0.2, 0.2})][vertex_at(thick, {0.3, -0.2, 0.2})]);
    expect_that("the middle is a neighbour of itself", table[front][front]);
}

TEST_CASE("neighbours: two walls that are near through the air are none")
{
    const SoftShape shape = two_walls(0.12);
    const Neighbours table = find_neighbours(shape);
    const int left = vertex_at(shape, {-0.035, 0.5, 0}), right = vertex_at(shape, {0.035, 0.5, 0}),
              outside = vertex_at(shape, {-0.085, 0.5, 0});
    given("two walls of 5 cm that hang together at their foot, half a metre below, 7 cm apart");
    expect_that("vertices at their tops, 7 cm apart through the air, are no neighbours", !table[left][right]);
    expect_that("the two sides of one of them are", table[left][outside]);
    int pairs = 0;
    for (const bool one_side : table[left])
        pairs += one_side;
    say("two walls: a vertex at the top has ", pairs - 1, " neighbours, none of them in the other wall");
}

TEST_CASE("neighbours: the longest edge of either end counts")
{
    // A long triangle and a small one, at a common vertex 0; vertex 4 has short edges only.
    SoftShape shape;
    shape.rest = {{0, 0, 0},       {1, 0, 0},      {0, 1, 0},     {-0.1, 0, 0},
                  {-0.1, -0.1, 0}, {0.5, -0.1, 0}, {0.5, -0.2, 0}};
    shape.now = shape.rest;
    shape.surface_vertices = 7;
    shape.faces = {{0, 1, 2}, {0, 3, 4}, {5, 1, 6}};
    shape.edges = {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {0, 4}, {3, 4}, {1, 5}, {1, 6}, {5, 6}};
    shape.bonds = shape.edges;
    const Neighbours table = find_neighbours(shape);
    given("vertex 2 has an edge of 1.41 m; vertex 4 is 1.1 m away and has edges of at most 0.14 m");
    expect_that("2 and 4 are neighbours", table[2][4]);
    expect_that("4 and 2 are neighbours", table[4][2]);
    given("vertices 0 and 1 are 1 m apart, and the ends of an edge; later edges at both of them are shorter");
    expect_that("0 and 1 are neighbours", table[0][1] && table[1][0]);
    given("vertices 4 and 5, 0.6 m apart; 4 has short edges, and 5 one of 0.51 m");
    expect_that("4 and 5 are none", !table[4][5] && !table[5][4]);
}

TEST_CASE("neighbours: without bonds there are none, and a path has at most twice the longest edge of all")
{
    SoftShape shape = two_triangles(0.3);
    given("two triangles of 1 m, 30 cm above each other, and no bond between them");
    expect_that("no vertex of the one is a neighbour of one of the other", !find_neighbours(shape)[0][3]);
    // A chain of two bonds over an inner vertex joins them; the longest edge has 1.414 m.
    for (const double height : {1.3, 1.5}) {
        SoftShape joined = shape;
        joined.rest.push_back({-std::sqrt(height * height - 0.15 * 0.15), 0, 0.15});
        joined.now = joined.rest;
        joined.bonds.push_back({0, 6});
        joined.bonds.push_back({3, 6});
        given("the same, and a path of ", 2 * height, " m over a vertex inside; the longest edge has 1.41 m");
        expect_that(height < 1.4 ? "vertices 0 and 3 are neighbours" : "vertices 0 and 3 are none",
                    find_neighbours(joined)[0][3] == (height < 1.4));
    }
}

TEST_CASE("neighbours: they are those of the shape at rest, however it lies now")
{
    const Neighbours straight = find_neighbours(bent_strip(1e-3)),
                     bent = find_neighbours(bent_strip(1.9 * std::numbers::pi));
    given("a strip that is bent to nearly a ring, and the same strip straight");
    expect_that("the tables are the same", straight == bent);
    SoftShape blown_up = wall(0.05);
    const Neighbours at_rest = find_neighbours(blown_up);
    for (const double size : {10.0, 0.1}) {
        for (std::size_t v = 0; v < blown_up.now.size(); ++v)
            blown_up.now[v] = size * blown_up.rest[v];
        given("a wall that is now ", size, " times as large as at rest");
        expect_that("the tables are the same", find_neighbours(blown_up) == at_rest);
    }
    const SoftShape strip = bent_strip(1.9 * std::numbers::pi);
    expect_that("its two ends are no neighbours, although they nearly touch",
                !bent[vertex_at(strip, {-0.3, 0, 0})][vertex_at(strip, {0.3, 0, 0})]);
}

TEST_CASE("pairs: by hand, two triangles above each other")
{
    const SoftShape shape = two_triangles(0.3);
    given("two triangles, 30 cm above each other, no neighbours, and a margin of 20 cm");
    const FoundPairs near = find_own_pairs(shape, table_with(6), 0.2);
    expect("pairs of a vertex and a face", near.vertex_face.size(), 6, 0);
    expect("pairs of edges", near.edge_edge.size(), 9, 0);
    given("the same, and a margin of 10 cm");
    const FoundPairs far = find_own_pairs(shape, table_with(6), 0.1);
    expect("pairs", far.vertex_face.size() + far.edge_edge.size(), 0, 0);
}

TEST_CASE("pairs: one vertex that is a neighbour suffices, whichever corner it is")
{
    const SoftShape shape = two_triangles(0.3);
    for (int corner = 0; corner < 3; ++corner)
        for (int other = 3; other < 6; ++other) {
            const Neighbours table = table_with(6, {{corner, other}});
            const FoundPairs pairs = find_own_pairs(shape, table, 0.2);
            given("two triangles, 30 cm above each other; vertices ", corner, " and ", other,
                  " are neighbours");
            expect("pairs of a vertex and a face", pairs.vertex_face.size(), 4, 0);
            expect("pairs of edges", pairs.edge_edge.size(), 5, 0);
        }
}

TEST_CASE("pairs: each once, the smaller edge first, in ascending order")
{
    const SoftShape shape = bent_strip(1.98 * std::numbers::pi);
    const FoundPairs pairs = find_own_pairs(shape, table_with(shape.surface_vertices), 0.03);
    given("a strip that is bent to nearly a ring, margin 3 cm");
    expect_that("there are pairs", pairs.vertex_face.size() > 100 && pairs.edge_edge.size() > 100);
    bool smaller_first = true;
    for (const auto& [edge, other] : pairs.edge_edge)
        smaller_first = smaller_first && edge < other;
    expect_that("the smaller edge comes first, and no edge meets itself", smaller_first);
    for (const auto* list : {&pairs.vertex_face, &pairs.edge_edge})
        expect_that("they ascend, none of them twice",
                    std::is_sorted(list->begin(), list->end()) &&
                        std::adjacent_find(list->begin(), list->end()) == list->end());
}

TEST_CASE("pairs: they are where features lie now, and as many as one finds by asking each pair")
{
    for (const double angle : {1e-3, 1.0, 1.95 * std::numbers::pi, 2.1 * std::numbers::pi}) {
        const SoftShape shape = bent_strip(angle);
        const Neighbours table = find_neighbours(shape);
        const FoundPairs pairs = find_own_pairs(shape, table, 0.01);
        std::size_t vertex_face = 0, edge_edge = 0;
        for (int v = 0; v < shape.surface_vertices; ++v)
            for (const auto& face : shape.faces)
                vertex_face += are_near(shape, {&v, 1}, face, 0.01) && !share({&v, 1}, face, table);
        for (std::size_t e = 0; e < shape.edges.size(); ++e)
            for (std::size_t g = 0; g < e; ++g)
                edge_edge += are_near(shape, shape.edges[e], shape.edges[g], 0.01) &&
                             !share(shape.edges[e], shape.edges[g], table);
        given("a strip, straight at rest, that is bent by ", angle, " rad over its length now");
        expect("pairs of a vertex and a face", pairs.vertex_face.size(), vertex_face, 0);
        expect("pairs of edges", pairs.edge_edge.size(), edge_edge, 0);
        if (angle < 2)
            expect("pairs of a strip that does not meet itself",
                   pairs.vertex_face.size() + pairs.edge_edge.size(), 0, 0);
        else
            expect_that("the ends that lie on each other have some", vertex_face + edge_edge > 0);
        if (angle > 6)
            say("a strip bent by ", angle, " rad: ", pairs.vertex_face.size(),
                " pairs of a vertex and a face, ", pairs.edge_edge.size(), " of edges");
    }
}
