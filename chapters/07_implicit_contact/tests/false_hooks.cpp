#include "chapters/07_implicit_contact/false_hooks.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/normal_cone.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

constexpr double pi = std::numbers::pi;

Vec3 random_vector(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    return {normal(random), normal(random), normal(random)};
}

/// The cosine of the angle between a unit vector and a cone: the foot on the cone is the sum of normals with
/// weights >= 0 that comes nearest, found one weight after the other.
double cosine_to_cone(const std::vector<Vec3>& normals, const Vec3& direction)
{
    std::vector<double> weights(normals.size(), 0);
    Vec3 foot = Vec3::Zero();
    for (int sweep = 0; sweep < 20000; ++sweep)
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const double weight = std::max(0.0, weights[i] + normals[i].dot(direction - foot));
            foot += (weight - weights[i]) * normals[i];
            weights[i] = weight;
        }
    return foot.norm();
}

/// Vertex 0 at the origin, and flat faces down from it: convex if its rim is.
struct TipSurface {
    SurfaceTopology topology;
    std::vector<Vec3> positions;

    SurfaceMoment surface() const { return {{topology, positions, positions}, 0}; }
    std::span<const int> faces() const { return topology.faces_around_vertex(0); }
    /// Whether a flat obstacle touches the tip without cutting into it. Needs no normal of its faces.
    bool can_be_touched(const Vec3& contact_normal) const
    {
        return std::all_of(positions.begin(), positions.end(),
                           [&](const Vec3& x) { return contact_normal.dot(x) >= 0; });
    }
};

/// @param angle  of the edges with the axis below the tip [rad], before it is drawn out by x and z
TipSurface tip_surface(int edges, double angle, double x = 1, double z = 1)
{
    std::vector<Vec3> positions{Vec3::Zero()};
    std::vector<Face> faces;
    for (int i = 0; i < edges; ++i) {
        const double around = 2 * pi * i / edges;
        positions.emplace_back(x * std::sin(angle) * std::cos(around), -std::cos(angle),
                               -z * std::sin(angle) * std::sin(around));
        faces.push_back({0, i + 1, (i + 1) % edges + 1});
    }
    return {SurfaceTopology(edges + 1, faces), positions};
}

TipSurface random_tip(std::mt19937& random)
{
    std::uniform_real_distribution<double> number(0, 1);
    const int edges = 3 + static_cast<int>(random() % 4);
    const double angle = 0.1 + 1.4 * number(random), x = 0.5 + number(random), z = 0.5 + number(random);
    return tip_surface(edges, angle, x, z);
}

}  // namespace

TEST_CASE("normal cone: it reaches as far as the nearest sum of its normals says")
{
    std::mt19937 random(5);
    int reached = 0, only_inside = 0;
    for (int i = 0; i < 60; ++i) {
        std::vector<Vec3> normals;
        for (auto n = 1 + random() % 5; n > 0; --n)
            normals.push_back((random_vector(random) + Vec3(0, 2, 0)).normalized());
        for (int j = 0; j < 10; ++j) {
            const Vec3 direction = (random_vector(random) + Vec3(0, 1, 0)).normalized();
            const double cosine = cosine_to_cone(normals, direction);
            for (const double asked : {0.5, hook_cosine, 0.95})
                if (std::abs(asked - cosine) > 1e-3) {
                    CAPTURE(cosine);
                    CAPTURE(asked);
                    CHECK(cone_reaches(normals, 3 * direction, asked) == (asked < cosine));
                }
            reached += cosine > hook_cosine;
            only_inside += cosine > 0.9999 &&
                           std::none_of(normals.begin(), normals.end(),
                                        [&](const Vec3& n) { return n.dot(direction) > 0.99; });
        }
    }
    CHECK(reached > 100);
    CHECK(only_inside > 20);
}

TEST_CASE("normal cone: the normals of a flat side's triangles, which rounding tells apart, span nothing")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> rounding(-1e-15, 1e-15);
    for (int i = 0; i < 2000; ++i) {
        const Mat3 turn = Eigen::AngleAxisd(i, random_vector(random).normalized()).toRotationMatrix();
        const auto nearly = [&](const Vec3& n) {
            return Vec3(turn * n + Vec3(rounding(random), rounding(random), rounding(random)));
        };
        // the corner of a box, each of whose sides has two triangles there
        const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
        const std::vector<Vec3> normals{nearly(x), nearly(x), nearly(y), nearly(y), nearly(z), nearly(z)};
        for (const Vec3& side : {x, y, z})
            CHECK_FALSE(cone_reaches(normals, nearly(-side), hook_cosine));
        CHECK(cone_reaches(normals, nearly(Vec3::Ones()), 0.999));
    }
}

TEST_CASE("normal cone: it holds against what a flat obstacle can touch, at a tip of any shape, and else not")
{
    std::mt19937 random(11);
    int touching = 0, hooked_by_span = 0;
    for (int i = 0; i < 2000; ++i) {
        const TipSurface tip = random_tip(random);
        const Vec3 normal = random_vector(random).normalized();
        const bool touches = tip.can_be_touched(normal);
        CHECK(cone_reaches(tip.surface(), tip.faces(), -normal, 1 - 1e-9) == touches);
        touching += touches;
        hooked_by_span += touches && is_hooked_vertex(tip.surface(), 0, normal);
    }
    CHECK(touching > 100);
    CHECK(hooked_by_span > 0);
}

TEST_CASE(
    "errata: the face normals and their average do not stand for the span of 6.2.2: a spike that meets a wall with an edge would be hooked")
{
    const TipSurface spike = tip_surface(3, 0.1);
    int hooked = 0;
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double angle = degrees * pi / 180;
        const Vec3 wall(std::cos(angle), 0, std::sin(angle));  // upright, as the spike is but for 6 degrees
        hooked += is_hooked_vertex(spike.surface(), 0, wall);
        CHECK(cone_reaches(spike.surface(), spike.faces(), -wall, hook_cosine));
    }
    CHECK(hooked > 12);
}

TEST_CASE(
    "normal cone: what lies 45 degrees beside all of it is hooked still, and a surface without normals is reached")
{
    const TipSurface cube = tip_surface(3, std::acos(std::sqrt(1.0 / 3)));  // of its corner
    CHECK(cone_reaches(cube.surface(), cube.faces(), Vec3::UnitY(), 0.9999));
    CHECK_FALSE(cone_reaches(cube.surface(), cube.faces(), -Vec3::UnitY(), hook_cosine));
    CHECK(cone_reaches(cube.surface(), std::vector<int>{-1}, Vec3::UnitX(), hook_cosine));
}

TEST_CASE("false hooks: the tip of a narrow spike does not pass the wall of a wide crack")
{
    Scene scene = tip_in_crack(Tip::spike, 33, 60, 0.01);
    SolveStatistics solves;
    const Solver solver = counting_solver(solves)(scene.contact);
    Contacts contacts;
    double deepest = 0;
    for (int step = 0; step < 45; ++step) {  // until it has slid to the bottom
        advance(scene.world, contacts, solver, scene.dt);
        for (const Vec3& x : scene.world.bodies[1]->positions_t0())
            deepest = std::max(deepest, 0.5 * std::abs(x.x()) * std::sqrt(3.0) - 0.5 * x.y());
    }
    CHECK(contacts.size() > 0);
    CHECK(deepest < 2e-3);
}

TEST_CASE("false hooks: the spike passes neither wall at the bottom of the crack")
{
    for (const auto& angles : {std::pair(33.0, 60), {12.8, 88}, {53.0, 55}})
        for (const double dt : {0.01, 1.0 / 60}) {
            CAPTURE(angles.second);
            Scene scene = tip_in_crack(Tip::spike, angles.first, angles.second, dt);
            const PileOutcome outcome = watch(scene, 4);
            CHECK(outcome.energy_gain_j <= 1e-9);
            CHECK(outcome.deepest_ever_mm < 5);
            for (const Vec3& x : scene.world.bodies[1]->positions_t0())
                CHECK(x.y() > -0.005);
        }
}

TEST_CASE("false hooks: a wedge that slips off the edge of another one gains no energy")
{
    for (const double dt : {0.01, 1.0 / 60}) {
        Scene scene = wedge_on_edge(dt);
        const PileOutcome outcome = watch(scene, 2);
        CHECK(outcome.energy_gain_j <= 1e-9);
        CHECK(outcome.deepest_ever_mm < 5);
    }
}
