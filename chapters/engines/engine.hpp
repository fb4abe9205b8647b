#pragma once

#include "chapters/engines/engine_scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring::engines {

/// With which settings an engine runs. Whatever it is, no body may fall asleep.
struct Way {
    std::string name;    ///< "default", "best"
    int substeps = 1;    ///< the engine's own steps a frame; 0 for as many as make its default time step
    int iterations = 0;  ///< of its solver; 0 for its default
    bool fine = false;  ///< what its documentation says against slop, slip and round corners; see the adapter
};

/// A moment of a run.
struct Frame {
    std::vector<Pose> poses;  ///< of all bodies, in the scene's order
    double ms = 0;            ///< processor time since the frame before [ms]
};
/// The start, and a frame a step.
using Trajectory = std::vector<Frame>;

/// A physics engine and what is known of it.
struct Engine {
    std::string name, version;
    std::string missing;  ///< why it cannot run here; empty if it can
    std::string says;     ///< where its documentation tells the best settings
    Way plain, best;
    std::function<Trajectory(Scene, const Way&, int steps)> run;

    bool is_here() const { return missing.empty(); }
};

/// All of them, ours first. Which are here is asked anew.
std::vector<Engine> all_engines();

/// A scene inside an engine of this process.
class EngineWorld {
public:
    EngineWorld() = default;
    virtual ~EngineWorld() = default;
    EngineWorld(const EngineWorld&) = delete;
    EngineWorld& operator=(const EngineWorld&) = delete;
    virtual void step(double dt) = 0;
    /// Of a body that moves, by its place in the scene.
    virtual Pose pose(std::size_t body) const = 0;
};

/// Steps a world, and notes where its bodies are.
Trajectory follow(const EngineScene& scene, EngineWorld& world, int substeps, int steps);

/// The same of a solver of ours, which steps our World.
/// @param make  the solver, once the scene stands where it stays
Trajectory run_solver(Scene scene, int substeps, int steps, const std::function<Solver(Scene&)>& make);

/// Of a scene: substeps, or as many as come nearest to an engine's default time step.
int substeps_of(const Way& way, const EngineScene& scene, double default_dt);

Engine chapter10_engine();
Engine chapter11_engine();
Engine bullet_engine();
Engine ode_engine();
Engine mujoco_engine();
/// Of npm, run by node as a process of its own.
Engine npm_mujoco_engine();
Engine jolt_engine();
Engine rapier_engine();
/// In a process of its own, for it brings another Bullet.
Engine dart_engine();

}  // namespace enduring::engines
