#pragma once

#include "common/fem/material.hpp"
#include "common/geometry/vector.hpp"

#include <Eigen/Core>

namespace enduring {

/// A linear map of gradients, which are read column by column.
using GradientMap = Eigen::Matrix<double, 9, 9>;

// What a material stores and how it pulls, as functions of the deformation gradient F at one point.

/// Hooke's law of the stretch alone: with F = R S, psi = mu |S - 1|^2 + lambda/2 tr(S - 1)^2.
class CorotatedLaw {
public:
    explicit CorotatedLaw(const LameConstants& lame) : lame_(lame) {}

    double energy(const Mat3& f) const;  ///< psi [J/m^3], zero at rest
    Mat3 stress(const Mat3& f) const;    ///< d psi / dF, first Piola and Kirchhoff's [Pa]
    /// Derivative of the stress with R held: positive semidefinite for every F.
    GradientMap stiffness(const Mat3& f) const;

private:
    LameConstants lame_;
};

/// Stable Neo-Hookean: psi = mu/2 (|F|^2 - 3) - mu/2 log(|F|^2 + 1) + lambda/2 (det F - alpha)^2, up to a
/// constant. It is finite and smooth also for F that are flat or inverted.
/// @see Smith, de Goes, Kim 2018, equations 13 to 16, and section 4 for the eigenvectors of its stiffness
class NeoHookeanLaw {
public:
    /// @param lame  Hooke's: for small strains the two laws are the same
    explicit NeoHookeanLaw(const LameConstants& lame);

    double energy(const Mat3& f) const;
    Mat3 stress(const Mat3& f) const;
    /// Derivative of the stress without the part that has negative eigenvalues.
    GradientMap stiffness(const Mat3& f) const;

private:
    double lambda_, mu_, alpha_;
};

}  // namespace enduring
