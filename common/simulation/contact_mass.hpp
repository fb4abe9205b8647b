#pragma once

#include <Eigen/Core>

namespace enduring {

/// Mass matrix A of a body's coordinates in contact, and how they answer: an impulse P on them changes them
/// by A^-1 P. Who asks needs both, and each body knows one of them best.
struct ContactMass {
    Eigen::MatrixXd mass;      ///< A
    Eigen::MatrixXd response;  ///< A^-1
};

}  // namespace enduring
