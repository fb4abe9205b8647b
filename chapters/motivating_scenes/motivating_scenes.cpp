#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "chapters/motivating_scenes/motivating_scene.hpp"
#include "chapters/motivating_scenes/self_crossings.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::motivating {
namespace {

using Value = std::optional<double>;

constexpr double pi = std::numbers::pi;

int index_of(const World& world, const std::string& name)
{
    const auto found = std::find_if(world.bodies.begin(), world.bodies.end(),
                                    [&](const auto& body) { return body->name() == name; });
    return static_cast<int>(found - world.bodies.begin());
}

/// How far the lowest vertex of all bodies is below the ground at the end [mm].
void below_ground(Value& value, const World& world, const Contacts&, double)
{
    value.reset();
    for (const auto& body : world.bodies)
        for (const Vec3& x : body->positions_t0())
            value = std::max(value.value_or(-1e9), -1000 * x.y());
}

/// Most pairs of features that were in the list after a step.
void most_pairs(Value& value, const World&, const Contacts& contacts, double)
{
    const auto pairs = std::count_if(contacts.begin(), contacts.end(), [](const Contact& contact) {
        return contact.kind != ContactKind::vertex_plane;
    });
    value = std::max(value.value_or(0), static_cast<double>(pairs));
}

/// Height of a body's middle at the end [m].
Gauge::Reading height_of(const std::string& body)
{
    return [body](Value& value, const World& world, const Contacts&, double) {
        value = body_named(world, body).centre().y();
    };
}

/// The same for a body that has to be held up at first: none if it is below a height [m] before a time [s].
Gauge::Reading height_after_being_held(const std::string& body, double above, double until)
{
    return [body, above, until, fell = false](Value& value, const World& world, const Contacts&,
                                              double) mutable {
        const double height = body_named(world, body).centre().y();
        fell = fell || (world.time <= until && height < above);
        value = fell ? Value() : Value(height);
    };
}

//! [label_truth]
/// Share of pairs that are labelled as they should be, over the whole run [%]. On a flat floor it is known
/// how: a pair that pushes along the floor is hooked, one that pushes upwards is regular.
Gauge::Reading right_labels()
{
    return [right = 0L, all = 0L](Value& value, const World& world, const Contacts& contacts,
                                  double) mutable {
        for (const Contact& contact : contacts) {
            if (contact.kind == ContactKind::vertex_plane || !contact.answered())
                continue;
            const bool sideways = std::abs(contact_geometry(world, contact, 0).normal.y()) < std::sqrt(0.5);
            right += contact.category == (sideways ? ContactCategory::hooked : ContactCategory::regular);
            ++all;
        }
        if (all > 0)
            value = 100.0 * static_cast<double>(right) / static_cast<double>(all);
    };
}
//! [label_truth]

/// Longest lever of a pushing pair over the run [mm].
void longest_of_levers(Value& value, const World& world, const Contacts& contacts, double)
{
    if (const Value lever = longest_lever(world, contacts))
        value = std::max(value.value_or(0), 1000 * *lever);
}

/// Deepest vertex over the run that nothing pushes out [mm].
Gauge::Reading deepest_unpushed(const std::string& of, const std::string& in)
{
    return [of, in](Value& value, const World& world, const Contacts& contacts, double) {
        const double depth = deepest_without_pair(world, contacts, index_of(world, of), index_of(world, in));
        value = std::max(value.value_or(0), 1000 * depth);
    };
}

/// A body's speed along x at the end [m/s], unless it has fallen through the floor.
Gauge::Reading speed_on_floor(const std::string& body)
{
    return [body](Value& value, const World& world, const Contacts&, double) {
        value.reset();
        if (body_named(world, body).centre().y() > 0)
            value = body_named(world, body).mean_velocity().x();
    };
}

/// Kinetic energy at the end over that at the start, once it has bounced back.
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

/// How far a body moves in the last second [mm].
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

/// How far the way that a block comes up a slope departs from v^2 / (2 g
/// (sin + mu_d cos)) [%], once it lies still.
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

/// How far above its floor, at height 0, the lowest vertex of a body comes [mm], unless it is in the floor at
/// the end.
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

/// Most energy that a tower has over that at a time [J], from then on, unless its last cube has come down by
/// half of itself.
Gauge::Reading energy_gained_after(double time, const std::string& last, double lowest_height)
{
    return [=, before = 0.0, most = 0.0](Value& value, const World& world, const Contacts&, double) mutable {
        const double energy = total_energy(world).total();
        before = world.time <= time ? energy : before;
        most = std::max(most, energy - before);
        value = body_named(world, last).centre().y() < lowest_height ? Value() : Value(most);
    };
}

/// Kinetic energy at the end over that at the start, unless the body's middle is below height 0.
Gauge::Reading energy_if_above(const std::string& body)
{
    return [body, before = 0.0](Value& value, const World& world, const Contacts&, double) mutable {
        const double energy = body_named(world, body).energy(world.gravity).kinetic;
        before = world.step == 0 ? energy : before;
        value = body_named(world, body).centre().y() < 0 ? Value() : Value(energy / before);
    };
}

/// Most edges of a body that passed, after a step, through faces that were `apart` from them at first [m], unless
/// the body still stands higher than `standing` [m]. Surfaces that are pressed into each other by less than a
/// millimetre do not cross.
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

//! [expectations]
std::vector<MotivatingScene> all_scenes()
{
    return {
        {"ground",
         "ground",
         R"({"duration": 2})",
         "lowest vertex below the ground",
         "mm",
         Bound::at_most,
         50,
         "their weight on four springs alone presses them in by less",
         "pppppppp",
         'p',
         below_ground,
         {2}},
        {"fast_plate",
         "fast_plate",
         "",
         "pairs of features reported",
         "",
         Bound::at_least,
         1,
         "it passes a plate, so there is something to report",
         "fppppppp",
         'p',
         most_pairs,
         {0.03}},
        {"bar_on_cube",
         "bar_on_cube",
         R"({"duration": 1.2})",
         "height of the bar",
         "m",
         Bound::at_least,
         0.7,
         "half way: a bar of 0.4 m on a cube of 1 m has its middle at 1.2 m, less what both sink in; on the ground it would be at 0.2 m",
         "ffpppppp",
         'p',
         height_of("bar"),
         {1.2}},
        {"slope",
         "block_on_slope",
         "",
         "way in the last second",
         "mm",
         Bound::at_most,
         1,
         "0.3 is more than tan 10 deg = 0.176: it holds",
         "fffppppp",
         'p',
         drift_after("block", 3),
         {3}},
        {"labels",
         "hooked",
         "",
         "pairs labelled rightly",
         "%",
         Bound::at_least,
         98,
         "on a flat floor a pair either lifts or hooks; a few turn within the step that they are labelled in",
         "ffffpppp",
         '-',
         right_labels(),
         {0.3}},
        {"through_the_side",
         "through_the_side",
         "",
         "height of the wedge",
         "m",
         Bound::at_most,
         -0.5,
         "free fall from the table's edge ends below -1 m",
         "fffffppp",
         'p',
         height_after_being_held("wedge", 0.03, 0.08),
         {0.05, 0.1, 0.15, 0.25}},
        {"shifted",
         "shifted",
         "",
         "distance from vertex to push",
         "mm",
         Bound::at_most,
         10,
         "in a step the tip moves by 6 mm",
         "fffffppp",
         '-',
         longest_of_levers,
         {0.1, 0.25, 0.5}},
        {"false_resolution",
         "false_resolution",
         "",
         "deepest vertex that nothing pushes out",
         "mm",
         Bound::at_most,
         1,
         "before its first push the tip comes in by 0.2 mm",
         "fffffppp",
         'p',
         deepest_unpushed("spike", "slab"),
         {0.1, 0.3, 0.5}},
        {"hooked",
         "hooked",
         "",
         "speed at the end",
         "m/s",
         Bound::at_least,
         1.485,
         "99 % of 1.5 m/s: nothing rubs",
         "fffffppp",
         'p',
         speed_on_floor("cube"),
         {0.1, 0.3, 0.6}},
        {"mesh_slope",
         "block_on_triangles",
         "",
         "error of the way up",
         "%",
         Bound::at_most,
         2,
         "chapter 4 stops it where it should; here it first has to land",
         "fffffppp",
         'f',
         error_of_way("block", 9 / (2 * 9.81 * (std::sin(pi / 18) + 0.09 * std::cos(pi / 18)))),
         {0.5, 1.5, 3}},
        {"deep",
         "deep",
         "",
         "energy after the bounce over that before",
         "",
         Bound::at_most,
         1.1,
         "nothing is there to add any",
         "ffpppfpp",
         'p',
         energy_after_bounce("cube"),
         {0.03, 0.06, 0.15}},
        {"born_inside",
         "born_inside",
         "",
         "height over the floor, at most",
         "mm",
         Bound::at_most,
         10,
         "it has no reason to leave the floor; a centimetre is left for tipping over",
         "fffffffp",
         'p',
         highest_over_floor("block"),
         {0.3, 0.8, 2}},
        {"wholly_inside",
         "born_inside",
         R"({"/bodies/block/position": [0.013, -0.3, 0.021]})",
         "height over the floor, at most",
         "mm",
         Bound::at_most,
         10,
         "as above; nothing crosses at the start, so nothing tells where the floor ends but its surface",
         "fffffffp",
         'f',
         highest_over_floor("block"),
         {0.3, 0.8, 2}},
        {"thin",
         "thin",
         "",
         "energy after the impact over that before",
         "",
         Bound::at_most,
         1.01,
         "it came from above; its middle may not be under the plate, and nothing adds energy",
         "ffffffpp",
         'p',
         energy_if_above("ball"),
         {0.02, 0.05, 0.2}},
        {"tower",
         "tower",
         "",
         "energy gained in the last second",
         "J",
         Bound::at_most,
         0.03,
         "0.1 % of 29 J, with which the cubes fell on each other",
         "ffffffpp",
         'p',
         energy_gained_after(2, "cube 5", 2.3),
         {0.1, 0.5, 3}},
        {"folded",
         "folded",
         "",
         "edges through its own body",
         "",
         Bound::at_most,
         0,
         "it has folded onto itself; a millimetre, a twentieth of its thickness, is left for the pressing",
         "fffffffp",
         'f',
         edges_through("strip", 0.1, 0.3),
         {0.45, 0.6, 0.75}},
    };
}
//! [expectations]

}  // namespace

const std::vector<MotivatingScene>& motivating_scenes()
{
    static const std::vector<MotivatingScene> scenes = all_scenes();
    return scenes;
}

}  // namespace enduring::motivating
