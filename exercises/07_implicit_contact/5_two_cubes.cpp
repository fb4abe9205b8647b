#include "exercises/07_implicit_contact/5_two_cubes.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

double potential_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    not_implemented_yet("7.5");
}

Eigen::Vector2d impulse_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    not_implemented_yet("7.5");
}

Eigen::Matrix2d hessian_of(const CubePair& pair, const Eigen::Vector2d& velocity, double limit, double dt)
{
    not_implemented_yet("7.5");
}

Eigen::VectorXd gradient(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& v)
{
    not_implemented_yet("7.5");
}

Eigen::VectorXd solved(const PileStep& step, const std::vector<double>& limits, const Eigen::VectorXd& begin)
{
    not_implemented_yet("7.5");
}

PileMotion after_step(const PileStep& step)
{
    not_implemented_yet("7.5");
}

}  // namespace enduring
