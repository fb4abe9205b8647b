#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"

#include <filesystem>
#include <string>

namespace enduring {

/// A problem from a file: FCLIB's HDF5 or Siconos' text, told apart by how it begins.
/// @throws InputError  names the file and the place of the mistake
FrictionProblem read_problem(const std::filesystem::path& file);

/// Siconos' text: dimension, number of contacts, W, q and mu; or, where a second matrix follows the first, M,
/// H, f, w and mu.
/// @param text  the contents
/// @param file  named in messages
FrictionProblem parse_siconos(const std::string& text, const std::filesystem::path& file);

/// FCLIB's HDF5. Equations of bodies or contacts that hold in both directions (its G, V, R) are refused.
/// @throws InputError  also where the program was built without libhdf5
FrictionProblem read_fclib(const std::filesystem::path& file);

/// Whether this program was built with libhdf5: else the functions beside this one only complain.
bool knows_fclib();

/// A file that FCLIB's own functions read. With impulses it holds an answer, too: FCLIB's solution v, u and
/// r.
/// @param impulses  r, or nothing
/// @throws InputError  also where the program was built without libhdf5
void write_fclib(const FrictionProblem& problem, const std::filesystem::path& file,
                 const Eigen::VectorXd& impulses = {});

}  // namespace enduring
