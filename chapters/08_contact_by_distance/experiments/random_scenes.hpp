#pragma once

#include "common/scenes/scene.hpp"

#include <functional>

namespace enduring::chapter08 {

/// A short scene by its seed: boxes, plates, needles, balls and, in every fifth one, soft boxes, which fall
/// and are thrown onto a floor and into each other. Steps are 1 ms to 40 ms long, sizes go from a millimetre
/// to a kilometre, and speeds up to 200 sizes a second. Every third scene has no floor, and every fourth one
/// no gravity. Nothing begins in touch.
Scene random_scene(unsigned seed);
/// Steps that such a scene is run.
constexpr int random_scene_steps = 15;

/// Whether a vertex of one body is inside another one, or an edge of one goes through a face of another one,
/// where one of the two moves; of their surfaces for contact. By the winding number and by edges in
/// triangles, which no search knows.
bool any_crossing(const World& world);

/// Runs a scene with the solver of this chapter, and tells nothing.
/// @param after_step  is called after each step, if there is one
/// @return            steps after which any_crossing()
long crossing_steps(Scene& scene, int steps, const std::function<void()>& after_step = {});

/// How deep vertices lie in other bodies as these are drawn, over the size of the smallest moving body [1].
double deepest_drawn(const World& world);

}  // namespace enduring::chapter08
