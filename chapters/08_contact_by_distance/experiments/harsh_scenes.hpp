#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"

#include <Eigen/Geometry>

#include <array>
#include <functional>

namespace enduring::chapter08 {

/// Bodies that are thrown against each other in a closed room, as nobody who wrote a solver would throw them.
struct HarshScene {
    Scene scene;
    Eigen::AlignedBox3d room;  ///< between ground, walls and ceiling [m]
    double speed = 0;          ///< of every body at first [m/s]
};

/// 12 to 27 sheets, needles, tetrahedra, boxes and plump bodies of 10 g to 100 kg, none of which overlaps
/// another, fly towards the middle of the room at 10 m/s to 100 m/s and spin with 20 rad/s. Steps of 1 ms to
/// 30 ms, friction 0 to 1. The ground is a plane or a slab; walls and ceiling are slabs of 1 m.
/// @param soft  one to three of the bodies are soft boxes of 1e4 Pa to 1e7 Pa
HarshScene harsh_scene(unsigned seed, bool soft);

/// So many steps each scene is run.
inline constexpr int harsh_steps = 100;

/// What a run came to. Plain numbers, to be kept by sweep().
struct HarshOutcome {
    unsigned seed = 0;
    bool soft = false;
    double speed = 0, dt = 0;            ///< [m/s], [s]
    double start_j = 0;                  ///< energy at first, bodies and springs
    double gain_j = 0;                   ///< the most that a step brings
    int gain_step = 0;                   ///< which step that was, from 1
    double free_gain_j = 0;              ///< as gain_j, without any contact; asked where bodies are soft
    double max_energy = 0;               ///< after any step, over that at first
    double deepest_m = 0, at_end_m = 0;  ///< chapter07::true_depth() after any step, and after the last one
    double size_m = 0;                   ///< of the smallest body
    int bodies = 0;
    int lost = 0;                                ///< bodies whose middle is outside of the room at the end
    int max_inverted = 0;                        ///< elements, after any step
    int steps = 0;                               ///< fewer than harsh_steps if one could not be taken
    long parts = 0;                              ///< in which they were taken
    long unsolved = 0, solves = 0;               ///< problems
    std::array<int, harsh_steps> newton{};       ///< steps of Newton's method in each step
    double longest_step_s = 0, all_steps_s = 0;  ///< on the processor: for the screen, never for a table

    double gain() const { return gain_j / start_j; }
    /// Whether a step brings more than a joule, and more than a thousandth of what the scene began with.
    bool gains() const { return gain_j > 1 && gain() > 1e-3; }
    bool stopped() const { return steps < harsh_steps; }
    int tried() const { return stopped() ? steps + 1 : steps; }  ///< with the step that ended a run
};

/// Runs a scene and measures it after every step; so may the observer, which sees the first state, too.
HarshOutcome run_harsh(
    HarshScene& harsh, chapter07::MakeSolver make,
    const std::function<void(const World&)>& observe = [](const World&) {});
/// The scene of this seed; one with soft bodies also without any contact, for what these gain by themselves.
HarshOutcome run_harsh(unsigned seed, bool soft, chapter07::MakeSolver make);

}  // namespace enduring::chapter08
