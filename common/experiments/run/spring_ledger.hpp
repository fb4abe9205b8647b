#pragma once

#include "common/simulation/step.hpp"

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace enduring {

/// Where the energy of the contacts' springs came from and where it went, summed over the steps so far [J].
///
/// A spring of stiffness k holds k c^2 / 2, where c is how much deeper its pair is than its rest offset. In a
/// step that ended badly a pair's impulse is not what its depth says, as where driven bodies squeeze a stack:
/// there a spring holds no more than its pair has pushed with.
struct SpringAccounts {
    double born = 0;    ///< that new pairs had where their bodies lay at the start of their first step
    double died = 0;    ///< that pairs still had when they ended or were held
    double lifted = 0;  ///< work of a rest offset that fades: force times the distance by which it moved
    double jumped = 0;  ///< by a rest offset that fades faster than anything may separate, or by another face
    double pushed = 0;  ///< work of the normal impulses on the bodies
    double rubbed = 0;  ///< that of friction
    double damped = 0;  ///< lost between the springs and their impulses: with an implicit step never negative

    /// What came without work: initial overlaps and jumps, less what pairs that end take along.
    double brought() const { return born + jumped - died; }
};

/// Books what each spring holds from step to step: what is held is what was born, lifted and jumped, less
/// what died, was pushed and damped.
///
/// Between two steps the bodies stand still, so a spring's compression can only change with the spring: by
/// its rest offset, its stiffness, or by another face. A spring that gets stiffer and pushes as before loses
/// energy, and that is damping. If the rest of the change is no more than the leaving speed allows, it is a
/// lift, whose work counts with the force at the end of the step, as the step itself does. Depths of a step
/// are measured along the normal at its end, as an implicit step sees them.
class SpringLedger {
public:
    /// @param world          before its first step
    /// @param stiffness      k of a pair without one of its own, on planes without one of their own [N/m]
    /// @param max_depenetration_velocity  a rest offset that fades faster throws [m/s]; without it, that of
    ///                       the pair's size
    SpringLedger(const World& world, double stiffness, std::optional<double> max_depenetration_velocity);

    /// To be told after each step.
    /// @param contacts  those alive after it
    void add_step(const World& world, const Contacts& contacts, double dt);

    const SpringAccounts& accounts() const { return accounts_; }
    double held() const;  ///< by all springs now [J]

private:
    using Key = std::tuple<ContactKind, int, int, int, int>;  ///< kind, body_a, feature_a, body_b, feature_b
    struct Spring {
        double compression;  ///< at the end of the step, negative if it pushes, else 0 [m]
        double energy;       ///< then [J]
        double stiffness;    ///< [N/m]
    };
    struct Booked {
        Key key;
        Spring spring;
        Spring at_start;                    ///< the same spring where the bodies lay at the start of the step
        double force;                       ///< mean over the step [N]
        double max_depenetration_velocity;  ///< at which its rest offset may fade [m/s]
        double came = 0;                    ///< into the spring: what it held before, and what was put in [J]
        bool known = false;                 ///< it was there in the last step
    };

    Booked book(const World& world, const Contact& contact, bool ended_badly, double dt);
    void take_over(Booked& booked, std::multimap<Key, Spring>::iterator before, double dt);
    std::multimap<Key, Spring>::iterator find_at_any_face(Key key);

    double stiffness_;
    std::optional<double> max_depenetration_velocity_;
    std::vector<std::vector<Vec3>> positions_;  ///< of each body before the step
    std::multimap<Key, Spring> springs_;
    long ended_badly_;  ///< parts so far
    SpringAccounts accounts_;
};

}  // namespace enduring
