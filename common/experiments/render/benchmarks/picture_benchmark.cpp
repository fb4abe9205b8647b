#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/tests/sample_stages.hpp"

#include <benchmark/benchmark.h>

using namespace enduring;

/// Seconds a picture: the arguments are its width and height.
static void draw_bunny_in_bowl(benchmark::State& state)
{
    Renderer renderer(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const Stage stage = bunny_in_bowl();
    for (auto _ : state)
        benchmark::DoNotOptimize(renderer.draw(stage).rgb.data());
}
BENCHMARK(draw_bunny_in_bowl)
    ->Args({640, 360})
    ->Args({960, 540})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
