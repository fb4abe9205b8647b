#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/bolt.hpp"
#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "chapters/11_exact_contact/problem_of_step.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <algorithm>
#include <functional>
#include <string>

namespace enduring::chapter11 {
namespace {

constexpr double dt = 0.01;

/// A scene, and the steps whose problems are taken.
struct Source {
    std::string name;
    std::function<Scene()> make;
    std::vector<int> steps;
    bool in_quick = true;
};

Scene soft_on_soft(int cells, double upper_young)
{
    Scene scene = chapter07::scene_of(std::vector<chapter07::Box>{}, dt);
    for (const bool upper : {false, true}) {
        DeformableSettings settings;
        settings.material.density = 100;  // [kg/m^3]
        settings.material.young = upper ? upper_young : 1e5;
        settings.material.stiffness_damping = chapter07::soft_damping;
        settings.position = upper ? Vec3(0.1, 1.5 + 2e-4, 0.05) : Vec3(0, 0.5 + 1e-4, 0);
        settings.impulse_response = ImpulseResponse::implicit;
        scene.world.bodies.push_back(std::make_unique<DeformableBody>(
            upper ? "upper" : "lower", bar(Vec3::Ones(), {cells, cells, cells}), settings));
    }
    return scene;
}

/// What is leaned or tilted, so that it has few contacts.
Scene tilted(double mass, const Vec3& axis, double turn_deg, const Vec3& spin, double height)
{
    return chapter07::scene_of({{.mass = mass,
                                 .centre = Vec3(0, height, 0),
                                 .turn_deg = turn_deg,
                                 .axis = axis.normalized(),
                                 .spin = spin}},
                               dt);
}

std::vector<Source> sources()
{
    using namespace chapter07;
    const auto boxes = [](const std::vector<Box>& of, double slope = 0, double mu = 0.5) {
        return [=] { return scene_of(of, dt, slope, mu, mu); };
    };
    const std::vector<Box> cube = stack_of(1);
    return {
        {"cube_at_rest", boxes(cube), {1, 10}},
        {"cube_holds_on_slope", boxes(cube, 26), {2, 20}},
        {"cube_slides_on_slope", boxes(cube, 35), {2, 20}},
        {"cube_on_ice", boxes(cube, 10, 0.01), {2}},
        {"cube_on_corner",
         [] {
             return tilted(10, {1, 0, 1}, 54.7, {0, 5, 0}, 0.87);
         },
         {1, 4, 40}},
        {"cube_on_edge",
         [] {
             return tilted(10, {0, 0, 1}, 44, Vec3::Zero(), 0.708);
         },
         {1, 20, 60}},
        {"spinning_cube",
         [] {
             return tilted(10, {0, 1, 0}, 10, {0, 40, 3}, 0.5);
         },
         {1, 5}},
        {"stack_of_2", boxes(stack_of(2)), {1, 20}},
        {"stack_of_3_turned", boxes(stack_of(3, 10, 10, 45)), {1, 20}},
        {"stack_of_10", boxes(stack_of(10)), {1, 20}},
        {"100_to_1", boxes(stack_of(2, 10, 1000)), {1, 20}},
        {"20000_to_1", boxes(stack_of(2, 10, 200000)), {1, 20}},
        {"million_to_1", boxes(stack_of(2, 1, 1e6)), {1, 5}},
        {"light_on_heavy", boxes(stack_of(2, 1e5, 1)), {1, 20}},
        {"stack_on_slope", boxes(stack_of(3), 20), {2, 20}},
        {"wedged_cube", [] { return cube_between_planes(10, 0.5, dt); }, {22, 25, 40}},
        {"wedged_cube_slides", [] { return cube_between_planes(30, 0.2, dt); }, {22, 40}},
        {"jammed_cube", [] { return cube_between_planes(2, 1, dt); }, {22, 25}},
        {"wedge_in_crack", [] { return tip_in_crack(Tip::wedge, 33, 60, dt); }, {20, 60}},
        {"spike_in_crack", [] { return tip_in_crack(Tip::spike, 33, 60, dt); }, {20, 60}},
        {"wedge_on_edge", [] { return wedge_on_edge(dt); }, {10, 40}},
        {"card_house_of_1", boxes(card_house(1, 15)), {1, 30}},
        {"card_house_of_3", boxes(card_house(3, 15)), {1, 30}},
        {"arch_of_7", [] { return arch(7, 2, dt); }, {1, 30}},
        {"arch_of_20", [] { return arch(20, 5, dt); }, {1, 30}},
        {"arch_of_101", [] { return arch(101, 5, dt); }, {1, 3}, false},
        {"heap_of_8", boxes(loose_cubes(8, 2, 2)), {30, 60, 100, 140}},
        {"heap_of_27", boxes(loose_cubes(27, 3, 2)), {60, 100}, false},
        {"ton_on_soft", [] { return ton_on_block({}, dt); }, {3, 20}, false},
        {"bolt_in_nut",
         [] {
             return chapter08::scene_of(
                 chapter08::BoltInNut{.segments = 24, .bolt_segments = 21, .dt = 0.001});
         },
         {2, 20}},
        {"soft_on_soft", [] { return soft_on_soft(1, 1e5); }, {2, 10, 40}},
        {"stiff_on_soft", [] { return soft_on_soft(1, 1e9); }, {2, 10}},
        {"soft_on_triangles",
         [] {
             return soft_cube_on_triangles({1, 1e5, dt, 100}, 0.3);
         },
         {2, 20}},
    };
}

/// Writes problems as NAME.dat and our answers as NAME.answer, both together as NAME.hdf5, and counts how
/// they are solved.
class Collection {
public:
    explicit Collection(Report& report) : report_(report) {}

    void add(const std::string& name, const FrictionProblem& problem)
    {
        const std::string text = siconos_text(problem);
        const ExactSolution solution = solve_exactly(problem);
        write_file(report_.file(name + ".dat"), text);
        write_file(report_.file(name + ".answer"), answer_text(solution.impulses));
        if (knows_fclib())
            write_fclib(problem, report_.file(name + ".hdf5"), solution.impulses);
        table_.add({name, static_cast<long>(problem.contacts()), solution.error,
                    static_cast<long>(solution.errors.size()), static_cast<long>(solution.newton_steps),
                    static_cast<double>(text.size()) / 1000});
        solved_ += solution.solved();
        most_steps_ = std::max(most_steps_, solution.newton_steps);
        if (solution.error > worst_) {
            worst_ = solution.error;
            worst_name_ = name;
        }
    }
    void tell() const
    {
        report_.table("own_problems", table_);
        Table hardest(table_.columns());
        for (const std::vector<Cell>& row : table_.rows())
            if (std::get<long>(row[4]) >= 300)
                hardest.add(row);
        report_.page_table("own_problems", hardest, 2);
        report_.fact("own_problems", "problems", static_cast<double>(table_.rows().size()));
        report_.fact("own_problems", "solved", static_cast<double>(solved_));
        report_.fact("own_problems", "worst_name", worst_name_);
        report_.fact("own_problems", "worst_error", worst_, 2);
        report_.fact("own_problems", "most_steps", most_steps_);
    }

private:
    Report& report_;
    Table table_{{"problem", "contacts", "natural_map", "passes", "newton_steps", "kilobytes"}};
    long solved_ = 0;
    int most_steps_ = 0;
    double worst_ = 0;
    std::string worst_name_;
};

void collect(const Source& source, Collection& collection)
{
    Scene scene = source.make();
    ImplicitSettings silent;
    silent.record = [](const SolveRecord&) {};
    Solver solver = chapter11_solver(scene.contact, silent, {.record = [](const PassRecord&) {}});
    int taken = 0;  // of a step that is taken in halves, the first part
    take_problems(solver, scene.contact, [&](int step, const FrictionProblem& problem) {
        if (step > taken && std::find(source.steps.begin(), source.steps.end(), step) != source.steps.end())
            collection.add(source.name + '_' + std::to_string(step), problem);
        taken = step;
    });
    Contacts contacts;
    while (scene.world.step < source.steps.back())
        advance(scene.world, contacts, solver, scene.dt);
}

}  // namespace

/// Problems of our own scenes: each as Siconos' text beside our answer.
void own_problems(const RunOptions& options, Report& report)
{
    Collection collection(report);
    for (const Source& source : sources())
        if (!options.quick || source.in_quick)
            collect(source, collection);
    collection.tell();
}

}  // namespace enduring::chapter11
