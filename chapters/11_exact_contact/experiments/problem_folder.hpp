#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace enduring::chapter11 {

struct NamedProblem {
    std::string name;  ///< of its file
    FrictionProblem problem;
};

/// A file that is no problem, or one that is not solved here.
struct RefusedFile {
    std::string name, reason;
};

struct ProblemFolder {
    std::vector<NamedProblem> problems;  ///< by name
    std::vector<RefusedFile> refused;    ///< by name
};

/// The public problems that lie beside the chapter, and our own.
std::filesystem::path public_problems();
std::filesystem::path own_problems();

/// All files of a folder that end in .dat or .hdf5.
/// @throws InputError  the folder cannot be read
ProblemFolder read_problems(const std::filesystem::path& folder);

}  // namespace enduring::chapter11
