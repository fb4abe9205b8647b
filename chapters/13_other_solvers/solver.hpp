#pragma once

#include "chapters/13_other_solvers/avbd.hpp"
#include "chapters/13_other_solvers/barrier.hpp"
#include "chapters/13_other_solvers/convex_relaxation.hpp"
#include "chapters/13_other_solvers/sequential_impulses.hpp"
#include "chapters/13_other_solvers/soft_step.hpp"
#include "chapters/13_other_solvers/xpbd.hpp"

#include <string>
#include <vector>

namespace enduring {

/// A method of this chapter by its name.
struct OtherMethod {
    std::string name;                                      ///< a word: "sequential"
    std::string title;                                     ///< as a table has it
    std::function<Solver(const ContactParameters&)> make;  ///< with its paper's defaults
    std::function<Solver(const ContactParameters&, int)>
        make_with;                   ///< with so many iterations, substeps or steps
    bool knows_restitution = false;  ///< of a scene
};

/// All of them, in the chapter's order.
const std::vector<OtherMethod>& other_methods();

/// One by its name. @throws InputError  there is none; names those there are
Solver chapter13_solver(const std::string& method, const ContactParameters& parameters);

}  // namespace enduring
