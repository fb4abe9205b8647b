#include "chapters/solvers/chapter_solver.hpp"

#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/02_collision_detection/solver.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/04_friction/solver.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "chapters/12_joints/solver.hpp"
#include "common/input/input_error.hpp"

namespace enduring::solvers {
Solver chapter_solver(int chapter, const ContactParameters& parameters, const ImplicitSettings& settings)
{
    switch (chapter) {
        case 1: return chapter01_solver(parameters);
        case 2: return chapter02_solver(parameters);
        case 3: return chapter03_solver(parameters);
        case 4: return chapter04_solver(parameters);
        case 5: return chapter05_solver(parameters);
        case 6: return chapter06_solver(parameters);
        case 7: return chapter07_solver(parameters, settings);
        case 8: return chapter08_solver(parameters, settings);
        case 9: return chapter09_solver(parameters, settings);
        case 10: return chapter10_solver(parameters, settings);
        case 11: return chapter11_solver(parameters, settings);
        case 12: return chapter12_solver(parameters, settings);
        default:
            throw InputError("chapter " + std::to_string(chapter) + " has no solver; 1 to " +
                             std::to_string(last_chapter) + " have");
    }
}

}  // namespace enduring::solvers
