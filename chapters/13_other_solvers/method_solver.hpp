#pragma once

#include "chapters/13_other_solvers/method_step.hpp"
#include "chapters/13_other_solvers/settings.hpp"
#include "common/simulation/contact_parameters.hpp"

#include <functional>
#include <string>

namespace enduring {

/// A method: from the start of the step to poses and velocities at its end, and the impulse of each point.
using StepMethod = std::function<void(MethodStep&)>;
/// The pairs of a step, ascending by their keys, with Contact::normal_t0.
using PairSearch = std::function<Contacts(World&)>;

/// What a method can move beside rigid bodies.
enum class SoftBodies : std::uint8_t {
    refused,    ///< no paper of the method has them
    corotated,  ///< with the corotated law, whose energy is a square of strains
    any_law     ///< with every law of the base
};

//! [method_solver]
/// A solver that is this method on the common search, from an empty list of passes: pairs, the method, and
/// behind the commit the velocities where they are not the way of the step over dt. It keeps the trees and
/// impulses of one world, so make one for each run.
/// @throws InputError  when it runs: a body is held, pinned or driven, or soft in a way that the method has
///     not; names it
Solver method_solver(const std::string& name, const ContactParameters& parameters, StepMethod method,
                     SoftBodies soft = SoftBodies::refused, const SearchSettings& search = {});
/// The same with a search of its own.
Solver method_solver(const std::string& name, const ContactParameters& parameters, StepMethod method,
                     SoftBodies soft, PairSearch search);
//! [method_solver]

}  // namespace enduring
