#pragma once

#include "common/simulation/material_friction.hpp"
#include "common/simulation/normal_law.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <variant>

namespace enduring {

enum class PenaltyMethod { discrete, continuous };

/// Their words in the file, in this order.
inline constexpr std::array<std::string_view, 2> penalty_words{"dpf", "cpf"};

/// Friction of every pair, with 0 <= mu_d <= mu_s: the static and the dynamic coefficient.
struct NoFriction {};

/// A spring and a damper that let go, with the thesis' constants (its section 7.3).
struct YamaneNakamura {
    double mu_s = 0.5, mu_d = 0.3;
    double spring = 100;  ///< tangential stiffness of one pair [N/m]; k_FP of (5.22)
    double damper = 25;   ///< k_FD of (5.22), of one pair [N s/m]
    /// k_w of (5.24) [s/m]: 1/k_w is the slip speed at which friction becomes dynamic
    double weighting = 10000;
};

/// A spring that gives where its pair slips, all pairs together.
struct MassSplitting {
    double mu_s = 0.5, mu_d = 0.3;
    /// tangential stiffness of one pair [N/m]; a scene that leaves it out takes that along the normal
    double spring = 1000;
    /// of the damper beside the spring, relative to critical for the pair's share of mass
    double damping_ratio = 20;
    /// 1/weighting is the slip speed at which friction becomes dynamic [s/m]: 5 cm/s
    double weighting = 20;
};

/// In the order of their words in the file.
using FrictionParameters = std::variant<NoFriction, YamaneNakamura, MassSplitting>;

inline constexpr std::array<std::string_view, 3> friction_words{"none", "yamane_nakamura", "mass_splitting"};

/// Those of a model; zero without friction.
inline FrictionCoefficients coefficients_of(const FrictionParameters& friction)
{
    const auto get = [](const auto& model) {
        if constexpr (requires { model.mu_s; })
            return FrictionCoefficients{model.mu_s, model.mu_d};
        else
            return FrictionCoefficients{};
    };
    return std::visit(get, friction);
}

/// The same model with other coefficients.
inline FrictionParameters with_coefficients(FrictionParameters friction, double mu_s, double mu_d)
{
    const auto set = [&](auto& model) {
        if constexpr (requires { model.mu_s; }) {
            model.mu_s = mu_s;
            model.mu_d = mu_d;
        }
    };
    std::visit(set, friction);
    return friction;
}

/// What a scene says about contact. A chapter reads what its layer knows and leaves the rest.
struct ContactParameters {
    PenaltyMethod method = PenaltyMethod::continuous;
    double stiffness = 1000;  ///< k of one pair [N/m], positive
    FrictionParameters friction{};
    SurfaceLaws surface_laws{};
    NormalLaw law{};  ///< a normal law of one's own, in place of the method's
    /// of what begins inside another body or a plane, under a solver that lets it out [m/s]; without it, a
    /// part of what is natural for bodies of their size (see ScaleParts)
    std::optional<double> max_depenetration_velocity{};
    /// how deep the load of a pair may press it, under a solver that finds its stiffness [m]; the same
    /// without it
    std::optional<double> wanted_depth{};
};

/// What pairs have whose bodies name no material.
inline FrictionCoefficients coefficients_of(const ContactParameters& contact)
{
    FrictionCoefficients of = coefficients_of(contact.friction);
    of.laws = contact.surface_laws;
    return of;
}

}  // namespace enduring
