#include "chapters/08_contact_by_distance/experiments/pressed_soft.hpp"

#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/fem/point_laws.hpp"
#include "common/input/source_directory.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter08 {

using namespace driven_parts;

namespace {

constexpr double side = 0.4, young_of_pressed = 1e5, poisson_of_pressed = 0.4;  // [m], [Pa]

const char* word_of(ElasticLaw law)
{
    return law == ElasticLaw::neo_hookean           ? "neo_hookean"
           : law == ElasticLaw::corotated_at_points ? "corotated_at_points"
                                                    : "corotated";
}

Scene pressed_scene(const PressedSoft& plan)
{
    const bool is_bunny = plan.shape == "bunny";
    const double tall = is_bunny ? 9.45 * 0.04 : side;  // [m]
    json text = scene_text("pressed", plan.dt, 1.5, plan.mu, plan.mu);
    text["gravity"] = {0, 0, 0};
    json upper = box_body("upper", "static", {1.2, 0.1, 1.2}, {0, tall + 0.05, 0});
    upper["motion"] = {
        {"table", {{{"time", 0}}, {{"time", 1}, {"displacement", {0, (plan.height - 1) * tall, 0}}}}}};
    json soft{{"name", "soft"},
              {"type", "deformable"},
              {"density", 1000},
              {"young", young_of_pressed},
              {"poisson", poisson_of_pressed},
              {"elasticity", word_of(plan.law)},
              {"basis", plan.basis},
              {"impulse_response", "implicit"},
              {"rayleigh", {{"stiffness", 0.01}}}};
    if (is_bunny)
        soft["shape"] = {{"file", "bunny_363.msh"}, {"scale", 0.04}};
    else {
        soft["shape"] = {{"bar", {{"size", {side, side, side}}, {"cells", {3, 3, 3}}}}};
        soft["position"] = {0, side / 2, 0};
    }
    text["bodies"] = {box_body("lower", "static", {1.2, 0.1, 1.2}, {0, -0.05, 0}), upper, soft};
    return read_scene(text.dump(), "", "pressed.json", {{source_directory() / "common" / "meshes"}});
}

}  // namespace

double force_without_friction(ElasticLaw law, double height)
{
    const LameConstants lame = lame_constants({.young = young_of_pressed, .poisson = poisson_of_pressed});
    const auto stress = [&](double across) -> Mat3 {
        const Mat3 stretch = Vec3(across, height, across).asDiagonal();
        return law == ElasticLaw::neo_hookean ? NeoHookeanLaw(lame).stress(stretch)
                                              : CorotatedLaw(lame).stress(stretch);
    };
    double narrow = 1, wide = 2;  // the sides pull at one end and push at the other
    while (wide - narrow > 1e-12) {
        const double middle = (narrow + wide) / 2;
        (stress(middle)(0, 0) < 0 ? narrow : wide) = middle;
    }
    return -stress(narrow)(1, 1) * side * side;
}

PressedOutcome press_soft(const PressedSoft& plan)
{
    Scene scene = pressed_scene(plan);
    PressedOutcome outcome;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double dt) {
        outcome.inverted = std::max(outcome.inverted, world.bodies[2]->inverted_elements());
        outcome.force = body_forces(world, contacts, dt)[1].y();
        for (const Contact& contact : contacts)
            if (contact.answered())
                outcome.deepest_mm = std::max(outcome.deepest_mm,
                                              -1000 * contact_geometry(world, contact, 1).depth);
    });
    run(scene, chapter08_solver(scene.contact), {&watch});
    outcome.unsolved = static_cast<int>(scene.world.ended_badly);
    if (plan.shape == "block" && plan.mu == 0)
        outcome.formula = force_without_friction(plan.law, plan.height);
    return outcome;
}

/// Soft bodies pressed between plates that move as given: is the plate's force that of the material, and does
/// any element invert?
void pressed(const RunOptions& options, Report& report)
{
    Table table({"body", "basis", "elasticity", "mu", "height", "force_n", "formula_n", "deepest_mm",
                 "inverted", "unsolved"});
    double off = 0;
    int inverted = 0, unsolved = 0;
    const auto add = [&](const PressedSoft& plan) {
        const PressedOutcome found = press_soft(plan);
        table.add({plan.shape, plan.basis, word_of(plan.law), plan.mu, plan.height, found.force,
                   found.formula, found.deepest_mm, long{found.inverted}, long{found.unsolved}});
        if (found.formula > 0)
            off = std::max(off, 100 * std::abs(found.force / found.formula - 1));
        if (plan.law == ElasticLaw::neo_hookean)
            inverted = std::max(inverted, found.inverted);
        unsolved += found.unsolved;
    };
    for (const ElasticLaw law : {ElasticLaw::corotated, ElasticLaw::neo_hookean})
        for (const double mu : {0.0, 0.5})
            add({.law = law, .mu = mu, .height = 0.5});
    if (!options.quick) {
        for (const ElasticLaw law : {ElasticLaw::corotated, ElasticLaw::neo_hookean}) {
            add({.law = law, .mu = 0.5, .height = 0.3});
            add({.law = law, .basis = "quadratic", .mu = 0.5, .height = 0.5});
            add({.law = law, .basis = "quadratic", .mu = 0.5, .height = 0.3});
            add({.shape = "bunny", .law = law, .mu = 0.5, .height = 0.7});
        }
    }
    report.table("pressed", table);
    report.page_table("pressed", table, 3);
    report.fact("pressed", "force_percent", off, 2);
    report.fact("pressed", "inverted", inverted);
    report.fact("pressed", "unsolved", unsolved);
}

}  // namespace enduring::chapter08
