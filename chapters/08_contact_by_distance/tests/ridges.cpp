#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/08_contact_by_distance/experiments/ridge_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/08_contact_by_distance/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE("ridges: what comes down a centimetre goes less far in than both skins, also along a ridge")
{
    for (const RidgePlan& plan : ridge_plans())
        for (const double dt : {0.01, 0.002}) {
            CAPTURE(plan.name);
            CAPTURE(dt);
            Scene scene = ridge_scene(plan, dt);
            const chapter07::DepthOutcome outcome = chapter07::measure_depths(scene, 1, chapter08_solver);
            CHECK(outcome.deepest_m <
                  3e-4);  // their boxes have skins of 0.25 mm, which recede farther at edges
            // Two ridges 0.01 degrees askew may take all steps of Newton's method that there are: as they
            // slide by 0.16 mm in a step, the place where they cross moves by a metre, more than they are
            // long, and their normal turns 5,700 times as far as the body.
            CHECK(outcome.unsolved <= 1);
        }
}

TEST_CASE("ridges: a box over the border of a sheet stays if its middle is over the sheet, and falls if not")
{
    for (const RidgePlan& plan : ridge_plans()) {
        if (plan.kind != RidgePlan::Kind::border)
            continue;
        CAPTURE(plan.name);
        Scene scene = ridge_scene(plan, 0.01);
        chapter07::measure_depths(scene, 1.5, chapter08_solver);
        CHECK(is_held(scene) == (plan.aside < 0));
    }
}

namespace {

/// Two cards of 30 cm that lean by 15 degrees, one millimetre apart at their tips, in the mirror x = 0.
World leaning_cards()
{
    const double height = 0.3, thickness = 0.008, lean = 15 * M_PI / 180, gap = 1e-3;
    World world;
    world.planes.push_back({"ground"});
    for (const int side : {-1, 1}) {
        const Quaternion turn(Eigen::AngleAxisd(side * lean, Vec3::UnitZ()));
        const double half_width = 0.5 * (height * std::sin(lean) + thickness * std::cos(lean)),
                     half_height = 0.5 * (height * std::cos(lean) + thickness * std::sin(lean));
        const SurfaceMesh card = placed(box({thickness, height, 0.2}), turn,
                                        Vec3(side * (half_width + 0.5 * gap), half_height + 1e-4, 0));
        world.bodies.push_back(
            std::make_unique<RigidBody>("card", card, mass_properties(card, 700), Vec3::Zero()));
    }
    return world;
}

}  // namespace

TEST_CASE("leaning cards: with long steps, too, their tips meet and do not pass each other")
{
    for (const double dt : {0.01, 0.02, 0.033}) {
        World world = leaning_cards();
        ContactParameters parameters;
        parameters.friction = MassSplitting{0.6, 0.6};
        const Solver solver = chapter08_solver(parameters);
        Contacts contacts;
        double passed = -INFINITY, top = 0;  // of the left card: beyond the mirror, and at the end
        while (world.time < 0.2) {
            advance(world, contacts, solver, dt);
            top = 0;
            for (const Vec3& vertex : world.bodies[0]->positions_t0()) {
                passed = std::max(passed, vertex.x());
                top = std::max(top, vertex.y());
            }
        }
        CAPTURE(dt);
        CHECK(passed < 1e-4);
        CHECK(top > 0.29);  // they hold each other
    }
}
