#include "chapters/06_redefinition/vertex_face_redefinition.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/face_choice.hpp"
#include "chapters/06_redefinition/new_pairs.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <cmath>
#include <random>
#include <set>

using namespace enduring;
using namespace enduring::small_worlds;

namespace {

/// Whether a face of a surface in y = 0 lies under a point, seen from above: signs of areas in the plane, and
/// nothing of the layer's own projection.
bool lies_on(const World& world, int face, double x, double z, double slack)
{
    const Face& f = world.bodies[0]->surface().faces()[face];
    const auto corner = [&](int i) {
        return world.bodies[0]->positions_t0()[f[static_cast<std::size_t>(i)]];
    };
    for (int i = 0; i < 3; ++i) {
        const Vec3 p = corner(i), q = corner((i + 1) % 3);
        if ((q.z() - p.z()) * (x - p.x()) - (q.x() - p.x()) * (z - p.z()) < -slack)
            return false;
    }
    return true;
}

/// An open surface over [-1, 1] x [-1, 1] that is folded along x = 0: height |x| times a slope.
SurfaceMesh folded(double slope)
{
    SurfaceMesh mesh = plane_grid(2, 2, {2, 2});
    for (Vec3& x : mesh.vertices)
        x.y() = slope * std::abs(x.x());
    return mesh;
}

}  // namespace

TEST_CASE(
    "redefinition: a vertex under a flat floor keeps its depth and has one pair, that of the face above it")
{
    for (const GridDiagonals diagonals :
         {GridDiagonals::same, GridDiagonals::alternating, GridDiagonals::crossed}) {
        CAPTURE(static_cast<int>(diagonals));
        const double depth = 1e-3, dt = 0.01;
        World world = tip_and(plane_grid(4, 4, {12, 12}, diagonals), {-1.71, 1e-9, -1.3},
                              {3.1, -depth / dt, 2.3});
        Contacts contacts;
        const Solver solver = weak_solver();
        std::set<int> faces;
        advance(world, contacts, solver, dt);
        turn_to(world, {3.1, 0, 2.3});
        for (int step = 1; step < 100; ++step) {
            CAPTURE(step);
            const Vec3 before = tip_place(world);
            advance(world, contacts, solver, dt);
            REQUIRE(of_tip(contacts).size() == 1);
            const Contact contact = of_tip(contacts)[0];
            CHECK(lies_on(world, contact.feature_b, before.x(), before.z(), 1e-12));  // where the step began
            CHECK(contact_geometry(world, contact, 0).depth == doctest::Approx(-depth).epsilon(1e-5));
            CHECK(contact.category == ContactCategory::regular);
            faces.insert(contact.feature_b);
        }
        CHECK(faces.size() >= 10);
    }
}

TEST_CASE("redefinition: the pair acts under the vertex, so p - q stands at right angles to the face")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-0.9, 0.9);
    for (int round = 0; round < 200; ++round) {
        SurfaceMesh hills = plane_grid(2, 2, {4, 4});
        for (Vec3& x : hills.vertices)
            x.y() = 0.05 * anywhere(random);
        World world = tip_and(hills, {anywhere(random), -0.1, anywhere(random)});
        for (int face = 0; face < static_cast<int>(hills.faces.size()); ++face) {
            Contacts contacts{on_face(world, face)};
            Redefinitions redefinitions;
            redefine_enduring_vertices(world, contacts, redefinitions);
            const ContactGeometry found = contact_geometry(world, contacts[0], 0);
            CHECK((found.p - found.q - found.depth * found.normal).norm() < 1e-13);
            CHECK(redefinitions.size() == (contacts[0].feature_b == face ? 0u : 1u));
        }
    }
}

TEST_CASE(
    "redefinition: below a valley no face has the foot, and the tolerance (6.4) passes the vertex on, once")
{
    // Sides at 45 degrees: the feet on both lie beyond the fold for |x| < -y.
    World world = tip_and(folded(1), {-0.2, -0.5, 0.3});
    int left = -1;
    for (int face = 0; face < 8; ++face)
        if (lies_on(world, face, -0.4, 0.45, 0))
            left = face;
    const Contact on_left = on_face(world, left);
    const PairSurfaces surfaces(world, on_left, 0);
    const TriangleFoot foot = *foot_on_face(surfaces.a, 0, surfaces.b, left);
    CHECK(overshoot(foot.weights) > 0);
    CHECK_FALSE(find_face(world, on_left, 0, all_corners, {}).has_value());

    int changes = 0;
    Contacts contacts{on_left};
    Redefinitions redefinitions;
    for (double x = -0.2; x < 0.2; x += 0.01) {
        CAPTURE(x);
        World moved = tip_and(folded(1), {x, -0.5, 0.3});
        redefinitions.clear();
        redefine_enduring_vertices(moved, contacts, redefinitions);
        changes += static_cast<int>(redefinitions.size());
        CHECK_FALSE(contacts[0].resolved);
        const double side = moved.bodies[0]->positions_t0()[contacts[0].vertices[1]].x() +
                            moved.bodies[0]->positions_t0()[contacts[0].vertices[2]].x() +
                            moved.bodies[0]->positions_t0()[contacts[0].vertices[3]].x();
        if (std::abs(x) > 0.011)
            CHECK(side * x > 0);  // on the face of its own side
    }
    CHECK(changes == 1);
    CHECK(contacts[0].feature_b != left);
}

TEST_CASE("redefinition: a vertex past the rim of a sheet is let go, one at its very rim is not")
{
    for (const double beyond : {-1e-9, 1e-9}) {
        CAPTURE(beyond);
        World world = tip_and(plane_grid(2, 2, {3, 3}), {1 + beyond, -0.01, 0.1});
        int under = -1;
        for (int face = 0; face < static_cast<int>(world.bodies[0]->surface().faces().size()); ++face)
            if (lies_on(world, face, 0.999, 0.1, 0))
                under = face;
        Contacts contacts{on_face(world, under)};
        Redefinitions redefinitions;
        redefine_enduring_vertices(world, contacts, redefinitions);
        CHECK(contacts[0].resolved == (beyond > 0));
    }
}

TEST_CASE("redefinition: the friction anchor comes along")
{
    World world = tip_and(plane_grid(2, 2, {3, 3}), {0.1, -0.01, 0.05});
    for (int face = 0; face < static_cast<int>(world.bodies[0]->surface().faces().size()); ++face) {
        Contacts contacts{on_face(world, face)};
        contacts[0].spring.stretch = {0.003, 0, -0.001};
        Redefinitions redefinitions;
        redefine_enduring_vertices(world, contacts, redefinitions);
        CHECK(contacts[0].spring.stretch == Vec3(0.003, 0, -0.001));
    }
}

TEST_CASE("new pairs: a vertex that dives through a diagonal has one pair here and two in chapter 3")
{
    World world = tip_and(plane_grid(2, 2, {1, 1}), {0, 0.1, 0}, {0, -2, 0});
    Contacts three, six;
    advance(world, three, chapter03_solver({PenaltyMethod::continuous, 1e-9}), 0.1);
    CHECK(of_tip(three).size() == 2);
    world = tip_and(plane_grid(2, 2, {1, 1}), {0, 0.1, 0}, {0, -2, 0});
    advance(world, six, weak_solver(), 0.1);
    CHECK(of_tip(six).size() == 1);
}

TEST_CASE(
    "new pairs: of two entries of a vertex the earliest is kept, and of two at the same time the regular one")
{
    World world = tip_and(plane_grid(2, 2, {1, 1}), {0, -0.1, 0});
    for (const int early : {0, 1}) {
        CAPTURE(early);
        Contacts contacts{on_face(world, 0), on_face(world, 1)};
        contacts[0].start = contacts[1].start = 0.6;
        contacts[early].start = 0.2;
        label_new_contacts(world, contacts);
        Redefinitions redefinitions;
        admit_new_pairs(world, contacts, 0, redefinitions);
        REQUIRE(contacts.size() == 1);
        CHECK(contacts[0].start == 0.2);
        CHECK(contacts[0].feature_b == early);
    }

    // Face 0 stands upright, along the tip's surface; face 1 looks up.
    world = tip_and({{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {{0, 3, 1}, {0, 1, 2}}}, {0, 0, 0.1});
    Contacts contacts{on_face(world, 0), on_face(world, 1)};
    contacts[0].start = contacts[1].start = 0.5;
    label_new_contacts(world, contacts);
    Redefinitions redefinitions;
    admit_new_pairs(world, contacts, 0, redefinitions);
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].feature_b == 1);
    CHECK(redefinitions.empty());
}

TEST_CASE(
    "new pairs: a floor's vertex that enters by the front of a box belongs to its bottom before its first impulse")
{
    // The box's front face, at x = 0.5, moves over the floor's vertex at (0.55,
    // 0, 0), which is 1 mm above the box's bottom.
    World world;
    world.gravity.setZero();
    SurfaceMesh floor = plane_grid(2, 2, {2, 2});
    for (Vec3& x : floor.vertices)
        x += Vec3(0.55, 0, 0);
    SurfaceMesh mesh = box({1, 1, 1});
    for (Vec3& x : mesh.vertices)
        x.y() += 0.499;
    world.bodies.push_back(still("floor", floor));
    world.bodies.push_back(std::make_unique<PointMasses>("box", mesh.vertices, mesh.faces, 1, Vec3(1, 0, 0)));
    Contacts contacts;
    advance(world, contacts, chapter06_solver({PenaltyMethod::continuous, 10}), 0.1);
    const auto of_floor = [](const Contact& c) {
        return c.kind == ContactKind::vertex_face && c.body_a == 0;
    };
    REQUIRE(std::count_if(contacts.begin(), contacts.end(), of_floor) == 1);
    const Contact& contact = *std::find_if(contacts.begin(), contacts.end(), of_floor);
    CHECK(contact_geometry(world, contact, 0).normal.y() == doctest::Approx(-1));
    CHECK(contact.start == doctest::Approx(0.5).epsilon(1e-6));
    CHECK(contact.impulse.y() < 0);
    CHECK(std::abs(contact.impulse.x()) < 1e-15);
    for (const Contact& each : contacts)
        CHECK(std::abs(each.impulse.x()) <= 1e-12);
}
