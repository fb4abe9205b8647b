#include "common/fem/point_weights.hpp"

#include "common/fem/basis.hpp"

#include <cmath>

namespace enduring {
namespace {

Eigen::Vector4d barycentric_in(const ElasticMesh& mesh, const ElasticElement& element, const Vec3& point)
{
    Eigen::Vector4d lambda = element.gradients.transpose() * (point - mesh.rest().col(element.nodes[0]));
    lambda[0] += 1;
    return lambda;
}

}  // namespace

//! [point_weights]
std::vector<NodeWeight> point_weights(const ElasticMesh& mesh, const Vec3& point)
{
    constexpr double outside = -1e-6;
    const ElasticElement* holder = nullptr;
    Eigen::Vector4d lambda;
    for (const ElasticElement& element : mesh.elements()) {
        const Eigen::Vector4d here = barycentric_in(mesh, element, point);
        if (here.minCoeff() >= (holder ? lambda.minCoeff() : outside)) {
            holder = &element;
            lambda = here;
        }
    }
    std::vector<NodeWeight> weights;
    if (!holder)
        return weights;
    with_basis(mesh.basis(), [&](auto basis) {
        using B = decltype(basis);
        weights.reserve(B::nodes);
        for (int node = 0; node < B::nodes; ++node) {
            double weight = node < 4 ? 1 : 2;
            for (int corner = 0; corner < 4; ++corner)
                weight *= std::pow(lambda[corner], B::exponent(node, corner));
            weights.push_back({holder->nodes[static_cast<std::size_t>(node)], weight});
        }
    });
    return weights;
}
//! [point_weights]

}  // namespace enduring
