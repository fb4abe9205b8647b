#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/static_body.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE("contact geometry: a vertex under a face has its foot, the outward normal and a negative depth")
{
    World world;
    world.bodies.push_back(triangle("a", -0.25));
    world.bodies.push_back(triangle("b"));
    Contact contact{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -0.5, -0.25, -0.25}};
    const ContactGeometry geometry = contact_geometry(world, contact, 0);
    CHECK(geometry.p == Vec3(0, -0.25, 0));
    CHECK(geometry.q == Vec3(0.25, 0, 0.25));
    CHECK(geometry.normal == Vec3(0, 1, 0));
    CHECK(geometry.depth == doctest::Approx(-0.25));
}

TEST_CASE("contact geometry: positions between the ends of the step are linear in tau")
{
    World world;
    world.gravity.setZero();
    auto moving = triangle("a", 0.5, {0, -2, 0});
    moving->predict(world.gravity, 0.5);
    world.bodies.push_back(std::move(moving));
    world.bodies.push_back(triangle("b"));
    Contact contact{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -1, 0, 0}};
    CHECK(contact_geometry(world, contact, 0.0).depth == doctest::Approx(0.5));
    CHECK(contact_geometry(world, contact, 0.75).depth == doctest::Approx(-0.25));
    CHECK(contact_geometry(world, contact, 1.0).depth == doctest::Approx(-0.5));
}

TEST_CASE("contact geometry: an edge pair keeps the orientation of its first contact")
{
    // Edge 0-2 of A runs along x at height 0.1; edge 0-1 of B along z at height 0.
    World world;
    world.bodies.push_back(triangle("a", 0.1));
    world.bodies.push_back(triangle("b"));
    Contact contact{ContactKind::edge_edge, 0, 1, 1, 0, {0, 2, 0, 1}, {0.5, 0.5, -0.25, -0.75}};
    contact.orientation = -1;  // x cross z is -y, and A lies above
    const ContactGeometry above = contact_geometry(world, contact, 0);
    CHECK(above.normal == Vec3(0, 1, 0));
    CHECK(above.depth == doctest::Approx(0.1));
    CHECK(above.p == Vec3(0.5, 0.1, 0));
    CHECK(above.q == Vec3(0, 0, 0.75));
    contact.orientation = 1;
    CHECK(contact_geometry(world, contact, 0).depth == doctest::Approx(-0.1));
}

TEST_CASE("contact geometry: on a plane the foot is the nearest point of the plane")
{
    World world;
    world.bodies.push_back(triangle("a", -0.3));
    world.planes.push_back({"ground", {5, 0, 7}, Vec3(0, 1, 0)});
    Contact contact{ContactKind::vertex_plane, 0, 0, 2, -1, {2, -1, -1, -1}, {1, 0, 0, 0}};
    const ContactGeometry geometry = contact_geometry(world, contact, 0);
    CHECK(geometry.depth == doctest::Approx(-0.3));
    CHECK((geometry.q - Vec3(1, 0, 0)).norm() < 1e-15);
    CHECK(name_of_a(world, contact) == "a");
    CHECK(name_of_b(world, contact) == "ground");
}

TEST_CASE("contact geometry: parallel edges have no normal, and no NaN")
{
    World world;
    world.bodies.push_back(triangle("a", 0.1));
    world.bodies.push_back(triangle("b"));
    Contact contact{ContactKind::edge_edge, 0, 1, 0, 0, {0, 1, 0, 1}, {0.5, 0.5, -0.5, -0.5}};
    const ContactGeometry geometry = contact_geometry(world, contact, 0);
    CHECK(geometry.normal.isZero());
    CHECK(geometry.depth == 0);
}

TEST_CASE("static body: impulses leave it where it is")
{
    StaticBody body("floor", SurfaceTopology(3, {{0, 1, 2}}), {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
    body.apply_impulse(0, {1, 1, 1});
    body.predict({0, -9.81, 0}, 0.1);
    body.update_prediction(0.1);
    body.commit(0.1);
    CHECK(body.positions_t0()[2] == Vec3(1, 0, 0));
    CHECK(body.positions_t1()[2] == Vec3(1, 0, 0));
    CHECK(body.velocity(0).isZero());
    CHECK(body.inverse_mass(1).isZero());
    CHECK_THROWS_AS(StaticBody("floor", SurfaceTopology(3, {{0, 1, 2}}), {{0, 0, 0}}), std::invalid_argument);
}
