#pragma once

#include "chapters/13_other_solvers/barrier_terms.hpp"
#include "chapters/13_other_solvers/rigid_step.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace enduring {

//! [smooth_friction]
/// Friction of force 1 over a slip: its potential f0 [m], the force f1 in [0, 1] and its slope [1/m]. Full from `full` [m] on, and smooth through 0.
struct SmoothFriction {
    double potential = 0, force = 0, slope = 0;
};
/// @see Li et al. 2020, section on friction: f0 and f1
SmoothFriction smooth_friction(double slip, double full);
//! [smooth_friction]

/// The incremental potential of a step over the poses of all bodies [J]: inertia, a barrier for each pair of features, and friction with normal forces
/// of poses before. Six coordinates a moving body: its displacement, and a rotation vector from the pose that there is.
/// @see Li et al. 2020, (5); Ferguson et al. 2021, "Intersection-free rigid body dynamics", section on rigid bodies: the inertia of all points
class IncrementalPotential {
public:
    /// @param step      its points are the pairs that can meet
    /// @param distance  d^hat [m], positive
    IncrementalPotential(const RigidStep& step, const BarrierSettings& settings, double distance);

    int coordinates() const { return size_; }
    /// Poses behind a displacement of all coordinates.
    Poses moved(const Poses& from, const Eigen::VectorXd& by) const;
    double value(const Poses& poses) const;
    struct Slopes {
        Eigen::VectorXd gradient;
        Eigen::SparseMatrix<double> hessian;  ///< of each pair its positive part
    };
    Slopes slopes(const Poses& poses) const;
    /// Friction holds by the normal forces of these poses from now on.
    void lag(const Poses& poses);
    /// The impulse on A of each point, normal and friction [N s].
    std::vector<Vec3> impulses(const Poses& poses) const;
    /// The part of a displacement on which no pair meets and no body leaves the reach of the search: 1, or less; 0 if there is none.
    /// Paths of vertices are straight from pose to pose. So what is behind them can be reached without a crossing.
    /// @param reach  from the start of the step [m]
    double free_part(const Poses& from, const Eigen::VectorXd& by, double reach) const;

private:
    struct Holding {  ///< friction of a term, lagged
        std::size_t point;
        std::array<double, 4> weights;
        Vec3 normal;
        double most;  ///< mu times the normal force [N]
        Vec3 start;   ///< p - q when the step begins [m]
    };
    struct Assembly;

    void add_inertia(std::size_t body, const Pose& pose, Assembly& assembly) const;
    Vec3 slip(const Holding& holding, const Poses& poses) const;
    bool is_beyond(const Poses& poses, double reach) const;

    const RigidStep& step_;
    const BarrierSettings& settings_;
    double distance_;   ///< d^hat [m]
    double full_slip_;  ///< from which on friction is full [m]
    double kappa_ = 0;  ///< [J]
    int size_ = 0;
    std::vector<int> first_;  ///< coordinate of each body; -1 for what does not move
    Poses inertial_;          ///< where each comes without contact
    std::vector<Holding> holdings_;
};

}  // namespace enduring
