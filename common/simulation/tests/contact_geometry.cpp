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

TEST_CASE("contact geometry: a face of a tenth of a micrometre has a normal of unit length")
{
    World world;
    const double size = 1e-7;
    world.bodies.push_back(triangle("a", -size));
    world.bodies.push_back(std::make_unique<StaticBody>(
        "b", SurfaceTopology(3, {{0, 1, 2}}), std::vector<Vec3>{{0, 0, 0}, {0, 0, size}, {size, 0, 0}}));
    const ContactGeometry geometry = contact_geometry(
        world, {ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -1, 0, 0}}, 0);
    CHECK((geometry.normal - Vec3(0, 1, 0)).norm() < 1e-12);
    CHECK(geometry.depth == doctest::Approx(-size));
}

namespace {

/// Two triangles of materials 0 and 1, a third of none, and a plane of none that is stiffer than other pairs.
World of_materials()
{
    World world;
    for (const int material : {0, 1, MaterialFriction::none}) {
        world.bodies.push_back(triangle("body"));
        world.bodies.back()->set_material(material);
    }
    world.planes.push_back({.name = "ground", .stiffness = 70});
    world.friction.materials = 2;
    for (int i = 0; i < 9; ++i)
        world.friction.between.push_back({.mu_s = 0.1 * i, .mu_d = 0.05 * i});
    return world;
}

Contact pair_of(int a, int b, bool with_plane = false)
{
    return {with_plane ? ContactKind::vertex_plane : ContactKind::vertex_face, a, b, 0, 0};
}

}  // namespace

TEST_CASE(
    "contact geometry: a pair has the coefficients of its materials, also if one side names none, and a plane its own stiffness")
{
    const World world = of_materials();
    const FrictionCoefficients all{.mu_s = 9, .mu_d = 8};
    const auto mu = [&](const Contact& pair) { return pair_friction(world, pair, all).mu_s; };
    CHECK(mu(pair_of(0, 1)) == doctest::Approx(0.5));
    CHECK(mu(pair_of(1, 0)) == doctest::Approx(0.7));
    CHECK(mu(pair_of(2, 1)) == doctest::Approx(0.2));
    CHECK(mu(pair_of(1, 0, true)) == doctest::Approx(0.6));
    CHECK(mu(pair_of(2, 0, true)) == 9);
    CHECK(pair_stiffness(world, pair_of(0, 0, true), 5) == 70);
    CHECK(pair_stiffness(world, pair_of(0, 1), 5) == 5);
}

TEST_CASE(
    "contact geometry: how surfaces run against each other is the difference of both, on a plane that of the body")
{
    World world = of_materials();
    world.bodies[0]->set_surface_velocity({1, 0, 0});
    world.bodies[1]->set_surface_velocity({0, 0, 2});
    CHECK(running_of_surfaces(world, pair_of(0, 1)) == Vec3(1, 0, -2));
    CHECK(running_of_surfaces(world, pair_of(1, 0)) == Vec3(-1, 0, 2));
    CHECK(running_of_surfaces(world, pair_of(1, 0, true)) == Vec3(0, 0, 2));
}
