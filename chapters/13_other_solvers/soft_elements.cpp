#include "chapters/13_other_solvers/soft_elements.hpp"

#include "common/simulation/deformable_body.hpp"

namespace enduring {
namespace {

std::variant<CorotatedLaw, NeoHookeanLaw> law_of(const ElasticMaterial& material)
{
    const LameConstants lame = lame_constants(material);
    if (material.law == ElasticLaw::neo_hookean)
        return NeoHookeanLaw(lame);
    return CorotatedLaw(lame);
}

/// How the stress at a point pulls at a corner, and a corner's motion changes the gradient there: rows j of
/// column j.
using CornerMap = Eigen::Matrix<double, 9, 3>;

CornerMap corner_map(const Vec3& gradient)
{
    CornerMap map;
    for (int j = 0; j < 3; ++j)
        map.middleRows<3>(3 * j) = gradient[j] * Mat3::Identity();
    return map;
}

}  // namespace

SoftElements::SoftElements(const SoftBody& soft)
    : elements_(&soft.of->elastic().mesh().elements()), first_(soft.first),
      law_(law_of(soft.of->elastic().material()))
{}

std::array<std::size_t, 4> SoftElements::nodes(std::size_t e) const
{
    std::array<std::size_t, 4> nodes{};
    for (std::size_t i = 0; i < 4; ++i)
        nodes[i] = first_ + static_cast<std::size_t>(element(e).nodes[i]);
    return nodes;
}

Mat3 SoftElements::deformation_gradient(std::size_t e, const FourPoints& x) const
{
    Mat3 f = Mat3::Zero();
    for (int i = 0; i < 4; ++i)
        f += x[static_cast<std::size_t>(i)] * element(e).gradients.col(i).transpose();
    return f;
}

double SoftElements::energy(std::size_t e, const FourPoints& x) const
{
    return element(e).volume * energy_density(deformation_gradient(e, x));
}

double SoftElements::energy_density(const Mat3& f) const
{
    return std::visit([&](const auto& law) { return law.energy(f); }, law_);
}

Mat3 SoftElements::stress(const Mat3& f) const
{
    return std::visit([&](const auto& law) { return law.stress(f); }, law_);
}

GradientMap SoftElements::stiffness(const Mat3& f) const
{
    return std::visit([&](const auto& law) { return law.stiffness(f); }, law_);
}

Derivatives SoftElements::derivatives(std::size_t e, const FourPoints& x) const
{
    const Mat3 f = deformation_gradient(e, x);
    Eigen::Matrix<double, 9, 12> motion;
    for (int i = 0; i < 4; ++i)
        motion.middleCols<3>(3 * i) = corner_map(element(e).gradients.col(i));
    Derivatives of;
    of.value = element(e).volume * energy_density(f);
    of.gradient = element(e).volume * motion.transpose() * stress(f).reshaped();
    of.hessian = element(e).volume * motion.transpose() * stiffness(f) * motion;
    return of;
}

//! [at_corner]
std::pair<Vec3, Mat3> SoftElements::at_corner(std::size_t e, int corner, const FourPoints& x) const
{
    const Mat3 f = deformation_gradient(e, x);
    const CornerMap motion = corner_map(element(e).gradients.col(corner));
    return {element(e).volume * motion.transpose() * stress(f).reshaped(),
            element(e).volume * motion.transpose() * stiffness(f) * motion};
}
//! [at_corner]

FourPoints corners_now(const MethodStep& step, const std::array<std::size_t, 4>& nodes)
{
    return {step.nodes[nodes[0]].place, step.nodes[nodes[1]].place, step.nodes[nodes[2]].place,
            step.nodes[nodes[3]].place};
}

}  // namespace enduring
