#include "chapters/08_contact_by_distance/contact_memory.hpp"
#include "chapters/08_contact_by_distance/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

constexpr double dt = 0.004;

/// A block that turns about z as given, and a cube whose vertex 0 is a millimetre below the middle of its
/// upper side.
struct VertexInBlock {
    World world;
    Contacts last, found;

    /// @param turn  in the step [rad]
    explicit VertexInBlock(double turn = 0)
    {
        world.gravity.setZero();
        world.bodies.push_back(
            std::make_unique<DrivenBody>("block", box(Vec3::Ones()), Vec3::Zero(),
                                         GivenMotion::steady(Vec3::Zero(), Vec3(0, 0, turn / dt))));
        SurfaceMesh cube = box(Vec3::Constant(0.3));
        const Vec3 by = Vec3(0, 0.499, 0) - cube.vertices[0];
        for (Vec3& x : cube.vertices)
            x += by;
        world.bodies.push_back(std::make_unique<RigidBody>("cube", cube, mass_properties(cube, 1000)));
        for (const auto& body : world.bodies)
            body->predict(world.gravity, dt);
    }
    /// Vertex 0 of the cube with a face of the block.
    Contact pair(int face) const
    {
        const auto [f0, f1, f2] = world.bodies[0]->surface().faces()[face];
        return {ContactKind::vertex_face, 1, 0, 0, face, {0, f0, f1, f2}, {1, -0.5, -0.25, -0.25}};
    }
    std::vector<int> faces_towards(const Vec3& direction) const
    {
        std::vector<int> faces;
        for (int face = 0; face < 12; ++face)
            if (surface_at(*world.bodies[0], 0).face_normal(face).normalized().dot(direction) > 0.999)
                faces.push_back(face);
        return faces;
    }
};

Contact with_memory(Contact contact, double stiffness)
{
    contact.spring.stiffness = stiffness;
    contact.spring.load = 0.5 * stiffness;
    return contact;
}

}  // namespace

TEST_CASE(
    "contact memory: which way faces look, and how deep a vertex lies, is that of the start of the step")
{
    for (const double turn : {1.2, -1.2}) {
        VertexInBlock at(turn);
        const std::vector<int> upper = at.faces_towards(Vec3::UnitY());
        REQUIRE(upper.size() == 2);
        for (const bool swapped : {false, true}) {
            at.last = {with_memory(at.pair(upper[swapped]), 5e4)};
            at.last[0].spring.rest_offset = -2e-4;
            at.found = {at.pair(upper[!swapped])};
            remember(at.world, at.last, at.found);
            CHECK(at.found[0].spring.stiffness == 5e4);
            CHECK(at.found[0].spring.rest_offset == doctest::Approx(-2e-4));
        }
    }
}

TEST_CASE(
    "contact memory: a face that looks elsewhere does not hide one that hands on, whatever their numbers")
{
    VertexInBlock at;
    const std::vector<int> upper = at.faces_towards(Vec3::UnitY());
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, -1, 0)})
        for (const int elsewhere : at.faces_towards(side)) {
            CAPTURE(elsewhere);
            at.last = {with_memory(at.pair(elsewhere), 7), with_memory(at.pair(upper[0]), 9)};
            at.found = {at.pair(upper[1])};
            remember(at.world, at.last, at.found);
            CHECK(at.found[0].spring.stiffness == 9);
        }
}

TEST_CASE(
    "contact memory: what an edge or a plane remembers is no vertex' and no face's, though their numbers agree")
{
    VertexInBlock at;
    at.world.planes.push_back({"ground"});
    const int upper = at.faces_towards(Vec3::UnitY())[0];
    // An edge of the cube along x over one of the block along z: their normal is the face's, or against it.
    const auto along = [&](std::size_t body, const Vec3& axis) {
        for (const Edge& edge : at.world.bodies[body]->surface().edges())
            if (const auto& x = at.world.bodies[body]->positions_t0();
                (x[static_cast<std::size_t>(edge[1])] - x[static_cast<std::size_t>(edge[0])])
                    .cross(axis)
                    .norm() < 1e-9)
                return edge;
        return Edge{};
    };
    const Edge a = along(1, Vec3::UnitX()), b = along(0, Vec3::UnitZ());
    for (const double orientation : {1.0, -1.0}) {
        Contact edges{ContactKind::edge_edge, 1, 0, 0, 3, {a[0], a[1], b[0], b[1]}, {0.5, 0.5, -0.5, -0.5}};
        edges.orientation = orientation;
        at.last = {with_memory(edges, 7)};
        at.found = {at.pair(upper)};
        remember(at.world, at.last, at.found);
        CHECK(at.found[0].spring.stiffness == 0);
    }
    at.last = {with_memory(at.pair(upper), 7)};
    at.found = {{ContactKind::vertex_plane, 1, 0, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}}};
    remember(at.world, at.last, at.found);
    CHECK(at.found[0].spring.stiffness == 0);
}
