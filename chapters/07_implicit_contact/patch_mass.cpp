#include "chapters/07_implicit_contact/patch_mass.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace enduring {
namespace {

/// Two bodies, in either order, or a body and a plane.
std::tuple<bool, int, int> patch_of(const Contact& contact)
{
    const bool on_plane = contact.kind == ContactKind::vertex_plane;
    const auto [low, high] = std::minmax(contact.body_a, contact.body_b);
    return {on_plane, on_plane ? contact.body_a : low, on_plane ? contact.body_b : high};
}

}  // namespace

//! [patch_masses]
std::vector<double> patch_masses(const StepProblem& step)
{
    const std::vector<PairRow>& rows = step.problem.rows;
    std::map<std::tuple<bool, int, int>, std::vector<std::size_t>> patches;
    for (std::size_t i = 0; i < rows.size(); ++i)
        patches[patch_of(*step.of_row[i])].push_back(i);
    std::vector<double> masses(rows.size());
    for (const auto& [bodies, members] : patches) {
        Eigen::VectorXd momentum = Eigen::VectorXd::Zero(step.problem.size);
        for (const std::size_t i : members)
            rows[i].add_impulse(rows[i].law.normal, momentum);
        const Eigen::VectorXd velocity = times_response(step.problem, momentum);
        for (const std::size_t i : members) {
            const Vec3& normal = rows[i].law.normal;
            const double alone = normal.dot(rows[i].response(step.problem.blocks) * normal),
                         together = normal.dot(rows[i].rate_of(velocity));
            masses[i] = 1 / std::max(alone, together);
        }
    }
    return masses;
}
//! [patch_masses]

void aim_at_wanted_depth(const World& world, StepProblem& step, const StiffnessChoice& choice,
                         double most_load, bool first)
{
    const double dt = step.problem.step.dt, gravity = world.gravity.norm();
    const std::vector<double> masses = patch_masses(step);
    for (std::size_t i = 0; i < masses.size(); ++i) {
        PairLaw& law = step.problem.rows[i].law;
        Contact& contact = *step.of_row[i];
        StiffnessChoice own = choice.of_pair(natural_units(world, contact, dt));
        if (gravity > 0)
            own.of_its_mass = gravity * dt * dt / own.depth();
        if (first || contact.stiffness == 0)
            adapt_stiffness(contact, law.depth_t0 + contact.slack, masses[i], own, dt, most_load);
        law.stiffness = contact.stiffness;
        law.stretch = contact.stretch;
    }
}

}  // namespace enduring
