#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/new_pairs.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <set>

using namespace enduring;
using namespace enduring::small_worlds;

namespace {

/// Two triangles: body 0 looks down with an edge from (0, 0, 0) to (1, 0, 0), moved by `offset`; body 1 lies
/// in y = 0, looks up, and has an edge along z through x = 0.5.
World crossing_edges(const Vec3& offset)
{
    World world;
    world.gravity.setZero();
    std::vector<Vec3> above{{0, 0, 0}, {1, 0, 0}, {0.5, 0, -1}};
    for (Vec3& x : above)
        x += offset;
    world.bodies.push_back(still("above", {above, {{0, 2, 1}}}));  // looks down
    world.bodies.push_back(still("below", {{{0.5, 0, -0.5}, {0.5, 0, 0.5}, {1.5, 0, 0}}, {{0, 1, 2}}}));
    return world;
}

int edge_between(const Body& body, int v, int w)
{
    const auto edges = body.surface().edges();
    const auto found = std::find(edges.begin(), edges.end(), Edge{std::min(v, w), std::max(v, w)});
    return static_cast<int>(found - edges.begin());
}

Contact pair_in(const World& world)
{
    return {ContactKind::edge_edge,
            0,
            1,
            edge_between(*world.bodies[0], 0, 1),
            edge_between(*world.bodies[1], 0, 1),
            {0, 1, 0, 1},
            {},
            -1};
}

/// The pair after the pass, with the upper edge moved by `offset`.
Contact dismissed(const Vec3& offset)
{
    const World world = crossing_edges(offset);
    Contacts contacts{pair_in(world)};
    dismiss_enduring_edges(world, contacts);
    return contacts[0];
}

}  // namespace

TEST_CASE(
    "edges: a pair pushes while both feet are on their edges, is held a little beyond, and dismissed farther out")
{
    // The lower edge crosses the upper one at s = 0.5 - x, and is crossed at t = 0.5 + z.
    const double small = 1e-9;
    struct Case {
        double x, z;
        bool held, gone;
    };
    for (const Case& c : {Case{0.5 - small, 0, false, false}, Case{0.5 + small, 0, true, false},
                          Case{0.8 - small, 0, true, false}, Case{0.8 + small, 0, true, true},
                          Case{-0.5 + small, 0, false, false}, Case{-0.5 - small, 0, true, false},
                          Case{-0.8 - small, 0, true, true}, Case{0, 0.5 - small, false, false},
                          Case{0, 0.5 + small, true, false}, Case{0, 0.8 + small, true, true},
                          Case{0, -0.8 + small, true, false}, Case{0, -0.8 - small, true, true}}) {
        CAPTURE(c.x);
        CAPTURE(c.z);
        const Contact contact = dismissed({c.x, -0.01, c.z});
        CHECK(contact.resolved == c.gone);
        CHECK(contact.held() == c.held);
        CHECK(contact.weights[1] == doctest::Approx(0.5 - c.x));
        CHECK(contact.weights[3] == doctest::Approx(-(0.5 + c.z)));
    }
}

TEST_CASE("edges: a pair whose depth has become positive is resolved")
{
    CHECK_FALSE(dismissed({0, -1e-9, 0}).resolved);
    CHECK(dismissed({0, 1e-9, 0}).resolved);
}

TEST_CASE("edges: two edges that have become parallel are held, for nothing says which way is out")
{
    World world = crossing_edges({0, -0.01, 0});
    Contact contact = pair_in(world);
    // The lower triangle's edge from (0.5, 0, 0.5) to (1.5, 0, 0), turned to run along x.
    world.bodies[1] = still("below", {{{0.2, 0, 0.05}, {0.8, 0, 0}, {0.5, 0, 1}}, {{0, 2, 1}}});
    Contacts contacts{contact};
    dismiss_enduring_edges(world, contacts);
    CHECK(contacts[0].held());
    CHECK_FALSE(contacts[0].resolved);
}

namespace {

/// crossing_edges with the upper triangle turned over: it looks up,
/// so a push upwards is along its own surface.
World hooked_edges()
{
    World world = crossing_edges(Vec3::Zero());
    world.bodies[0] = still("above", {{{0, -0.01, 0}, {1, -0.01, 0}, {0.5, -0.01, -1}}, {{0, 1, 2}}});
    return world;
}

/// What the hand-over of a vertex brings, from a face to itself: all
/// edges at the vertex against all of the face.
Contacts brought_by(const Redefinition& redefinition)
{
    Contacts contacts;
    append_edge_pairs(crossing_edges({0, -0.01, 0}), {redefinition}, 0, contacts);
    return contacts;
}

}  // namespace

TEST_CASE("edges: a hooked pair is held, and one that is hooked at its entry does not come in")
{
    const World world = hooked_edges();
    Contacts contacts{pair_in(world)};
    dismiss_enduring_edges(world, contacts);
    CHECK(contacts[0].held());
    CHECK_FALSE(contacts[0].resolved);
    CHECK(contacts[0].category == ContactCategory::hooked);

    Redefinitions redefinitions;
    Contacts entries{pair_in(world)};
    label_new_contacts(world, entries);
    admit_new_pairs(world, entries, 0, redefinitions);
    CHECK(entries.empty());
    const World regular = crossing_edges({0, -0.01, 0});
    entries = {pair_in(regular)};
    label_new_contacts(regular, entries);
    admit_new_pairs(regular, entries, 0, redefinitions);
    CHECK(entries.size() == 1);
}

TEST_CASE(
    "edges: the pairs that a vertex brings push from when its own pair does, out of the body that they name second")
{
    const Contacts of_a = brought_by({0, 0, 1, 0, 0, Vec3::UnitY(), 0.4}),
                   of_b = brought_by({1, 0, 0, 0, 0, -Vec3::UnitY(), 0.4});
    const World world = crossing_edges({0, -0.01, 0});
    for (const Contacts* brought : {&of_a, &of_b}) {
        REQUIRE(brought->size() > 0);
        for (const Contact& pair : *brought) {
            CHECK(pair.start == 0.4);
            CHECK(pair.body_a == 0);
            CHECK(contact_geometry(world, pair, 0).normal.y() == doctest::Approx(1));
            CHECK(contact_geometry(world, pair, 0).depth == doctest::Approx(-0.01));
        }
    }
    // Their normals stand at 53 degrees to this one.
    CHECK(brought_by({0, 0, 1, 0, 0, Vec3(0.8, 0.6, 0), 0.4}).empty());
}

namespace {

/// A box that slides over a floor: body 0 the floor with cells of 0.1 m,
/// body 1 the box, its bottom 1 mm below the floor.
World sliding_box(const Vec3& velocity)
{
    World world;
    world.gravity.setZero();
    SurfaceMesh mesh = box({0.37, 0.2, 0.33});
    for (Vec3& x : mesh.vertices)
        x += Vec3(0.011, 0.1 + 1e-9, 0.017);
    world.bodies.push_back(still("floor", plane_grid(2, 2, {20, 20})));
    world.bodies.push_back(std::make_unique<PointMasses>("box", mesh.vertices, mesh.faces, 1, velocity));
    return world;
}

struct Coverage {
    long crossing = 0;  ///< floor edges that cross an edge of the box's bottom, seen from above
    long missing = 0;   ///< of those without a pair that pushed
};

/// Seen from above: where two segments cross, by signs of areas. Nothing of the layer's own projection.
bool cross_in_plan(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s)
{
    const auto side = [](const Vec3& from, const Vec3& to, const Vec3& x) {
        return (to.x() - from.x()) * (x.z() - from.z()) - (to.z() - from.z()) * (x.x() - from.x());
    };
    return side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
}

bool pushed(const Contacts& contacts, int edge_a, int edge_b)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
        return c.kind == ContactKind::edge_edge && c.answered() && c.feature_a == edge_a &&
               c.feature_b == edge_b;
    });
}

/// Counts, for where the box was at the start of the step just taken, what pushed in it.
void count(const World& world, const std::vector<Vec3>& x, const Contacts& contacts, Coverage& coverage)
{
    const Body &floor = *world.bodies[0], &box_body = *world.bodies[1];
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    for (int b = 0; b < static_cast<int>(box_body.surface().edges().size()); ++b) {
        const auto [b0, b1] = box_body.surface().edges()[at(b)];
        const bool along_axis = std::abs(x[at(b0)].x() - x[at(b1)].x()) < 1e-12 ||
                                std::abs(x[at(b0)].z() - x[at(b1)].z()) < 1e-12;
        // only the bottom's sides, not its diagonal
        if (x[at(b0)].y() > 0 || x[at(b1)].y() > 0 || !along_axis)
            continue;
        for (int a = 0; a < static_cast<int>(floor.surface().edges().size()); ++a) {
            const auto [a0, a1] = floor.surface().edges()[at(a)];
            if (!cross_in_plan(floor.positions_t0()[at(a0)], floor.positions_t0()[at(a1)], x[at(b0)],
                               x[at(b1)]))
                continue;
            ++coverage.crossing;
            coverage.missing += !pushed(contacts, a, b);
        }
    }
}

/// Slides the box over five cells; without the edge pairs of vertices that leave, if asked.
Coverage coverage_of(const Vec3& velocity, bool with_exits)
{
    World world = sliding_box({0, -0.1, 0});
    Solver solver = weak_solver();
    if (!with_exits)
        solver.remove("edge pairs of exits");
    Contacts contacts;
    advance(world, contacts, solver, 0.01);  // down by 1 mm
    turn_to(world, velocity);
    Coverage coverage;
    for (int step = 0; step < 100; ++step) {
        const std::vector<Vec3> before(world.bodies[1]->positions_t0().begin(),
                                       world.bodies[1]->positions_t0().end());
        advance(world, contacts, solver, 0.01);
        count(world, before, contacts, coverage);
    }
    return coverage;
}

}  // namespace

TEST_CASE(
    "edges: an edge that slides over a floor always has its pairs, and a trailing one only if vertices that leave bring them")
{
    for (const Vec3& velocity :
         {Vec3(0.5, 0, 0), Vec3(0, 0, -0.5), Vec3(-0.47, 0, 0.31), Vec3(0.3, 0, 0.5)}) {
        CAPTURE(velocity.transpose());
        const Coverage with = coverage_of(velocity, true), without = coverage_of(velocity, false);
        REQUIRE(with.crossing > 1000);
        CHECK(static_cast<double>(with.missing) < 0.01 * static_cast<double>(with.crossing));
        CHECK(static_cast<double>(without.missing) > 0.05 * static_cast<double>(without.crossing));
    }
}

TEST_CASE(
    "edges: no pair stands twice in the list, and all are oriented out of the body that they name second")
{
    World world = sliding_box({0, -0.1, 0});
    Solver solver = weak_solver();
    Contacts contacts;
    advance(world, contacts, solver, 0.01);
    turn_to(world, {0.4, 0, 0.3});
    for (int step = 0; step < 50; ++step) {
        advance(world, contacts, solver, 0.01);
        std::set<std::array<int, 5>> keys;
        for (const Contact& c : contacts) {
            if (c.resolved)
                continue;
            // one face a vertex and body
            const int face_or_edge = c.kind == ContactKind::edge_edge ? c.feature_b : -1;
            CHECK(keys.insert({static_cast<int>(c.kind), c.body_a, c.body_b, c.feature_a, face_or_edge})
                      .second);
            if (c.kind == ContactKind::edge_edge && c.answered())
                // out of the box, body 1, down into the floor
                CHECK(contact_geometry(world, c, 0).normal.y() == doctest::Approx(-1));
        }
    }
}
