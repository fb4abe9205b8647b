#include "chapters/06_redefinition/face_choice.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

using namespace enduring;
using namespace enduring::small_worlds;

namespace {

/// Body 0 is a still surface, body 1 one particle, which no pair can push along a surface of its own.
World particle_and(const SurfaceMesh& surface, const Vec3& place)
{
    World world;
    world.bodies.push_back(still("surface", surface));
    world.bodies.push_back(
        std::make_unique<PointMasses>("particle", std::vector<Vec3>{place}, std::vector<Face>{}, 1));
    return world;
}

/// A tetrahedron under its face 0, a triangle in y = 0 that looks up, with its fourth corner at `lowest`.
SurfaceMesh below_a_triangle(const Vec3& lowest)
{
    return {{{0, 0, 0}, {1, 0, -1}, {1, 0, 1}, lowest}, {{0, 2, 1}, {2, 0, 3}, {1, 2, 3}, {0, 1, 3}}};
}

}  // namespace

TEST_CASE("face choice: of the faces that fit the one with the smallest penetration is taken")
{
    // The corner of three planes: faces 0, 1, 2 in x = 0, y = 0, z = 0, and face 3 across.
    const SurfaceMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{0, 3, 2}, {0, 1, 3}, {0, 2, 1}, {1, 2, 3}}};
    const World world = particle_and(corner, {0.1, 0.2, 0.15});
    const auto chosen = [&](int present) {
        return *find_face(world, on_face(world, present), 0, all_corners, {});
    };
    CHECK(chosen(3).face == 0);
    CHECK(chosen(3).foot.depth == doctest::Approx(-0.1));
    CHECK(chosen(0).face == 2);
    CHECK(chosen(0).foot.depth == doctest::Approx(-0.15));
}

TEST_CASE("face choice: a foot on a deep face comes before one beside a shallow face")
{
    FaceTrial on_deep{0, {{0.2, 0.3, 0.5}, -3}, 0, FaceVerdict::fit},
        beside{1, {{-0.1, 0.6, 0.5}, -1}, 0.1, FaceVerdict::fit};
    CHECK(is_better(on_deep, beside));
    CHECK_FALSE(is_better(beside, on_deep));
}

TEST_CASE("face choice: a vertex whose foot has left its face is not handed to the far side of the body")
{
    // Past the upright face at x = 1, 0.1 m below the top's plane: the feet
    // on both lower faces are fine, 0.58 m away.
    const World world = particle_and(below_a_triangle({1, -1, 0}), {1.1, -0.1, 0});
    Contacts contacts{on_face(world, 0)};
    const PairSurfaces surfaces(world, contacts[0], 0);
    REQUIRE(try_face(surfaces, 0, 3, {}).verdict == FaceVerdict::fit);
    Redefinitions redefinitions;
    redefine_enduring_vertices(world, contacts, redefinitions);
    CHECK(redefinitions.empty());
    CHECK(contacts[0].feature_b == 0);
}

TEST_CASE("face choice: a hooked pair waits rather than push the vertex out behind")
{
    // The vertex' own face looks up, as the face does through which it came: hooked. The lower faces would be
    // regular, and look the other way by more than 135 degrees.
    const Vec3 place(0.6, -0.1, -0.05);
    World world = particle_and(below_a_triangle({0.6, -0.2, 0}), place);
    const std::vector<Vec3> sheet{place, place + Vec3(1, 0, 0), place + Vec3(0, 0, -1)};
    world.bodies[1] = std::make_unique<PointMasses>("sheet", sheet, std::vector<Face>{{0, 1, 2}}, 1);
    Contacts contacts{on_face(world, 0)};
    const PairSurfaces surfaces(world, contacts[0], 0);
    REQUIRE(try_face(surfaces, 0, 3, {}).verdict == FaceVerdict::fit);
    Redefinitions redefinitions;
    redefine_enduring_vertices(world, contacts, redefinitions);
    CHECK(redefinitions.empty());
    CHECK(contacts[0].feature_b == 0);
    CHECK(contacts[0].held());
}

TEST_CASE("face choice: a foot that has left its face asks only the corners on whose side it lies")
{
    // A second triangle leans over the first from its far corner, like a tile: at
    // x = 1.1 it is nearer than the first one's edge.
    const SurfaceMesh tile{{{0, 0, 0}, {1, 0, -1}, {1, 0, 1}, {2, 0.04, 1}, {2, 0.04, -1}},
                           {{0, 2, 1}, {0, 3, 4}}};
    const World world = particle_and(tile, {1.1, -0.05, 0});
    Contacts contacts{on_face(world, 0)};
    const PairSurfaces surfaces(world, contacts[0], 0);
    const double beyond = overshoot(foot_on_face(surfaces.a, 0, surfaces.b, 0)->weights);
    REQUIRE(find_face(world, contacts[0], 0, all_corners, limits_of_shifted(world, contacts[0], 0, beyond)));
    Redefinitions redefinitions;
    redefine_enduring_vertices(world, contacts, redefinitions);
    CHECK(redefinitions.empty());
    CHECK(contacts[0].feature_b == 0);
}
