#include "chapters/motivating_scenes/readings.hpp"

#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "chapters/motivating_scenes/self_crossings.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/joint.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::motivating {
namespace {

int index_of(const World& world, const std::string& name)
{
    const auto found = std::find_if(world.bodies.begin(), world.bodies.end(),
                                    [&](const auto& body) { return body->name() == name; });
    return static_cast<int>(found - world.bodies.begin());
}

}  // namespace

void below_ground(Value& value, const World& world, const Contacts&, double)
{
    value.reset();
    for (const auto& body : world.bodies)
        for (const Vec3& x : body->positions_t0())
            value = std::max(value.value_or(-1e9), -1000 * x.y());
}

void max_pairs(Value& value, const World&, const Contacts& contacts, double)
{
    const auto pairs = std::count_if(contacts.begin(), contacts.end(),
                                     [](const Contact& contact) { return !contact.on_plane(); });
    value = std::max(value.value_or(0), static_cast<double>(pairs));
}

Gauge::Reading height_of(const std::string& body)
{
    return [body](Value& value, const World& world, const Contacts&, double) {
        value = body_named(world, body).centre().y();
    };
}

Gauge::Reading height_after_being_held(const std::string& body, double above, double until)
{
    return [body, above, until, fell = false](Value& value, const World& world, const Contacts&,
                                              double) mutable {
        const double height = body_named(world, body).centre().y();
        fell = fell || (world.time <= until && height < above);
        value = fell ? Value() : Value(height);
    };
}

Gauge::Reading right_labels()
{
    return [right = 0L, all = 0L](Value& value, const World& world, const Contacts& contacts,
                                  double) mutable {
        for (const Contact& contact : contacts) {
            if (contact.on_plane() || !contact.answered())
                continue;
            const bool sideways = std::abs(contact_geometry(world, contact, 0).normal.y()) < std::sqrt(0.5);
            right += contact.category == (sideways ? ContactCategory::hooked : ContactCategory::regular);
            ++all;
        }
        if (all > 0)
            value = 100.0 * static_cast<double>(right) / static_cast<double>(all);
    };
}

void longest_of_levers(Value& value, const World& world, const Contacts& contacts, double)
{
    if (const Value lever = longest_lever(world, contacts))
        value = std::max(value.value_or(0), 1000 * *lever);
}

Gauge::Reading deepest_unpushed(const std::string& of, const std::string& in)
{
    return [of, in](Value& value, const World& world, const Contacts& contacts, double) {
        const double depth = deepest_without_pair(world, contacts, index_of(world, of), index_of(world, in));
        value = std::max(value.value_or(0), 1000 * depth);
    };
}

Gauge::Reading speed_on_floor(const std::string& body)
{
    return [body](Value& value, const World& world, const Contacts&, double) {
        value.reset();
        if (body_named(world, body).centre().y() > 0)
            value = body_named(world, body).mean_velocity().x();
    };
}

Gauge::Reading energy_after_bounce(const std::string& body)
{
    return [body, before = 0.0](Value& value, const World& world, const Contacts&, double) mutable {
        const Body& mover = body_named(world, body);
        if (world.step == 0)
            before = mover.energy(world.gravity).kinetic;
        value.reset();
        if (mover.mean_velocity().x() < 0)
            value = mover.energy(world.gravity).kinetic / before;
    };
}

Gauge::Reading drift_after(const std::string& body, double time)
{
    return [body, time, place = Vec3(0, 0, 0)](Value& value, const World& world, const Contacts&,
                                               double) mutable {
        const Vec3 middle = body_named(world, body).centre();
        if (world.time <= time)
            place = middle;
        value = 1000 * (middle - place).norm();
    };
}

Gauge::Reading error_of_way(const std::string& body, double exact)
{
    return [body, exact, start = Vec3(0, 0, 0)](Value& value, const World& world, const Contacts&,
                                                double) mutable {
        const Body& block = body_named(world, body);
        if (world.step == 0)
            start = block.centre();
        value.reset();
        if (block.linear_momentum().norm() / block.mass() < 0.001)
            value = 100 * std::abs((block.centre() - start).norm() / exact - 1);
    };
}

Gauge::Reading highest_over_floor(const std::string& body)
{
    return [body, highest = -1e9](Value& value, const World& world, const Contacts&, double) mutable {
        double lowest = 1e9;
        for (const Vec3& x : body_named(world, body).positions_t0())
            lowest = std::min(lowest, 1000 * x.y());
        highest = std::max(highest, lowest);
        value = lowest < -10 ? Value() : Value(std::max(0.0, highest));
    };
}

Gauge::Reading energy_gained_after(double time, const std::string& last, double lowest_height)
{
    return [=, before = 0.0, most = 0.0](Value& value, const World& world, const Contacts&, double) mutable {
        const double energy = total_energy(world).total();
        before = world.time <= time ? energy : before;
        most = std::max(most, energy - before);
        value = body_named(world, last).centre().y() < lowest_height ? Value() : Value(most);
    };
}

Gauge::Reading energy_if_above(const std::string& body)
{
    return [body, before = 0.0](Value& value, const World& world, const Contacts&, double) mutable {
        const double energy = body_named(world, body).energy(world.gravity).kinetic;
        before = world.step == 0 ? energy : before;
        value = body_named(world, body).centre().y() < 0 ? Value() : Value(energy / before);
    };
}

void gap_of_joints(Value& value, const World& world, const Contacts&, double)
{
    for (const Joint& joint : world.joints) {
        const JointPose pose = committed_pose(world, joint);
        value = std::max(value.value_or(0), 1000 * (pose.point_a - pose.point_b).norm());
    }
}

Gauge::Reading edges_through(const std::string& body, double apart, double standing)
{
    return [=, most = 0, first = std::vector<Vec3>()](Value& value, const World& world, const Contacts&,
                                                      double) mutable {
        const Body& folded = body_named(world, body);
        const auto places = folded.positions_t0();
        if (world.step == 0)
            first.assign(places.begin(), places.end());
        most = std::max(most, self_crossings(folded, first, apart, 0.001));
        const bool stands = std::any_of(places.begin(), places.end(),
                                        [&](const Vec3& x) { return x.y() > standing; });
        value = stands ? Value() : Value(most);
    };
}

}  // namespace enduring::motivating
