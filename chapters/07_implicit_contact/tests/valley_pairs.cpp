#include "chapters/07_implicit_contact/valley_pairs.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

constexpr double pi = std::numbers::pi;

/// The walls' normals of a right-angled valley along z whose bottom is the line x = y = 0.
const Vec3 left = Vec3(1, 1, 0).normalized(), right = Vec3(-1, 1, 0).normalized();

/// A vertex of a small wedge, tip down, over a fixed body with an edge along z at x = y = 0.
struct TipOver {
    World world;

    /// @param outline  of the fixed body
    /// @param tip      where the vertex is [m], and where the step takes it
    TipOver(const std::vector<std::array<double, 2>>& outline, const Vec3& tip,
            const Vec3& way = Vec3::Zero())
    {
        const SurfaceMesh ground = prism(outline, 2);
        SurfaceMesh wedge = prism({{0, 0}, {0.02, 0.1}, {-0.02, 0.1}}, 0.1);
        for (Vec3& x : wedge.vertices)
            x += tip - Vec3(0, 0, 0.05);
        world.bodies.push_back(std::make_unique<StaticBody>(
            "ground", SurfaceTopology(static_cast<int>(ground.vertices.size()), ground.faces),
            ground.vertices));
        world.bodies.push_back(
            std::make_unique<RigidBody>("wedge", wedge, with_mass(mass_properties(wedge, 1000), 1)));
        world.bodies[1]->predict(way / 1e-4, 0.01);
    }

    /// The vertex' pair with the face of this normal that is nearest to the foot.
    Contact pair(const Vec3& normal) const
    {
        Contact pair{ContactKind::vertex_face, 1, 0, 0, -1};
        const PairSurfaces surfaces(world, pair, 0);
        const SurfaceTopology& ground = world.bodies[0]->surface();
        double nearest = 1e9;
        for (int face = 0; face < static_cast<int>(ground.faces().size()); ++face)
            if (surfaces.b.face_normal(face).normalized().dot(normal) > 0.99) {
                const auto foot = foot_on_face(surfaces.a, 0, surfaces.b, face);
                if (overshoot(foot->weights) < nearest)
                    put_on_face(pair, ground, face, foot->weights);
                nearest = std::min(nearest, overshoot(foot->weights));
            }
        REQUIRE(pair.feature_b >= 0);
        pair.vertices[0] = 0;
        pair.weights[0] = 1;
        pair.category = ContactCategory::regular;
        return pair;
    }

    Vec3 normal(const Contact& pair) const
    {
        return surface_at(*world.bodies[0], 0).face_normal(pair.feature_b).normalized();
    }
};

const std::vector<std::array<double, 2>> valley{{0, 0}, {-1, 1}, {-2, 1}, {-2, -1}, {2, -1}, {2, 1}, {1, 1}},
    ridge{{0, 0}, {-1, -1}, {1, -1}};
/// Its walls are 33 degrees apart: one wall that bends.
const std::vector<std::array<double, 2>> flat{{0, 0},  {-1, 0.3}, {-2, 0.5}, {-2, -1},
                                              {2, -1}, {2, 0.5},  {1, 0.3}};

Contacts with_other_walls(const TipOver& at, const Contact& own)
{
    Contacts contacts{own};
    append_pairs_with_other_walls(at.world, contacts);
    return contacts;
}

}  // namespace

TEST_CASE("valley pairs: behind both walls a vertex has a pair with each, and no more if it is asked again")
{
    const TipOver at(valley, {0, -1e-3, 0});
    for (const auto& [own, other] : {std::pair(left, right), std::pair(right, left)}) {
        Contacts contacts = with_other_walls(at, at.pair(own));
        REQUIRE(contacts.size() == 2);
        CHECK(at.normal(contacts[1]).dot(other) == doctest::Approx(1));
        CHECK(contacts[1].feature_a == 0);
        CHECK(contacts[1].category == ContactCategory::regular);
        CHECK(contacts[1].waiting());
        append_pairs_with_other_walls(at.world, contacts);
        CHECK(contacts.size() == 2);
    }
}

TEST_CASE("valley pairs: in a corner of three walls the corner of a cube has a pair with each")
{
    const std::vector<Vec3> x{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 0}};
    const std::vector<Face> faces{{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 1}, {0, 3, 6}, {0, 6, 4}};
    SurfaceMesh cube = box(Vec3::Constant(0.1));
    int corner = 0;
    for (std::size_t i = 0; i < cube.vertices.size(); ++i) {
        cube.vertices[i] += Vec3::Constant(0.05 - 1e-3);
        corner = cube.vertices[i].maxCoeff() < 0 ? static_cast<int>(i) : corner;
    }
    World world;
    world.bodies.push_back(std::make_unique<StaticBody>("corner", SurfaceTopology(7, faces), x));
    world.bodies.push_back(
        std::make_unique<RigidBody>("cube", cube, with_mass(mass_properties(cube, 1000), 1)));
    world.bodies[1]->predict(Vec3::Zero(), 0.01);
    Contact own{ContactKind::vertex_face, 1, 0, corner, -1};
    own.vertices[0] = corner;
    own.weights[0] = 1;
    own.category = ContactCategory::regular;
    for (const int face : {0, 2, 5}) {
        const PairSurfaces surfaces(world, own, 0);
        put_on_face(own, world.bodies[0]->surface(), face,
                    foot_on_face(surfaces.a, corner, surfaces.b, face)->weights);
        Contacts contacts{own};
        append_pairs_with_other_walls(world, contacts);
        REQUIRE(contacts.size() == 3);
        Vec3 sum = Vec3::Zero();
        for (const Contact& contact : contacts)
            sum += surfaces.b.face_normal(contact.feature_b).normalized();
        CHECK((sum - Vec3::Ones()).norm() < 1e-12);
    }
}

TEST_CASE("valley pairs: a wall that the vertex does not reach in the step has none")
{
    const Vec3 on_left(-0.1, 0.1 - 1e-3, 0);  // 141 mm from the other wall
    for (const auto& expected : {std::pair(0.0, 1), {0.069, 1}, {0.073, 2}, {0.2, 2}}) {
        const double way = expected.first;
        CAPTURE(way);
        const TipOver at(valley, on_left, way * Vec3(1, -1, 0).normalized());
        CHECK(with_other_walls(at, at.pair(left)).size() == expected.second);
    }
}

TEST_CASE(
    "valley pairs: none over a ridge, none where the two faces are one wall, none for pairs that do not push")
{
    const TipOver at_ridge(ridge, {0, -1e-3, 0});
    CHECK(with_other_walls(at_ridge, at_ridge.pair(left)).size() == 1);
    const TipOver at(valley, {0, -1e-3, 0});
    const TipOver at_flat(flat, {0, -1e-3, 0});
    CHECK(with_other_walls(at_flat, at_flat.pair(Vec3(0.3, 1, 0).normalized())).size() == 1);
    for (const auto silence : {+[](Contact& c) { c.hold(true); }, +[](Contact& c) { c.resolved = true; },
                               +[](Contact& c) { c.category = ContactCategory::hooked; }}) {
        Contact own = at.pair(left);
        silence(own);
        CHECK(with_other_walls(at, own).size() == 1);
    }
}

TEST_CASE(
    "valley pairs: set aside, the list is as if there were none, and with its own pair a vertex loses all")
{
    const TipOver at(valley, {0, -1e-3, 0});
    const Contacts both = with_other_walls(at, at.pair(left));
    REQUIRE(both.size() == 2);
    for (const bool left_it : {false, true}) {
        Contacts contacts = both;
        ValleyPairs valleys;
        valleys.set_aside(contacts);
        REQUIRE(contacts.size() == 1);
        CHECK(contacts[0].feature_b == both[0].feature_b);
        contacts[0].resolved = left_it;
        valleys.put_back(contacts);
        CHECK(contacts.size() == (left_it ? 1 : 2));
    }
}

TEST_CASE(
    "valley pairs: what a spring holds stays with its wall when the vertex' own pair goes to another one")
{
    const TipOver at(valley, {0, -1e-3, 0});
    Contacts contacts = with_other_walls(at, at.pair(left));
    REQUIRE(contacts.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        contacts[i].stiffness = 100 + static_cast<double>(i);
        contacts[i].load = 10 + static_cast<double>(i);
        contacts[i].slack = -1e-4 * static_cast<double>(i + 1);
    }
    const Contacts before = contacts;
    for (const Vec3& own_now : {left, right}) {
        contacts = before;
        ValleyPairs valleys;
        valleys.set_aside(contacts);
        const Contact on = at.pair(own_now);  // chapter 6 hands the spring on, wherever the pair goes
        contacts[0].feature_b = on.feature_b;
        contacts[0].vertices = on.vertices;
        contacts[0].weights = on.weights;
        valleys.follow(at.world, contacts);
        REQUIRE(contacts.size() == 2);
        for (const Contact& contact : contacts) {
            const std::size_t was = at.normal(contact).dot(left) > 0.99 ? 0 : 1;
            CHECK(contact.stiffness == before[was].stiffness);
            CHECK(contact.load == before[was].load);
            CHECK(contact.slack == before[was].slack);
        }
    }
}

namespace {

int far_corner(const Face& face, const Edge& edge)
{
    return *std::find_if(face.begin(), face.end(),
                         [&](int vertex) { return vertex != edge[0] && vertex != edge[1]; });
}

/// Six times the volume of the tetrahedron that an edge of a solid spans with the far corners of its two faces: positive
/// where the edge is convex.
double spanned_volume(const Body& body, int edge)
{
    const SurfaceTopology& surface = body.surface();
    const Edge ends = surface.edges()[static_cast<std::size_t>(edge)];
    const auto faces = surface.faces_at_edge(edge);
    const Face &one = surface.faces()[static_cast<std::size_t>(faces[0])],
               &other = surface.faces()[static_cast<std::size_t>(faces[1])];
    const Vec3 x = body.position(ends[0], 0), along = body.position(ends[1], 0) - x;
    const Vec3 to_one = body.position(far_corner(one, ends), 0) - x,
               to_other = body.position(far_corner(other, ends), 0) - x;
    const auto at = static_cast<std::size_t>(std::find(one.begin(), one.end(), ends[0]) - one.begin());
    return (one[(at + 1) % 3] == ends[1] ? 1 : -1) * along.dot(to_other.cross(to_one));
}

int first_convex_edge(const Body& body)
{
    int edge = 0;
    while (spanned_volume(body, edge) < 1e-9)
        ++edge;
    return edge;
}

}  // namespace

TEST_CASE("valley pairs: concave edges have no pairs, however shallow, and all convex ones have")
{
    for (const auto& outline : {valley, ridge, flat}) {
        const TipOver at(outline, {0, 1, 0});
        const Body &ground = *at.world.bodies[0], &wedge = *at.world.bodies[1];
        const int of_wedge = first_convex_edge(wedge);
        const Edge w = wedge.surface().edges()[static_cast<std::size_t>(of_wedge)];
        for (int edge = 0; edge < static_cast<int>(ground.surface().edges().size()); ++edge) {
            const Edge e = ground.surface().edges()[static_cast<std::size_t>(edge)];
            Contacts contacts{{ContactKind::edge_edge, 0, 1, edge, of_wedge, {e[0], e[1], w[0], w[1]}},
                              {ContactKind::edge_edge, 1, 0, of_wedge, edge, {w[0], w[1], e[0], e[1]}}};
            drop_what_cannot_touch(at.world, contacts);
            const double volume = spanned_volume(ground, edge);
            if (std::abs(volume) > 1e-9)
                CHECK(contacts.size() == (volume > 0 ? 2U : 0U));
        }
    }
}

TEST_CASE(
    "valley pairs: a vertex in the hollow of a bowl has none, those outside and those of flat sides have")
{
    const BowlShape shape;
    const auto pairs_kept = [](const SurfaceMesh& mesh, const auto& asked) {
        World world;
        world.bodies.push_back(std::make_unique<StaticBody>(
            "mesh", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
        Contacts contacts;
        for (int vertex = 0; vertex < static_cast<int>(mesh.vertices.size()); ++vertex)
            if (asked(mesh.vertices[static_cast<std::size_t>(vertex)]))
                contacts.push_back({ContactKind::vertex_face, 0, 0, vertex, 0});
        const auto all = static_cast<double>(contacts.size());
        drop_what_cannot_touch(world, contacts);
        return static_cast<double>(contacts.size()) / all;
    };
    const double hollow = shape.inner_radius + 1e-6, below_rim = -0.3;
    CHECK(pairs_kept(bowl(shape), [&](const Vec3& x) { return x.norm() < hollow && x.y() < below_rim; }) ==
          0);
    CHECK(pairs_kept(bowl(shape), [&](const Vec3& x) { return x.norm() > hollow; }) == 1);
    CHECK(pairs_kept(box(Vec3::Ones(), {3, 3, 3}), [](const Vec3&) { return true; }) == 1);
}

TEST_CASE("valley pairs: tips of any angle come to rest in wider cracks, and pass neither wall")
{
    std::mt19937 random(3);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int trial = 0; trial < 6; ++trial) {
        const double crack = between(62, 88),
                     tip = between(10, crack - 20);  // friction alone holds no tip there
        CAPTURE(crack);
        CAPTURE(tip);
        Scene scene = tip_in_crack(Tip::wedge, tip, crack, trial % 2 == 0 ? 0.01 : 1.0 / 60);
        const PileOutcome outcome = watch(scene, 6);
        double behind = 0;
        for (const Vec3& x : scene.world.bodies[1]->positions_t0())
            behind = std::max(behind, std::abs(x.x()) * std::cos(0.5 * crack * pi / 180) -
                                          x.y() * std::sin(0.5 * crack * pi / 180));
        CHECK(behind < 2e-5);
        CHECK(outcome.energy_gain_j <= 1e-9);
        CHECK(outcome.drift_um_per_s < 1);
    }
}
