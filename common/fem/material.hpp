#pragma once

#include <Eigen/Core>

namespace enduring {

/// How stress follows from deformation. For small strains all of them are Hooke's law.
enum class ElasticLaw {
    corotated,            ///< one frame an element: the strain left when its mean rotation is taken out
    corotated_at_points,  ///< the same with a frame at each quadrature point
    neo_hookean           ///< stable Neo-Hookean at each quadrature point
};

/// A uniform isotropic solid with Rayleigh damping C = alpha M + beta K.
struct ElasticMaterial {
    double young = 1e5;            ///< Young's modulus [Pa], positive
    double poisson = 0.3;          ///< Poisson's ratio, in (-1, 0.5)
    double density = 1000;         ///< [kg/m^3], positive
    double mass_damping = 0;       ///< alpha [1/s], not negative: slows every motion, a free fall too
    double stiffness_damping = 0;  ///< beta [s], not negative: slows deformation only
    ElasticLaw law = ElasticLaw::corotated;
};

/// @throws InputError  a constant that is not finite or outside its range; names it, the range and the value
void check(const ElasticMaterial& material);

/// Hooke's law as sigma = 2 mu eps + lambda tr(eps) I.
struct LameConstants {
    double lambda = 0, mu = 0;  ///< [Pa]
};
LameConstants lame_constants(const ElasticMaterial& material);

/// The same law as the matrix E of sigma = E eps (thesis 3.17), both in the order xx, yy, zz, xy, yz, zx,
/// with the shear strains doubled (gamma = 2 eps).
Eigen::Matrix<double, 6, 6> hooke_matrix(const LameConstants& lame);

}  // namespace enduring
