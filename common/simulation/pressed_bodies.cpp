#include "common/simulation/pressed_bodies.hpp"

#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/step.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

PressedBodies& entry_of(std::vector<PressedBodies>& all, const Contact& contact)
{
    const bool with_plane = contact.on_plane();
    int a = contact.body_a, b = contact.body_b;
    if (!with_plane && b < a)
        std::swap(a, b);
    const auto known = std::find_if(all.begin(), all.end(), [&](const PressedBodies& entry) {
        return entry.a == a && entry.b == b && entry.with_plane == with_plane;
    });
    return known != all.end() ? *known : all.emplace_back(PressedBodies{a, b, with_plane});
}

void add(std::vector<PressedBodies>& all, const Contact& contact, double stiffness, double depth)
{
    PressedBodies& entry = entry_of(all, contact);
    ++entry.pairs;
    entry.stiffness += stiffness;
    entry.energy += 0.5 * stiffness * depth * depth;
}

double inverse_mass(const World& world, int body)
{
    const double mass = world.bodies[body]->mass();
    return mass > 0 ? 1 / mass : 0;
}

}  // namespace

std::vector<PressedBodies> pressed_bodies(const World& world, const Contacts& contacts, double stiffness)
{
    std::vector<PressedBodies> all;
    for (const Contact& contact : contacts) {
        const double depth = contact.is_spring() ? contact_geometry(world, contact, 1).depth : 0;
        if (depth < 0)
            add(all, contact, pair_stiffness(world, contact, stiffness), depth);
    }
    return all;
}

std::vector<PressedBodies> pushed_bodies(const World& world, const Contacts& contacts, double stiffness)
{
    std::vector<PressedBodies> all;
    for (const Contact& contact : contacts)
        if (!contact.impulse.isZero(0))
            add(all, contact, pair_stiffness(world, contact, stiffness), 0);
    return all;
}

std::string names_of(const World& world, const PressedBodies& pressed)
{
    const auto b = static_cast<std::size_t>(pressed.b);
    return "'" + world.bodies[pressed.a]->name() + "' and '" +
           (pressed.with_plane ? world.planes[b].name : world.bodies[b]->name()) + "'";
}

double stable_step(double inverse_mass, double stiffness, PenaltyMethod method)
{
    return std::sqrt(largest_stable_h(method) / (inverse_mass * stiffness));
}

double stable_step(const World& world, const PressedBodies& pressed, PenaltyMethod method)
{
    const double inverse = inverse_mass(world, pressed.a) +
                           (pressed.with_plane ? 0 : inverse_mass(world, pressed.b));
    return stable_step(inverse, pressed.stiffness, method);
}

}  // namespace enduring
