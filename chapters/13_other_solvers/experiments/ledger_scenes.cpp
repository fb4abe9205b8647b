#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/experiments/method_table.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "chapters/motivating_scenes/motivating_scene.hpp"
#include "common/input/input_error.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace enduring::chapter13 {
namespace {

using namespace motivating;

/// A first step tells whether a method takes the scene at all.
void refuse_what_cannot_run(const MotivatingScene& asked, const MakeMethod& make)
{
    Scene scene = load_scene(scene_file(asked.file), asked.patch);
    const Solver solver = make(scene.contact);
    const auto& methods = other_methods();
    if (asked.with_bullet == '-' &&
        std::any_of(methods.begin(), methods.end(),
                    [&](const OtherMethod& method) { return method.title == solver.name; }))
        throw InputError(
            "asks for labels or levers of pairs that live on; a method finds its pairs in each step");
    Contacts contacts;
    advance(scene.world, contacts, solver, scene.dt);
}

Question question_of(const MotivatingScene& asked)
{
    return {asked.name, asked.quantity + ", " + bound_text(asked), [&asked](const MakeMethod& make) {
                refuse_what_cannot_run(asked, make);
                const Outcome outcome = try_scene(asked, make, {.may_gain_energy = true});
                return Answer{outcome.value.value_or(std::numeric_limits<double>::infinity()),
                              passes(asked, outcome.value)};
            }};
}

/// A row that asks for a joint says nothing about them: none has joints.
bool asks_contact_alone(const MotivatingScene& asked)
{
    return load_scene(scene_file(asked.file), asked.patch).asks_joints.empty();
}

}  // namespace

/// The scenes of the failure ledger under each method, with the ledger's own bounds.
void ledger_scenes(const RunOptions& options, Report& report)
{
    const std::set<std::string> few{"fast_plate", "deep", "thin", "labels", "mesh_slope", "slope", "tower"};
    std::vector<Question> questions;
    for (const MotivatingScene& asked : motivating_scenes())
        if (asks_contact_alone(asked) && (!options.quick || few.contains(asked.name)))
            questions.push_back(question_of(asked));
    report_answers(options, report, "ledger_scenes", questions);
}

}  // namespace enduring::chapter13
