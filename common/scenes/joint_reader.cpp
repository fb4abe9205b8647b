#include "common/scenes/joint_reader.hpp"

#include "common/input/number_text.hpp"
#include "common/simulation/make_joint.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace enduring {
namespace {

constexpr double strongest = 1e9;
const NumberRange joint_point_range{-1e4, 1e4, true, true, "m"}, joint_length_range{0, 1e4, false, true, "m"};

/// The words of "type", and what they are.
constexpr std::array<std::string_view, 9> joint_words{"ball",  "hinge", "slider", "cylinder", "universal",
                                                      "fixed", "rod",   "rope",   "spring"};
constexpr std::size_t rod_word = 6, rope_word = 7, spring_word = 8;

JointKind kind_of(std::size_t word)
{
    return word < rod_word ? static_cast<JointKind>(word) : JointKind::distance;
}

/// The names of numbers, and their units, along a way and about a turn.
struct DriveWords {
    const char *limits, *rest;
    NumberRange coordinate, speed, most, stiffness, damping;
    bool in_degrees;
};
const DriveWords of_way{"limits",
                        "rest",
                        joint_point_range,
                        {-1e4, 1e4, true, true, "m/s"},
                        {0, strongest, false, true, "N"},
                        {0, 1e12, false, true, "N/m"},
                        {0, 1e12, true, true, "N s/m"},
                        false};
const DriveWords of_turn{"limits_deg",
                         "rest_deg",
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

/// The keys "limits", "motor" and "spring" of a joint with one free coordinate.
void read_drive(const JsonValue& value, const DriveWords& words, JointDrive& drive)
{
    if (const std::optional<JsonValue> limits = value.find(words.limits))
        read_limits(*limits, words, drive);
    if (const std::optional<JsonValue> motor = value.find("motor")) {
        motor->require_keys({"speed", "most"});
        drive.motor_speed = motor->at("speed").number(words.speed);
        drive.motor_most = motor->at("most").number(words.most);
    }
    if (const std::optional<JsonValue> held = value.find("spring")) {
        held->require_keys({"stiffness", "damping", words.rest});
        drive.stiffness = held->at("stiffness").number(words.stiffness);
        drive.damping = held->number_or("damping", words.damping, 0);
        if (const std::optional<JsonValue> rest = held->find(words.rest))
            drive.rest = read_coordinate(*rest, words);
    }
}

/// Index of the body that stands here by name; it may be one that stands, but none that is driven or soft.
int read_body_name(const JsonValue& value, const World& world)
{
    const std::string name = value.text();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const Body& body = *world.bodies[i];
        if (body.name() != name)
            continue;
        if (dynamic_cast<const RigidBody*>(&body) == nullptr &&
            dynamic_cast<const StaticBody*>(&body) == nullptr)
            value.complain("a joint holds rigid bodies and those that stand; \"" + name +
                           "\" is soft or moves as given");
        return static_cast<int>(i);
    }
    value.complain("there is no body \"" + name + "\"");
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
                                "motor", "spring"});
            break;
        case 2:
            value.require_keys(
                {"name", "type", "a", "b", "at", "touch", "breaks_at", "axis", "limits", "motor", "spring"});
            break;
        case 3: value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at", "axis"}); break;
        case 4:
            value.require_keys({"name", "type", "a", "b", "at", "touch", "breaks_at", "axis", "axis_b"});
            break;
        case rod_word:
            value.require_keys({"name", "type", "a", "b", "at", "to", "touch", "breaks_at"});
            break;
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

}  // namespace

Joint read_joint(const JsonValue& value, const World& world)
{
    const std::size_t word = value.at("type").choice(joint_words);
    require_keys_of(value, word);
    const JointKind kind = kind_of(word);
    const int a = read_body_name(value.at("a"), world);
    const std::optional<JsonValue> other = value.find("b");
    const int b = other ? read_body_name(*other, world) : -1;
    if (world.bodies[static_cast<std::size_t>(a)]->is_static())
        value.at("a").complain("stands; \"a\" is the one that moves, and what stands is \"b\"");
    if (a == b)
        value.at("b").complain("is \"a\" itself");
    const Vec3 at = value.at("at").vector(joint_point_range);
    const std::string name = value.at("name").text();
    Joint joint;
    if (kind == JointKind::distance) {
        const Vec3 to = value.at("to").vector(joint_point_range);
        joint = make_rod(world, name, a, b, at, to);
        read_distance(value, word, (at - to).norm(), joint.way);
    } else {
        joint = make_joint(world, name, kind, a, b, at, read_axes(value, kind));
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
