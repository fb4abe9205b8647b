#include "common/scenes/friction_reader.hpp"

#include "common/input/mistakes.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

FrictionModel read_model(const JsonValue& value)
{
    constexpr std::array models{FrictionModel::none, FrictionModel::yamane_nakamura, FrictionModel::mass_splitting};
    return models[value.at("model").choice({"none", "yamane_nakamura", "mass_splitting"})];
}

/// A scene may switch friction off and keep its numbers; a key that would do nothing beside others that do is a mistake.
void require_known_keys(const JsonValue& value, FrictionModel model)
{
    value.require_keys({"model", "mu_s", "mu_d", "spring", "damper", "damping_ratio", "weighting"});
    const std::string foreign = model == FrictionModel::mass_splitting ? "damper" : "damping_ratio";
    if (const std::optional<JsonValue> key = value.find(foreign); key && model != FrictionModel::none)
        key->complain(model == FrictionModel::mass_splitting ? "the model \"mass_splitting\" knows no \"damper\"; it has a \"damping_ratio\""
                                                     : "the model \"yamane_nakamura\" knows no \"damping_ratio\"; it has a \"damper\"");
}

/// With one coefficient given, the other follows where it must: mu_d is never above mu_s.
void read_coefficients(const JsonValue& value, FrictionParameters& friction)
{
    const NumberRange range{0, 10};
    friction.mu_s = value.number_or("mu_s", range, friction.mu_s);
    friction.mu_d = value.number_or("mu_d", range, std::min(friction.mu_d, friction.mu_s));
    if (friction.mu_d > friction.mu_s)
        value.complain("\"mu_d\" is above \"mu_s\"; a body that slides is never held better than one at rest");
}

}  // namespace

FrictionParameters read_friction(const JsonValue& value, double stiffness)
{
    FrictionParameters friction;
    Mistakes mistakes;
    mistakes.gather([&] {
        friction = friction_defaults(read_model(value), stiffness);
        require_known_keys(value, friction.model);
    });
    mistakes.gather([&] { read_coefficients(value, friction); });
    mistakes.gather([&] { friction.spring = value.number_or("spring", {0, 1e12, false, true, "N/m"}, friction.spring); });
    mistakes.gather([&] { friction.damper = value.number_or("damper", {0, 1e12, true, true, "N s/m"}, friction.damper); });
    mistakes.gather([&] { friction.damping_ratio = value.number_or("damping_ratio", {0, 1e6}, friction.damping_ratio); });
    mistakes.gather([&] { friction.weighting = value.number_or("weighting", {0, 1e9, false, true, "s/m"}, friction.weighting); });
    mistakes.complain();
    return friction;
}

}  // namespace enduring
