#include "chapters/engines/engine.hpp"

#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::engines {

Trajectory follow(const EngineScene& scene, EngineWorld& world, int substeps, int steps)
{
    Trajectory run(1);
    for (const EngineBody& body : scene.bodies)
        run[0].poses.push_back(body.frame);
    for (int step = 0; step < steps; ++step) {
        Frame frame = run[0];
        const double start = processor_seconds();
        for (int i = 0; i < substeps; ++i)
            world.step(scene.dt / substeps);
        frame.ms = 1000 * (processor_seconds() - start);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            if (scene.bodies[i].moves)
                frame.poses[i] = world.pose(i);
        run.push_back(std::move(frame));
    }
    return run;
}

int substeps_of(const Way& way, const EngineScene& scene, double default_dt)
{
    return way.substeps > 0 ? way.substeps
                            : std::max(1, static_cast<int>(std::lround(scene.dt / default_dt)));
}

std::vector<Engine> all_engines()
{
    return {chapter10_engine(), chapter11_engine(),  bullet_engine(), ode_engine(),   dart_engine(),
            mujoco_engine(),    npm_mujoco_engine(), jolt_engine(),   rapier_engine()};
}

}  // namespace enduring::engines
