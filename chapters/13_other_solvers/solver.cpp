#include "chapters/13_other_solvers/solver.hpp"

#include "common/input/input_error.hpp"

#include <algorithm>

namespace enduring {

const std::vector<OtherMethod>& other_methods()
{
    using P = ContactParameters;
    static const std::vector<OtherMethod> methods{
        {"sequential", "sequential impulses", [](const P& p) { return chapter13_sequential_solver(p); },
         [](const P& p, int n) { return chapter13_sequential_solver(p, {.iterations = n}); }, true},
        {"soft_step", "soft step", [](const P& p) { return chapter13_soft_step_solver(p); },
         [](const P& p, int n) { return chapter13_soft_step_solver(p, {.substeps = n}); }, true},
        {"relaxation", "convex relaxation", [](const P& p) { return chapter13_relaxation_solver(p); },
         [](const P& p, int n) { return chapter13_relaxation_solver(p, {.max_steps = n}); }, false},
        {"xpbd", "XPBD", [](const P& p) { return chapter13_xpbd_solver(p); },
         [](const P& p, int n) { return chapter13_xpbd_solver(p, {.substeps = n}); }, true},
        {"avbd", "AVBD", [](const P& p) { return chapter13_avbd_solver(p); },
         [](const P& p, int n) { return chapter13_avbd_solver(p, {.iterations = n}); }, false},
        {"barrier", "barrier", [](const P& p) { return chapter13_barrier_solver(p); },
         [](const P& p, int n) { return chapter13_barrier_solver(p, {.max_steps = n, .max_halvings = 0}); },
         false},
    };
    return methods;
}

Solver chapter13_solver(const std::string& method, const ContactParameters& parameters)
{
    std::string names;
    for (const OtherMethod& one : other_methods()) {
        if (one.name == method)
            return one.make(parameters);
        names += (names.empty() ? "" : ", ") + one.name;
    }
    throw InputError("no method '" + method + "'; there are " + names);
}

}  // namespace enduring
