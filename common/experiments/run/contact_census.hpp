#pragma once

#include "common/experiments/run/probes.hpp"

namespace enduring {

/// How many contacts of each kind and category there are, and what they carry.
///
/// time_s, plane, vf_regular, vf_hooked, vf_other, ee_regular, ee_hooked, ee_other (no category: a solver
/// that gives none, or a new pair), held (counted above as well), normal_n, friction_n: sums of the lengths
/// of all pairs' mean forces over the step, so that forces in opposite directions add up.
class ContactCensus final : public TableProbe {
public:
    ContactCensus();
    void observe(const World& world, const Contacts& contacts, double dt) override;
};

}  // namespace enduring
