#include "chapters/07_implicit_contact/island_solve.hpp"

#include "chapters/07_implicit_contact/anderson_mixing.hpp"
#include "chapters/07_implicit_contact/limit_search.hpp"
#include "chapters/07_implicit_contact/part_without_gain.hpp"
#include "chapters/07_implicit_contact/rolling_friction.hpp"
#include "chapters/07_implicit_contact/whole_bodies.hpp"
#include "common/fem/elastic_body.hpp"
#include "common/simulation/turns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enduring {
namespace {

/// What springs hold where the bodies are at the start of the step [J].
double springs_at_start(const World& world, const StepProblem& step)
{
    double sum = 0;
    for (const Contact* contact : step.of_row) {
        const double compression = std::min(0.0,
                                            depth_at_start(world, *contact) - contact->spring.rest_offset);
        sum += contact->spring.stiffness / 2 *
               (compression * compression + contact->spring.stretch.squaredNorm());
    }
    return sum;
}

/// The way that bodies which move as given take in the step against a pair's normal: they come nearer,
/// whatever the pair answers [m].
double driven_approach(const World& world, const Contact& contact, const Vec3& normal)
{
    double approach = 0;
    for (int i = 0; i < contact.vertex_count(); ++i) {
        const auto vertex = static_cast<std::size_t>(i);
        if (const Body& body = body_of_vertex(world, contact, i); body.is_static())
            approach -= contact.weights[vertex] * normal.dot(body.position(contact.vertices[vertex], 1) -
                                                             body.position(contact.vertices[vertex], 0));
    }
    return std::max(0.0, approach);
}

/// How much farther a spring is pressed at the end of the step than at its start, over the size of its
/// smaller body; the most of all. What pressed it before no shorter step mends, nor what a drive presses.
double largest_compression(const World& world, const StepProblem& step)
{
    double most = 0;
    for (std::size_t i = 0; i < step.of_row.size(); ++i) {
        const PairRow& row = step.problem.rows[i];
        const Contact& contact = *step.of_row[i];
        const double depth_t0 = std::min(0.0, row.law.depth_t0),
                     depth_t1 = row.law.depth_t0 + step.problem.step.dt * row.law.normal.dot(row.velocity),
                     added = depth_t0 - depth_t1 - driven_approach(world, contact, row.law.normal);
        most = std::max(most, added / natural_length(world, contact));
    }
    return most;
}

/// By how much the pairs' impulses change, over what they become, both measured by the speed that they give
/// [1]. The residual would say too much: between stiff springs it is near 1 even where hardly anything moves,
/// so elements would follow in each round, and no two rounds could be mixed.
double changed_part(const ContactProblem& problem, const Eigen::VectorXd& before, const Eigen::VectorXd& next,
                    double least_speed)
{
    Eigen::VectorXd change = Eigen::VectorXd::Zero(problem.size), total = change;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const auto place = static_cast<Eigen::Index>(3 * i);
        problem.rows[i].add_impulse(next.segment<3>(place) - before.segment<3>(place), change);
        problem.rows[i].add_impulse(next.segment<3>(place), total);
    }
    return residual_from(problem, change, total, least_speed);
}

//! [begin]
/// The impulses of the last step act on the bodies: at rest they are the answer. Where other pairs are in
/// touch now they balance no more, and a motion that turns a body too far for a step is no beginning: then
/// the free motion is.
void begin_with_last_impulses(World& world, StepProblem& step, double max_turn)
{
    const Turns free_turns(world, step.bodies, step.problem.step.dt);
    apply_impulses(world, step, last_impulses(world, step));
    if (free_turns.exceeded(world, max_turn))
        apply_impulses(world, step, Eigen::VectorXd::Zero(impulses_acting(step.problem).size()));
}
//! [begin]

/// The size of all pairs' impulses, each by the mass that its pair feels: pushes that cancel count, too
/// [sqrt(kg) m/s].
double speed_of_pairs(const StepProblem& step, const Eigen::VectorXd& impulses)
{
    double sum = 0;
    for (std::size_t i = 0; i < step.responses.size(); ++i)
        sum += impulses.segment<3>(static_cast<Eigen::Index>(3 * i)).squaredNorm() /
               mass_along(step.problem.rows[i].law.normal, step.responses[i]);
    return std::sqrt(sum);
}

//! [own_impulses]
/// Gives each pair what its own law says of the motion found, with the limit of friction that this motion
/// makes. Newton's tangents move the bodies in the same way, but leave open what no motion tells apart, as
/// among seven vertices or between the jaws of a vice. One more step of Newton's method, from the laws'
/// impulses, makes these add up to what moves the bodies.
/// @param enough  part of the impulses by which they may miss their laws as they are; what rounding makes of
///     them is enough, too
/// @return        steps of Newton's method: one, or none where the impulses obey their laws already
int take_own_impulses(World& world, StepProblem& step, NewtonMatrix& matrix, double enough)
{
    ContactProblem& problem = step.problem;
    for (PairRow& row : problem.rows)
        row.law.lagged_normal_impulse = normal_impulse(row.law, row.velocity, problem.step);
    const Answers answers = answers_to(problem, Eigen::VectorXd::Zero(problem.size));
    if (speed_of_pairs(step, answers.impulses - impulses_acting(problem)) <=
        std::max(enough * speed_of_pairs(step, answers.impulses), rounding_speed(world, step)))
        return 0;
    std::vector<Mat3> hessians;
    hessians.reserve(problem.rows.size());
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
        hessians.push_back(problem.hessian_by(problem.rows[i], answers.pushes[i], problem.rows[i].velocity));
    const Eigen::VectorXd correction = matrix.solve(problem, hessians, answers.unbalanced);
    apply_impulses(world, step, matrix.tangent(answers.impulses, rates_of(problem, correction)));
    return 1;
}
//! [own_impulses]

/// One island in one response, and what lasts from round to round.
class IslandSolve {
public:
    IslandSolve(World& world, const Island& island, const ImplicitSettings& settings, NewtonMatrix& matrix,
                const Allowance& allowed, bool first, double dt);

    IslandOutcome solve();

private:
    void take_rounds();
    void follow_elastic_forces();
    void follow_motion();
    bool follow_levers_when_near();
    void solve_round(const ProblemSolution& begin);
    bool solve_last_problem();

    /// Of Newton's method; the next round counts as one.
    int steps_left() const { return most_steps_ - matrix_.solves() - record_.rounds - 1; }

    World& world_;
    const Island& island_;
    const ImplicitSettings& settings_;
    NewtonMatrix& matrix_;
    const Allowance allowed_;
    const bool first_, has_elements_, is_soft_;
    const double dt_, least_;  ///< [s], see least_speed()
    StepProblem step_;
    const bool has_new_pairs_;  ///< in the first response all are
    const bool has_budget_;
    const int most_steps_;  ///< of Newton's method since the attempt began
    const int mixed_;       ///< see ImplicitSettings::mixing_rounds
    AndersonMixing mixing_;
    double missing_ = 0;  ///< of elastic forces, as a part of what the step changes
    /// Of velocities, back to before elements moved the pairs: springs are a thousand times as stiff, so a
    /// problem begins there.
    Eigen::VectorXd before_move_;
    SolveRecord record_{};
};

IslandSolve::IslandSolve(World& world, const Island& island, const ImplicitSettings& settings,
                         NewtonMatrix& matrix, const Allowance& allowed, bool first, double dt)
    : world_(world), island_(island), settings_(settings), matrix_(matrix), allowed_(allowed), first_(first),
      has_elements_(!island.elements.empty()), is_soft_(follows_end(world, island)), dt_(dt),
      least_(least_speed(world, island, dt)),
      step_(set_up(world, island, settings.stiffness, settings.friction, {settings.centre, dt}, first,
                   settings.sparse_operation)),
      has_new_pairs_(std::any_of(step_.of_row.begin(), step_.of_row.end(),
                                 [](const Contact* contact) { return contact->waiting(); })),
      has_budget_(!is_soft_ && !has_elements_),
      most_steps_(has_budget_ ? std::min(settings.max_newton_steps, allowed.newton_steps)
                              : settings.max_newton_steps),
      // Forces of joints that cancel each other are not determined, and mixing would enlarge what rounding
      // makes of them.
      mixed_(has_elements_ ? 0 : settings.mixing_rounds), mixing_(mixed_),
      before_move_(Eigen::VectorXd::Zero(step_.problem.size))
{
    add_rolling_rows(world, settings.friction, step_);
    if (has_elements_)
        settings.elements.add_rows(world, step_);
    record_.pairs = static_cast<int>(step_.of_row.size());
}

//! [solve_island]
IslandOutcome IslandSolve::solve()
{
    IslandOutcome outcome;
    if (first_) {
        outcome.springs = springs_at_start(world_, step_);
        begin_with_last_impulses(world_, step_, settings_.max_turn);
    }
    const int solves_before = matrix_.solves();
    take_rounds();
    // what rounding leaves of hardly any impulse no shorter step mends
    const bool is_near = record_.converged || record_.residual <= settings_.kept_residual,
               is_lagged = !is_near && has_budget_ && allowed_.is_last && solve_last_problem();
    const bool is_last = !world_.attempt.may_be_halved;
    outcome.is_held_up = has_elements_ && is_last && !is_near;
    if (outcome.is_held_up)  // a part of what joints push holds nothing
        apply_impulses(world_, step_, 0 * impulses_acting(step_.problem));
    else if ((is_lagged || is_last) && !has_elements_)
        if (const double part = part_without_gain(world_, step_); part < 1)
            apply_impulses(world_, step_, part * impulses_acting(step_.problem));
    outcome.is_lagged = is_lagged;
    if (!is_near && !is_lagged)
        outcome.trouble = StepTrouble::unsolved;
    else if (largest_compression(world_, step_) > settings_.kept_depth)
        outcome.trouble = StepTrouble::too_deep;
    find_slip(step_);
    if (has_elements_)
        settings_.elements.remember(world_, step_);
    outcome.record = record_;
    outcome.solves = matrix_.solves() - solves_before;
    return outcome;
}
//! [solve_island]

//! [rounds]
void IslandSolve::take_rounds()
{
    for (;; ++record_.rounds) {
        if (missing_ > small_imbalance)
            follow_elastic_forces();
        follow_motion();
        const ProblemSolution begin = unchanged(step_.problem);
        record_.residual = true_residual(step_.problem, begin.change, least_);
        if (follow_levers_when_near())
            continue;
        record_.converged = record_.residual <= settings_.tolerance ||
                            record_.residual <= rounding_residual(world_, step_, least_);
        if (record_.converged && (record_.rounds > 0 || has_new_pairs_))
            record_.newton_steps += take_own_impulses(world_, step_, matrix_, settings_.tolerance_of_laws);
        if (record_.converged && stiffen_where_pressed(world_, step_, settings_.stiffness))
            continue;
        if (record_.converged || steps_left() <= 0)
            break;
        solve_round(begin);
    }
}
//! [rounds]

void IslandSolve::follow_elastic_forces()
{
    before_move_ += velocities_of(world_, step_);
    missing_ = approach_ends(world_, island_, dt_);
    before_move_ -= velocities_of(world_, step_);
    if (follow_elements(world_, step_))
        matrix_.begin_response(matrix_.solves());
    mixing_ = AndersonMixing(mixed_);
}

/// Brings normals, limits of friction and the rows of elements to the last motion.
void IslandSolve::follow_motion()
{
    update_kinematics(world_, step_);
    follow_rolling(world_, settings_.friction, step_);
    if (has_elements_)
        settings_.elements.follow(world_, step_);
}

/// Levers of a motion that is far from the one to be found would lead astray. They follow even where no step
/// of Newton's method is left: a small residual by other levers than the motion's own says nothing, and would
/// let the step pass.
bool IslandSolve::follow_levers_when_near()
{
    const bool followed = record_.residual <= settings_.kept_residual &&
                          record_.rounds < settings_.max_newton_steps &&
                          follow_levers(world_, step_, settings_.lever_turn);
    if (followed)
        matrix_.begin_response(matrix_.solves());
    return followed;
}

//! [solve_round]
/// Solves the convex problem of the last motion's normals, levers and limits, and mixes its impulses with
/// those of the rounds before.
void IslandSolve::solve_round(const ProblemSolution& begin)
{
    const double of_round = residual_of(step_.problem, begin.change, least_),
                 sharp = std::max(settings_.tolerance_of_laws,
                                  settings_.left_by_round * std::min(record_.residual, of_round));
    const ProblemSolution solution =
        record_.rounds < settings_.rounds_before_search
            ? solve_convex(step_.problem, matrix_,
                           {std::exchange(before_move_, begin.change), begin.impulses}, sharp, least_,
                           std::min(steps_left(), max_convex_steps))
            : solve_with_limit_search(step_.problem, matrix_, begin, sharp, least_, steps_left());
    record_.newton_steps += solution.newton_steps;
    const Eigen::VectorXd next = mixing_.next(begin.impulses, solution.impulses);
    if (is_soft_)  // their elements feel what contact changes
        missing_ += changed_part(step_.problem, begin.impulses, next, least_);
    apply_impulses(world_, step_, next);
}
//! [solve_round]

//! [last_problem]
/// Where the rounds do not end: normals, levers and limits of friction stay those of the last motion, and
/// their convex problem is solved to its end. Its impulses belong to its motion, so they take energy only;
/// what errs is how much friction there is.
/// @return  whether it is solved
bool IslandSolve::solve_last_problem()
{
    const int most = std::min(settings_.max_newton_steps - matrix_.solves() - record_.rounds,
                              settings_.budget.of_last_problem);
    if (most <= 0)
        return false;
    const ProblemSolution solution = solve_convex(step_.problem, matrix_, unchanged(step_.problem),
                                                  settings_.left_by_round * settings_.kept_residual, least_,
                                                  most);
    record_.newton_steps += solution.newton_steps;
    apply_impulses(world_, step_, solution.impulses);
    update_kinematics(world_, step_);
    return solution.residual <= settings_.kept_residual;
}
//! [last_problem]

}  // namespace

IslandOutcome solve_island(World& world, const Island& island, const ImplicitSettings& settings,
                           NewtonMatrix& matrix, const Allowance& allowed, bool first, double dt)
{
    return IslandSolve(world, island, settings, matrix, allowed, first, dt).solve();
}

}  // namespace enduring
