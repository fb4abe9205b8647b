#include "chapters/07_implicit_contact/rim_pairs.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

constexpr double beyond = 1e-5;
const StiffnessChoice choice{.wanted_depth = beyond};

/// A cube of 1 m, whose corner lies beside or below the rim of the upper face of a block that stands still.
struct Rim {
    World world;
    Contact pair;

    /// @param aside  how far the corner is outside the rim [m]
    /// @param depth  of the corner below the upper face, negative inside [m]
    Rim(double aside, double depth)
    {
        world.gravity.setZero();
        SurfaceMesh block = box({1, 1, 1}), cube = box({1, 1, 1});
        for (Vec3& x : block.vertices)
            x -= Vec3(0.5, 0.5, 0);  // its upper face is y = 0, its rim x = 0
        const auto lowest = std::find_if(cube.vertices.begin(), cube.vertices.end(),
                                         [](const Vec3& x) { return x.x() < 0 && x.y() < 0 && x.z() < 0; });
        const int corner = static_cast<int>(lowest - cube.vertices.begin());
        const Vec3 to = Vec3(aside, depth, 0.1) - *lowest;
        for (Vec3& x : cube.vertices)
            x += to;
        world.bodies.push_back(std::make_unique<StaticBody>(
            "block", SurfaceTopology(static_cast<int>(block.vertices.size()), block.faces), block.vertices));
        world.bodies.push_back(std::make_unique<RigidBody>("cube", cube, mass_properties(cube, 1000)));
        for (const auto& body : world.bodies)
            body->predict(Vec3::Zero(), 0.01);
        pair = pair_with_rim(block, corner);
    }

    /// With the triangle of the upper face that has the rim as its border.
    static Contact pair_with_rim(const SurfaceMesh& block, int corner)
    {
        for (int face = 0; face < static_cast<int>(block.faces.size()); ++face) {
            const Face& corners = block.faces[static_cast<std::size_t>(face)];
            const auto at = [&](int i) { return block.vertices[static_cast<std::size_t>(i)]; };
            const bool is_above = std::all_of(corners.begin(), corners.end(),
                                              [&](int i) { return at(i).y() > -1e-9; });
            if (is_above && std::count_if(corners.begin(), corners.end(),
                                          [&](int i) { return at(i).x() > -1e-9; }) == 2) {
                Contact pair{ContactKind::vertex_face, 1, 0, corner, face};
                pair.vertices = {corner, corners[0], corners[1], corners[2]};
                pair.category = ContactCategory::regular;
                return pair;
            }
        }
        FAIL("the upper face has no triangle at the rim");
        return {};
    }
};

Contact resolved(Contact pair)
{
    pair.resolved = true;
    return pair;
}

/// Whether a pair goes on that has been resolved at this place.
bool goes_on(double aside, double depth)
{
    const Rim rim(aside, depth);
    Contacts contacts{resolved(rim.pair)};
    RimPairs().keep(rim.world, {rim.pair}, choice, contacts);
    return !contacts[0].resolved;
}

}  // namespace

TEST_CASE(
    "rim pairs: a vertex that has slipped over the rim by a hair keeps its pair, one farther out or above the face does not")
{
    for (const double depth : {-1e-3, -1e-5, -1e-9})
        for (const double aside : {1e-15, 1e-9, 0.999 * beyond})
            CHECK(goes_on(aside, depth));
    CHECK_FALSE(goes_on(1.001 * beyond, -1e-5));
    CHECK_FALSE(goes_on(0.1, -1e-5));
    CHECK_FALSE(goes_on(1e-9, 0));
    CHECK_FALSE(goes_on(1e-9, 1e-9));
}

TEST_CASE("rim pairs: a pair that was held, is hooked or has entered in this step ends with its resolution")
{
    const Rim rim(1e-9, -1e-5);
    Contact held = rim.pair, hooked = rim.pair, entered = rim.pair;
    held.hold(true);
    hooked.category = ContactCategory::hooked;
    entered.start = 0.5;
    for (const Contact& before : {held, hooked, entered}) {
        Contacts contacts{resolved(before)};
        RimPairs().keep(rim.world, {before}, choice, contacts);
        CHECK(contacts[0].resolved);
    }
}

TEST_CASE(
    "rim pairs: what is outside ends when it goes farther, without a further passage; what never left is not asked")
{
    const Rim near(1e-9, -1e-5), far(1e-3, -1e-5);
    RimPairs rims;
    Contacts contacts{resolved(near.pair)};
    rims.keep(near.world, {near.pair}, choice, contacts);
    REQUIRE_FALSE(contacts[0].resolved);
    for (int step = 0; step < 3; ++step) {
        const Contacts before = contacts;
        rims.keep(near.world, before, choice, contacts);
        CHECK_FALSE(contacts[0].resolved);
    }
    Contacts never_left = contacts;
    rims.keep(far.world, Contacts(contacts), choice, contacts);
    CHECK(contacts[0].resolved);
    RimPairs().keep(far.world, Contacts(never_left), choice, never_left);
    CHECK_FALSE(never_left[0].resolved);
}

TEST_CASE("rim pairs: a vertex that left and came back within a step has one pair, its old one")
{
    const Rim rim(-1e-9, -1e-5);
    Contact new_one = rim.pair, other = rim.pair;
    new_one.start = 0.4;
    other.feature_a = rim.pair.feature_a == 0 ? 1 : 0;
    Contacts contacts{resolved(rim.pair), new_one, other};
    RimPairs().keep(rim.world, {rim.pair}, choice, contacts);
    REQUIRE(contacts.size() == 2);
    CHECK_FALSE(contacts[0].resolved);
    CHECK(contacts[0].start == 0);
    CHECK(contacts[1].feature_a == other.feature_a);
}

/// An edge of this body that has this direction, or its opposite.
int edge_along(const Body& body, const Vec3& direction)
{
    const auto& edges = body.surface().edges();
    const auto at = [&](int i) { return body.positions_t0()[static_cast<std::size_t>(i)]; };
    const auto found = std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) {
        return (at(edge[1]) - at(edge[0])).normalized().cross(direction).norm() < 1e-9;
    });
    REQUIRE(found != edges.end());
    return static_cast<int>(found - edges.begin());
}

/// Whether a pair of the cube's edge along x, which is held now, goes on to push.
/// @param along_b   direction of the block's edge
/// @param past_end  by which the foot is beyond the second end of the cube's edge, or if negative the first [m]
/// @param pushed    before the step
bool pushes_past_end(const Vec3& along_b, double past_end, bool pushed)
{
    const Rim rim(0, -1e-5);
    const Body &cube = *rim.world.bodies[1], &block = *rim.world.bodies[0];
    Contact before{ContactKind::edge_edge, 1, 0, edge_along(cube, Vec3::UnitX()), edge_along(block, along_b)};
    const Edge a = cube.surface().edges()[static_cast<std::size_t>(before.feature_a)],
               b = block.surface().edges()[static_cast<std::size_t>(before.feature_b)];
    before.vertices = {a[0], a[1], b[0], b[1]};
    before.category = ContactCategory::regular;
    Contact now = before;
    before.hold(!pushed);
    now.hold(true);
    const double s = past_end > 0 ? 1 + past_end : past_end;  // of an edge of 1 m
    now.weights = {1 - s, s, -0.5, -0.5};
    Contacts contacts{now};
    push_beyond_ends(rim.world, {before}, choice, contacts);
    return !contacts[0].held();
}

TEST_CASE("rim pairs: edges whose feet pass an end by a hair go on pushing, but do not begin to")
{
    for (const double past_end : {-0.999 * beyond, -1e-9, 1e-9, 0.999 * beyond}) {
        CHECK(pushes_past_end(Vec3::UnitZ(), past_end, true));
        CHECK_FALSE(pushes_past_end(Vec3::UnitZ(), past_end, false));
    }
    CHECK_FALSE(pushes_past_end(Vec3::UnitZ(), 1.001 * beyond, true));
    CHECK_FALSE(pushes_past_end(Vec3::UnitZ(), -1.001 * beyond, true));
}

TEST_CASE("rim pairs: parallel edges, which have no feet, do not go on pushing at those that they had")
{
    for (const double past_end : {-0.5 * beyond, 1e-9, 0.5 * beyond})
        CHECK_FALSE(pushes_past_end(Vec3::UnitX(), past_end, true));
}

TEST_CASE("rim pairs: cubes exactly edge on edge stay where they are to a nanometre, at any angle")
{
    for (const double turn_deg : {0.0, 6.0, 17.0, 45.0}) {
        CAPTURE(turn_deg);
        std::vector<Box> boxes;
        for (int i = 0; i < 5; ++i)
            boxes.push_back({10, Vec3(0, 0.5 + i, 0), turn_deg});
        Scene scene = scene_of(boxes, 0.01);
        const PileOutcome outcome = watch(scene, 3);
        CHECK(outcome.energy_gain_j <= 1e-9);
        for (const auto& body : scene.world.bodies)
            CHECK(std::hypot(body->centre().x(), body->centre().z()) < 1e-9);
    }
}
