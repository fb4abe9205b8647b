#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

#include <filesystem>
#include <functional>

namespace enduring {

/// The problem that rigid contact sets in a step, where normals and levers are those of the prediction
/// without contact. The coordinates are the changes of the velocities of all bodies that a pair moves, so f =
/// 0; w is the velocity of each contact, with its gap over dt more along the normal: nothing may be inside at
/// the end of the step but for what lets a pair out. A contact's numbers are along its normal and two
/// directions of its surface.
/// @param contacts  before they are solved; they are copied
FrictionProblem problem_of_step(const World& world, const Contacts& contacts,
                                const FrictionCoefficients& friction, double dt);

/// Three rows: a normal and two directions at right angles to it.
Mat3 contact_frame(const Vec3& normal);

/// Siconos' text, sparse: what parse_siconos() reads, and Siconos.
std::string siconos_text(const FrictionProblem& problem);

/// Impulses as a NAME.answer holds them: a number a line.
std::string answer_text(const Eigen::VectorXd& impulses);

/// Chapter 11's solver, which hands on the problem of each step in which something is near. Of a step that is
/// taken in halves it is the last part.
/// @param take  is given the number of the step, from 1 on
void take_problems(Solver& solver, const ContactParameters& parameters,
                   std::function<void(int step, const FrictionProblem&)> take);

/// What a written problem is: Siconos' text, or FCLIB's HDF5.
enum class ProblemForm { siconos, fclib };

/// Chapter 11's solver, which writes the problem of each step into a folder, with its answer: step_000001.dat
/// and step_000001.answer and so on, or step_000001.hdf5 with both. What has no answer to 1e-8 is told, and
/// written without.
/// @throws InputError  a file cannot be written; HDF5 where the program was built without it
void write_problems(Solver& solver, const ContactParameters& parameters, const std::filesystem::path& folder,
                    ProblemForm form = ProblemForm::siconos);

}  // namespace enduring
