#pragma once

#include "chapters/13_other_solvers/potential_assembly.hpp"
#include "chapters/13_other_solvers/settings.hpp"
#include "chapters/13_other_solvers/soft_elements.hpp"

#include <vector>

namespace enduring {

//! [smooth_friction]
/// Friction of force 1 over a slip: its potential f0 [m], the force f1 in [0, 1] and its slope [1/m]. Full
/// from `full` [m] on, and smooth through 0.
struct SmoothFriction {
    double potential = 0, force = 0, slope = 0;
};
/// @see Li et al. 2020, section on friction: f0 and f1
SmoothFriction smooth_friction(double slip, double full);
//! [smooth_friction]

/// The incremental potential of a step over the places of all bodies and nodes [J]: inertia, what elements
/// store, a barrier for each pair of features, and friction with normal forces of places before.
/// @see Li et al. 2020, (5); Ferguson et al. 2021, "Intersection-free rigid body dynamics", section on rigid
///     bodies: the inertia of all points
class IncrementalPotential {
public:
    /// @param step      its points are the pairs that can meet
    /// @param distance  d^hat [m], positive
    /// @param reach     how far bodies may go in the step [m]
    /// @param whole_dt  of the step of which this one may be a part [s]: barriers do not stiffen where it is
    ///     halved
    IncrementalPotential(const MethodStep& step, const BarrierSettings& settings, double distance,
                         double reach, double whole_dt);

    Places moved(const Places& from, const Eigen::VectorXd& by) const { return coordinates_.moved(from, by); }
    double value(const Places& places) const;
    /// What the barriers hold of it [J].
    double held(const Places& places) const;
    PotentialSlopes slopes(const Places& places) const;
    /// Friction holds by the normal forces of these places from now on.
    void lag(const Places& places);
    /// The impulse on A of each point, normal and friction [N s].
    std::vector<Vec3> impulses(const Places& places) const;
    /// The part of a displacement on which no pair meets and no body leaves the reach of the search: 1, or
    /// less; 0 if there is none. Paths of vertices are straight from pose to pose. So what is behind them can
    /// be reached without a crossing.
    double free_part(const Places& from, const Eigen::VectorXd& by) const;

private:
    struct Holding {  ///< friction of a term, lagged
        std::size_t point;
        std::array<double, 4> weights;
        Vec3 normal;
        double most;  ///< mu times the normal force [N]
        Vec3 start;   ///< p - q when the step begins [m]
    };
    /// The pairs that may come within d^hat at these places.
    const PairPlaces& near(const Places& places) const;
    /// Whether no pair comes within d^hat that near_ has not.
    bool is_served(const Places& places) const;
    /// A bound of how far a corner has moved from one to the other [m].
    double longest_way(const Places& from, const Places& to) const;
    double inertia(const Places& places) const;
    void add_inertia(const Places& places, PotentialSlopes& slopes) const;
    Derivatives friction(const Holding& holding, const Places& places) const;
    Vec3 slip(const Holding& holding, const Places& places) const;
    bool is_beyond(const Places& places) const;

    const MethodStep& step_;
    const BarrierSettings& settings_;
    double distance_;   ///< d^hat [m]
    double reach_;      ///< from the start of the step [m]
    double full_slip_;  ///< from which on friction is full [m]
    double kappa_ = 0;  ///< [J]
    StepCoordinates coordinates_;
    std::vector<SoftElements> soft_;
    Places start_;     ///< of the step
    Places inertial_;  ///< where each comes without contact and elements
    PairPlaces all_;   ///< pairs
    std::vector<Holding> holdings_;
    double slack_;             ///< how much nearer than d^hat two features of near_ may be found apart [m]
    mutable PairPlaces near_;  ///< of near_places_; found anew where corners have moved by half of slack_
    mutable Places near_places_;
};

}  // namespace enduring
