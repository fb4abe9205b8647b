#include "exercises/03_penalty_impulses/3_shared_push.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace enduring {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

std::vector<double> spread_weights(const Patch& patch, const Vec3& p)
{
    not_implemented_yet("3.3");
}

void push_patch(Patch& patch, const std::vector<double>& weights, const Vec3& impulse)
{
    not_implemented_yet("3.3");
}

double effective_mass(const Patch& patch, const std::vector<double>& weights)
{
    not_implemented_yet("3.3");
}

double longest_step(const Patch& patch, const std::vector<double>& weights, double k)
{
    not_implemented_yet("3.3");
}

}  // namespace enduring
