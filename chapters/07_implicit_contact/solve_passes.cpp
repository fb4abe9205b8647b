#include "chapters/07_implicit_contact/solve_passes.hpp"

#include "chapters/07_implicit_contact/elastic_ends.hpp"
#include "chapters/07_implicit_contact/restitution.hpp"

#include <memory>
#include <string>

namespace enduring {

ImplicitSettings settings_for(const ContactParameters& parameters, ImplicitSettings settings)
{
    settings.friction = coefficients_of(parameters.friction);
    if (parameters.wanted_depth)
        settings.stiffness.wanted_depth = parameters.wanted_depth;
    return settings;
}

//! [add_solve]
void add_solve(Solver& solver, const ImplicitSettings& settings)
{
    solver.max_halvings = max_halvings;
    solver.finds_stiffness = true;
    const std::string first = solver.passes(StepStage::refresh).front().name;
    solver.insert_before(first, "settle soft bodies",
                         [](World& world, Contacts&, double dt) { settle_soft_bodies(world, dt); });
    solver.append(StepStage::respond, "solve contacts",
                  [settings, matrices = std::make_shared<IslandMatrices>()](World& world, Contacts& contacts,
                                                                            double dt) {
                      solve_contacts(world, contacts, settings, *matrices, dt);
                  });
    solver.append(StepStage::finish, "remember pairs", remember_pairs);
    solver.append(StepStage::settle, "restitution",
                  [friction = settings.friction](World& world, Contacts& contacts, double dt) {
                      restitute(world, contacts, friction, dt);
                  });
}
//! [add_solve]

}  // namespace enduring
