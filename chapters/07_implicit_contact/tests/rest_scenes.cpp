#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/tests/extent.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

std::pair<double, double> heights(const Body& body) { return extent(body, 1); }

}  // namespace

TEST_CASE("prism: its volume is outline times length, also where the outline has a notch")
{
    const SurfaceMesh notched = prism({{0, 0}, {-1, 1}, {-2, 1}, {-2, -1}, {2, -1}, {2, 1}, {1, 1}}, 3);
    const MassProperties properties = mass_properties(notched, 1);  // throws unless closed and outwards
    CHECK(properties.mass == doctest::Approx((8 - 1) * 3));
    CHECK(properties.centre.z() == doctest::Approx(0));
}

TEST_CASE("card house: neighbours do not overlap, and each level stands on the flat cards of the one below")
{
    for (const double lean_deg : {10.0, 20.0}) {
        const Scene scene = scene_of(card_house(3, lean_deg), 0.01);
        const auto& cards = scene.world.bodies;
        REQUIRE(cards.size() == 2 * (3 + 2 + 1) + 2 + 1);
        for (std::size_t i = 0; i < 5; ++i)  // the six cards on the ground, from left to right
            CHECK(extent(*cards[i], 0).second <= extent(*cards[i + 1], 0).first + 1e-12);
        CHECK(extent(*cards[6], 0).second < extent(*cards[7], 0).first);  // the two flat ones on them
        for (const auto& [card, below] :
             {std::pair(6, 0), {7, 5}, {8, 6}, {11, 7}, {12, 8}, {13, 12}, {14, 12}})
            CHECK(extent(*cards[static_cast<std::size_t>(card)], 1).first ==
                  doctest::Approx(extent(*cards[static_cast<std::size_t>(below)], 1).second));
        CHECK(std::abs(extent(*cards[0], 1).first) < 1e-12);
    }
}

TEST_CASE("arch: its stones weigh the same, meet without a gap, and the outermost stand on the ground")
{
    const Scene scene = arch(20, 5, 0.01);
    REQUIRE(scene.world.bodies.size() == 20);
    for (std::size_t i = 0; i + 1 < 20; ++i)
        for (const int corner : {0, 1}) {
            const Vec3 mine = scene.world.bodies[i]->positions_t0()[corner == 0 ? 3 : 2];
            const Vec3 its = scene.world.bodies[i + 1]->positions_t0()[corner];
            CHECK((mine - its).norm() < 1e-12);
        }
    CHECK(std::abs(heights(*scene.world.bodies.front()).first) < 1e-12);
    CHECK(std::abs(heights(*scene.world.bodies.back()).first) < 1e-12);
    CHECK(heights(*scene.world.bodies[10]).second == doctest::Approx(5.5));
    CHECK(scene.world.bodies[4]->mass() == scene.world.bodies[15]->mass());
}

TEST_CASE("loaded block: the ton begins just above the soft cube, and presses it down by its weight over E A")
{
    Scene scene = ton_on_block({100, 1e7, 2}, 0.01);
    const auto [block_bottom, block_top] = heights(*scene.world.bodies[1]);
    CHECK(block_bottom == doctest::Approx(1e-4).epsilon(1e-6));
    CHECK(heights(*scene.world.bodies[0]).first - block_top == doctest::Approx(1e-4).epsilon(1e-6));
    CHECK(scene.world.bodies[1]->mass() == doctest::Approx(100));
    watch(scene, 1, chapter07_solver);
    // 9.81 kN on the whole top: 0.98 mm. It lies on a part of it, and the mesh is coarse.
    const double pressed = block_top - heights(*scene.world.bodies[0]).first;
    CHECK(pressed > 0.5e-3);
    CHECK(pressed < 3e-3);
}

TEST_CASE(
    "bunnies: as many fall as asked, above the bowl and one another, each as stiff as asked, no k given")
{
    const Scene scene = bunnies_in_bowl({2, 363, "linear", 3e5}, 0.02);
    REQUIRE(scene.world.bodies.size() == 3);
    CHECK(scene.dt == 0.02);
    CHECK(scene.contact.stiffness == ContactParameters{}.stiffness);
    CHECK_FALSE(scene.world.planes.at(0).stiffness.has_value());
    CHECK(heights(*scene.world.bodies[2]).first > heights(*scene.world.bodies[1]).second);
    for (std::size_t i = 1; i < 3; ++i) {
        const auto& bunny = dynamic_cast<const DeformableBody&>(*scene.world.bodies[i]);
        CHECK(bunny.elastic().material().young == 3e5);
        CHECK(bunny.mass() == doctest::Approx(30));
    }
}
