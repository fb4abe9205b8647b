#pragma once

#include "common/scenes/scene.hpp"

namespace enduring {

/// Hands a scene over to the Bullet library: its rigid world, or its deformable one if a body is deformable.
/// The scene's moving bodies are replaced by ones that Bullet moves, so that runs, probes and pictures see
/// them as they see ours. The solver that comes back has one pass: a step of Bullet.
///
/// Bullet's own defaults hold (10 iterations, split impulses, no bounce, explicit elastic
/// forces) but for these: no body falls asleep, so that what creeps is seen; fast bodies are
/// swept (see its manual on continuous collision detection); inner edges of flat sides are known
/// to it. It has one coefficient of friction: the static one.
///
/// After each step the contacts are Bullet's points between two bodies, each as the pair of
/// the vertex and the face that lie nearest; they are held, for no spring of ours is in
/// them. Its points on planes and on soft bodies are left out.
/// @param scene  of which no step is done yet
/// @throws InputError  Bullet cannot take the scene; names the scene, the body and why
Solver bullet_solver(Scene& scene);
/// The same with so many iterations of its solver.
Solver iterated_bullet_solver(Scene& scene, int iterations);

/// Of the library, as "3.24".
std::string bullet_version();

}  // namespace enduring
