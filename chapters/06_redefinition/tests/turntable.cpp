#include "chapters/04_friction/experiments/rides.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

using namespace enduring;
using namespace enduring::small_worlds;

TEST_CASE(
    "turntable: a load that is held on a table, a wheel or a soft slab that turns creeps less than 5 micrometres a turn" *
    doctest::test_suite("long simulation"))
{
    for (const rides::Ground ground : {rides::Ground::table, rides::Ground::wheel, rides::Ground::soft_slab})
        for (const rides::Load load : {rides::Load::block, rides::Load::grate}) {
            CAPTURE(static_cast<int>(ground));
            CAPTURE(static_cast<int>(load));
            const rides::RideRecord record = rides::take(rides::short_ride(ground, load), chapter06_solver);
            CHECK(record.creep.back() < 5e-6);
            CHECK(record.edge_edges > 10);
            CHECK((load == rides::Load::grate || record.vertex_faces >= 4));
        }
}

TEST_CASE(
    "redefinition: over an edge the friction anchor's stretch turns with the face, and keeps its length")
{
    // A roof: the tip was below its left slope, and is below its right one now.
    const SurfaceMesh roof{{{0, 0, -2}, {0, 0, 2}, {-2, -1, 0}, {2, -1, 0}}, {{0, 2, 1}, {0, 1, 3}}};
    World world = tip_and(roof, {0.1, -0.1, 0.05});
    Contacts contacts{on_face(world, 0)};
    contacts[0].spring.stretch = {0.004, 0.002, 0.003};  // along the left slope
    Redefinitions redefinitions;
    redefine_enduring_vertices(world, contacts, redefinitions);
    REQUIRE(contacts[0].feature_b == 1);
    CHECK((contacts[0].spring.stretch - Vec3(0.004, -0.002, 0.003)).norm() < 1e-15);
}
