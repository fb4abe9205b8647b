#pragma once

#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/run/probes.hpp"

#include <vector>

namespace enduring::chapter06 {

/// Follows the cube of scene sliding along the bar: solver, time_s, x_m, speed_m_per_s, force_n (of the bar
/// on the cube, upwards), pairs (that pushed), held.
class BarSlideProbe final : public TableProbe {
public:
    explicit BarSlideProbe(std::string solver);
    void observe(const World& world, const Contacts& contacts, double dt) override;

    /// One step of the cube.
    struct Moment {
        double time, x, speed, force;
        double tilt;  ///< of the side that was up at first [rad]
    };
    const std::vector<Moment>& moments() const { return moments_; }
    double weight() const { return weight_; }  ///< of the cube [N]

private:
    std::string solver_;
    ForceProbe force_;
    std::vector<Moment> moments_;
    std::size_t top_ = 0;  ///< the cube's face that was up at first
    double weight_ = 0;
};

/// What a slide along the bar came to, while the whole cube is above it.
struct BarSlideOutcome {
    double speed_kept = 0;  ///< last over first speed
    /// of the force from one step to the next, as a part of the cube's weight
    double largest_leap = 0;
    double mean_leap = 0;  ///< mean of its absolute value, likewise
    /// steps with a leap of more than a hundredth of the weight, as a part of all
    double leaps_above_percent = 0;
    double stopped_at = -1;   ///< first time at which the cube does not go on [s]; -1 never
    double largest_tilt = 0;  ///< in the whole run [rad]
};

/// @param settled  time by which the landing is over [s]
/// @param end      x of the cube's middle where its front reaches the bar's end [m]
BarSlideOutcome outcome_of(const BarSlideProbe& probe, double settled, double end);

/// Marks the pairs of vertices that push, vertices red and faces blue,
/// hooked ones orange (thesis figures 7.8, 7.9).
void mark_vertex_pairs(Stage& stage, const World& world, const Contacts& contacts);
/// Marks edge pairs: those that push green, those that are held red (thesis figures 7.10, 7.11).
void mark_edge_pairs(Stage& stage, const World& world, const Contacts& contacts);

}  // namespace enduring::chapter06
