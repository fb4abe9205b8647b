#pragma once

#include "chapters/07_implicit_contact/pair_law.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/natural_units.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace enduring {

struct StepProblem;

/// What decides a pair's stiffness, the same for all scenes.
struct StiffnessChoice {
    double k_dt2_over_m = 100;  ///< h = k dt^2 / m of a pair with the mass that it feels itself
    /// Upper bound of h: a mass is added to k dt^2, and rounding the sum would lose the mass. A tenth: a die
    /// of a gram under 100 kg is pressed ten times deeper. Ten times: such solves do not converge.
    double max_k_dt2_over_m = 1e7;
    /// Ratio of the stiffness that mass and load require to the present one that triggers stiffening within
    /// the step; its inverse triggers softening. Infinite: a light body under a heavy one sinks through the
    /// ground until its load is known, and what has landed stays as stiff as in its impact: heaps take up to
    /// four times the steps of Newton's method. A half: every landing begins its rounds anew.
    double at_once = 2;
    /// how deep the load that a pair carries may press it [m]; without it, a part of the pair's size
    std::optional<double> wanted_depth{};
    ScaleParts parts = scale_parts;  ///< of a pair's own units: what of_pair() takes
    double keep = 0.9;               ///< part of a spring's rest offset that a step keeps
    /// Friction begins when a pair that began inside is this many wanted depths from coming out. Infinite:
    /// friction lifts a leaning block with more work than its weight needs. A tenth: it comes to rest up to
    /// 0.3 s later. Ten times: hardly anything changes.
    double friction_offset = 100;
    /// the fastest at which a rest offset fades [m/s]; without it, a part of the pair's natural speed
    std::optional<double> max_depenetration_velocity{};

    /// The wanted depth of a pair of this length [m].
    double depth(double length = NaturalUnits{}.length) const
    {
        return wanted_depth.value_or(parts.wanted_depth * length);
    }
    /// The fastest at which a rest offset of a pair with this natural speed fades [m/s].
    double fading_speed(double natural = NaturalUnits{}.speed) const
    {
        return max_depenetration_velocity.value_or(parts.max_depenetration_velocity * natural);
    }
    /// The same for a pair with these units: all its lengths in metres, and its speed.
    StiffnessChoice of_pair(const NaturalUnits& units) const;
};

/// The stiffness that a pair should have: enough for the mass that it feels, and
/// for the load that it carried in the last step, as far as numbers bear it [N/m].
/// @param mass  1 / (n . W n), W the change of its velocity per impulse [kg]
double wanted_stiffness(double mass, double load, const StiffnessChoice& choice, double dt);

/// Changes a pair's stiffness, up or down, and no force of its: its spring gets a rest offset, and friction's
/// another stretch.
void stiffen(PairMemory& spring, double depth_t0, double stiffness);

/// Gives a pair its stiffness for the step. That of an enduring one rises with its load, and falls where it
/// is far too large, without a jump of its force: its spring gets a rest offset, which fades while the pair
/// pushes no more than the most load. A pair that is born inside begins uncompressed; one that comes from
/// outside has none.
/// @param depth_t0   at the start of the step [m], negative inside
/// @param mass       as above
/// @param max_load  that others can bring upon a pair [N]
void adapt_stiffness(Contact& contact, double depth_t0, double mass, const StiffnessChoice& choice, double dt,
                     double max_load = std::numeric_limits<double>::infinity());

/// The mass that each pair stops in this step [kg]: its impulse over the fastest approach of any pair,
/// without all pairs' impulses, and at least over what gravity gives in a step. It is more than the mass that
/// the pair feels itself where other bodies press through its own.
std::vector<double> pressing_masses(const World& world, const StepProblem& step);

/// Stiffens pairs at once to what the mass that presses them requires, where this is more than twice their
/// present stiffness, but no stiffer than their load requires; no force changes.
/// @param step  as it is solved
/// @return      whether there was any: then the step's problem is another one
bool stiffen_where_pressed(const World& world, StepProblem& step, const StiffnessChoice& choice);

/// Before the step is settled: what each pair hands on to the next one, its load and the stretch of its
/// friction. One that is held holds nothing: its spring has let go. Its `start` says from here on whether it
/// endures, or was open when the step began and pushes from its end. In a part that cannot be halved any more
/// its spring is pressed by what it carries, and by no depth that the solve has left.
void remember_pairs(const World& world, Contacts& contacts, double dt);

}  // namespace enduring
