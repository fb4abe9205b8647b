#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "chapters/08_contact_by_distance/experiments/soft_contact_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/08_contact_by_distance/tests/resumed.hpp"

using namespace enduring;
using namespace enduring::chapter08;

namespace {

double apart(const std::function<Scene()>& make, int saved_after, int steps)
{
    return apart_when_resumed(
        make, [](const ContactParameters& parameters) { return chapter08_solver(parameters); }, saved_after,
        steps);
}

}  // namespace

TEST_CASE("resumed run: rigid bodies go on with the same numbers, to the last bit, wherever they were saved")
{
    for (const int saved_after : {30, 61})
        for (const unsigned seed : {1U, 2U}) {
            CAPTURE(saved_after);
            CAPTURE(seed);
            CHECK(apart(
                      [&] {
                          return random_heap({mixed_family, 8, seed == 1 ? 0.01 : 0.004, 0.5, seed});
                      },
                      saved_after, 80) == 0);
        }
}

TEST_CASE("resumed run: what spins and lands in halved steps goes on with the same numbers, too")
{
    const HeapPlan notches{4, 8, 0.02, 0.1, 74, 30}, tetrahedra{0, 8, 0.01, 0, 198, 30},
        lumps{6, 6, 0.02, 0.5, 4, 30};
    for (const HeapPlan& plan : {notches, tetrahedra, lumps})
        for (const double saved_at : {0.4, 0.6}) {
            CAPTURE(family_name(plan.family));
            CAPTURE(saved_at);
            CHECK(apart([&] { return random_heap(plan); }, static_cast<int>(std::lround(saved_at / plan.dt)),
                        static_cast<int>(std::lround(0.8 / plan.dt))) == 0);
        }
}

TEST_CASE(
    "resumed run: soft bodies go on with the same numbers, to the last bit, on the ground and on each other")
{
    for (const int saved_after : {10, 40}) {
        CAPTURE(saved_after);
        CHECK(apart(
                  [] {
                      return chapter07::soft_cube_on_triangles({2, 1e6, 0.01, 100}, 0.4);
                  },
                  saved_after, 60) == 0);
    }
    for (const Basis basis : {Basis::linear, Basis::quadratic}) {
        CAPTURE(static_cast<int>(basis));
        CHECK(apart([&] { return soft_collision({basis, 1e5, 0.005, 1}); }, 13, 30) == 0);
    }
}

namespace {

using driven_parts::json;

json scene_of_parts(double mu, const std::vector<json>& bodies)
{
    json text = driven_parts::scene_text("parts", 1, 1, mu, 0.8 * mu);
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    text["bodies"] = bodies;
    return text;
}

/// A box tips over the border of an open sheet that is driven, and a ball rolls on a rigid sheet which
/// reaches over a box.
json open_sheets()
{
    json driven{{"name", "driven"},
                {"type", "static"},
                {"shape", {{"plane_grid", {{"size", {1, 1}}}}}},
                {"position", {0, 0.3, 0}}};
    driven["motion"]["table"] = {
        {{"time", 0}},
        {{"time", 0.4}, {"displacement", {0.1, 0.1, 0}}, {"turn", {{"axis", {0, 1, 0}}, {"angle_deg", 30}}}}};
    const json loose{{"name", "loose"},
                     {"type", "rigid"},
                     {"sheet", true},
                     {"mass", 3},
                     {"shape", {{"plane_grid", {{"size", {0.5, 0.5}}}}}},
                     {"position", {3.1, 0.42, 0}}};
    const json ball{{"name", "ball"},
                    {"type", "rigid"},
                    {"shape", {{"sphere", {{"radius", 0.1}}}}},
                    {"velocity", {0.4, 0, 0.1}},
                    {"mass", 1},
                    {"position", {3.05, 0.55, 0.02}}};
    return scene_of_parts(
        0.6, {driven, driven_parts::box_body("over", "rigid", {0.3, 0.2, 0.25}, {0.53, 0.4, 0.05}),
              driven_parts::box_body("box", "rigid", {0.4, 0.4, 0.4}, {3, 0.2, 0}), loose, ball});
}

/// Blocks on a disc that turns faster and faster, on a belt, and under a piston that comes down.
json driven_bodies()
{
    json disc = driven_parts::box_body("disc", "static", {1.6, 0.2, 1.6}, {0, 0.3, 0}),
         belt = driven_parts::box_body("belt", "static", {2, 0.2, 1}, {3, 0.3, 0}),
         piston = driven_parts::box_body("piston", "static", {0.5, 0.2, 0.5}, {6, 0.55, 0});
    disc["motion"]["table"] = {{{"time", 0}},
                               {{"time", 0.1}, {"turn", {{"axis", {0, 1, 0}}, {"angle_deg", 30}}}},
                               {{"time", 0.4}, {"turn", {{"axis", {0, 1, 0}}, {"angle_deg", 300}}}}};
    belt["surface_velocity"] = {1.5, 0, 0.2};
    piston["motion"]["table"] = {{{"time", 0}},
                                 {{"time", 0.2}, {"displacement", {0, -0.1501, 0}}},
                                 {{"time", 0.4}, {"displacement", {0.1, 0, 0}}}};
    return scene_of_parts(
        0.5, {disc, belt, piston, driven_parts::box_body("rider", "rigid", {0.2, 0.1, 0.2}, {0.4, 0.45, 0.1}),
              driven_parts::box_body("carried", "rigid", {0.3, 0.1, 0.3}, {3, 0.45, 0}),
              driven_parts::box_body("pressed", "rigid", {0.3, 0.3, 0.3}, {6.05, 0.15, 0.02})});
}

/// A crank on a hinge pushes a slider, and a door is hit by a block that a spring pulls.
json held_directions()
{
    json crank = driven_parts::box_body("crank", "rigid", {0.4, 0.1, 0.1}, {0.15, 0.5, 0}),
         slider = driven_parts::box_body("slider", "rigid", {0.1, 0.8, 0.2}, {0.42, 0.5, 0}),
         door = driven_parts::box_body("door", "rigid", {0.1, 0.5, 0.5}, {3, 0.5, 0}),
         block = driven_parts::box_body("block", "rigid", {0.2, 0.2, 0.2}, {2.7, 0.35, 0.1});
    crank["locked"] = {{"about", {-0.15, 0, 0}}, {"rotation", {"x", "y"}}};
    crank["angular_velocity"] = {0, 0, 6};
    slider["locked"] = {{"translation", {"y", "z"}}, {"rotation", {"x", "y", "z"}}};
    slider["forces"] = json::array({json::object({{"force", {-5, 0, 0}}})});
    door["locked"] = {{"about", {0, 0, -0.25}}, {"rotation", {"x", "z"}}};
    block["velocity"] = {2, 1, 0};
    block["forces"] =
        json::array({json::object({{"spring", {{"anchor", {3.2, 0.4, 0.1}}, {"stiffness", 40}}}})});
    return scene_of_parts(0.3, {crank, slider, door, block});
}

/// A soft bar that is clamped, bent at its other end, and let go onto a block.
json let_go()
{
    json bar{{"name", "bar"},
             {"type", "deformable"},
             {"density", 500},
             {"young", 2e5},
             {"poisson", 0.3},
             {"basis", "linear"},
             {"elasticity", "corotated_at_points"},
             {"position", {0, 0.35, 0}}};
    bar["shape"]["bar"] = {{"size", {0.8, 0.1, 0.1}}, {"cells", {6, 1, 1}}};
    bar["fixed"] = {{"max", {-0.399, 1, 1}}};
    json end{{"min", {0.399, -1, -1}}, {"until", 0.15}};
    end["motion"]["table"] = {{{"time", 0}}, {{"time", 0.15}, {"displacement", {-0.05, 0.15, 0.05}}}};
    bar["driven"] = json::array({end});
    return scene_of_parts(0.4,
                          {bar, driven_parts::box_body("block", "rigid", {0.2, 0.2, 0.3}, {0.3, 0.1, 0})});
}

}  // namespace

TEST_CASE(
    "resumed run: open sheets, driven bodies, held directions and freed nodes go on with the same numbers, with any step")
{
    const std::pair<const char*, json> scenes[] = {{"open sheets", open_sheets()},
                                                   {"driven bodies", driven_bodies()},
                                                   {"held directions", held_directions()},
                                                   {"let go", let_go()}};
    for (const auto& [name, scene] : scenes)
        for (const double dt : {0.003, 1.0 / 60})
            for (const double saved_at : {0.11, 0.27}) {
                json text = scene;
                text["dt"] = dt;
                CAPTURE(name);
                CAPTURE(dt);
                CAPTURE(saved_at);
                CHECK(apart([&] { return driven_parts::scene_from(text); },
                            static_cast<int>(std::lround(saved_at / dt)),
                            static_cast<int>(std::lround(0.4 / dt))) == 0);
            }
}
