#include "common/fem/material.hpp"

#include "common/input/input_error.hpp"

#include <cmath>
#include <sstream>

namespace enduring {
namespace {

void demand(bool holds, const char* name, double value, const char* range)
{
    if (holds && std::isfinite(value))
        return;
    std::ostringstream message;
    message << name << " must be " << range << ", not " << value;
    throw InputError(message.str());
}

}  // namespace

void check(const ElasticMaterial& material)
{
    demand(material.young > 0, "young (Young's modulus, Pa)", material.young, "positive and finite");
    demand(material.poisson > -1 && material.poisson < 0.5, "poisson (Poisson's ratio)", material.poisson,
           "between -1 and 0.5, both excluded");
    demand(material.density > 0, "density (kg/m^3)", material.density, "positive and finite");
    demand(material.mass_damping >= 0, "mass_damping (1/s)", material.mass_damping,
           "zero or positive, and finite");
    demand(material.stiffness_damping >= 0, "stiffness_damping (s)", material.stiffness_damping,
           "zero or positive, and finite");
}

LameConstants lame_constants(const ElasticMaterial& material)
{
    const double e = material.young, nu = material.poisson;
    return {.lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), .mu = e / (2 * (1 + nu))};
}

Eigen::Matrix<double, 6, 6> hooke_matrix(const LameConstants& lame)
{
    Eigen::Matrix<double, 6, 6> e = Eigen::Matrix<double, 6, 6>::Zero();
    e.topLeftCorner<3, 3>().setConstant(lame.lambda);
    e.diagonal().head<3>().array() += 2 * lame.mu;
    e.diagonal().tail<3>().setConstant(lame.mu);
    return e;
}

}  // namespace enduring
