#include "chapters/08_contact_by_distance/contact_memory.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/triangle_foot.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

constexpr double degree = std::numbers::pi / 180;

void add_ground(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "ground", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

/// A cube whose vertex 0 is at a place.
void add_cube(World& world, const Vec3& vertex_0, double size = 1, double mass = 10)
{
    SurfaceMesh mesh = box(Vec3::Constant(size));
    const Vec3 by = vertex_0 - mesh.vertices[0];
    for (Vec3& x : mesh.vertices)
        x += by;
    world.bodies.push_back(
        std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1000), mass)));
}

/// A vertex against a face, with its foot where the vertex is at the start of the step.
Contact pair_of(const World& world, int body_a, int vertex, int body_b, int face)
{
    const auto [f0, f1, f2] = world.bodies[static_cast<std::size_t>(body_b)]->surface().faces()[face];
    const auto foot = foot_on_triangle(world.bodies[static_cast<std::size_t>(body_a)]->position(vertex, 0),
                                       world.bodies[static_cast<std::size_t>(body_b)]->position(f0, 0),
                                       world.bodies[static_cast<std::size_t>(body_b)]->position(f1, 0),
                                       world.bodies[static_cast<std::size_t>(body_b)]->position(f2, 0));
    Contact contact{ContactKind::vertex_face, body_a, body_b, vertex, face, {vertex, f0, f1, f2}};
    contact.weights = {1, -foot->weights[0], -foot->weights[1], -foot->weights[2]};
    return contact;
}

Contact edges_of(int body_a, int edge_a, int body_b, int edge_b)
{
    return {ContactKind::edge_edge, body_a, body_b, edge_a, edge_b, {0, 1, 0, 1}, {0.5, 0.5, -0.5, -0.5}};
}

Contact with_memory(Contact contact)
{
    contact.spring.stiffness = 5e4;
    contact.spring.load = 30;
    contact.spring.rest_offset = -2e-4;
    contact.spring.stretch = {1e-5, 2e-5, -3e-5};
    contact.spring.slip = 0.07;
    return contact;
}

bool begins_new(const Contact& contact)
{
    return contact.spring.stiffness == 0 && contact.spring.load == 0 && contact.spring.rest_offset == 0 &&
           contact.spring.slip == 0 && contact.spring.stretch.isZero(0);
}

/// Two faces that meet at an angle, and a cube whose vertex 0 is as deep below one plane as below the other.
World at_hinge(double angle, double depth, double size)
{
    World world;
    add_ground(world, placed(hinge(angle), size));
    const Vec3 between = (Vec3::UnitY() + Vec3(std::sin(angle), std::cos(angle), 0)).normalized();
    add_cube(world, Vec3(0, 0, 0.5 * size) - depth / std::cos(angle / 2) * between, size);
    return world;
}

}  // namespace

TEST_CASE(
    "contact memory: a pair with the same key takes over load, stiffness, rest offset, stretch and slip, as they are")
{
    World world = at_hinge(0.3, 1e-3, 1);
    for (Contact last : {pair_of(world, 1, 0, 0, 1), edges_of(0, 3, 1, 7),
                         Contact{ContactKind::vertex_plane, 1, 0, 4, -1, {4, -1, -1, -1}, {1, 0, 0, 0}}}) {
        last = with_memory(last);
        last.impulse = {1, 2, 3};
        last.state = ContactState::answered;
        Contact again = last;
        again.spring.stiffness = again.spring.load = again.spring.rest_offset = again.spring.slip = 0;
        again.spring.stretch.setZero();
        again.impulse.setZero();
        again.state = ContactState::waiting;
        again.weights[0] = 0.25;
        Contacts found{again};
        remember(world, {last}, found);
        REQUIRE(found.size() == 1);
        CHECK(found[0].spring.stiffness == last.spring.stiffness);
        CHECK(found[0].spring.load == last.spring.load);
        CHECK(found[0].spring.rest_offset == last.spring.rest_offset);
        CHECK(found[0].spring.stretch == last.spring.stretch);
        CHECK(found[0].spring.slip == last.spring.slip);
        CHECK(found[0].weights[0] == 0.25);  // geometry is that of this step
        CHECK(found[0].impulse.isZero(0));
        CHECK(found[0].waiting());
    }
}

TEST_CASE(
    "contact memory: a pair that nobody remembers begins new, and nothing is left of what is not found again")
{
    World world = at_hinge(0.3, 1e-3, 1);
    add_cube(world, {0, -1e-3, 0.6});
    const Contacts last{with_memory(pair_of(world, 1, 0, 0, 0)), with_memory(edges_of(0, 3, 1, 7))};
    Contacts found{pair_of(world, 1, 2, 0, 0),  // another vertex
                   pair_of(world, 2, 0, 0, 0),  // of another body
                   pair_of(world, 0, 0, 1, 0),  // the other way round
                   edges_of(0, 3, 1, 8),        // another edge: only vertices hand on
                   edges_of(0, 4, 1, 7)};
    const std::size_t count = found.size();
    remember(world, last, found);
    REQUIRE(found.size() == count);
    for (const Contact& contact : found) {
        CAPTURE(contact.feature_a);
        CAPTURE(contact.feature_b);
        CHECK(begins_new(contact));
    }
}

TEST_CASE("contact memory: a vertex hands its spring on to the next face with its compression and its load")
{
    for (const double degrees : {-40.0, -10.0, 0.0, 10.0, 40.0})
        for (const double size : {1e-3, 1.0, 100.0})
            for (const double slack_part : {0.0, -0.3, 0.4}) {
                CAPTURE(degrees);
                CAPTURE(size);
                CAPTURE(slack_part);
                const double depth = 1e-3 * size;
                World world = at_hinge(degrees * degree, depth, size);
                Contact last = with_memory(pair_of(world, 1, 0, 0, 0));
                REQUIRE(contact_geometry(world, last, 0).depth == doctest::Approx(-depth));
                last.spring.rest_offset = std::min(0.0, slack_part * depth);
                Contacts found{pair_of(world, 1, 0, 0, 1)};
                remember(world, {last}, found);
                CHECK(found[0].spring.stiffness == last.spring.stiffness);
                CHECK(found[0].spring.load == last.spring.load);
                CHECK(found[0].spring.slip == last.spring.slip);
                const double compression = contact_geometry(world, found[0], 0).depth -
                                           found[0].spring.rest_offset;
                CHECK(compression == doctest::Approx(-depth - last.spring.rest_offset).epsilon(1e-9));
            }
}

TEST_CASE(
    "contact memory: where the next face is deeper below, the rest offset takes the difference, and never the other way")
{
    World world;
    SurfaceMesh stairs = hinge(0);
    stairs.vertices.insert(stairs.vertices.end(), {{0, 0.002, 0}, {0, 0.002, 1}, {-1, 0.002, 0.5}});
    stairs.faces.push_back({5, 4, 6});
    add_ground(world, stairs);
    add_cube(world, {-0.01, -0.001, 0.5});  // 1 mm below the faces 0 and 1, 3 mm below the face 2
    const auto handed = [&](int from, int to, double rest_offset) {
        Contact last = with_memory(pair_of(world, 1, 0, 0, from));
        last.spring.rest_offset = rest_offset;
        Contacts found{pair_of(world, 1, 0, 0, to)};
        remember(world, {last}, found);
        CHECK(found[0].spring.stiffness == last.spring.stiffness);
        return found[0].spring.rest_offset;
    };
    CHECK(handed(0, 2, 0) == doctest::Approx(-0.002));
    CHECK(handed(0, 2, -0.0004) == doctest::Approx(-0.0024));
    CHECK(handed(0, 2, -0.005) == doctest::Approx(-0.003));  // it was not compressed at all
    CHECK(handed(2, 0, -0.0025) == doctest::Approx(-0.0005));
    CHECK(handed(2, 0, 0) == 0);  // it held more than the new depth can
}

TEST_CASE("contact memory: the stretch turns into the plane of the next face and keeps its length")
{
    for (const double degrees : {-40.0, 15.0, 40.0})
        for (const double size : {1e-3, 1.0, 100.0}) {
            World world = at_hinge(degrees * degree, 1e-3 * size, size);
            Contact last = with_memory(pair_of(world, 1, 0, 0, 0));
            last.spring.stretch = size * Vec3(3e-4, 0, 4e-4);
            Contacts found{pair_of(world, 1, 0, 0, 1)};
            remember(world, {last}, found);
            CAPTURE(degrees);
            CAPTURE(size);
            // The surface turns about the edge, which is z: the normal by as much as the face.
            const Vec3 expected = Eigen::AngleAxisd(-degrees * degree, Vec3::UnitZ()) * last.spring.stretch;
            CHECK((found[0].spring.stretch - expected).norm() < 1e-9 * size);
            CHECK(found[0].spring.stretch.norm() == doctest::Approx(5e-4 * size));
            CHECK(std::abs(found[0].spring.stretch.dot(contact_geometry(world, found[0], 0).normal)) <
                  1e-12 * size);
        }
}

TEST_CASE("contact memory: to a face that looks elsewhere, by more than the angle, a vertex hands on nothing")
{
    const double limit = std::acos(distance_parts.hand_on) / degree;
    CHECK(limit > 30);
    CHECK(limit < 60);
    for (const double sign : {1.0, -1.0})
        for (const double beyond : {-2.0, 2.0, 30.0}) {
            World world = at_hinge(sign * (limit + beyond) * degree, 1e-3, 1);
            Contacts found{pair_of(world, 1, 0, 0, 1)};
            remember(world, {with_memory(pair_of(world, 1, 0, 0, 0))}, found);
            CAPTURE(sign);
            CAPTURE(beyond);
            CHECK(begins_new(found[0]) == (beyond > 0));
        }
}

TEST_CASE("contact memory: no two pairs take over from the same one, and who has the same key comes first")
{
    World world;
    add_ground(world, plane_grid(4, 4, {2, 2}));
    add_cube(world, {0.1, -1e-3, 0.1});
    const auto pair = [&](int face, double stiffness = 0) {
        Contact contact = pair_of(world, 1, 0, 0, face);
        contact.spring.stiffness = stiffness;
        return contact;
    };
    const auto stiffnesses = [&](const Contacts& last, Contacts found) {
        remember(world, last, found);
        std::vector<double> all;
        for (const Contact& contact : found)
            all.push_back(contact.spring.stiffness);
        return all;
    };
    using Numbers = std::vector<double>;
    CHECK(stiffnesses({pair(0, 7)}, {pair(1), pair(2)}) == Numbers{7, 0});
    CHECK(stiffnesses({pair(1, 7)}, {pair(0), pair(1)}) == Numbers{0, 7});
    CHECK(stiffnesses({pair(0, 5), pair(1, 7)}, {pair(1), pair(2)}) == Numbers{7, 5});
    CHECK(stiffnesses({pair(0, 5), pair(1, 7)}, {pair(2), pair(3), pair(4)}) == Numbers{5, 7, 0});
    CHECK(stiffnesses({}, {pair(2)}) == Numbers{0});
}
