#pragma once

#include "chapters/13_other_solvers/barrier_distances.hpp"
#include "chapters/13_other_solvers/method_step.hpp"
#include "common/fem/elastic_mesh.hpp"
#include "common/fem/point_laws.hpp"

#include <array>
#include <variant>
#include <vector>

namespace enduring {

//! [soft_elements]
/// The linear tetrahedra of a soft body, with the base's laws: what an element stores, and how this changes
/// with its four corners. All methods with soft bodies minimise this energy, and so does the implicit step of
/// the base.
class SoftElements {
public:
    /// @param soft  outlives this
    explicit SoftElements(const SoftBody& soft);

    std::size_t count() const { return elements_->size(); }
    const ElasticElement& element(std::size_t e) const { return (*elements_)[e]; }
    /// In MethodStep::nodes.
    std::array<std::size_t, 4> nodes(std::size_t e) const;

    /// F, of corners [m].
    Mat3 deformation_gradient(std::size_t e, const FourPoints& x) const;
    double energy(std::size_t e, const FourPoints& x) const;  ///< [J]
    Derivatives derivatives(std::size_t e,
                            const FourPoints& x) const;  ///< of the energy; no negative part in the Hessian
    /// Of the energy by one corner: slope [N], and stiffness [N/m] without a negative part.
    std::pair<Vec3, Mat3> at_corner(std::size_t e, int corner, const FourPoints& x) const;

private:
    GradientMap stiffness(const Mat3& f) const;
    double energy_density(const Mat3& f) const;
    Mat3 stress(const Mat3& f) const;

    const std::vector<ElasticElement>* elements_;
    std::size_t first_;
    std::variant<CorotatedLaw, NeoHookeanLaw> law_;
};
//! [soft_elements]

/// Where the corners of an element are now.
FourPoints corners_now(const MethodStep& step, const std::array<std::size_t, 4>& nodes);

}  // namespace enduring
