#pragma once

#include "chapters/07_implicit_contact/islands.hpp"
#include "chapters/07_implicit_contact/step_budget.hpp"
#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/07_implicit_contact/threads.hpp"

#include <functional>

namespace enduring {

/// How the problem of a step was solved: of one island, or of all of them.
struct SolveRecord {
    int step = 0;
    int pairs = 0;   ///< of all islands
    int rounds = 0;  ///< how often a problem was set up anew from the motion that its answer made; the most
                     ///< of any island
    int newton_steps = 0;  ///< of all rounds; the most of any island
    /// on the bodies: with the normals and the limits of friction that the impulses themselves make; the
    /// largest of any island
    double residual = 0;
    bool converged = true;  ///< every island
    int islands = 0, unsolved_islands = 0;
};

/// Says on the standard error stream which step is not solved, and how well it is.
void tell_unconverged(const SolveRecord& record);

/// Into how short a part of a step a solver goes that takes an unsolved one in halves, as a power of two:
/// 1/32. Shorter, what one part misses is no larger than what a step of a fast body misses anyway.
inline constexpr int max_halvings = 5;

//! [settings]
/// The same for all scenes but for the coefficients of friction, which are the scene's.
struct ImplicitSettings {
    StiffnessChoice stiffness;
    FrictionCoefficients friction;
    double centre = 1;  ///< of the weight over the step
    /// Of the residual, or what the rounding of coordinates leaves (rounding_residual()). A tenth: a round
    /// more for what nobody sees. Ten times: bodies at rest creep.
    double tolerance = 1e-6;
    /// The largest residual with which a step is kept; else it is taken in halves. A tenth: landing soft
    /// bodies are halved for an error that nobody sees. Ten times: impulses that do not belong to their
    /// motion gain energy.
    double kept_residual = 1e-2;
    /// Of the smaller body's size: the furthest that an impact may press a spring; else the step is taken in
    /// halves. Geometry tells the side of a pair by where it is. A tenth: a fall of some metres is halved.
    /// Ten times: what flies by fifty sizes in a step comes through a plate.
    double kept_depth = 5e-3;
    /// Part of the impulses by which pairs may miss their laws when a step is solved, and the residual below
    /// which no round is solved. A tenth: a step of Newton's method more at rest. Ten times: loads on 400
    /// pairs add up to eight digits.
    double tolerance_of_laws = 1e-9;
    /// Part of the residual that a round leaves: of its own or of that on the bodies, whichever is smaller.
    /// Its normals, its limits and its soft masses are those of the last motion. A tenth: steps of Newton's
    /// method for what the next round changes. Ten times: rounds more.
    double left_by_round = 1e-2;
    /// By how much a body may be turned from its levers [rad] in a motion that is small enough in its
    /// residual to be kept. A tenth: heaps take 10 % more steps of Newton's method. Ten times: a ball that
    /// lands while it slides ends 3 to 8 % too slow at 60 Hz.
    double lever_turn = 5e-3;
    /// The furthest that the impulses of the last step may turn a body [rad], or the solve begins without
    /// them: that of the solver, which refuses such a step. Infinite: what jaws squeeze is thrown when its
    /// pairs change, for the solve finds a whole turn.
    double max_turn = Solver{}.max_turn;
    /// Time of an operation in a sparse factor over that in a dense one: a soft body enters Newton's matrix
    /// with all its nodes where the factor of these takes fewer operations than a dense one of its vertices
    /// in touch by more than this. A tenth: a tower of soft blocks takes 2.4 times as long. Ten times: a mat
    /// of 8 by 8 cells that lies flat takes 4 times as long. Infinite: none does.
    double sparse_operation = 3;
    /// Of Newton's method for an island in a step, over all its responses and rounds, each of which counts as
    /// one more; what is not solved then is told, or the step is taken in halves. No island takes another
    /// one's. A tenth of it would cut landing soft bodies off; ten times as many cost ten seconds where a
    /// heap jams.
    int max_newton_steps = 500;
    BudgetLimits budget{};  ///< of a step, for rigid bodies
    /// Changes from round to round that are combined (AndersonMixing). None: a jam takes some times the steps
    /// of Newton's method. Ten times: changes of rounds in which other pairs slipped lead astray.
    int mixing_rounds = 8;
    /// Where bodies jam, limits that are taken from the last round come back enlarged: from this round on,
    /// each round looks for its limits (LimitSearch). A tenth: the search is tried where the rounds would
    /// have ended by themselves. Ten times: jams take most of the steps of Newton's method that there are.
    int rounds_before_search = 40;
    ForceElements elements{};         ///< what is solved together with the pairs
    int threads = allowed_threads();  ///< that solve islands side by side
    /// Of all islands together: the pairs from which on a second thread is woken. Waking it takes as long as
    /// ten pairs. A tenth: two cubes are solved no sooner, by twice the processor time. Ten times: twenty
    /// stacks leave a core without work.
    int pairs_for_threads = 64;
    /// called once a response, when all islands are done
    std::function<void(const SolveRecord&)> record = tell_unconverged;
};
//! [settings]

/// Response: finds the impulses of all pairs of an island together, from the motion that they make, and
/// applies them; so for each island. Each round brings normals, levers and limits of friction to the last
/// motion, solves one convex problem, and mixes its impulses with those of the rounds before, until the
/// equation holds on the bodies themselves.
/// @param matrices  keep their memory and their order from step to step
/// @param budget    counts what the islands of a step take, from response to response
void solve_contacts(World& world, Contacts& contacts, const ImplicitSettings& settings,
                    IslandMatrices& matrices, StepBudget& budget, double dt);
/// The same as the only response of a step.
void solve_contacts(World& world, Contacts& contacts, const ImplicitSettings& settings,
                    IslandMatrices& matrices, double dt);

/// Refresh, before anything is looked for: brings the elastic forces of soft bodies to where the step ends
/// without contact. A body that is inside out may not reach its end, for its frames jump. Halves would not
/// help: they jump in the shortest step, too.
void find_elastic_ends(World& world, double dt);

/// Whether inner forces of an island's bodies are those of the end of this step. A solver without that pass
/// keeps the linear step.
bool follows_end(const World& world, const Island& island);

/// Brings them nearer to where the step ends now.
/// @return  what was missing, of the body that missed most (InnerForces::approach_end())
double approach_ends(World& world, const Island& island, double dt);

/// What counts as a momentum at all: what gravity gives to all bodies of an island in a step, or if that is
/// more, what the rounding of their coordinates does [sqrt(kg) m/s].
double least_speed(const World& world, const Island& island, double dt);

/// What springs answer to the last digits of coordinates, of all pairs that push [sqrt(kg) m/s].
double rounding_speed(const World& world, const StepProblem& step);

/// Residual that rounding may leave, whatever the impulses are: a spring answers the last digit of a
/// coordinate with k dt times it. A stiff spring in a short step, in which weight does little, so leaves more
/// than a millionth.
double rounding_residual(const World& world, const StepProblem& step, double least_speed);

/// Gives a solver that finds pairs this chapter's solve of them.
/// @param parameters  of a scene: its coefficients of friction, its depth and its velocity come before those
///     of the settings
void add_solve(Solver& solver, const ContactParameters& parameters, ImplicitSettings settings);

}  // namespace enduring
