#include "chapters/13_other_solvers/xpbd_elements.hpp"

#include "common/fem/polar_rotation.hpp"
#include "common/simulation/deformable_body.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace enduring {
namespace {

using StrainRate = Eigen::Matrix<double, 6, 3>;

/// How the strains xx, yy, zz, xy, yz, zx (the shears doubled) change with a corner, in the frame of the
/// element.
StrainRate strain_rate(const Vec3& g)
{
    StrainRate rate;
    rate << g.x(), 0, 0, 0, g.y(), 0, 0, 0, g.z(), g.y(), g.x(), 0, 0, g.z(), g.y(), g.z(), 0, g.x();
    return rate;
}

}  // namespace

XpbdElements::XpbdElements(MethodStep& step) : step_(step)
{
    for (const SoftBody& soft : step.soft) {
        bodies_.emplace_back(soft);
        compliances_.push_back(hooke_matrix(lame_constants(soft.of->elastic().material())).inverse());
        for (std::size_t e = 0; e < bodies_.back().count(); ++e)
            elements_.push_back({bodies_.size() - 1, e, Strains::Zero()});
    }
}

void XpbdElements::begin(double h)
{
    h_ = h;
    for (Element& element : elements_)
        element.lambda.setZero();
}

void XpbdElements::sweep(bool backwards)
{
    const std::size_t count = elements_.size();
    for (std::size_t k = 0; k < count; ++k)
        solve(elements_[backwards ? count - 1 - k : k]);
}

//! [solve_element]
void XpbdElements::solve(Element& element)
{
    const SoftElements& body = bodies_[element.body];
    const ElasticElement& at_rest = body.element(element.index);
    const std::array<std::size_t, 4> nodes = body.nodes(element.index);
    const Mat3 f = body.deformation_gradient(element.index, corners_now(step_, nodes)),
               frame = polar_rotation(f);
    const Mat3 s = frame.transpose() * f;
    Strains strains;
    strains << s(0, 0) - 1, s(1, 1) - 1, s(2, 2) - 1, s(0, 1) + s(1, 0), s(1, 2) + s(2, 1), s(2, 0) + s(0, 2);

    const Eigen::Matrix<double, 6, 6> compliance = compliances_[element.body] / (at_rest.volume * h_ * h_);
    Eigen::Matrix<double, 6, 6> system = compliance;
    std::array<StrainRate, 4> j;
    for (std::size_t i = 0; i < 4; ++i) {
        j[i] = strain_rate(at_rest.gradients.col(static_cast<int>(i))) * frame.transpose();
        system += step_.nodes[nodes[i]].inverse_mass * j[i] * j[i].transpose();
    }
    const Strains change = system.ldlt().solve(-strains - compliance * element.lambda);
    element.lambda += change;
    for (std::size_t i = 0; i < 4; ++i)
        step_.nodes[nodes[i]].place += step_.nodes[nodes[i]].inverse_mass * j[i].transpose() * change;
}
//! [solve_element]

}  // namespace enduring
