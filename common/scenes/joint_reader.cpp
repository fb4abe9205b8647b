#include "common/scenes/joint_reader.hpp"

#include "common/input/number_text.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/joint_body.hpp"
#include "common/simulation/make_joint.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace enduring {
namespace {

constexpr double strongest = 1e9;
const NumberRange joint_point_range{-1e4, 1e4, true, true, "m"}, joint_length_range{0, 1e4, false, true, "m"};

/// The words of "type", and what they are.
constexpr std::array<std::string_view, 10> joint_words{"ball",  "hinge", "slider", "cylinder", "universal",
                                                       "fixed", "rod",   "rope",   "spring",   "gear"};
constexpr std::size_t rod_word = 6, rope_word = 7, spring_word = 8, gear_word = 9;

JointKind kind_of(std::size_t word)
{
    if (word == gear_word)
        return JointKind::gear;
    return word < rod_word ? static_cast<JointKind>(word) : JointKind::distance;
}

/// The names of numbers, and their units, along a way and about a turn.
struct DriveWords {
    const char *limits, *rest, *target;
    NumberRange coordinate, speed, most, stiffness, damping;
    bool in_degrees;
};
const DriveWords of_way{"limits",
                        "rest",
                        "to",
                        joint_point_range,
                        {-1e4, 1e4, true, true, "m/s"},
                        {0, strongest, false, true, "N"},
                        {0, 1e12, false, true, "N/m"},
                        {0, 1e12, true, true, "N s/m"},
                        false};
const DriveWords of_turn{"limits_deg",
                         "rest_deg",
                         "to_deg",
                         {-1e6, 1e6, true, true, "degrees"},
                         {-1e4, 1e4, true, true, "rad/s"},
                         {0, strongest, false, true, "N m"},
                         {0, 1e12, false, true, "N m/rad"},
                         {0, 1e12, true, true, "N m s/rad"},
                         true};

double read_coordinate(const JsonValue& value, const DriveWords& words)
{
    return words.in_degrees ? value.angle(words.coordinate) : value.number(words.coordinate);
}

void read_limits(const JsonValue& value, const DriveWords& words, JointDrive& drive)
{
    const std::vector<JsonValue> both = value.items(2, 2);
    drive.low = read_coordinate(both[0], words);
    drive.high = read_coordinate(both[1], words);
    if (!(drive.low <= 0 && drive.high >= 0))
        value.complain("the joint begins at 0, which lies outside of its limits");
    if (!(drive.low < drive.high))
        value.complain("both limits are the same; another type locks what is free here");
}

/// A motor keeps a speed, or goes to a place as fast as it can stop there, and no faster than its speed.
void read_motor(const JsonValue& motor, const DriveWords& words, JointDrive& drive)
{
    motor.require_keys({"speed", "most", words.target});
    drive.motor_most = motor.at("most").number(words.most);
    if (const std::optional<JsonValue> target = motor.find(words.target)) {
        drive.motor_target = read_coordinate(*target, words);
        drive.motor_speed = motor.number_or("speed", {0, 1e4, false, true, words.speed.unit},
                                            std::numeric_limits<double>::infinity());
    } else {
        drive.motor_speed = motor.at("speed").number(words.speed);
    }
}

/// The keys "limits", "restitution", "motor" and "spring" of a joint with one free coordinate.
void read_drive(const JsonValue& value, const DriveWords& words, JointDrive& drive)
{
    if (const std::optional<JsonValue> limits = value.find(words.limits))
        read_limits(*limits, words, drive);
    if (const std::optional<JsonValue> bounce = value.find("restitution")) {
        if (!value.find(words.limits))
            bounce->complain("stands without limits, at which alone a joint bounces");
        drive.bounce = bounce->number({0, 1});
    }
    if (const std::optional<JsonValue> motor = value.find("motor"))
        read_motor(*motor, words, drive);
    if (const std::optional<JsonValue> held = value.find("spring")) {
        held->require_keys({"stiffness", "damping", words.rest});
        drive.stiffness = held->at("stiffness").number(words.stiffness);
        drive.damping = held->number_or("damping", words.damping, 0);
        if (const std::optional<JsonValue> rest = held->find(words.rest))
            drive.rest = read_coordinate(*rest, words);
    }
}

/// Index of the body that stands here by name.
/// @param kind  of the joint: those that read turns hold no soft body
int read_body_name(const JsonValue& value, const World& world, JointKind kind)
{
    const std::string name = value.text();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        if (world.bodies[i]->name() != name)
            continue;
        if (is_soft(world, static_cast<int>(i)) && !leaves_turns(kind))
            value.complain(
                "\"" + name +
                "\" is soft, and a point of it has no axes that could be locked; a soft body takes "
                "the types \"ball\", \"rod\", \"rope\" and \"spring\"");
        return static_cast<int>(i);
    }
    value.complain("there is no body \"" + name + "\"");
}

/// The farthest that a joint's point may be from the surface of a soft body that it holds, over the body's
/// size.
constexpr double farthest_from_surface = 0.05;

/// A soft body is held at the point of its surface that is nearest to the one of the file.
Vec3 read_held_point(const JsonValue& value, const World& world, int body)
{
    const Vec3 point = value.vector(joint_point_range);
    Vec3 held = held_point(world, body, point);
    if (const double away = (held - point).norm();
        away > 0 && away > farthest_from_surface * world.bodies[static_cast<std::size_t>(body)]->size())
        value.complain("is " + shortest(away) + " m from the surface of \"" +
                       world.bodies[static_cast<std::size_t>(body)]->name() + "\", which it would hold");
    return held;
}

/// The point at which a joint holds both bodies.
Vec3 read_common_point(const JsonValue& value, const World& world, int a, int b)
{
    Vec3 point = read_held_point(value, world, a);
    const Vec3 of_b = held_point(world, b, point);
    if (!is_soft(world, a) && is_soft(world, b))
        return read_held_point(value, world, b);
    if (const double apart = (of_b - point).norm();
        apart > 1e-9 * world.bodies[static_cast<std::size_t>(a)]->size())
        value.complain("the surfaces of both soft bodies are " + shortest(apart) +
                       " m apart there; a rod joins points that are apart");
    return point;
}

Mat3 read_axes(const JsonValue& value, JointKind kind)
{
    if (kind == JointKind::universal) {
        const Vec3 first = value.at("axis").direction(), second = value.at("axis_b").direction();
        constexpr double right_angle = 1e-6;
        if (std::abs(first.dot(second)) > right_angle)
            value.at("axis_b").complain("is not at right angles to \"axis\"");
        Mat3 axes;
        axes.col(0) = first;
        axes.col(1) = (second - first.dot(second) * first).normalized();
        axes.col(2) = axes.col(0).cross(axes.col(1));
        return axes;
    }
    return kind == JointKind::hinge || kind == JointKind::slider || kind == JointKind::cylinder
               ? axes_about(value.at("axis").direction())
               : Mat3(Mat3::Identity());
}

/// A rod keeps its length, a rope none longer than it is, and a spring pulls towards its own.
void read_distance(const JsonValue& value, std::size_t word, double length, JointDrive& way)
{
    if (!(length > 0))
        value.at("to").complain("is the point \"at\"; between them is no direction");
    if (word == rod_word)
        return;
    way.low = -std::numeric_limits<double>::infinity();
    way.high = std::numeric_limits<double>::infinity();
    const double own = value.number_or("length", joint_length_range, length);
    if (word == rope_word) {
        way.high = own;
        if (own < length * (1 - 1e-12))
            value.at("length").complain("is shorter than the " + shortest(length) +
                                        " m from \"at\" to \"to\"");
        return;
    }
    way.stiffness = value.at("stiffness").number(of_way.stiffness);
    way.damping = value.number_or("damping", of_way.damping, 0);
    way.rest = own;
}

void require_keys_of(const JsonValue& value, std::size_t word)
{
    switch (word) {
        case 1:
            value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at", "axis", "limits_deg",
                                "restitution", "motor", "spring"});
            break;
        case 2:
            value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at", "axis", "limits",
                                "restitution", "motor", "spring"});
            break;
        case 3: value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at", "axis"}); break;
        case 4:
            value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at", "axis", "axis_b"});
            break;
        case rod_word:
            value.require_keys({"name", "type", "a", "b", "at", "to", "touch", "breaks_at"});
            break;
        case gear_word: value.require_keys({"name", "type", "hinges", "ratio"}); break;
        case rope_word:
            value.require_keys({"name", "type", "a", "b", "at", "to", "touch", "breaks_at", "length"});
            break;
        case spring_word:
            value.require_keys({"name", "type", "a", "b", "at", "to", "touch", "breaks_at", "length",
                                "stiffness", "damping"});
            break;
        default: value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at"});
    }
}

/// One of a gear's two hinges, which stand before it in the list.
int read_hinge_name(const JsonValue& value, const World& world)
{
    const std::string name = value.text();
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
        const Joint& joint = world.joints[i];
        if (joint.name != name)
            continue;
        if (joint.kind != JointKind::hinge)
            value.complain("\"" + name + "\" is no hinge, and a gear joins two of them");
        const Body* const other = body_at(world, joint.b);
        if (other && dynamic_cast<const DrivenBody*>(other) != nullptr)
            value.complain("\"" + name + "\" stands on \"" + other->name() +
                           "\", which moves as given; a gear's hinges stand on the world or on rigid bodies");
        return static_cast<int>(i);
    }
    value.complain("there is no joint \"" + name + "\" before this one");
}

Joint read_gear(const JsonValue& value, const World& world)
{
    const std::vector<JsonValue> names = value.at("hinges").items(2, 2);
    const int first = read_hinge_name(names[0], world), second = read_hinge_name(names[1], world);
    if (first == second)
        names[1].complain("is the first one itself");
    const double ratio = value.at("ratio").number({-1e4, 1e4});
    if (ratio == 0)
        value.at("ratio").complain("is 0; a gear turns both");
    return make_gear(value.at("name").text(), world, first, second, ratio);
}

}  // namespace

Joint read_joint(const JsonValue& value, const World& world)
{
    const std::size_t word = value.at("type").choice(joint_words);
    require_keys_of(value, word);
    const JointKind kind = kind_of(word);
    if (kind == JointKind::gear)
        return read_gear(value, world);
    const int a = read_body_name(value.at("a"), world, kind);
    const std::optional<JsonValue> other = value.find("b");
    const int b = other ? read_body_name(*other, world, kind) : -1;
    if (world.bodies[static_cast<std::size_t>(a)]->is_static())
        value.at("a").complain(
            "stands or moves as given; \"a\" is the one that forces move, and the other one is \"b\"");
    if (a == b)
        value.at("b").complain("is \"a\" itself");
    const std::string name = value.at("name").text();
    Joint joint;
    if (kind == JointKind::distance) {
        const Vec3 at = read_held_point(value.at("at"), world, a),
                   to = read_held_point(value.at("to"), world, b);
        joint = make_rod(world, name, a, b, at, to);
        read_distance(value, word, (at - to).norm(), joint.way);
    } else {
        joint = make_joint(world, name, kind, a, b, read_common_point(value.at("at"), world, a, b),
                           read_axes(value, kind));
    }
    if (kind == JointKind::slider)
        read_drive(value, of_way, joint.way);
    else if (kind == JointKind::hinge)
        read_drive(value, of_turn, joint.turn);
    joint.breaks_at = value.number_or("breaks_at", {0, strongest, false, true, "N"},
                                      std::numeric_limits<double>::infinity());
    joint.bodies_touch = value.flag_or("touch", false);
    return joint;
}

}  // namespace enduring
