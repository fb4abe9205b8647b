#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/mass_splitting_friction.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/simulation/point_masses.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

const std::array<FrictionParameters, 2> both_models{YamaneNakamura{}, MassSplitting{.spring = 50}};

/// One point of 1 kg on a plane with the normal y, already pushed by it, and
/// predicted to move by `way` in a step of 0.1 s.
struct OnPlane {
    World world;
    Contacts contacts;
    FrictionParameters friction;
    static constexpr double dt = 0.1;

    OnPlane(const FrictionParameters& model, const Vec3& way) : friction(model)
    {
        world.gravity.setZero();
        world.planes.push_back({"floor"});
        world.bodies.push_back(std::make_unique<PointMasses>(
            "point", std::vector<Vec3>{{0, 0, 0}, {5, 9, 0}, {0, 9, 5}}, std::vector<Face>{{0, 1, 2}}, 1.0));
        dynamic_cast<PointMasses&>(*world.bodies[0]).set_velocity(0, way / dt);
        world.bodies[0]->predict(world.gravity, dt);
        Contact contact;
        contact.kind = ContactKind::vertex_plane;
        contact.body_a = contact.body_b = contact.feature_a = contact.vertices[0] = 0;
        contact.weights[0] = 1;
        contact.impulse = {0, 2, 0};
        contacts.push_back(contact);
    }
    Contact& contact() { return contacts[0]; }
    void finish() { move_friction_anchors(world, contacts, friction, dt); }
};

}  // namespace

TEST_CASE("friction anchors: a point that is held drags its stretch along the surface, not off it")
{
    for (const FrictionParameters& model : both_models) {
        OnPlane it(model, {0.01, -0.5, 0.02});
        it.contact().spring.stretch = {0.001, 0, 0};
        it.finish();
        CHECK((it.contact().spring.stretch - Vec3(0.011, 0, 0.02)).norm() < 1e-15);
        it.contact().start = 0.75;  // a new pair counts from its time of impact
        it.finish();
        CHECK((it.contact().spring.stretch - Vec3(0.0135, 0, 0.025)).norm() < 1e-15);
    }
}

TEST_CASE("friction anchors: a pair that does not push has none, and one that is held keeps its own")
{
    OnPlane it(MassSplitting{.spring = 50}, {0.01, 0, 0});
    it.contact().spring.stretch = {0.001, 0, 0};
    it.contact().hold(true);
    it.contact().impulse.setZero();
    it.finish();
    CHECK(it.contact().spring.stretch == Vec3(0.001, 0, 0));
    it.contact().hold(false);
    it.finish();
    CHECK(it.contact().spring.stretch == Vec3::Zero());
}

TEST_CASE(
    "friction anchors: when a pair lets go, the thesis' anchor comes to the point, the mass-splitting one within its pull")
{
    OnPlane printed(YamaneNakamura{}, {0.3, 0, 0});
    printed.contact().spring.slip = 3;
    printed.finish();
    CHECK(printed.contact().spring.stretch == Vec3::Zero());

    OnPlane mass_splitting(MassSplitting{.spring = 50}, {0.3, 0, 0});
    mass_splitting.contact().spring.slip = 0.01;
    mass_splitting.contact().friction = {-0.6, 0, 0};  // 6 N, that is 0.12 m of a spring of 50 N/m
    mass_splitting.finish();
    CHECK((mass_splitting.contact().spring.stretch - Vec3(0.12 * std::exp(-20 * 0.01), 0, 0)).norm() < 1e-14);
    mass_splitting.contact().spring.slip = 10;
    mass_splitting.finish();
    CHECK(mass_splitting.contact().spring.stretch.norm() < 1e-20);
}

TEST_CASE("friction: the pass computes and applies nothing, and only for pairs that wait and push")
{
    for (const FrictionParameters& model : both_models) {
        OnPlane it(model, {0.1, 0, 0});
        it.contacts.resize(4, it.contact());
        it.contacts[1].state = ContactState::answered;
        it.contacts[2].hold(true);
        it.contacts[3].impulse.setZero();
        compute_friction_impulses(it.world, it.contacts, it.friction, it.dt);
        CHECK(it.contacts[0].friction.x() < -0.01);
        for (std::size_t other = 1; other < 4; ++other)
            CHECK(it.contacts[other].friction == Vec3::Zero());
        CHECK(it.world.bodies[0]->velocity(0) == Vec3(1, 0, 0));
        CHECK_FALSE(it.contact().answered());
    }
}

TEST_CASE("friction: a scene without friction runs as in chapter 3, to the last bit")
{
    CHECK(chapter04_solver({}).passes(StepStage::respond).size() + 1 == [] {
        ContactParameters rough;
        rough.friction = MassSplitting{};
        return chapter04_solver(rough).passes(StepStage::respond).size();
    }());
    CHECK(chapter04_solver({}).passes(StepStage::finish).empty());
}

TEST_CASE("friction anchors: a pair that waits and does not push slips no more")
{
    for (const FrictionParameters& model : both_models) {
        OnPlane it(model, {0.01, 0, 0});
        it.contact().impulse.setZero();
        it.contact().spring.slip = 3;  // of the step before
        compute_friction_impulses(it.world, it.contacts, it.friction, OnPlane::dt);
        CHECK(it.contact().spring.slip == 0);
    }
}

TEST_CASE("friction anchors: a stretch from before the surface tilted is laid along it, held or slipping")
{
    for (const double slip : {0.0, 0.01}) {
        OnPlane it(MassSplitting{.spring = 50}, Vec3::Zero());
        it.contact().spring.stretch = {0.01, 0.02, 0};
        it.contact().spring.slip = slip;
        it.contact().friction = {-0.6, 0, 0};  // enough for 0.12 m
        it.finish();
        CHECK((it.contact().spring.stretch - Vec3(0.01, 0, 0)).norm() < 1e-15);
    }
}
