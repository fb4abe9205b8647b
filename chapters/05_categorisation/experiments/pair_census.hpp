#pragma once

#include "common/experiments/run/probes.hpp"

namespace enduring::chapter05 {

/// How many pairs there are after a step, by kind and label, and what they did along a floor that lies flat.
struct PairCensus {
    long vertex_face_regular = 0, vertex_face_hooked = 0, edge_edge_regular = 0, edge_edge_hooked = 0;
    long without_normal = 0;
    double sideways = 0;         ///< sum of the horizontal parts of all impulses [N s]
    double hooked_sideways = 0;  ///< of those that hooked pairs gave [N s]

    PairCensus& operator+=(const PairCensus& other);
};

PairCensus census(const Contacts& contacts);

/// time_s, x_m, y_m, speed_m_per_s of one rigid body, and its census. Sums up the run.
class CensusProbe final : public TableProbe {
public:
    explicit CensusProbe(std::string body);
    void observe(const World& world, const Contacts& contacts, double dt) override;

    const PairCensus& total() const { return total_; }  ///< over all steps
    int steps() const { return steps_; }
    /// first time the body no longer moves towards +x [s], -1 never
    double stopped_at() const { return stopped_at_; }
    double way() const { return farthest_ - first_x_; }  ///< farthest towards +x [m]
    double sunk() const { return first_y_ - lowest_; }   ///< lowest point below the lowest of the start [m]
    double last_speed() const { return last_speed_; }    ///< along x [m/s]

private:
    std::string body_;
    PairCensus total_;
    int steps_ = 0;
    double stopped_at_ = -1, first_x_ = 0, farthest_ = 0, first_y_ = 0, lowest_ = 0, last_speed_ = 0;
};

}  // namespace enduring::chapter05
