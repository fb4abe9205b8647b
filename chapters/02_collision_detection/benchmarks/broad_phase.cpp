// One step of the broad phase: between bodies, and for two balls about to touch (our tree of faces, and
// Bullet's dynamic tree over the same boxes).
#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/body_broad_phase.hpp"
#include "chapters/02_collision_detection/experiments/bullet_tree.hpp"
#include "common/geometry/round_shapes.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace enduring {
namespace {

/// A ball of radius 1 that moves by a tenth of its edge length in each step.
struct Ball {
    SurfaceTopology topology;
    std::vector<Vec3> t0, t1;

    Ball(int subdivisions, const Vec3& place, const Vec3& direction)
    {
        const SurfaceMesh mesh = sphere(1, subdivisions);
        topology = SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces);
        const double edge = 1.1 / std::exp2(subdivisions);
        for (const Vec3& x : mesh.vertices) {
            t0.push_back(x + place);
            t1.push_back(x + place + 0.1 * edge * direction);
        }
    }
    SurfaceStep step() const { return {topology, t0, t1}; }
};

struct Balls {
    Ball upper, lower;
    explicit Balls(int subdivisions)
        : upper(subdivisions, {0, 1.97, 0}, {0.3, -1, 0}), lower(subdivisions, {0, 0, 0}, {0, 0.2, 0.1})
    {}
};

void tree_of_faces(benchmark::State& state)
{
    const Balls balls(static_cast<int>(state.range(0)));
    FaceTree upper(balls.upper.topology, balls.upper.t0), lower(balls.lower.topology, balls.lower.t0);
    CandidatePairs pairs;
    for (auto _ : state) {
        upper.refit(balls.upper.step());
        lower.refit(balls.lower.step());
        collect_pairs(upper, lower, pairs);
        benchmark::DoNotOptimize(pairs.edge_edge.data());
    }
    state.counters["faces"] = static_cast<double>(balls.upper.topology.faces().size());
    state.counters["pairs"] = static_cast<double>(pairs.size());
}
BENCHMARK(tree_of_faces)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);

void refit_alone(benchmark::State& state)
{
    const Balls balls(static_cast<int>(state.range(0)));
    FaceTree upper(balls.upper.topology, balls.upper.t0);
    for (auto _ : state) {
        upper.refit(balls.upper.step());
        benchmark::DoNotOptimize(&upper.vertex_box(0));
    }
}
BENCHMARK(refit_alone)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);

/// Cubes of edge 1 at random places, eight cubic metres for each.
std::vector<SweptBox> scattered_cubes(long count)
{
    std::mt19937 generator(6);
    std::uniform_real_distribution<double> place(0, 2 * std::cbrt(static_cast<double>(count)));
    std::vector<SweptBox> boxes;
    for (long i = 0; i < count; ++i) {
        const Vec3 low(place(generator), place(generator), place(generator));
        boxes.push_back({low, low + Vec3::Ones()});
    }
    return boxes;
}

void tree_of_bodies(benchmark::State& state)
{
    const std::vector<SweptBox> boxes = scattered_cubes(state.range(0));
    std::size_t pairs = 0;
    for (auto _ : state)
        pairs = overlapping_bodies(boxes).size();
    state.counters["pairs"] = static_cast<double>(pairs);
}
BENCHMARK(tree_of_bodies)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

void all_pairs_of_bodies(benchmark::State& state)
{
    const std::vector<SweptBox> boxes = scattered_cubes(state.range(0));
    std::vector<OverlappingBodies> pairs;
    for (auto _ : state) {
        pairs.clear();
        for (int b = 0; b < static_cast<int>(boxes.size()); ++b)
            for (int a = 0; a < b; ++a)
                if (boxes[a].overlaps(boxes[b]))
                    pairs.push_back({a, b});
    }
    state.counters["pairs"] = static_cast<double>(pairs.size());
}
BENCHMARK(all_pairs_of_bodies)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

void bullet_tree_faces_only(benchmark::State& state)
{
    const Balls balls(static_cast<int>(state.range(0)));
    chapter02::BulletTree upper(balls.upper.step()), lower(balls.lower.step());
    std::vector<FeaturePair> found;
    for (auto _ : state) {
        upper.refit(balls.upper.step());
        lower.refit(balls.lower.step());
        found.clear();
        chapter02::BulletTree::overlapping_faces(upper, lower, [&](int f, int g) {
            found.push_back({f, g});
        });
        benchmark::DoNotOptimize(found.data());
    }
    state.counters["face_pairs"] = static_cast<double>(found.size());
}
BENCHMARK(bullet_tree_faces_only)->DenseRange(2, 5)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace enduring
