#pragma once

#include "common/fem/elastic_mesh.hpp"
#include "common/geometry/vector.hpp"

#include <array>

namespace enduring {

template <class B>
using PointGradients = std::array<Mat3, B::points>;

/// Gradients of a nodal field at the element's corners (linear: everywhere). For positions: the deformation
/// gradients.
template <class B>
PointGradients<B> corner_gradients(const ElasticElement& element, const NodalVectors& field)
{
    PointGradients<B> result;
    for (int k = 0; k < B::points; ++k) {
        Mat3 d = Mat3::Zero();
        for (int j = 0; j < 4; ++j)
            d.noalias() += field.col(element.nodes[B::corner_tetrahedra[k][j]]) *
                           element.gradients.col(j).transpose();
        result[k] = B::gradient_scale * d;
    }
    return result;
}

}  // namespace enduring
