#pragma once

#include "common/simulation/normal_law.hpp"

#include <array>
#include <string_view>

namespace enduring {

enum class PenaltyMethod { discrete, continuous };

/// Their words in the file, in this order.
inline constexpr std::array<std::string_view, 2> penalty_words{"dpf", "cpf"};

enum class FrictionModel { none, yamane_nakamura, mass_splitting };  ///< "none", "yamane_nakamura" or "mass_splitting" in the file

/// Friction of every pair (chapter 4).
struct FrictionParameters {
    FrictionModel model = FrictionModel::none;
    double mu_s = 0.5, mu_d = 0.3;  ///< static and dynamic coefficient; 0 <= mu_d <= mu_s
    double spring = 100;            ///< tangential stiffness of one pair [N/m]; k_FP of (5.22)
    double damper = 25;             ///< yamane_nakamura: k_FD of (5.22), of one pair [N s/m]
    double damping_ratio = 20;      ///< mass_splitting: the damper beside the spring, relative to critical for the pair's share of mass
    double weighting = 10000;       ///< k_w of (5.24) [s/m]: 1/k_w is the slip speed at which friction becomes dynamic
};

/// What a scene leaves out: the thesis' constants for yamane_nakamura (its section 7.3); for mass_splitting a spring as stiff as
/// the pair along its normal, and 1/k_w = 5 cm/s.
/// @param stiffness  k of one pair [N/m]
FrictionParameters friction_defaults(FrictionModel model, double stiffness);

/// What a scene says about contact. A chapter reads what its layer knows and leaves the rest.
struct ContactParameters {
    PenaltyMethod method = PenaltyMethod::continuous;
    double stiffness = 1000;  ///< k of one pair [N/m], positive
    FrictionParameters friction{};
    NormalLaw law{};          ///< a normal law of one's own, in place of the method's
};

}  // namespace enduring
