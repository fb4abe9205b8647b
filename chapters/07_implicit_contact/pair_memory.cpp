#include "chapters/07_implicit_contact/pair_memory.hpp"

#include "chapters/04_friction/surface_turn.hpp"
#include "chapters/07_implicit_contact/restitution.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

/// The largest stiffness that a pair may be given [N/m]: pressed as it is, its spring then holds no more than
/// others can bring. What presses harder comes from what cannot give way. No stiffness makes that less deep,
/// and each would ask for more.
double most_stiffness(const PairMemory& spring, double depth_t0, double max_load)
{
    const double pressed = spring.rest_offset - depth_t0;
    return pressed > 0 ? std::max(spring.stiffness, max_load / pressed)
                       : std::numeric_limits<double>::infinity();
}

}  // namespace

StiffnessChoice StiffnessChoice::of_pair(const NaturalUnits& units) const
{
    StiffnessChoice own = *this;
    own.wanted_depth = depth(units.length);
    own.max_depenetration_velocity = fading_speed(units.speed);
    return own;
}

double wanted_stiffness(double mass, double load, const StiffnessChoice& choice, double dt)
{
    const double own = mass / (dt * dt);
    return std::min(std::max(choice.k_dt2_over_m * own, load / choice.depth()),
                    choice.max_k_dt2_over_m * own);
}

//! [stiffen]
void stiffen(PairMemory& spring, double depth_t0, double stiffness)
{
    const double before = std::exchange(spring.stiffness, stiffness),
                 compressed = depth_t0 - spring.rest_offset;
    if (compressed < 0) {
        spring.rest_offset = depth_t0 - compressed * before / stiffness;
        spring.stretch *= before / stiffness;
    }
}
//! [stiffen]

//! [adapt_stiffness]
void adapt_stiffness(Contact& contact, double depth_t0, double mass, const StiffnessChoice& choice, double dt,
                     double max_load)
{
    PairMemory& spring = contact.spring;
    const double asked = wanted_stiffness(mass, spring.load, choice, dt);
    if (spring.stiffness == 0) {
        spring.stiffness = asked;
        spring.rest_offset = std::min(0.0, depth_t0);
        return;
    }
    const double wanted = std::min(asked, most_stiffness(spring, depth_t0, max_load));
    const bool carries_its_load = spring.stiffness * (spring.rest_offset - depth_t0) <=
                                  choice.at_once * spring.load;  // else it is wound up, and would throw
    if (wanted > spring.stiffness || (choice.at_once * wanted < spring.stiffness && carries_its_load))
        stiffen(spring, depth_t0, wanted);
    // What pushes more than others can bring upon it does not move out, and is not wound up. Its load is that
    // of impulses that moved something; a push that another one cancels is seen in its spring.
    const double compressed = spring.rest_offset - depth_t0 - choice.depth();
    if (spring.rest_offset < 0 && std::max(spring.load, spring.stiffness * compressed) <= max_load)
        spring.rest_offset = std::min(choice.keep * spring.rest_offset,
                                      spring.rest_offset + contact.outward * choice.fading_speed() * dt);
}
//! [adapt_stiffness]

//! [pressing_masses]
std::vector<double> pressing_masses(const World& world, const StepProblem& step)
{
    const std::vector<PairRow>& rows = step.problem.rows;
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(step.problem.size);
    for (const PairRow& row : rows)
        row.add_impulse(row.acting, momentum);
    const Eigen::VectorXd change = times_response(step.problem, momentum);
    double approach = world.gravity.norm() * step.problem.step.dt;  // what rests approaches with this
    const std::span pairs = step.pair_rows();
    for (const PairRow& row : pairs)
        approach = std::max(approach, row.law.normal.dot(row.rate_of(change) - row.velocity));
    std::vector<double> masses;
    masses.reserve(pairs.size());
    for (const PairRow& row : pairs)
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
        const double load = std::min(law.normal.dot(step.problem.rows[i].acting) / dt, step.max_load);
        const double depth = choice.of_pair(natural_units(world, contact, dt)).depth();
        const double wanted = std::min(choice.k_dt2_over_m * masses[i] / (dt * dt), load / depth);
        if (wanted < choice.at_once * contact.spring.stiffness)
            continue;
        const double depth_t0 = depth_at_start(world, contact);
        const double stiffness =
            std::min({wanted, choice.max_k_dt2_over_m * mass_along(law.normal, step.responses[i]) / (dt * dt),
                      most_stiffness(contact.spring, depth_t0, step.max_load)});
        if (stiffness < choice.at_once * contact.spring.stiffness)
            continue;
        const double before = contact.spring.stiffness;
        stiffen(contact.spring, depth_t0, stiffness);
        law.stiffness = contact.spring.stiffness;
        law.stretch = law.viscous > 0 ? Vec3(before / stiffness * law.stretch) : contact.spring.stretch;
        any = true;
    }
    return any;
}
//! [stiffen_where_pressed]

//! [remember_pairs]
namespace {

/// Whether its surfaces were apart at the start of the step or just touched, or its spring began where they
/// were, and carried nothing. What pressed then rests, or is an impact of an earlier step.
bool was_open(const World& world, const Contact& contact)
{
    const double least = restitution_limits.least_length * natural_length(world, contact);
    return contact.spring.load <= contact.spring.stiffness * least &&
           depth_at_start(world, contact) - std::min(0.0, contact.spring.rest_offset) > -least;
}

/// A spring that is shorter than its pair's load says gets the length of this load. Where the pair is solved,
/// both agree but for rounding.
void take_given_length(const World& world, Contact& contact)
{
    const double given = contact_geometry(world, contact, 1).depth +
                         contact.spring.load / contact.spring.stiffness;
    if (contact.spring.rest_offset - given > restitution_limits.least_length * natural_length(world, contact))
        contact.spring.rest_offset = given;
}

}  // namespace

void remember_pairs(const World& world, Contacts& contacts, double dt)
{
    for (Contact& contact : contacts) {
        PairMemory& spring = contact.spring;
        contact.began_open = was_open(world, contact);
        if (contact.held()) {  // its spring lets go: where the pair pushes again, it begins as a new one does
            spring.stiffness = 0;
            spring.stretch.setZero();
            continue;
        }
        spring.load = contact.impulse.norm() / dt;
        spring.stretch = spring.stiffness > 0 ? Vec3(contact.friction / (-spring.stiffness * dt))
                                              : Vec3(Vec3::Zero());
        spring.stretch = surface_turn(world, contact) * spring.stretch;
        if (world.attempt.work.unsolved > 0 && spring.stiffness > 0)  // what is not solved presses no spring
            take_given_length(world, contact);
    }
}
//! [remember_pairs]

}  // namespace enduring
