#include "common/simulation/contact_parameters.hpp"

namespace enduring {

FrictionParameters with_coefficients(FrictionParameters friction, double mu_s, double mu_d)
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

}  // namespace enduring
