#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::chapter04 {

/// All that can turn into motion again [J]: kinetic, gravitational and elastic energy of the bodies, what the
/// penalty springs hold (k depth^2 / 2 a pair), and what the friction springs hold.
double energy_with_springs(const World& world, const Contacts& contacts, const ContactParameters& parameters);

/// series, time_s, energy_j; and how far the energy ever rose above what it had been before.
class SpringEnergyProbe final : public TableProbe {
public:
    SpringEnergyProbe(std::string series, ContactParameters parameters);
    void observe(const World& world, const Contacts& contacts, double dt) override;
    double largest_rise() const { return largest_rise_; }  ///< above the lowest value so far [J]

private:
    std::string series_;
    ContactParameters parameters_;
    double lowest_ = 1e300, largest_rise_ = 0;
};

}  // namespace enduring::chapter04
