#include "common/scenes/friction_reader.hpp"

#include "common/input/mistakes.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

/// A scene may switch friction off and keep its numbers; a key that would
/// do nothing beside others that do is a mistake.
void refuse_foreign_keys(const JsonValue&, const NoFriction&) {}

void refuse_foreign_keys(const JsonValue& value, const YamaneNakamura&)
{
    if (const std::optional<JsonValue> key = value.find("damping_ratio"))
        key->complain("the model \"yamane_nakamura\" knows no \"damping_ratio\"; it has a \"damper\"");
}

void refuse_foreign_keys(const JsonValue& value, const MassSplitting&)
{
    if (const std::optional<JsonValue> key = value.find("damper"))
        key->complain("the model \"mass_splitting\" knows no \"damper\"; it has a \"damping_ratio\"");
}

/// With one coefficient given, the other follows where it must: mu_d is never above mu_s.
template <class Friction>
void read_coefficients(const JsonValue& value, Friction& friction)
{
    const NumberRange range{0, 10};
    friction.mu_s = value.number_or("mu_s", range, friction.mu_s);
    friction.mu_d = value.number_or("mu_d", range, std::min(friction.mu_d, friction.mu_s));
    if (friction.mu_d > friction.mu_s)
        value.complain(
            "\"mu_d\" is above \"mu_s\"; a body that slides is never held better than one at rest");
}

void read_damping(const JsonValue& value, YamaneNakamura& friction)
{
    friction.damper = value.number_or("damper", {0, 1e12, true, true, "N s/m"}, friction.damper);
}

void read_damping(const JsonValue& value, MassSplitting& friction)
{
    friction.damping_ratio = value.number_or("damping_ratio", {0, 1e6}, friction.damping_ratio);
}

template <class Friction>
void read_constants(const JsonValue& value, Friction& friction, Mistakes& mistakes)
{
    mistakes.gather([&] { read_coefficients(value, friction); });
    mistakes.gather([&] {
        friction.spring = value.number_or("spring", {0, 1e12, false, true, "N/m"}, friction.spring);
    });
    mistakes.gather([&] { read_damping(value, friction); });
    mistakes.gather([&] {
        friction.weighting = value.number_or("weighting", {0, 1e9, false, true, "s/m"}, friction.weighting);
    });
}

/// What is switched off is still read, for its mistakes.
void read_constants(const JsonValue& value, NoFriction&, Mistakes& mistakes)
{
    YamaneNakamura one;
    MassSplitting other;
    read_constants(value, one, mistakes);
    read_constants(value, other, mistakes);
}

/// With what a scene leaves out.
FrictionParameters read_model(const JsonValue& value, double stiffness)
{
    const std::array<FrictionParameters, friction_words.size()> models{NoFriction{}, YamaneNakamura{},
                                                                       MassSplitting{.spring = stiffness}};
    return models[value.at("model").choice(friction_words)];
}

}  // namespace

FrictionParameters read_friction(const JsonValue& value, double stiffness)
{
    FrictionParameters friction;
    Mistakes mistakes;
    mistakes.gather([&] {
        friction = read_model(value, stiffness);
        value.require_keys({"model", "mu_s", "mu_d", "spring", "damper", "damping_ratio", "weighting",
                            "viscous", "rolling", "patch"});
        std::visit([&](const auto& model) { refuse_foreign_keys(value, model); }, friction);
    });
    std::visit([&](auto& model) { read_constants(value, model, mistakes); }, friction);
    mistakes.complain();
    return friction;
}

SurfaceLaws read_surface_laws(const JsonValue& value, const SurfaceLaws& otherwise)
{
    const NumberRange length{0, 1e3, true, true, "m"};
    return {value.number_or("viscous", {0, 1e4, true, true, "s/m"}, otherwise.viscous),
            value.number_or("rolling", length, otherwise.rolling),
            value.number_or("patch", length, otherwise.patch)};
}

Grain read_grain(const JsonValue& value)
{
    value.require_keys({"along", "across"});
    return {value.at("along").direction(), value.at("across").number({0, 100, false, true})};
}

}  // namespace enduring
