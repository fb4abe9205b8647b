#include "chapters/04_friction/experiments/rides.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/04_friction/tangent_plane.hpp"
#include "common/simulation/point_masses.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace enduring;

namespace {

/// A pair of either kind whose vertices are anywhere, and where a step of 1 s takes each of them.
struct MovingPair {
    World world;
    Contacts contacts;
    Vec3 normal;  ///< at the start

    /// @param motion  to where a vertex of the body (0 or 1) goes
    template <class Motion>
    MovingPair(ContactKind kind, unsigned seed, const Motion& motion) : engine_(seed)
    {
        world.gravity.setZero();
        std::array<std::vector<Vec3>, 2> x;
        for (std::size_t body = 0; body < 2; ++body) {
            x[body] = {vector(), vector(), vector()};
            auto points = std::make_unique<PointMasses>("points", x[body], std::vector<Face>{{0, 1, 2}}, 1.0);
            for (int v = 0; v < 3; ++v)
                points->set_velocity(v, motion(body, x[body][v]) - x[body][v]);
            world.bodies.push_back(std::move(points));
            world.bodies.back()->predict(world.gravity, 1);
        }
        Contact contact{kind, 0, 1, 0, 0};
        const double s = 0.5 + 0.4 * vector().x(), t = 0.5 + 0.4 * vector().x();
        if (kind == ContactKind::vertex_face) {
            contact.vertices = {0, 0, 1, 2};
            contact.weights = {1, -(1 - s) * (1 - t), -s * (1 - t), -t};
            normal = (x[1][1] - x[1][0]).cross(x[1][2] - x[1][0]).normalized();
        } else {
            contact.vertices = {0, 1, 0, 1};
            contact.weights = {1 - s, s, t - 1, -t};
            contact.orientation = vector().x() > 0 ? 1 : -1;
            normal = contact.orientation * (x[0][1] - x[0][0]).cross(x[1][1] - x[1][0]).normalized();
        }
        contact.impulse = contact_geometry(world, contact, 1).normal;
        contact.spring.stretch = TangentPlane(normal).projected(0.01 * vector());
        contacts.push_back(contact);
    }

    Vec3 vector() { return Vec3(number_(engine_), number_(engine_), number_(engine_)); }
    const Vec3& moved_stretch()
    {
        move_friction_anchors(world, contacts, MassSplitting{.spring = 100}, 1);
        return contacts[0].spring.stretch;
    }

private:
    std::mt19937 engine_;
    std::uniform_real_distribution<double> number_{-1, 1};
};

Mat3 any_turn(unsigned seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    return rides::turned_about(Vec3(number(engine), number(engine), number(engine)).normalized(),
                               3 * number(engine));
}

constexpr std::array<ContactKind, 2> kinds{ContactKind::vertex_face, ContactKind::edge_edge};

}  // namespace

TEST_CASE("friction anchors: what turns and moves as one rigid whole takes its stretch along, held or not")
{
    for (const ContactKind kind : kinds)
        for (const bool held : {false, true})
            for (unsigned seed = 0; seed < 200; ++seed) {
                CAPTURE(seed);
                const Mat3 turn = any_turn(seed);
                MovingPair it(kind, seed, [&](std::size_t, const Vec3& x) {
                    return Vec3(turn * x + Vec3(0.3, -0.2, 0.1));
                });
                it.contacts[0].hold(held);
                const Vec3 before = it.contacts[0].spring.stretch;
                CHECK((it.moved_stretch() - turn * before).norm() < 1e-11);
            }
}

TEST_CASE("friction anchors: what slides on a surface that turns is stretched by the way it slides")
{
    // The vertex goes along the face as the face's own turn lets it appear: so far in the face's axes.
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Mat3 turn = any_turn(seed);
        Vec3 slide = Vec3::Zero();
        const auto motion = [&](std::size_t body, const Vec3& x) {
            return Vec3(turn * (body == 0 ? Vec3(x + slide) : x));
        };
        slide = TangentPlane(MovingPair(ContactKind::vertex_face, seed, motion).normal)
                    .projected({0.02, -0.01, 0.03});
        MovingPair it(ContactKind::vertex_face, seed, motion);
        const Vec3 before = it.contacts[0].spring.stretch;
        CHECK((it.moved_stretch() - turn * (before + slide)).norm() < 1e-11);
    }
}

TEST_CASE("friction anchors: of two edges that turn against each other neither counts more than the other")
{
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const auto motion = [&](std::size_t body, const Vec3& x) {
            return Vec3(any_turn(seed + 1000 * static_cast<unsigned>(body)) * x);
        };
        MovingPair one(ContactKind::edge_edge, seed, motion), other(ContactKind::edge_edge, seed, motion);
        Contact& c = other.contacts[0];
        std::swap(other.world.bodies[0], other.world.bodies[1]);
        c.vertices = {c.vertices[2], c.vertices[3], c.vertices[0], c.vertices[1]};
        c.weights = {-c.weights[2], -c.weights[3], -c.weights[0], -c.weights[1]};
        c.impulse = -c.impulse;
        c.spring.stretch = -c.spring.stretch;
        CHECK((one.moved_stretch() + other.moved_stretch()).norm() < 1e-11);
    }
}

TEST_CASE(
    "friction anchors: a load that is held on a table, a wheel or a soft slab that turns creeps less than 5 micrometres a turn" *
    doctest::test_suite("long simulation"))
{
    for (const rides::Ground ground : {rides::Ground::table, rides::Ground::wheel, rides::Ground::soft_slab})
        for (const rides::Load load : {rides::Load::block, rides::Load::grate}) {
            CAPTURE(static_cast<int>(ground));
            CAPTURE(static_cast<int>(load));
            const rides::RideRecord record = rides::take(rides::short_ride(ground, load), chapter04_solver);
            CHECK(record.creep.back() < 5e-6);
            CHECK(record.edge_edges > 10);
            CHECK((load == rides::Load::grate || record.vertex_faces >= 4));
        }
}
