#include "chapters/07_implicit_contact/pressing_mass.hpp"

#include <algorithm>

namespace enduring {

//! [pressing_masses]
std::vector<double> pressing_masses(const World& world, const StepProblem& step)
{
    const std::vector<PairRow>& rows = step.problem.rows;
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(step.problem.size);
    for (const PairRow& row : rows)
        row.add_impulse(row.acting, momentum);
    const Eigen::VectorXd change = times_response(step.problem, momentum);
    double approach = world.gravity.norm() * step.problem.step.dt;  // what rests approaches with this
    for (const PairRow& row : rows)
        approach = std::max(approach, row.law.normal.dot(row.rate_of(change) - row.velocity));
    std::vector<double> masses;
    masses.reserve(rows.size());
    for (const PairRow& row : rows)
        masses.push_back(approach > 0 ? row.law.normal.dot(row.acting) / approach : 0);
    return masses;
}
//! [pressing_masses]

//! [stiffen_where_pressed]
bool stiffen_where_pressed(const World& world, StepProblem& step, const StiffnessChoice& choice)
{
    const double dt = step.problem.step.dt;
    const std::vector<double> masses = pressing_masses(world, step);
    bool any = false;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        Contact& contact = *step.of_row[i];
        PairLaw& law = step.problem.rows[i].law;
        const double load = law.normal.dot(step.problem.rows[i].acting) / dt;
        const double depth = choice.of_pair(natural_units(world, contact, dt)).depth();
        const double wanted = std::min(choice.k_dt2_over_m * masses[i] / (dt * dt), load / depth);
        if (wanted < choice.at_once * contact.stiffness)
            continue;
        const double most = choice.max_k_dt2_over_m * mass_of(step.problem.rows[i], step.problem) / (dt * dt);
        if (most < choice.at_once * contact.stiffness)
            continue;
        stiffen(contact, depth_at_start(world, contact), std::min(wanted, most));
        law.stiffness = contact.stiffness;
        law.stretch = contact.stretch;
        any = true;
    }
    return any;
}
//! [stiffen_where_pressed]

}  // namespace enduring
