#include "chapters/06_redefinition/experiments/chapter_solver.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/input/input_error.hpp"

namespace enduring::chapter06 {

Solver chapter_solver(int chapter, const ContactParameters& parameters)
{
    switch (chapter) {
    case 1: return chapter01_solver(parameters);
    case 3: return chapter03_solver(parameters);
    case 4: return chapter04_solver(parameters);
    case 5: return chapter05_solver(parameters);
    case 6: return chapter06_solver(parameters);
    default: throw InputError("chapter " + std::to_string(chapter) + " has no solver of its own; 1, 3, 4, 5 and 6 have");
    }
}

}  // namespace enduring::chapter06
