#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/islands.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/fem/exact_solver.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <algorithm>

namespace enduring::solvers {
namespace {

/// Soft blocks of 0.4 m and 10 kg, a hair above each other.
struct Blocks {
    int count;
    bool is_quadratic;
};

Scene scene_of(const Blocks& blocks)
{
    constexpr double side = 0.4, gap = 1e-3;
    Scene scene = chapter07::scene_of({}, 0.01);
    DeformableSettings settings;
    settings.material = {
        .young = 1e6, .poisson = 0.3, .density = 10 / (side * side * side), .stiffness_damping = 0.005};
    settings.impulse_response = ImpulseResponse::implicit;
    for (int i = 0; i < blocks.count; ++i) {
        settings.position = Vec3(0.01 * (i % 2), side / 2 + gap + (side + gap) * i, 0.007 * (i % 3));
        const std::string name = "block " + std::to_string(i + 1);
        std::unique_ptr<Body> body;
        if (blocks.is_quadratic)
            body = std::make_unique<DeformableBody>(
                name, with_edge_midpoints(bar(Vec3::Constant(side), {3, 3, 2})), settings);
        else
            body = std::make_unique<DeformableBody>(name, bar(Vec3::Constant(side), {2, 2, 2}), settings);
        scene.world.bodies.push_back(std::move(body));
    }
    return scene;
}

/// The least of some times of a factor [ms]: other work on the machine counts less.
double factor_ms(LinearSolver& solver, const Eigen::SparseMatrix<double>& matrix)
{
    double least = INFINITY;
    for (int i = 0; i < 5; ++i) {
        const double start = processor_seconds();
        solver.factor(matrix);
        least = std::min(least, 1000 * (processor_seconds() - start));
    }
    return least;
}

void add_row(const std::string& name, Scene scene, int steps, Table& table)
{
    ImplicitSettings settings;
    settings.threads = 1;
    long newton_steps = 0;
    settings.record = [&](const SolveRecord& record) { newton_steps += record.newton_steps; };
    const Solver solver = chapter08_solver(scene.contact, settings);
    Contacts contacts;
    const double start = processor_seconds();
    for (int i = 0; i < steps; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    const double step_ms = 1000 * (processor_seconds() - start) / steps;
    for (const auto& body : scene.world.bodies)
        body->predict(scene.world.gravity, scene.dt);
    const Island island = find_islands(scene.world, contacts).front();
    const ContactProblem problem = set_up(scene.world, island, settings.stiffness, settings.friction,
                                          {settings.centre, scene.dt}, false)
                                       .problem;
    const Eigen::SparseMatrix<double> matrix = pressed_matrix(problem);
    const auto columns = make_linear_solver(LinearSolverKind::simplicial, matrix),
               blocks = make_exact_solver(matrix);
    table.add({name, static_cast<long>(problem.size), estimated_operations(problem) / 1e6,
               factor_ms(*columns, matrix), factor_ms(*blocks, matrix),
               static_cast<double>(newton_steps) / steps, step_ms});
}

}  // namespace

void speed_of_matrices(bool quick, Report& report)
{
    Table table({"in touch", "coordinates", "operations, estimated [million]", "column by column [ms]",
                 "in blocks [ms]", "Newton steps a step", "a step [ms]"});
    for (const int count : {10, 40})
        if (!quick || count == 10)
            add_row(std::to_string(count) + " rigid cubes",
                    chapter07::scene_of(chapter07::stack_of(count), 0.01), 20, table);
    for (const bool is_quadratic : {false, true})
        for (const int count : {1, 2, 5})
            if (!quick || (count == 2 && !is_quadratic))
                add_row(std::to_string(count) + (is_quadratic ? " soft blocks of 108 quadratic elements"
                                                              : " soft blocks of 48 linear elements"),
                        scene_of({count, is_quadratic}), 12, table);
    report.table("speed_matrix", table);
    report.page_table("speed_matrix", table, 2);
}

}  // namespace enduring::solvers
