#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/07_implicit_contact/islands.hpp"
#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

#include <limits>
#include <optional>
#include <span>

namespace enduring {

/// The problem of one island in a step, and where it comes from. Masses are those of the step, levers those
/// that its bodies have (follow_levers()); the rest of its rows follows the prediction.
struct StepProblem {
    ContactProblem problem;        ///< with a block for each body, an empty one if it has no coordinates
    std::vector<Contact*> of_row;  ///< the contact of each row
    std::vector<Mat3> responses;   ///< PairRow::response() of each row
    std::vector<int> elements{};   ///< the island's, by number; their rows stand behind those of pairs
    std::vector<int> bodies{};     ///< the island's
    std::vector<std::vector<int>> vertices{};  ///< of each of these, those in touch
    std::vector<std::vector<int>>
        nodes{};  ///< where it enters with all its nodes, those of its vertices in touch; -1 where held
    double max_load = std::numeric_limits<double>::infinity();  ///< of the island, see max_load() [N]

    std::span<const PairRow> pair_rows() const { return std::span(problem.rows).first(of_row.size()); }
};

/// Sets up an island; its enduring and new pairs get their stiffness for the step.
/// @param first  the step's first problem: enduring pairs get their stiffness once a step
/// @param sparse_operation  see ImplicitSettings; by default no body enters with all its nodes
StepProblem set_up(const World& world, const Island& island, const StiffnessChoice& choice,
                   const FrictionCoefficients& friction, const StepLaw& step, bool first,
                   double sparse_operation = std::numeric_limits<double>::infinity());

/// How a vertex in touch, or that an element reads, moves with the coordinates of all.
/// @param tau  moment of the step whose lever counts
/// @return     none where nothing moves it: on a body without coordinates, and at a held node of one with all
///     its nodes
std::optional<VertexMotion> motion_of_vertex(const World& world, const StepProblem& step, int body,
                                             int vertex, double tau);

/// Appends a row of an element, which acts already with this impulse.
/// @param parts  the motion of each body that moves, by first_coordinate() or motion_of_vertex(); six at most
void add_element_row(StepProblem& step, ElementLaw law, std::span<const VertexMotion> parts,
                     const Vec3& acting);

/// Where a body stands among those of the problem; none for one that is not in the island.
std::optional<std::size_t> place_of(const StepProblem& step, int body);

/// Where a body's coordinates begin among those of all; -1 for a body that is not in the island or has none.
int first_coordinate(const StepProblem& step, int body);

/// Depth of a pair at the moment from which it pushes in this step (Contact::start) [m]: what lies behind a
/// plane before, and beyond its feature, is not inside.
double depth_at_start(const World& world, const Contact& contact);

/// The mass that a pair feels along its normal: 1 / (n . W n), with W the change of its velocity per impulse;
/// 0 for one that nothing moves [kg].
double mass_along(const Vec3& normal, const Mat3& response);

/// What can be brought upon a pair of an island [N]: the weight of its bodies, forces and torques from
/// outside and what elements push, all with a lever as a wedge has it; what stops their motion in this step;
/// and what brings them to the speed of a drive in a whole step. What presses harder than this comes from the
/// pairs themselves.
double max_load(const World& world, const Island& island, double dt);

/// A pair's normal where its force acts; zero where its features have none.
Vec3 normal_of(const PairStep& step, double tau);

/// Sets a row to where the bodies move now: normal, depth, velocity, and what acts.
void update_row(const World& world, const Contact& contact, const StepLaw& step, PairRow& row);

/// Brings the levers of all rows to the motion found, where a body has turned from them by more than this
/// [rad]: an impact with friction turns a body within the step. What acts turns its bodies by the new levers.
/// @return  whether it did: then the prediction is another one, and what was factored does not hold
bool follow_levers(World& world, StepProblem& step, double least_turn);

/// Brings normals, velocities and acting impulses of all rows to the present prediction. Friction's limits
/// are taken from the normal impulses that act, not from what the pairs answer to the motion: this enlarges
/// an error of the motion by h.
void update_kinematics(const World& world, StepProblem& step);

/// The impulses of all pairs in the last step, three numbers each [N s]: at rest they are the answer.
Eigen::VectorXd last_impulses(const World& world, const StepProblem& step);

/// Velocities of the coordinates: behind the commit those of the state, before it those that are predicted.
Eigen::VectorXd velocities_of(const World& world, const StepProblem& step);

/// The momentum of all pairs' impulses, by the levers of this problem.
Eigen::VectorXd momentum_of(const StepProblem& step);

/// Gives each pair this impulse, and brings the difference to the bodies and their prediction.
void apply_impulses(World& world, StepProblem& step, const Eigen::VectorXd& impulses);

/// Behind the commit of a step of dt: brings a momentum of the coordinates to the bodies; nothing moves.
void kick(World& world, const StepProblem& step, const Eigen::VectorXd& momentum);

/// Which pairs slip, and how fast.
void find_slip(StepProblem& step);

}  // namespace enduring
