#pragma once

#include <optional>

namespace enduring {

//! [search_settings]
/// How far the common search of this chapter looks.
struct SearchSettings {
    /// Of the size of the smaller body [1]: features nearer than this, and than the way of the step, get a
    /// pair. A tenth: a vertex that a soft contact has let in is still found, but a tilting cube meets its
    /// edge a step late. Ten times: four times the pairs, none of which pushes.
    double reach = 0.02;
    /// Of that size [1]: how deep inside a vertex or an edge may be and still be pushed out by what is
    /// nearest. A tenth: the block that begins 10 cm deep falls through its floor. Twice: more candidates,
    /// none of which is let out another way.
    double depth = 0.5;
};
//! [search_settings]

//! [sequential_settings]
/// Sequential impulses (Catto 2006; Bullet, Box2D 2.4).
struct SequentialSettings {
    int iterations =
        10;  ///< over all contacts; Bullet's default. A stack of ten needs some hundreds from zero impulses.
    double baumgarte = 0.2;  ///< part of a depth that a step takes away [1]; Box2D 2.4, Bullet. 1 overshoots:
                             ///< contacts answer one by one.
    double slop = 0.005;  ///< of the size of a body [1]: depth that is left, so that contacts do not open and
                          ///< close; Box2D's 5 mm on 1 m
    double warm_start = 1;  ///< part of the impulses of the last step with which it begins [1]; Box2D 2.4.
                            ///< With 0, a stack of ten sinks.
    double split_from = 0;  ///< depth [m] from which on velocities of their own, which are forgotten, take a
                            ///< depth away. Infinite: each push adds kinetic energy.
    double restitution_threshold = 1;  ///< approach below which nothing bounces [m/s]; Box2D 2.4
};
/// Bullet 3.24 (btContactSolverInfo): no slop, shallow depths by Baumgarte, a part of the last impulses.
inline SequentialSettings bullet_settings() { return {.slop = 0, .warm_start = 0.85, .split_from = 0.04}; }
/// Jolt (PhysicsSettings): 20 mm of slop; its rows of positions, after those of velocities, are split pushes.
inline SequentialSettings jolt_settings() { return {.slop = 0.02}; }
//! [sequential_settings]

//! [soft_step_settings]
/// The soft step (Catto 2024; Box2D 3).
struct SoftStepSettings {
    int substeps = 4;   ///< Box2D 3. One sweep each; twice as many halve what is left.
    double hertz = 30;  ///< of the spring of a contact [1/s]; Box2D 3
    double hertz_of_rate =
        0.25;  ///< and no more than this part of the rate of substeps, which is what a substep can follow
    double damping_ratio = 10;  ///< of critical; Box2D 3: far overdamped, so depths go without a bounce
    double push_speed =
        3;  ///< at which depths go at most [m/s]; Box2D 3. Ten times: what begins inside is thrown.
    double slop =
        0.005;  ///< of the size of a body [1]: a depth that no spring takes away; Box2D's 5 mm on 1 m
    double restitution_threshold = 1;  ///< [m/s]; Box2D 3
};
/// Rapier 0.21 of npm: 30 Hz, four substeps and a damping ratio of 10, which its `contact_erp` tells. Its
/// slop acts on nothing: a cube rests at the same depth for a slop of 0, 0.1 and 5 mm.
inline SoftStepSettings rapier_settings() { return {.slop = 0}; }
//! [soft_step_settings]

//! [impedance_settings]
/// MuJoCo's softness of a contact (Todorov 2014; `solref` and `solimp` of its documentation).
struct ImpedanceSettings {
    double time_constant = 0.02;  ///< in which a depth goes [s]; MuJoCo. At least two steps, or it rings.
    double damping_ratio = 1;     ///< of critical [1]; MuJoCo
    double least = 0.9;   ///< impedance where a contact begins [1]; MuJoCo. 1 would be rigid, 0 no contact.
    double most = 0.95;   ///< impedance from `width` on [1]; MuJoCo. 0.99: a fifth of the depth.
    double width = 1e-3;  ///< [m]; MuJoCo
};
//! [impedance_settings]

//! [relaxation_settings]
/// The convex relaxation (Anitescu 2006; Drake's SAP, Castro 2022).
struct RelaxedSettings {
    double beta = 1;  ///< near-rigid limit: the period of a contact is beta dt at least [1]; Drake. A tenth:
                      ///< worse condition, depth / 100.
    double sigma = 1e-3;  ///< regularisation of friction, in the response of a contact [1]; Drake. Ten times:
                          ///< a visible creep on slopes.
    double dissipation =
        1;  ///< time in which a depth relaxes, in steps [1]. Near 0 a depth goes in one step, and rings.
    double tolerance = 1e-10;    ///< of the gradient, in the momentum of the step [1]; ends Newton's method
    int max_steps = 100;         ///< of Newton's method; Drake. Stacks take below 20.
    int line_search_steps = 40;  ///< halvings: below 2^-40 nothing changes
    std::optional<ImpedanceSettings> impedance = {};  ///< MuJoCo's softness instead of the near-rigid limit
};
/// MuJoCo's defaults: its softness in the same convex problem.
inline RelaxedSettings mujoco_settings() { return {.impedance = ImpedanceSettings{}}; }
//! [relaxation_settings]

//! [xpbd_settings]
/// XPBD for rigid bodies (Macklin 2016, Mueller 2020).
struct XpbdSettings {
    int substeps = 20;      ///< Mueller 2020 has 20; one iteration each
    int iterations = 1;     ///< of a substep; Macklin 2019: substeps instead of iterations
    double compliance = 0;  ///< of a contact [m/N]; rigid in the paper
};
//! [xpbd_settings]

//! [avbd_settings]
/// Augmented vertex block descent for rigid bodies (Giles, Diaz, Yuksel 2025).
struct AvbdSettings {
    int iterations = 10;  ///< sweeps over the bodies; the paper's demo
    double alpha =
        0.95;  ///< part of an error at the start that is left as it is (eq. 18) [1]; demo 0.95 to 0.99
    double gamma = 0.99;  ///< part of stiffness and multiplier that the next step begins with (eq. 19) [1]
    double beta =
        1e5;  ///< growth of a stiffness per error (eq. 16) [N/m^2]; the demo's, for masses about 1 kg
    double least_stiffness = 1;   ///< [N/m], the demo
    double most_stiffness = 1e9;  ///< [N/m], the demo
};
//! [avbd_settings]

//! [barrier_settings]
/// The barrier method for rigid bodies (IPC, Li 2020; rigid-ipc, Ferguson 2021). Lengths are parts of the
/// smallest moving body's size.
struct BarrierSettings {
    double distance = 1e-3;  ///< d^, from which on the barrier pushes [1]; both papers, of the scene. Ten
                             ///< times: bodies rest ten times as deep.
    double stiffness = 1;    ///< kappa in m (d^ / dt)^2 [1], m the mean mass: to come to rest within d^ costs
                             ///< about one kappa. Ten times: nearer to d^, worse condition.
    double friction_speed = 1e-3;  ///< slip at which friction is in full, sizes a second [1/s]; Li 2020. A
                                   ///< tenth: a tenth of the creep on slopes, more steps.
    int lags = 2;  ///< problems of a step, each with the normal forces of the one before; with 1, a landing
                   ///< has no friction
    double tolerance = 1e-6;  ///< change of velocity that ends Newton's method, sizes a second [1/s]; Li 2020
                              ///< has 1e-2, where loads are right to a percent
    int max_steps = 100;      ///< of Newton's method for a problem; a stack of ten takes below 30
    int line_search_steps = 60;  ///< below 2^-60 nothing changes
    double reach = 4;  ///< of the longest way of a vertex as predicted [1]: how far bodies may go in a step.
                       ///< With 1, a light body is stopped that a heavy one hits.
    double least_reach =
        0.02;              ///< and this beside it [1]: what rests may rock. Ten times: ten times the pairs.
    int max_halvings = 6;  ///< of a step that turns a body too far, gains energy or ends unsolved; not in the
                           ///< papers. With 0, what spins fast gains when it hits.
    double part_of_impact = 0.8;  ///< of the time of impact that a step may go [1]; Li 2020
};
//! [barrier_settings]

}  // namespace enduring
