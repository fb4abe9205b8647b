#include "common/experiments/run/energy_budget.hpp"

#include "common/input/number_text.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/natural_units.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace enduring {
namespace {

// of what was put in: pairs are born and die at a depth, each with its spring's energy
constexpr double tolerated_gain = 0.1;

/// A scene at rest has put in next to nothing, and its bodies still tremble. A stable contact lets no body
/// rest less than about g dt^2 deep, so m (g dt)^2 is what gravity itself puts in there; and no one counts a
/// body that trembles by a hundred millionth of its size in a step, not without weight either.
double slack_of(const Scene& scene)
{
    const double fall = scene.dt * scene.world.gravity.norm();
    double sum = 0;
    for (const auto& body : scene.world.bodies) {
        const double trembling = scale_parts.trembling * body->size() / scene.dt;
        sum += body->mass() * (fall * fall + trembling * trembling);
    }
    return sum;
}

double mean_of(const std::array<double, 10>& numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

const Body& fastest_body(const World& world)
{
    const auto kinetic = [&](const auto& body) { return body->energy(world.gravity).kinetic; };
    return **std::max_element(
        world.bodies.begin(), world.bodies.end(),
        [&](const auto& one, const auto& other) { return kinetic(one) < kinetic(other); });
}

}  // namespace

EnergyBudget::EnergyBudget(const Scene& scene, const Contacts& contacts)
    : dt_(scene.dt), slack_(slack_of(scene)), parameters_(scene.contact),
      springs_(scene.world, scene.contact.stiffness, scene.contact.max_depenetration_velocity)
{
    const Energy energy = total_energy(scene.world);
    start_ = energy.total() + spring_energy(contacts);
    lowest_ = energy.gravitational;
    last_held_.fill(start_ - lowest_);
    driven_at_start_ = driven_so_far_ = scene.world.driven;
}

// The positions of symplectic Euler are half a step ahead of its velocities, so what a swing holds seems to
// swing itself, by half the root of h: a single step proves nothing.
double EnergyBudget::held() const { return mean_of(last_held_); }

double EnergyBudget::driven() const { return mean_of(last_driven_); }

//! [exceeded]
std::optional<std::string> EnergyBudget::exceeded(const World& world, const Contacts& contacts)
{
    springs_.add_step(world, contacts, dt_);
    if (world.step == 1)
        start_ += springs_.accounts().born;  // pressed before anything had moved
    const Energy energy = total_energy(world);
    lowest_ = std::min(lowest_, energy.gravitational);
    const std::size_t now = static_cast<std::size_t>(world.step) % last_held_.size();
    driven_both_ways_ += std::abs(world.driven - std::exchange(driven_so_far_, world.driven));
    last_driven_[now] = world.driven - driven_at_start_;
    last_held_[now] = energy.total() - lowest_ + springs_.held() +
                      friction_spring_energy(contacts, parameters_.friction);
    watch_springs(world, contacts);
    if (held() <= added_energy() + tolerated_gain * (added_energy() - driven() + driven_both_ways_) + slack_)
        return std::nullopt;
    return explanation(world);
}
//! [exceeded]

void EnergyBudget::watch_springs(const World& world, const Contacts& contacts)
{
    finds_stiffness_ = std::any_of(contacts.begin(), contacts.end(),
                                   [](const Contact& contact) { return contact.spring.stiffness > 0; });
    for (const PressedBodies& bodies : pushed_bodies(world, contacts, parameters_.stiffness)) {
        const double step = stable_step(world, bodies, parameters_.method);
        if (!least_stable_ || step < least_stable_->stable_step)
            least_stable_ = {bodies, step, world.step};
    }
}

std::string EnergyBudget::explanation(const World& world) const
{
    const Body& fastest = fastest_body(world);
    std::string text = "step " + std::to_string(world.step) + ", time " + readable(world.time, 4) +
                       " s: energy out of nothing: bodies and springs hold " + readable(held(), 3) +
                       " J, but only " + readable(added_energy(), 3) +
                       " J came from the start and from gravity" +
                       (lifted() > 0 ? ", from overlaps that separate" : "") +
                       (driven_both_ways_ > 0 ? ", from driven bodies" : "") + "; '" + fastest.name() +
                       "' moves with " + readable(fastest.energy(world.gravity).kinetic, 3) + " J. ";
    if (finds_stiffness_)
        return text +
               "The solver finds the stiffness of its pairs, so neither the scene's stiffness nor dt is the reason. "
               "Look for an unsolved step before this one, and for bodies that jam '" +
               fastest.name() + "' or in which it began.";
    if (!least_stable_)
        return text + "No pair had pushed.";
    text += "The stiffest springs for their masses were those of " + names_of(world, least_stable_->bodies) +
            " in step " + std::to_string(least_stable_->step) + ": " +
            std::to_string(least_stable_->bodies.pairs) +
            " pairs, n k = " + readable(least_stable_->bodies.stiffness, 3) +
            " N/m, stable up to dt = " + readable(least_stable_->stable_step, 3) + " s, where dt is " +
            readable(dt_, 3) + " s. ";
    if (least_stable_->stable_step < dt_)
        return text + "Make dt shorter, the stiffness smaller, or the bodies heavier.";
    return text +
           "As whole bodies they could bear this step: look for bodies that overlap at the start and for light vertices of a soft body "
           "(\"impulse_response\": \"implicit\"), or make dt shorter or the stiffness smaller.";
}

}  // namespace enduring
