#include "common/scenes/motion_reader.hpp"

#include "common/input/number_text.hpp"

#include <Eigen/Eigenvalues>

#include <limits>
#include <string>
#include <utility>

namespace enduring {
namespace {

constexpr std::size_t max_rows = 100'000, max_loads = 100;
constexpr double least_gap = 1e-6;  ///< between rows [s]: the shortest step
const NumberRange time_range{-3600, 3600, true, true, "s"}, place_range{-1e4, 1e4, true, true, "m"},
    speed_range{-1e4, 1e4, true, true, "m/s"}, spin_range{-1e4, 1e4, true, true, "rad/s"};

template <class Row>
double read_time(const JsonValue& row, const std::vector<Row>& before)
{
    return enduring::read_time(row, before.empty() ? nullptr : &before.back().time);
}

/// Axis times angle; zero if left out.
Vec3 read_turn(const JsonValue& row)
{
    const std::optional<JsonValue> turn = row.find("turn");
    if (!turn)
        return Vec3::Zero();
    turn->require_keys({"axis", "angle_deg"});
    return turn->at("angle_deg").angle({-1e6, 1e6}) * turn->at("axis").direction();
}

/// The velocities of a row, where they are given.
void read_velocities(const JsonValue& value, GivenMotion::Row& row)
{
    row.velocity = value.vector_or("velocity", speed_range, Vec3::Zero());
    row.gives_velocity = value.find("velocity").has_value();
    const std::optional<JsonValue> spin = value.find("angular_velocity");
    if (!spin)
        return;
    const std::optional<Vec3> rate = turn_rate(row.turn, spin->vector(spin_range));
    if (!rate)
        spin->complain("is not about the axis of \"turn\", and after whole turns no other axis can follow");
    row.turn_rate = *rate;
    row.gives_turn_rate = true;
}

GivenMotion read_motion_table(const JsonValue& table)
{
    std::vector<GivenMotion::Row> rows;
    for (const JsonValue& value : table.items(2, max_rows)) {
        value.require_keys({"time", "displacement", "turn", "velocity", "angular_velocity"});
        const double time = read_time(value, rows);
        rows.push_back({time, value.vector_or("displacement", place_range, Vec3::Zero()), read_turn(value)});
        read_velocities(value, rows.back());
    }
    return GivenMotion::through(std::move(rows));
}

void refuse_beside_table(const JsonValue& value, std::initializer_list<const char*> keys)
{
    for (const char* key : keys)
        if (const std::optional<JsonValue> found = value.find(key))
            found->complain("stands beside \"table\"; one of the two is enough");
}

GivenMotion read_course(const JsonValue& motion)
{
    if (const std::optional<JsonValue> table = motion.find("table")) {
        refuse_beside_table(motion, {"velocity", "angular_velocity"});
        return read_motion_table(*table);
    }
    const InitialMotion steady = read_motion(motion);
    return GivenMotion::steady(steady.velocity, steady.angular_velocity);
}

const NumberRange force_range{-1e9, 1e9, true, true, "N"}, torque_range{-1e9, 1e9, true, true, "N m"},
    spring_range{0, 1e12, false, true, "N/m"};

/// What stands here, or in the rows of the table, under one key.
TimedVector read_timed(const JsonValue& value, const std::string& key, const NumberRange& range)
{
    const std::optional<JsonValue> table = value.find("table");
    if (!table)
        return TimedVector(value.vector_or(key, range, Vec3::Zero()));
    std::vector<TimedVector::Row> rows;
    for (const JsonValue& row : table->items(2, max_rows)) {
        const double time = read_time(row, rows);
        rows.push_back({time, row.vector_or(key, range, Vec3::Zero())});
    }
    return TimedVector(std::move(rows));
}

AnchoredSpring read_spring(const JsonValue& value)
{
    value.require_keys({"anchor", "stiffness", "rest_length"});
    return {value.at("anchor").vector(place_range), value.at("stiffness").number(spring_range),
            value.number_or("rest_length", {0, 1e4, true, true, "m"}, 0)};
}

OutsideLoad read_load(const JsonValue& value, const Placement& placement)
{
    value.require_keys({"force", "torque", "table", "point", "axes", "spring"});
    if (const std::optional<JsonValue> table = value.find("table")) {
        refuse_beside_table(value, {"force", "torque"});
        for (const JsonValue& row : table->items(2, max_rows))
            row.require_keys({"time", "force", "torque"});
    }
    OutsideLoad load;
    load.force = read_timed(value, "force", force_range);
    load.torque = read_timed(value, "torque", torque_range);
    if (const std::optional<JsonValue> point = value.find("point"))
        load.point = placement.place(point->vector(place_range));
    if (const std::optional<JsonValue> spring = value.find("spring"))
        load.spring = read_spring(*spring);
    if (const std::optional<JsonValue> axes = value.find("axes"))
        load.turns_along = axes->choice({"world", "body"}) == 1;
    if (load.turns_along) {
        load.force = load.force.turned(placement.rotation);
        load.torque = load.torque.turned(placement.rotation);
    }
    return load;
}

/// Zero for each axis that is named.
Vec3 read_free_axes(const JsonValue& locked, const std::string& key)
{
    Vec3 free = Vec3::Ones();
    if (const std::optional<JsonValue> axes = locked.find(key))
        for (const JsonValue& axis : axes->items(0, 3)) {
            const auto direction = static_cast<Eigen::Index>(axis.choice({"x", "y", "z"}));
            if (std::exchange(free[direction], 0) == 0)
                axis.complain("is locked twice");
        }
    return free;
}

}  // namespace

double read_time(const JsonValue& row, const double* before)
{
    const double time = row.at("time").number(time_range);
    if (before && !(time >= *before + least_gap))
        row.at("time").complain("is not a microsecond or more later than that of the row before");
    return time;
}

double read_until(const JsonValue& value)
{
    return value.number_or("until", {0, 3600, false, true, "s"}, std::numeric_limits<double>::infinity());
}

ReadMotion read_given_motion(const JsonValue& value, const Placement& placement)
{
    value.require_keys({"velocity", "angular_velocity", "table", "centre", "until"});
    ReadMotion given{read_course(value), value.vector_or("centre", place_range, placement.position)};
    given.motion.end_at(read_until(value));
    return given;
}

std::vector<OutsideLoad> read_loads(const JsonValue& body, const Placement& placement)
{
    std::vector<OutsideLoad> loads;
    if (const std::optional<JsonValue> list = body.find("forces"))
        for (const JsonValue& entry : list->items(0, max_loads))
            loads.push_back(read_load(entry, placement));
    return loads;
}

TimedVector read_force(const JsonValue& entry)
{
    if (const std::optional<JsonValue> table = entry.find("table")) {
        refuse_beside_table(entry, {"force"});
        for (const JsonValue& row : table->items(2, max_rows))
            row.require_keys({"time", "force"});
    }
    return read_timed(entry, "force", force_range);
}

//! [slow_springs]
/// A spring that swings with omega is stable while omega dt < 2; at 1, its period is 5 percent off. All
/// springs of a body swing no faster than with the sum of their squares, each with the least mass that its
/// point has.
void require_slow_springs(const JsonValue& body, const RigidBody& of, double dt)
{
    const std::optional<JsonValue> list = body.find("forces");
    if (!list)
        return;
    const Placement placement = read_placement(body);
    double left = 1;
    for (const JsonValue& entry : list->items(0, max_loads)) {
        const std::optional<JsonValue> spring = entry.find("spring");
        if (!spring)
            continue;
        const std::optional<JsonValue> point = entry.find("point");
        const Vec3 where = point ? placement.place(point->vector(place_range)) : of.motion().centre();
        const double response = of.motion().inverse_mass_at(where).eigenvalues().real().maxCoeff(),
                     stiffness = spring->at("stiffness").number(spring_range);
        left -= dt * dt * response * stiffness;
        if (left < 0)
            spring->at("stiffness")
                .complain("is too stiff for steps of " + shortest(dt) + " s by " +
                          readable(-left / (dt * dt * response), 3) + " N/m; make dt shorter");
    }
}
//! [slow_springs]

ReadLocks read_locks(const JsonValue& body, const Placement& placement)
{
    ReadLocks locks;
    const std::optional<JsonValue> locked = body.find("locked");
    if (!locked)
        return locks;
    locked->require_keys({"translation", "rotation", "about", "axes"});
    if (const std::optional<JsonValue> axes = locked->find("axes");
        axes && axes->choice({"world", "body"}) == 1)
        locks.free.axes = placement.rotation.toRotationMatrix();
    locks.free.translation = read_free_axes(*locked, "translation");
    locks.free.rotation = read_free_axes(*locked, "rotation");
    if (const std::optional<JsonValue> about = locked->find("about")) {
        locks.pin = placement.place(about->vector(place_range));
        if (const std::optional<JsonValue> translation = locked->find("translation"))
            translation->complain("stands beside \"about\", which holds all translations of a point");
        if (const std::optional<JsonValue> velocity = body.find("velocity"))
            velocity->complain(
                "follows from the \"angular_velocity\" of a body that is locked \"about\" a point");
    }
    return locks;
}

}  // namespace enduring
