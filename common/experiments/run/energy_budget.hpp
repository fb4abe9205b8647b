#pragma once

#include "common/experiments/run/spring_ledger.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/pressed_bodies.hpp"

#include <array>
#include <optional>
#include <string>

namespace enduring {

/// Tells when a run makes energy out of nothing, by more than a tenth of all that was put in: then its step
/// is too long for its springs, or its pairs are not those that should push.
///
/// Held, as a mean over the last ten steps, is all that can turn into motion again: kinetic and elastic
/// energy of the bodies, that of every pair's spring, k stretch^2 / 2 of every friction spring, and their
/// weight above the lowest place that they came to. Put in are what was held at the start, the work of
/// gravity down to that lowest place, that of springs whose rest offset fades, which lift a body out that
/// began inside another (see SpringAccounts), and that of all that drives bodies from outside
/// (World::driven), as a mean over the last ten steps, too. Nothing else drives a scene, and its gravity does
/// not turn.
class EnergyBudget {
public:
    /// @param scene     before its first step
    /// @param contacts  pairs that live on from a run that is resumed
    explicit EnergyBudget(const Scene& scene, const Contacts& contacts = {});

    /// To be asked after each step.
    /// @param contacts  those alive after it
    /// @return what went wrong, where and what to change, as a sentence for
    ///     the reader; nothing while all is well
    std::optional<std::string> exceeded(const World& world, const Contacts& contacts);

    double added_energy() const { return start_ - lowest_ + lifted() + driven(); }  ///< [J]
    double lifted() const { return springs_.accounts().lifted; }  ///< by letting bodies out [J]
    double driven() const;  ///< from outside since the start, as the mean over the last ten steps [J]
    double held() const;    ///< the mean over the last ten steps [J]

private:
    /// The bodies whose springs asked for the shortest step so far.
    struct LeastStable {
        PressedBodies bodies{};
        double stable_step;  ///< [s]
        int step;
    };

    void watch_springs(const World& world, const Contacts& contacts);
    std::string explanation(const World& world) const;

    double dt_, slack_;
    ContactParameters parameters_;
    SpringLedger springs_;
    double start_ = 0;   ///< all energy at the start, the gravitational part from the origin [J]
    double lowest_ = 0;  ///< gravitational energy at its lowest, from the origin [J]
    /// after each of the last steps; before them what was there at the start [J]
    std::array<double, 10> last_held_{}, last_driven_{};
    double driven_at_start_ = 0, driven_so_far_ = 0;  ///< World::driven [J]
    double driven_both_ways_ = 0;  ///< sizes of the work of each step, which may be done and taken back [J]
    std::optional<LeastStable> least_stable_;
    bool finds_stiffness_ = false;  ///< the solver gives each pair its own
};

}  // namespace enduring
