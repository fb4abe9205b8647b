#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "chapters/03_penalty_impulses/penalty_law.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/pressed_bodies.hpp"
#include "common/simulation/static_body.hpp"
#include "common/simulation/tests/block_of_any_kind.hpp"
#include "common/worked_step/step_record.hpp"
#include "common/worked_step/worked_step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <tuple>

using namespace enduring;
using tests::BodyKind;

namespace {

/// One block above another, turned against it by its place only, and falling on it.
World two_blocks(BodyKind above, BodyKind below)
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(tests::block("above", above, {0.13, 0.93, 0.21}, {0.1, -1, 0.05}));
    world.bodies.push_back(tests::block("below", below, {0, 0, 0}, {0, 0.2, 0}));
    return world;
}

Vec3 linear_momentum(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->linear_momentum();
    return sum;
}

/// What receives the impulses: a rigid body, or the lumped masses of a deformable one's nodes. (Between its
/// nodes a deformable body lags behind them, so that it gains less than its lumps do.)
Vec3 angular_momentum(const World& world)
{
    const Vec3 about(1, 2, 3);
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies) {
        const auto* soft = dynamic_cast<const DeformableBody*>(body.get());
        if (!soft) {
            sum += body->angular_momentum(about);
            continue;
        }
        const ElasticBody& elastic = soft->elastic();
        for (int n = 0; n < elastic.node_count(); ++n)
            sum += elastic.masses()[n] *
                   (elastic.positions().col(n) - about).cross(elastic.velocities().col(n));
    }
    return sum;
}

/// (p - q) x I at the start of the step, where impulses act, over all contacts.
Vec3 angular_defect(const World& world, const Contacts& contacts)
{
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : contacts) {
        const ContactGeometry geometry = contact_geometry(world, contact, 0);
        sum += (geometry.p - geometry.q).cross(contact.impulse);
    }
    return sum;
}

std::vector<std::pair<BodyKind, BodyKind>> moving_pairs()
{
    return {{BodyKind::rigid, BodyKind::rigid},
            {BodyKind::rigid, BodyKind::linear},
            {BodyKind::linear, BodyKind::rigid},
            {BodyKind::linear, BodyKind::quadratic},
            {BodyKind::quadratic, BodyKind::rigid}};
}

}  // namespace

TEST_CASE(
    "penalty contact: impulses of every pair of bodies keep the momentum, and turn it by (p - q) x I alone")
{
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous})
        for (const std::pair<BodyKind, BodyKind>& kinds : moving_pairs()) {
            CAPTURE(static_cast<int>(kinds.first));
            CAPTURE(static_cast<int>(kinds.second));
            World world = two_blocks(kinds.first, kinds.second);
            Contacts contacts;
            Solver solver = chapter03_solver({method, 200});
            // Stands in for the solver's last pass and looks at momenta on both sides of it.
            int pushed = 0;
            solver.replace("impulses", "impulses", [&](World& w, Contacts& c, double dt) {
                Contacts fresh;
                for (Contact& contact : c)
                    if (!contact.answered()) {
                        fresh.push_back(contact);
                        contact.state = ContactState::answered;
                    }
                const Vec3 linear = linear_momentum(w), angular = angular_momentum(w);
                push_apart(w, fresh, normal_law({method}), 200, dt);
                apply_impulses(w, fresh);
                pushed += static_cast<int>(fresh.size());
                CHECK((linear_momentum(w) - linear).norm() < 1e-13 * (1 + linear.norm()));
                CHECK((angular_momentum(w) - angular - angular_defect(w, fresh)).norm() < 1e-12);
            });
            for (int step = 0; step < 25; ++step)
                advance(world, contacts, solver, 0.01);
            CHECK(pushed > 20);
        }
}

TEST_CASE("penalty contact: blocks of every kind push each other apart")
{
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous})
        for (const BodyKind above : {BodyKind::rigid, BodyKind::linear, BodyKind::quadratic})
            for (const BodyKind below :
                 {BodyKind::rigid, BodyKind::linear, BodyKind::quadratic, BodyKind::still}) {
                CAPTURE(static_cast<int>(above));
                CAPTURE(static_cast<int>(below));
                World world = two_blocks(above, below);
                Contacts contacts;
                const Solver solver = chapter03_solver({method, 200});
                for (int step = 0; step < 80; ++step)
                    advance(world, contacts, solver, 0.005);
                const double fall = world.bodies[0]->linear_momentum().y() / world.bodies[0]->mass();
                CHECK(fall > -0.5);  // it came with -1
            }
}

TEST_CASE(
    "penalty contact: no pair stands in the list twice, and the normal of an edge pair never turns over")
{
    World world = two_blocks(BodyKind::rigid, BodyKind::linear);
    Contacts contacts;
    const Solver solver = chapter03_solver({PenaltyMethod::continuous, 200});
    std::map<std::tuple<int, int, int>, double> orientations;
    for (int step = 0; step < 60; ++step) {
        advance(world, contacts, solver, 0.005);
        std::set<std::tuple<ContactKind, int, int, int, int>> seen;
        std::map<std::tuple<int, int, int>, double> now;
        for (const Contact& c : contacts) {
            CHECK(seen.insert({c.kind, c.body_a, c.body_b, c.feature_a, c.feature_b}).second);
            const std::tuple<int, int, int> key{static_cast<int>(c.kind), c.feature_a, c.feature_b};
            const auto before = orientations.find(key);
            if (before != orientations.end())
                CHECK(before->second == c.orientation);
            now[key] = c.orientation;
        }
        orientations = now;
    }
}

TEST_CASE("penalty contact: a pair lives while its depth is not positive, and no longer")
{
    World world = two_blocks(BodyKind::rigid, BodyKind::rigid);
    Contacts contacts;
    const Solver solver = chapter03_solver({PenaltyMethod::continuous, 400});
    bool any = false;
    for (int step = 0; step < 150; ++step) {
        advance(world, contacts, solver, 0.005);
        any = any || !contacts.empty();
        Contacts kept = contacts;
        resolve_separated_pairs(world, kept);
        for (const Contact& contact : kept)
            CHECK(contact_geometry(world, contact, 0).depth <= 1e-12);
        const auto inside = [&](const Contact& contact) {
            return contact_geometry(world, contact, 0).depth < -1e-12;
        };
        CHECK(static_cast<std::ptrdiff_t>(kept.size()) >=
              std::count_if(contacts.begin(), contacts.end(), inside));
    }
    CHECK(any);
    CHECK(contacts.empty());  // they have parted
}

TEST_CASE("penalty contact: a vertex exactly on its face keeps its pair, one a hair above it does not")
{
    for (const double height : {-1e-15, 0.0, 1e-15}) {
        CAPTURE(height);
        World world;
        world.bodies.push_back(std::make_unique<PointMasses>("vertex", std::vector<Vec3>{{0.1, height, 0.1}},
                                                             std::vector<Face>{}, 1.0));
        world.bodies.push_back(std::make_unique<StaticBody>(
            "face", SurfaceTopology(3, {{0, 1, 2}}), std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}));
        Contacts contacts{{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -0.8, -0.1, -0.1}}};
        resolve_separated_pairs(world, contacts);
        CHECK(contacts.size() == (height > 0 ? 0 : 1));
    }
}

TEST_CASE("penalty contact: an edge that falls on an edge is pushed up, whichever way the two run")
{
    for (const bool turned : {false, true})
        for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous}) {
            CAPTURE(turned);
            // An edge along x falls from 0.1 to -0.1 m over one along z; the
            // triangle above looks down, the one below up.
            std::vector<Vec3> upper{{-1, 0.1, 0}, {1, 0.1, 0}, {0, 0.5, -0.9}};
            if (turned)
                std::swap(upper[0], upper[1]);
            World world;
            world.gravity.setZero();
            world.bodies.push_back(std::make_unique<PointMasses>(
                "upper", upper, std::vector<Face>{turned ? Face{0, 1, 2} : Face{0, 2, 1}}, 1.0,
                Vec3(0, -2, 0)));
            world.bodies.push_back(
                std::make_unique<StaticBody>("lower", SurfaceTopology(3, {{0, 1, 2}}),
                                             std::vector<Vec3>{{0, 0, -1}, {0, 0, 1}, {1.5, -0.3, 0}}));
            // inside for half of the step
            const double k = 10, dt = 0.1, share = method == PenaltyMethod::discrete ? 1 : 0.25;
            Contacts contacts;
            advance(world, contacts, chapter03_solver({method, k}), dt);
            REQUIRE(contacts.size() == 1);
            const Vec3 impulse = contacts[0].impulse;
            CHECK((impulse - Vec3(0, k * dt * 0.1 * share, 0)).norm() < 1e-9);
            // from elsewhere by now, but answered once a step
            push_apart(world, contacts, normal_law({method}), k, dt);
            CHECK(contacts[0].impulse == impulse);
        }
}

TEST_CASE(
    "errata: a pair at depth 0 collides still, as 5.2.1 has it, and by 6.1.1 it would end, and what friction remembers with it")
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(
        std::make_unique<PointMasses>("points", std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}},
                                      std::vector<Face>{{0, 1, 2}}, 1.0, Vec3(0, -0.1, 0)));
    world.bodies.push_back(
        std::make_unique<StaticBody>("floor", SurfaceTopology(3, {{0, 1, 2}}),
                                     std::vector<Vec3>{{-50, 0, -50}, {-50, 0, 100}, {100, 0, -50}}));
    Contact touching{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -0.5, -0.25, -0.25}};
    touching.spring.stretch = {0.003, 0, 0};
    REQUIRE(contact_geometry(world, touching, 0).depth == 0);  // and it is about to go in
    for (const bool by_6_1_1 : {false, true}) {
        CAPTURE(by_6_1_1);
        Contacts contacts{touching};
        if (by_6_1_1)
            std::erase_if(contacts, [&](const Contact& contact) {
                return !(contact_geometry(world, contact, 0).depth < 0);
            });
        else
            resolve_separated_pairs(world, contacts);
        for (const auto& body : world.bodies)
            body->predict(world.gravity, 0.01);
        const Solver detecting = chapter03_solver({PenaltyMethod::continuous, 100});
        for (const Pass& pass : detecting.passes(StepStage::detect))
            pass.run(world, contacts, 0.01);
        const auto pair = std::find_if(contacts.begin(), contacts.end(),
                                       [](const Contact& contact) { return contact.vertices[0] == 0; });
        const bool remembers = pair != contacts.end() && pair->spring.stretch == touching.spring.stretch;
        CHECK(remembers != by_6_1_1);
    }
}

TEST_CASE(
    "penalty contact: the energy of a pair is k depth^2 / 2, and downhill on it leads the discrete force (5.1, 5.3)")
{
    const double k = 700, dt = 0.01, tiny = 1e-6;
    const std::vector<Vec3> slope{{-2, 0.3, -1}, {0, -0.4, 2}, {2, 0.1, -1}};
    const Contact contact{ContactKind::vertex_face, 0, 1, 0, 0, {0, 0, 1, 2}, {1, -0.25, -0.25, -0.5}};
    const auto world_with = [&](const Vec3& p) {
        World world;
        world.bodies.push_back(std::make_unique<PointMasses>(
            "points", std::vector<Vec3>{p, p + Vec3(0, 3, 1), p + Vec3(1, 3, 0)},
            std::vector<Face>{{0, 1, 2}}, 1.0));
        world.bodies.push_back(std::make_unique<StaticBody>("slope", SurfaceTopology(3, {{0, 1, 2}}), slope));
        return world;
    };
    const auto energy_at = [&](const Vec3& p) {
        const auto pressed = pressed_bodies(world_with(p), {contact}, k);
        return pressed.empty() ? 0 : pressed[0].energy;
    };
    const Vec3 foot = (slope[0] + slope[1]) / 4 + slope[2] / 2,
               normal = (slope[1] - slope[0]).cross(slope[2] - slope[0]).normalized();
    for (const double depth : {-0.2, 0.01, 0.1, 0.37}) {
        CAPTURE(depth);
        const Vec3 p = foot - depth * normal;
        CHECK(energy_at(p) == doctest::Approx(depth > 0 ? 0.5 * k * depth * depth : 0).epsilon(1e-12));
        Vec3 uphill;
        for (int i = 0; i < 3; ++i)
            uphill[i] = (energy_at(p + tiny * Vec3::Unit(i)) - energy_at(p - tiny * Vec3::Unit(i))) /
                        (2 * tiny);
        const Vec3 force = discrete_impulse(pair_step(world_with(p), contact).t1, k, dt) / dt;
        CHECK((force + uphill).norm() <= 1e-6 * (1 + force.norm()));
        CHECK((force.norm() > 0) == (depth > 0));
    }
}

TEST_CASE("penalty contact: the worked step gets the numbers of the stand-ins from this chapter's passes")
{
    WorkedStep by_hand = worked_step(), ours = worked_step();
    Solver solver = worked_step_solver(ours.stiffness);
    solver.replace("resolve", "resolve", [](World& world, Contacts& contacts, double) {
        resolve_separated_pairs(world, contacts);
    });
    solver.replace("respond", "respond", [k = ours.stiffness](World& world, Contacts& contacts, double dt) {
        push_apart(world, contacts, continuous_penalty, k, dt);
    });
    const auto expected = record_step(by_hand.world, by_hand.contacts, worked_step_solver(by_hand.stiffness),
                                      by_hand.dt);
    const auto found = record_step(ours.world, ours.contacts, solver, ours.dt);
    REQUIRE(found.size() == expected.size());
    for (std::size_t stage = 0; stage < found.size(); ++stage)
        for (std::size_t body = 0; body < 2; ++body)
            for (std::size_t v = 0; v < found[stage].bodies[body].velocities.size(); ++v) {
                CAPTURE(found[stage].stage);
                CHECK((found[stage].bodies[body].velocities[v] - expected[stage].bodies[body].velocities[v])
                          .norm() < 1e-14);
                CHECK(
                    (found[stage].bodies[body].positions_t1[v] - expected[stage].bodies[body].positions_t1[v])
                        .norm() < 1e-14);
            }
}

TEST_CASE("penalty contact: vertices of either body are tested against the faces of the other")
{
    for (const bool large_first : {true, false}) {
        CAPTURE(large_first);
        World world;
        world.gravity.setZero();
        // A large triangle that faces down falls on the three vertices of a
        // small one; no edges come near each other.
        auto large = std::make_unique<PointMasses>(
            "large", std::vector<Vec3>{{-9, 0.1, -9}, {9, 0.1, -9}, {0, 0.1, 9}},
            std::vector<Face>{{0, 1, 2}}, 1.0, Vec3(0, -2, 0));
        auto small = std::make_unique<PointMasses>(
            "small", std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, std::vector<Face>{{0, 1, 2}}, 1.0);
        world.bodies.push_back(std::move(large_first ? large : small));
        world.bodies.push_back(std::move(large_first ? small : large));
        Contacts contacts;
        advance(world, contacts, chapter03_solver({PenaltyMethod::continuous, 10}), 0.1);
        REQUIRE(contacts.size() == 3);
        for (const Contact& contact : contacts) {
            CHECK(contact.kind == ContactKind::vertex_face);
            CHECK(contact.body_a == (large_first ? 1 : 0));
            CHECK(contact.start == doctest::Approx(0.5).epsilon(1e-9));
            CHECK(contact.impulse.y() < 0);
        }
    }
}

TEST_CASE("penalty contact: a new pair pushes from its time of impact, not for a visit before it")
{
    // The face sways while the vertex passes over it: inside, outside, inside again (see the test of
    // crossings). The pair is made by the second visit; what came before belongs to nobody.
    World world;
    world.gravity.setZero();
    const std::vector<Vec3> above_t0{{0.45, 0.005, 0}, {0, 50, 0}, {0, 50, 1}},
        face_t0{{-1, -0.06, -1}, {-1, -0.06, 1}, {1, 0.06, 0}};
    auto above = std::make_unique<PointMasses>("above", above_t0, std::vector<Face>{{0, 1, 2}}, 1.0);
    auto face = std::make_unique<PointMasses>("face", face_t0, std::vector<Face>{{0, 1, 2}}, 1.0);
    above->set_velocity(0, {-0.9, 0.005, 0});
    face->set_velocity(0, {0, 0.14, 0});
    face->set_velocity(1, {0, 0.14, 0});
    face->set_velocity(2, {0, -0.14, 0});
    world.bodies.push_back(std::move(above));
    world.bodies.push_back(std::move(face));

    const double k = 0.01, dt = 1;
    Contacts contacts;
    const Solver solver = chapter03_solver({PenaltyMethod::continuous, k});
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
    for (const Pass& pass : solver.passes(StepStage::detect))
        pass.run(world, contacts, dt);
    const auto pair = std::find_if(contacts.begin(), contacts.end(),
                                   [](const Contact& c) { return c.kind == ContactKind::vertex_face; });
    REQUIRE(pair != contacts.end());
    CHECK(pair->start > 0.5);
    const PairStep step = pair_step(world, *pair);
    push_apart(world, contacts, continuous_penalty, k, dt);
    apply_impulses(world, contacts);
    const double second_visit = continuous_impulse(step, 0.5, k, dt).norm(),
                 both_visits = continuous_impulse(step, 0, k, dt).norm();
    CHECK(pair->impulse.norm() == doctest::Approx(second_visit).epsilon(1e-6));
    CHECK(both_visits > 1.3 * second_visit);
}
