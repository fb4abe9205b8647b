// What one impulse costs, from the positions of the four vertices to the impulse on p.

#include "chapters/03_penalty_impulses/penalty_impulse.hpp"

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace {

using namespace enduring;

struct BenchmarkPair {
    PairVertices t0, t1;
    double start;
};

enum class Situation { resting, entering, leaving, outside };

/// A vertex below (resting), falling into, rising out of or above a triangle that turns a little.
std::vector<BenchmarkPair> pairs(Situation situation)
{
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto small = [&] { return Vec3(0.02 * (unit(generator) - 0.5) * Vec3(1, 0.1, 1)); };
    const double before = situation == Situation::entering || situation == Situation::outside ? 0.01 : -0.01;
    const double after = situation == Situation::leaving || situation == Situation::outside ? 0.01 : -0.01;
    std::vector<BenchmarkPair> result(64);  // fits the first cache
    for (BenchmarkPair& pair : result) {
        const double w1 = 0.5 * unit(generator), w2 = 0.5 * unit(generator), w0 = 1 - w1 - w2;
        for (auto* x : {&pair.t0, &pair.t1}) {
            (*x)[1] = Vec3(0, 0, 0) + small();
            (*x)[2] = Vec3(0, 0, 1) + small();
            (*x)[3] = Vec3(1, 0, 0) + small();
            (*x)[0] = w0 * (*x)[1] + w1 * (*x)[2] + w2 * (*x)[3] + 0.1 * small();
        }
        pair.t0[0].y() += before * (0.5 + unit(generator));
        pair.t1[0].y() += after * (0.5 + unit(generator));
        pair.start = situation == Situation::entering ? 0.1 : 0;
    }
    return result;
}

void run(benchmark::State& state, Situation situation, Vec3 (*impulse)(const BenchmarkPair&))
{
    const std::vector<BenchmarkPair> all = pairs(situation);
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(impulse(all[i]));
        if (++i == all.size())
            i = 0;
    }
}

Vec3 continuous_vertex_face(const BenchmarkPair& pair)
{
    return continuous_impulse({vertex_face_instant(pair.t0), vertex_face_instant(pair.t1)}, pair.start, 1000,
                              0.01);
}

Vec3 continuous_edge_edge(const BenchmarkPair& pair)
{
    return continuous_impulse({edge_edge_instant(pair.t0, 1), edge_edge_instant(pair.t1, 1)}, pair.start,
                              1000, 0.01);
}

Vec3 discrete_vertex_face(const BenchmarkPair& pair)
{
    return discrete_impulse(vertex_face_instant(pair.t1), 1000, 0.01);
}

BENCHMARK_CAPTURE(run, discrete_resting, Situation::resting, discrete_vertex_face);
BENCHMARK_CAPTURE(run, continuous_resting, Situation::resting, continuous_vertex_face);
BENCHMARK_CAPTURE(run, continuous_entering, Situation::entering, continuous_vertex_face);
BENCHMARK_CAPTURE(run, continuous_leaving, Situation::leaving, continuous_vertex_face);
BENCHMARK_CAPTURE(run, continuous_outside, Situation::outside, continuous_vertex_face);
BENCHMARK_CAPTURE(run, continuous_edge_edge_random, Situation::resting, continuous_edge_edge);

}  // namespace
