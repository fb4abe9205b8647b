#include "chapters/08_speculative_contacts/contact_search.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

void add_static(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "fixed", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

void add_rigid(World& world, const SurfaceMesh& mesh, double mass = 10, const Vec3& velocity = Vec3::Zero())
{
    world.bodies.push_back(
        std::make_unique<RigidBody>("body", mesh, with_mass(mass_properties(mesh, 1000), mass), velocity));
}

void predict(World& world, double dt)
{
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
}

std::vector<PairKey> keys_of(const Contacts& contacts)
{
    std::vector<PairKey> keys;
    for (const Contact& contact : contacts)
        keys.push_back(key_of(contact));
    return keys;
}

/// Cubes that overlap their neighbours a little or lie near them, each turned and thrown at random.
World random_heap(unsigned seed, double size, double dt)
{
    Draw draw(seed);
    World world;
    add_static(world,
               placed(box({6, 1, 6}, {3, 1, 3}), size, Quaternion::Identity(), Vec3(0, -0.5, 0) * size));
    for (int i = 0; i < 8; ++i)
        add_rigid(world,
                  placed(box(Vec3::Ones()), size, draw.turn(),
                         size * Vec3(1.05 * (i % 2), 0.6 + 1.05 * (i / 4), 1.05 * (i / 2 % 2))),
                  draw.between(0.1, 100), draw.between(0, 3) * size / dt * 0.1 * draw.direction());
    world.gravity *= size;
    predict(world, dt);
    return world;
}

}  // namespace

TEST_CASE(
    "contact search: the margin is more than what falls in a step from rest, and less than twice as much")
{
    for (const double dt : {0.002, 0.01, 1.0 / 60})
        for (const Vec3& gravity : {Vec3(0, -9.81, 0), Vec3(3, 4, 0)}) {
            World world;
            world.gravity = gravity;
            add_static(world, box(Vec3::Constant(1e-6)));
            add_rigid(world, box(Vec3::Constant(0.1)), 10);
            predict(world, dt);
            const double falls = (world.bodies[1]->position(0, 1) - world.bodies[1]->position(0, 0)).norm();
            CAPTURE(dt);
            CAPTURE(gravity.transpose());
            CHECK(search_margin(world, dt) > falls);
            CHECK(search_margin(world, dt) < 2 * falls);
            CHECK(search_margin(world, dt) == doctest::Approx(search_parts.fall * falls));
        }
}

TEST_CASE("contact search: without gravity the margin is a part of the smallest body that can move")
{
    World world;
    world.gravity.setZero();
    add_static(world, box({0.001, 0.001, 0.001}));
    CHECK(search_margin(world, 0.01) == 0);
    add_rigid(world, box({3, 3, 3}));
    CHECK(search_margin(world, 0.01) == doctest::Approx(3 * search_parts.nearness));
    add_rigid(world, box({0.2, 0.2, 0.2}));
    add_rigid(world, box({5, 5, 5}));
    CHECK(search_margin(world, 0.01) == doctest::Approx(0.2 * search_parts.nearness));
    world.gravity = {0, -9.81, 0};
    CHECK(search_margin(world, 1e-5) == doctest::Approx(0.2 * search_parts.nearness));
}

TEST_CASE(
    "contact search: pairs are ascending and none comes twice, and they wait, without stiffness or load")
{
    std::size_t pairs = 0, edges = 0;
    for (unsigned seed = 0; seed < 10; ++seed)
        for (const double size : {1e-2, 1.0, 100.0}) {
            const World world = random_heap(seed, size, 0.01);
            ContactSearch search;
            const Contacts found = search.find(world, {}, 0.01);
            const auto keys = keys_of(found);
            CAPTURE(seed);
            CAPTURE(size);
            CHECK(std::adjacent_find(keys.begin(), keys.end(), std::greater_equal<>()) == keys.end());
            for (const Contact& contact : found) {
                CHECK(contact.waiting());
                CHECK(std::abs(contact.start - 0.5) <= 0.5);
                CHECK(contact.stiffness == 0);
                CHECK(contact.load == 0);
                CHECK(contact.category == ContactCategory::regular);
                CHECK(contact.body_a != contact.body_b);
                const double sum = contact.weights[0] + contact.weights[1] + contact.weights[2] +
                                   contact.weights[3];
                CHECK(std::abs(sum) < 1e-9);
                edges += contact.kind == ContactKind::edge_edge;
            }
            pairs += found.size();
        }
    CHECK(pairs > 100);
    CHECK(edges > 50);
}

TEST_CASE("contact search: the same pairs are found in a world of any size, whoever has looked before")
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        const World plain = random_heap(seed, 1, 0.01);
        ContactSearch search;
        const auto keys = keys_of(search.find(plain, {}, 0.01));
        CAPTURE(seed);
        CHECK(keys_of(search.find(plain, {}, 0.01)) == keys);
        for (const double size : {1e-2, 100.0}) {
            const World other = random_heap(seed, size, 0.01);
            ContactSearch fresh;
            CAPTURE(size);
            CHECK(keys_of(fresh.find(other, {}, 0.01)) == keys);
        }
    }
}

TEST_CASE(
    "contact search: who knows pairs finds the same, and what is deeper than the margin or a hair past its end")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        const World world = random_heap(seed, 1, 0.01);
        ContactSearch search;
        const Contacts found = search.find(world, {}, 0.01);
        Contacts every_other;
        for (std::size_t i = 0; i < found.size(); i += 2)
            every_other.push_back(found[i]);
        const auto shallow = [&](Contacts pairs) {
            std::erase_if(pairs, [&](const Contact& pair) {
                return contact_geometry(world, pair, 0).depth < -search_margin(world, 0.01);
            });
            return keys_of(pairs);
        };
        CAPTURE(seed);
        for (const Contacts& known : {found, every_other}) {
            const Contacts again = search.find(world, known, 0.01);
            CHECK(shallow(again) == shallow(found));
            CHECK(again.size() >= found.size());
        }
    }
    // A cube's corner a hair beside a fixed one stays with the side on which it lay.
    for (const double parts : {0.5, 2.0}) {
        World world;
        const double dt = 0.02;
        add_static(world, box(Vec3::Ones()));
        const double beside = parts * search_parts.hysteresis;
        add_rigid(world, placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {1 + beside, 1 + 5e-5, 0.3}),
                  10, -world.gravity * dt);
        predict(world, dt);
        REQUIRE(search_margin(world, dt) > beside);  // else it is not looked at
        ContactSearch search;
        const auto with_corners = [&](const Contacts& known) {
            Contacts corners;
            for (const Contact& contact : search.find(world, known, dt))
                if (contact.kind == ContactKind::vertex_face && contact.body_a == 1)
                    corners.push_back(contact);
            return corners;
        };
        CAPTURE(parts);
        CHECK(with_corners({}).empty());
        Contacts known;
        for (int vertex = 0; vertex < 8; ++vertex)
            for (int face = 0; face < 12; ++face)
                if (surface_at(*world.bodies[0], 0).face_normal(face).y() > 0)
                    known.push_back(pair_of(1, vertex, 0, face, world.bodies[0]->surface()));
        CHECK(with_corners(known).empty() == (parts > 1));
    }
}

TEST_CASE("contact search: the corner that leads into a box has a pair, however fast it comes")
{
    Draw draw(3);
    for (int trial = 0; trial < 300; ++trial) {
        const double size = std::pow(10, draw.between(-3, 2)), dt = trial % 2 ? 0.01 : 1.0 / 60;
        World world;
        world.gravity *= size;
        const double speed = std::pow(10, draw.between(-2, 2)) * size / dt;
        add_static(world,
                   placed(box({8, 4, 8}, {4, 1, 4}), size, Quaternion::Identity(), Vec3(0, -2, 0) * size));
        SurfaceMesh cube = placed(box(Vec3::Ones()), size, draw.turn());
        const auto lowest = std::min_element(
            cube.vertices.begin(), cube.vertices.end(),
            [](const Vec3& one, const Vec3& other) { return one.y() < other.y(); });
        const Vec3 path = speed * dt * (Vec3(0, -1, 0) + 0.5 * draw.direction());
        if (path.y() > -1e-2 * size)
            continue;
        // It passes the upper side, at y = 0, at a place of which no rounding tells on which triangle it lies.
        const double moment = draw.between(0.01, 0.99);
        const Vec3 through(size * draw.between(-1, 1), 0, size * draw.between(-1, 1));
        const int vertex = static_cast<int>(lowest - cube.vertices.begin());
        const Vec3 by = through - moment * path - *lowest;
        add_rigid(world, placed(cube, 1, Quaternion::Identity(), by), 10, path / dt - world.gravity * dt);
        predict(world, dt);
        REQUIRE((world.bodies[1]->position(vertex, moment) - through).norm() < 1e-9 * (size + path.norm()));
        ContactSearch search;
        const Contacts found = search.find(world, {}, dt);
        CAPTURE(trial);
        CAPTURE(size);
        CAPTURE(speed);
        const auto its_own = std::find_if(found.begin(), found.end(), [&](const Contact& contact) {
            return contact.kind == ContactKind::vertex_face && contact.body_a == 1 &&
                   contact.feature_a == vertex;
        });
        REQUIRE(its_own != found.end());
        CHECK(contact_geometry(world, *its_own, 0).normal.y() == doctest::Approx(1));
        CHECK(contact_geometry(world, *its_own, 1).depth < 0);
    }
}

namespace {

/// The pairs of a cube's corners with a floor that they are in and go on into, if that of one corner is known.
/// @param down   which of the cube's sides is the lower one
/// @param depth  of the cube's edge
std::ptrdiff_t corners_seen_inside(const Vec3& down, double depth, double size)
{
    World world;
    add_static(world, placed(box({6, 1, 6}), size, Quaternion::Identity(), Vec3(0, -0.5, 0) * size));
    const SurfaceMesh cube = placed(box(Vec3::Ones()), size, Quaternion::FromTwoVectors(down, -Vec3::UnitY()),
                                    Vec3(0.3, 0.5 - depth, 0) * size);
    add_rigid(world, cube, 10, Vec3(2, -10, 3) * size);
    predict(world, 1e-3);
    const SurfaceMoment ground = surface_at(*world.bodies[0], 0);
    Contact known{ContactKind::vertex_face, 1, 0, 0, 0, {}, {1, -1, 0, 0}};
    while (ground.face_normal(known.feature_b).y() <= 0)
        ++known.feature_b;
    while (cube.vertices[static_cast<std::size_t>(known.feature_a)].y() > 0)
        ++known.feature_a;
    const auto [p, q, r] = ground.step.face(known.feature_b);
    known.vertices = {known.feature_a, p, q, r};
    const Contacts found = ContactSearch().find(world, {known}, 1e-3);
    return std::count_if(found.begin(), found.end(), [](const Contact& contact) {
        return contact.kind == ContactKind::vertex_face && contact.body_a == 1;
    });
}

}  // namespace

TEST_CASE("contact search: what an impact has left inside keeps its pairs, however deep it is")
{
    for (const double size : {0.01, 1.0, 50.0})
        for (const double depth : {1e-3, 0.01, 0.09})
            for (const int side : {0, 1, 2, 3, 4, 5}) {
                CAPTURE(size);
                CAPTURE(depth);
                CAPTURE(side);
                Vec3 down = Vec3::Zero();
                down[side / 2] = side % 2 == 0 ? 1 : -1;
                CHECK(corners_seen_inside(down, depth, size) == 4);
            }
}

namespace {

/// A body that rests, all of whose elements may be inverted: then its faces look inwards.
class StillBody : public Body {
public:
    StillBody(const SurfaceMesh& mesh, bool is_inside_out)
        : Body("still", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces)),
          inverted_(is_inside_out ? 1 : 0)
    {
        positions_t0_ = positions_t1_ = mesh.vertices;
        measure();
    }
    void predict(const Vec3&, double) override {}
    void update_prediction(double) override {}
    void commit(double) override {}
    void apply_impulse(int, const Vec3&) override {}
    Vec3 velocity(int) const override { return Vec3::Zero(); }
    Mat3 inverse_mass(int) const override { return Mat3::Identity(); }
    double mass() const override { return 1; }
    Energy energy(const Vec3&) const override { return {}; }
    Vec3 linear_momentum() const override { return Vec3::Zero(); }
    Vec3 angular_momentum(const Vec3&) const override { return Vec3::Zero(); }
    int inverted_elements() const override { return inverted_; }

private:
    int inverted_;
};

}  // namespace

TEST_CASE("contact search: a body that is inside out stands on its corners as it did before")
{
    for (const bool is_inside_out : {false, true}) {
        World world;
        add_static(world, placed(box({4, 1, 4}), 1, Quaternion::Identity(), {0, -0.5, 0}));
        SurfaceMesh cube = placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {0.1, 0.5 + 1e-5, 0.2});
        for (Face& face : cube.faces)
            if (is_inside_out)
                std::swap(face[1], face[2]);
        world.bodies.push_back(std::make_unique<StillBody>(cube, is_inside_out));
        const Contacts found = ContactSearch().find(world, {}, 0.01);
        CAPTURE(is_inside_out);
        CHECK(std::count_if(found.begin(), found.end(), [](const Contact& contact) {
                  return contact.kind == ContactKind::vertex_face && contact.body_a == 1;
              }) == 4);
    }
}

TEST_CASE("contact search: bodies apart by more than the margin, at rest or leaving, have no pair")
{
    for (const double dt : {0.002, 0.01}) {
        World world;
        add_static(world, placed(box({4, 1, 4}), 1, Quaternion::Identity(), {0, -0.5, 0}));
        add_rigid(world, placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {0, 0.5, 0}), 10, {0, 1, 0});
        const double margin = search_margin(world, dt);
        CAPTURE(dt);
        for (const double gap : {0.0, 0.9, 1.1, 3.0}) {
            World at;
            add_static(at, placed(box({4, 1, 4}), 1, Quaternion::Identity(), {0, -0.5, 0}));
            add_rigid(at,
                      placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {0.1, 0.5 + gap * margin, 0.2}),
                      10, Vec3(0, 9.81 * dt, 0));
            predict(at, dt);  // it rests
            ContactSearch search;
            CAPTURE(gap);
            CHECK(search.find(at, {}, dt).empty() == (gap > 1));
        }
    }
}

TEST_CASE(
    "contact search: a vertex has moved if it ends by more than the margin elsewhere than when it was looked at")
{
    World world;
    add_static(world, box(Vec3::Ones()));
    add_rigid(world, placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {0, 3, 0}));
    add_rigid(world, placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {0, 6, 0}));
    const double dt = 0.01, margin = search_margin(world, dt);
    predict(world, dt);
    ContactSearch search;
    search.find(world, {}, dt);
    CHECK_FALSE(search.has_moved(world));
    const auto push = [&](double path) {  // of one vertex; all of its body move
        world.bodies[2]->apply_impulse(3, Vec3(0, path, 0) / dt * world.bodies[2]->mass());
        world.bodies[2]->update_prediction(dt);
    };
    push(0.01 * margin);
    CHECK_FALSE(search.has_moved(world));
    push(-20 * margin);
    CHECK(search.has_moved(world));
    search.find(world, {}, dt);
    CHECK_FALSE(search.has_moved(world));
}

TEST_CASE("contact search: planes have the vertices that are near or below at an end of the step")
{
    for (const double size : {1e-3, 1.0, 100.0}) {
        const double margin = 0.01 * size, dt = 0.01;
        const auto lower_of = [&](double from, double to) {
            World world;
            world.gravity.setZero();
            world.planes = {{"far", Vec3(0, -50, 0) * size, Vec3::UnitY()},
                            {"near", Vec3(0, 1, 0) * size, Vec3::UnitY()}};
            add_static(world, placed(box(Vec3::Ones()), size));
            add_rigid(world,
                      placed(box(Vec3::Ones()), size, Quaternion::Identity(), Vec3(0, 1.5 + from, 0) * size),
                      10, Vec3(0, to - from, 0) * size / dt);
            predict(world, dt);
            Contacts contacts;
            append_plane_pairs(world, margin, contacts);
            for (const Contact& contact : contacts) {
                CHECK(contact.kind == ContactKind::vertex_plane);
                CHECK(contact.body_a == 1);
                CHECK(contact.body_b == 1);
                CHECK(contact.vertices[0] == contact.feature_a);
                CHECK(contact.weights[0] == 1);
                CHECK(world.bodies[1]->position(contact.feature_a, 0).y() < (1.1 + from) * size);
            }
            return contacts.size();
        };
        CAPTURE(size);
        CHECK(lower_of(0.009, 0.009) == 4);
        CHECK(lower_of(0.011, 0.011) == 0);
        CHECK(lower_of(0.3, 0.009) == 4);
        CHECK(lower_of(0.3, 0.011) == 0);
        CHECK(lower_of(0.009, 0.3) == 4);
        CHECK(lower_of(0.3, -0.5) == 4);
        CHECK(lower_of(-0.5, 0.3) == 4);  // however deep: a plane knows its sides
        CHECK(lower_of(0.3, 0.3) == 0);
    }
}
