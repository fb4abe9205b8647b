#include "chapters/07_implicit_contact/restitution.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/natural_units.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

/// A pyramid that stands on its apex: four corners of a square as wide as high, and a vertex below their
/// middle.
SurfaceMesh standing_pyramid(double size)
{
    const double half = size / 2;
    return {{{-half, size, -half}, {-half, size, half}, {half, size, half}, {half, size, -half}, {0, 0, 0}},
            {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}}};
}

/// Pyramids of a kilogram above each other, each with its apex on the middle of the one below, so nothing
/// turns; behind the commit of a step in which their pairs pushed.
struct Tower {
    double size, pressed = 1e-4 * size;
    World world;
    Contacts contacts;  ///< the ground's first

    explicit Tower(double of_each = 1) : size(of_each)
    {
        world.planes.push_back({"ground"});
        world.gravity.setZero();
    }
    void press(Contact contact, double impulse, double by)
    {
        contact.state = ContactState::answered;
        contact.impulse = impulse * Vec3::UnitY();
        contact.spring.stiffness = impulse / (by * dt);
        contact.spring.load = 5;
        contact.spring.stretch = Vec3(1e-5, 0, 0);
        contacts.push_back(contact);
    }
    /// @param velocity  that it would have without the impulses of pairs [m/s]
    /// @param below     impulse of the pair under it [N s]
    /// @param above     of the pair on it
    void add(double velocity, double below, double above)
    {
        const int place = static_cast<int>(world.bodies.size());
        SurfaceMesh mesh = standing_pyramid(size);
        for (Vec3& x : mesh.vertices)
            x.y() += place * size - (place + 1) * pressed;
        world.bodies.push_back(std::make_unique<RigidBody>("pyramid " + std::to_string(place), mesh,
                                                           with_mass(mass_properties(mesh, 1), 1),
                                                           Vec3(0, velocity + below - above, 0)));
        world.bodies.back()->update_prediction(dt);
        if (place == 0)
            press({ContactKind::vertex_plane, 0, 0, 4, -1, {4, -1, -1, -1}, {1, 0, 0, 0}}, below, pressed);
        else
            press({ContactKind::vertex_face, place, place - 1, 4, 0, {4, 0, 1, 2}, {1, -0.5, 0, -0.5}}, below,
                  pressed);
        // what remember_pairs() says: whether the pair was open when the step began
        const double approach = this->velocity(place) - (place > 0 ? this->velocity(place - 1) : 0);
        contacts.back().began_open = -pressed - dt * approach > -1e-9 * size;
    }
    double velocity(int place) const
    {
        return world.bodies[static_cast<std::size_t>(place)]->mean_velocity().y();
    }
    Island island() { return find_islands(world, contacts).at(0); }
};

/// The lower pyramid rests, and the upper one comes with 1 m/s: the step has stopped it, 0.1 mm inside.
Tower struck_tower(double e_of_ground, double e_between, double gravity = 0)
{
    Tower tower;
    tower.world.gravity = Vec3(0, -gravity, 0);
    const double weight = gravity * dt, upper = 1 - tower.pressed / dt;
    tower.add(-weight, upper + weight, upper);
    tower.add(-1, upper, 0);
    tower.world.bodies[0]->set_material(0);
    tower.world.bodies[1]->set_material(0);
    tower.world.restitution = {1, {0, e_of_ground, e_of_ground, e_between}};
    return tower;
}

double kinetic(const World& world) { return total_energy(world).kinetic; }

}  // namespace

TEST_CASE("restitution: what rests is stopped by what falls on it, and does not bounce")
{
    constexpr double g = 9.81;
    for (const double e : {0.5, 1.0}) {
        Tower tower = struck_tower(e, e, g);
        restitute(tower.world, tower.contacts, {}, dt);
        CHECK(std::abs(tower.velocity(0)) < 1e-6);
        CHECK(tower.velocity(1) == doctest::Approx(e * (1 - g * dt)).epsilon(2e-3));
    }
}

TEST_CASE(
    "restitution: pairs with different coefficients gain no energy, and their impulses are what moves the bodies")
{
    // The upper pair would end with -0.6 m/s: it ends at rest, and the energy of before allows a part of that
    // only.
    Tower tower = struck_tower(1, 0.2);
    const double before = tower.velocity(1);
    const Contacts pushed = tower.contacts;
    restitute(tower.world, tower.contacts, {}, dt);
    CHECK(kinetic(tower.world) == doctest::Approx(0.5).epsilon(1e-9));
    CHECK((tower.velocity(1) - before) / tower.velocity(0) == doctest::Approx((0.8 - before) / 0.8));
    const Vec3 below = tower.contacts[0].impulse - pushed[0].impulse,
               between = tower.contacts[1].impulse - pushed[1].impulse;
    CHECK(between.y() == doctest::Approx(tower.velocity(1) - before));
    CHECK((below - between).y() == doctest::Approx(tower.velocity(0)));
}

TEST_CASE("restitution: a pair that bounces holds nothing any more, and one that does not holds what it held")
{
    Tower tower = struck_tower(0, 0.5);
    restitute(tower.world, tower.contacts, {}, dt);
    CHECK(tower.contacts[0].spring.load == 5);
    CHECK(tower.contacts[0].spring.stretch.x() == 1e-5);
    CHECK(tower.contacts[1].spring.load == 0);
    CHECK(tower.contacts[1].spring.stretch.isZero(0));
}

TEST_CASE("restitution: the velocity with which a pair leaves carries it up from where its spring is pressed")
{
    constexpr double g = 9.81, leaving = 0.7;
    for (const double pressed : {0.0, 1e-4, 1e-2}) {
        const double end = speed_after({.acceleration = -g, .pressed = pressed, .dt = dt}, leaving);
        const double in_the_middle = end - g * dt / 2;
        CHECK(in_the_middle * in_the_middle / 2 - g * pressed == doctest::Approx(leaving * leaving / 2));
    }
}

TEST_CASE("restitution: how little is pressed is a part of the body's size")
{
    for (const double size : {1e-3, 1.0, 50.0}) {
        const double length =
            RigidBody("one", standing_pyramid(size), mass_properties(standing_pyramid(size), 1)).size();
        CAPTURE(size);
        for (const double part : {0.3, 3.0}) {
            const double least = part * restitution_limits.least_length * length;
            Tower pushed(size);
            pushed.world.restitution.between = {1};
            pushed.add(-1, 1 - pushed.pressed / dt, 0);
            CHECK(pushed.island().contacts.size() == 1);
            pushed.contacts[0].spring.stiffness = pushed.contacts[0].impulse.norm() / (least * dt);
            CHECK(pushed_part(pushed.world, pushed.island(), dt).contacts.size() == (part > 1 ? 1 : 0));
        }
    }
}

TEST_CASE("restitution: without gravity rounding does not bounce, and what is ten times as fast does")
{
    for (const double size : {0.1, 1.0, 10.0})
        for (const double part : {0.1, 10.0}) {
            Tower tower(size);
            const double length = natural_length(tower.world, (tower.add(0, 1, 1), tower.contacts[0])),
                         speed = part * scale_parts.least_answer * length / dt;
            tower = Tower(size);
            tower.pressed = dt * speed;
            tower.world.restitution.between = {1};
            tower.add(-2 * speed, speed, 0);
            CAPTURE(size);
            CAPTURE(part);
            const IslandImpact impact = impact_of(tower.world, tower.island(), {}, dt);
            REQUIRE(impact.pairs.size() == 1);
            CHECK(impact.pairs[0].meets == (part > 1));
        }
}

namespace {

/// A pyramid that comes with 1 m/s onto a belt.
struct OnBelt {
    Tower tower;

    OnBelt(double e, double belt)
    {
        tower.world.restitution.between = {e};
        const double impulse = 1 - tower.pressed / dt;
        tower.add(-1, impulse, 0);
        tower.world.bodies.push_back(
            std::make_unique<StaticBody>("belt", SurfaceTopology(4, {{{0, 1, 2}}, {{0, 2, 3}}}),
                                         std::vector<Vec3>{{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}}));
        tower.world.bodies[1]->set_surface_velocity(Vec3(belt, 0, 0));
        tower.contacts.clear();
        tower.press({ContactKind::vertex_face, 0, 1, 4, 0, {4, 0, 1, 2}, {1, -0.5, 0, -0.5}}, impulse,
                    tower.pressed);
        tower.contacts[0].began_open = true;
    }
};

}  // namespace

TEST_CASE("restitution: a belt drags what bounces on it by mu_d times what sends it back, and pays for it")
{
    constexpr double mu_s = 0.3, mu_d = 0.1;
    for (const double e : {0.25, 0.5, 1.0})
        for (const double belt : {-5.0, 3.0}) {
            auto [tower] = OnBelt(e, belt);
            const double dragged = std::copysign(mu_d * (e + tower.pressed / dt), belt);
            restitute(tower.world, tower.contacts, {mu_s, mu_d}, dt);
            CAPTURE(e);
            CAPTURE(belt);
            CHECK(tower.velocity(0) == doctest::Approx(e));
            CHECK(tower.world.bodies[0]->mean_velocity().x() == doctest::Approx(dragged));
            CHECK(tower.contacts[0].friction.x() == doctest::Approx(dragged));
            CHECK(tower.world.driven == doctest::Approx(dragged * belt));
        }
}

TEST_CASE("restitution: what a belt has given in the step of an impact may be given back, too")
{
    const auto lost = [](double belt) {
        auto [tower] = OnBelt(0.5, belt);
        tower.contacts[0].friction = Vec3(0.05, 0, 0);
        return impact_of(tower.world, tower.island(), {0.3, 0.1}, dt).lost;
    };
    for (const double belt : {-5.0, 3.0})
        CHECK(lost(belt) - lost(0) == doctest::Approx(0.05 * belt));
}

TEST_CASE("reflections: light and heavy balls are stopped alike, and what leaves fast hides no slow approach")
{
    Eigen::MatrixXd pairs = Eigen::MatrixXd::Zero(4, 5);
    for (int i = 0; i < 4; ++i) {
        pairs(i, i) = -1;
        pairs(i, i + 1) = 1;
    }
    Eigen::VectorXd velocities = Eigen::VectorXd::Zero(5);
    velocities[0] = 1;
    for (const double mass : {1e-9, 1.0, 1e9}) {
        const Eigen::MatrixXd response = pairs * pairs.transpose() / mass;
        const Eigen::VectorXd before = pairs * velocities;
        CAPTURE(mass);
        CHECK((before + response * stopping_impulses(response, before)).minCoeff() > -1e-6);
    }
    const Eigen::VectorXd apart = Eigen::Vector2d(-1, 1e9);
    CHECK((reflecting_impulses(Eigen::Matrix2d::Identity(), apart) - Eigen::Vector2d(2, 0)).norm() < 1e-12);
    CHECK(allowed_part(-2, 1, -1.2) == 1);
}
