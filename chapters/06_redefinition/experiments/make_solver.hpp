#pragma once

#include "chapters/06_redefinition/solver.hpp"

#include <functional>

namespace enduring::chapter06 {

/// A chapter's solver as a function, for experiments that later chapters repeat with theirs.
using MakeSolver = std::function<Solver(const ContactParameters&)>;

}  // namespace enduring::chapter06
