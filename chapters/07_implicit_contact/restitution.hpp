#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

/// The impact of one pair along its normal, in a step that ended with its surfaces in touch.
struct PairImpact {
    double gap_t0 = 0;  ///< at the start of the step [m], positive outside
    double free_speed =
        0;  ///< at the end of the step without the impulses of pairs [m/s], negative while it approaches
    double acceleration = 0;  ///< of p against q by gravity [m/s^2], negative towards each other
    double pressed = 0;       ///< how far its spring is pressed at the end of the step [m]
    double dt = 0.01;         ///< [s]
};

/// The velocity at the moment of touch [m/s], negative; 0 where the pair does not approach.
///
/// The velocities of symplectic Euler belong to the middles of its steps, so at the start of the step the
/// velocity is u_0 + a dt / 2, and a parabola leads from there through the gap.
double touching_speed(const PairImpact& impact);

/// The velocity at the end of the step [m/s] that belongs to the velocity `leaving` at touch: the height
/// above the pressed spring is taken into account, and the velocity is brought back to the middle of the
/// step.
double speed_after(const PairImpact& impact, double leaving);

//! [restitution_limits]
struct RestitutionLimits {
    /// Of g dt: the least speed at touch of an impact. At rest gravity brings g dt in a step, and what falls
    /// through the width of one step up to twice as much. A tenth: a pile trembles for ever. Ten times: a
    /// ball of e = 0.5 and dt 10 ms ends its bounces at 20 cm, not at 2 mm.
    double least_speed = 2;
    /// Of the pair's length: the depth that counts as none. A spring of 100 m / dt^2 is pressed by this when
    /// it answers the least that counts as an answer (ScaleParts::least_answer). A tenth: rounding bounces.
    /// Ten times: what begins in touch and comes in slowly does not bounce.
    double least_length = 1e-9;
    /// Of the largest response: what counts as none where more pairs meet than bodies can tell apart. A
    /// tenth: 1 kg that strikes 1 mg before 1,000 t bounces, too. Ten times: 1 kg, 0.1 g and 10 t still do.
    double least_response = 1e-6;
    /// over the pairs with friction in an impact. A tenth: a cube that lands flat keeps some slip. Ten times:
    /// only costs time.
    int friction_sweeps = 20;
};
inline constexpr RestitutionLimits restitution_limits;
//! [restitution_limits]

/// A pair that carried an impulse in this step.
struct PushedPair {
    PairImpact impact;
    Vec3 normal = Vec3::UnitY();
    Vec3 velocity = Vec3::Zero();         ///< of p against q, behind the commit [m/s]
    Vec3 velocity_driven = Vec3::Zero();  ///< the part of bodies that do not answer
    Vec3 running = Vec3::Zero();          ///< of the surfaces [m/s]
    Vec3 acceleration = Vec3::Zero();     ///< of p against q by gravity [m/s^2]
    double restitution = 0, mu = 0;
    bool meets = false;  ///< was open at the start, and met faster than what rests does
};

/// What impulses of pairs do to energy.
struct ImpulseWork {
    double slope = 0;   ///< impulses . velocities behind the commit, with surfaces that run [J]
    double fall = 0;    ///< g . p of them [J/s]
    double driven = 0;  ///< work of bodies that move as given, and of surfaces that run [J]

    /// @param friction  the part of the impulse that is friction [N s]
    void add(const PushedPair& pair, const Vec3& impulse, const Vec3& friction);
};

/// An island's impact: its pairs, and the coordinates of its bodies behind the commit.
struct IslandImpact {
    StepProblem step;
    std::vector<PushedPair> pairs;  ///< of each row
    ImpulseWork work;               ///< of all impulses of the step
    double lost = 0;           ///< energy that these impulses took away, with work of running surfaces [J]
    Eigen::MatrixXd response;  ///< W, of velocities along the normals
};

/// What pairs answer to an impact, seen by the pairs alone: velocities along their normals [m/s], negative
/// while they approach, and the response W, the change of these velocities per impulse [1/kg], symmetric and
/// never negative.
/// @see Smith, Kaufman, Vouga, Tamstorf, Grinspun: Reflections on simultaneous impact, ACM TOG 31(4), 2012

/// The impulses [N s], none negative, after which no pair approaches and none that got one separates: the
/// impact without restitution.
/// @param velocities  before
Eigen::VectorXd stopping_impulses(const Eigen::MatrixXd& response, const Eigen::VectorXd& velocities);

/// The sum of the impulses of generalized reflections: those pairs that approach are stopped together and
/// sent back by as much again, which keeps the kinetic energy; so with those that approach now, until none
/// does.
Eigen::VectorXd reflecting_impulses(const Eigen::MatrixXd& response, const Eigen::VectorXd& velocities);

/// The largest part, up to 1, of some impulses with which the kinetic energy changes by no more than is
/// allowed: part slope + part^2 curvature / 2 <= allowed.
/// @param slope      impulses . velocities before [J]
/// @param curvature  impulses . W impulses [J]
/// @param allowed    [J]; below zero, nothing is
double allowed_part(double slope, double curvature, double allowed);

/// Of an island, the pairs that pushed and their bodies. Empty where none of them can bounce.
Island pushed_part(const World& world, const Island& island, double dt);

/// Behind the commit of a step of dt: what these pairs met with. Masses and levers are those behind the
/// commit.
IslandImpact impact_of(const World& world, const Island& part, const FrictionCoefficients& friction,
                       double dt);

/// Behind the commit: pairs that met in this step send their bodies back, as the coefficients of restitution
/// of the world say. Only velocities change, by impulses of pairs that carried one in this step: along their
/// normals, and friction of these. Without coefficients nothing is done.
/// @param friction  of all pairs; a world's materials come before it
void restitute(World& world, Contacts& contacts, const FrictionCoefficients& friction, double dt);

}  // namespace enduring
