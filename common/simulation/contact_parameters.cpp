#include "common/simulation/contact_parameters.hpp"

namespace enduring {

FrictionParameters friction_defaults(FrictionModel model, double stiffness)
{
    FrictionParameters friction;
    friction.model = model;
    if (model == FrictionModel::mass_splitting) {
        friction.spring = stiffness;
        friction.weighting = 20;
    }
    return friction;
}

}  // namespace enduring
