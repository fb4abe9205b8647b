#include "common/fem/elastic_body.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/input/source_directory.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

using namespace enduring;

namespace {

/// The bunny, 0.8 m high, swaying on fixed feet: its elements turn by tenths of a radian, back and forth.
std::unique_ptr<ElasticBody> bending_bunny(long elements, double young)
{
    QuadraticTetrahedralMesh mesh = read_gmsh_quadratic(
        source_directory() / ("common/meshes/bunny_" + std::to_string(elements) + ".msh"));
    for (Vec3& node : mesh.nodes)
        node *= 0.1;
    auto body = std::make_unique<ElasticBody>(ElasticMesh(mesh),
                                              ElasticMaterial{.young = young, .poisson = 0.4});
    for (int n = 0; n < body->node_count(); ++n) {
        const double height = body->positions()(1, n);
        if (height < 0.03)
            body->fix(n);
        else
            body->velocities().col(n) = 2 * height * Vec3::UnitX() + height * height * Vec3::UnitZ();
    }
    return body;
}

constexpr double dt = 0.01;
const Vec3 gravity(0, -9.81, 0);

void whole_step(benchmark::State& state)
{
    const auto body = bending_bunny(state.range(0), static_cast<double>(state.range(1)));
    body->predict(gravity, dt);  // orders the unknowns and makes the first factor
    body->commit(dt);
    double iterations = 0, steps = 0;
    for (auto _ : state) {
        body->predict(gravity, dt);
        body->commit(dt);
        iterations += body->solver_iterations();
        ++steps;
    }
    state.counters["unknowns"] = 3 * body->node_count();
    state.counters["iterations"] = iterations / steps;
    state.counters["factorisations"] = body->factorisations();
}
BENCHMARK(whole_step)
    ->ArgNames({"elements", "young"})
    ->ArgsProduct({{363, 785, 1452}, {100000, 1000000}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);
BENCHMARK(whole_step)
    ->ArgNames({"elements", "young"})
    ->Args({10668, 100000})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);

void rotations(benchmark::State& state)
{
    const auto body = bending_bunny(state.range(0), 1e5);
    ElementRotations result;
    for (auto _ : state)
        find_rotations(body->mesh(), body->positions() + dt * body->velocities(), result);
}
BENCHMARK(rotations)->Arg(785)->Arg(1452)->Unit(benchmark::kMicrosecond);

void forces(benchmark::State& state)
{
    const auto body = bending_bunny(state.range(0), 1e5);
    ElementRotations turned;
    find_rotations(body->mesh(), body->positions(), turned);
    const CorotatedElasticity elasticity(body->mesh(), lame_constants(body->material()), turned);
    NodalVectors result = NodalVectors::Zero(3, body->node_count());
    for (auto _ : state)
        elasticity.add_forces(body->positions(), result);
}
BENCHMARK(forces)->Arg(785)->Arg(1452)->Unit(benchmark::kMicrosecond);

/// The share of an iteration that is not `forces`: a solve with the
/// factor. And the factor itself, with its matrix.
struct Factored {
    Factored(long elements, LinearSolverKind kind)
        : body(bending_bunny(elements, 1e5)), factor(body->mesh(), kind)
    {
        find_rotations(body->mesh(), body->positions(), turned);
        refactor();
    }
    void refactor() { factor.factor(elasticity, body->mass_matrix(), free, 1, dt * dt); }

    std::unique_ptr<ElasticBody> body;
    ElementRotations turned;
    LameConstants lame = lame_constants(body->material());
    CorotatedElasticity elasticity{body->mesh(), lame, turned};
    std::vector<char> free = std::vector<char>(body->node_count(), 0);
    TurnedFactor factor;
};

void solve_with_factor(benchmark::State& state, LinearSolverKind kind)
{
    Factored system(state.range(0), kind);
    NodalVectors z;
    for (auto _ : state)
        system.factor.apply(system.body->velocities(), z);
}
BENCHMARK_CAPTURE(solve_with_factor, simplicial, LinearSolverKind::simplicial)
    ->Arg(363)
    ->Arg(785)
    ->Arg(1452)
    ->Arg(10668)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve_with_factor, supernodal, LinearSolverKind::supernodal)
    ->Arg(363)
    ->Arg(785)
    ->Arg(1452)
    ->Arg(10668)
    ->Unit(benchmark::kMicrosecond);

void assemble_and_factor(benchmark::State& state, LinearSolverKind kind)
{
    Factored system(state.range(0), kind);
    for (auto _ : state)
        system.refactor();
}
BENCHMARK_CAPTURE(assemble_and_factor, simplicial, LinearSolverKind::simplicial)
    ->Arg(363)
    ->Arg(785)
    ->Arg(1452)
    ->Arg(10668)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(assemble_and_factor, supernodal, LinearSolverKind::supernodal)
    ->Arg(363)
    ->Arg(785)
    ->Arg(1452)
    ->Arg(10668)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(5);

}  // namespace
