#pragma once

#include "common/geometry/meshes.hpp"

#include <array>

namespace enduring {

/// How the displacement varies inside a tetrahedron.
enum class Basis { linear, quadratic };

/// What the element loops need to know of a basis, at compile time.
///
/// Both bases are made of *corner tetrahedra*: four nodes c_0..c_3 whose differences give a gradient, D =
/// sum_j c_j (grad lambda_j)^T. A linear element is one of them. A quadratic element in Bernstein form has
/// ten control points, and its gradient varies linearly between the values 2 D_k at the four corners, where
/// D_k belongs to the control points next to corner k. So a quadratic element is four linear ones of half the
/// size, coupled by the integrals of lambda_k lambda_l.
//! [bases]
struct LinearBasis {
    static constexpr int nodes = 4, points = 1;
    static constexpr std::array<std::array<int, 4>, points> corner_tetrahedra{{{0, 1, 2, 3}}};
    static constexpr double gradient_scale = 1;
    /// Mean over the element of the product of the weights of points k and l.
    static constexpr double coupling(int, int) { return 1; }
    /// Power of a barycentric coordinate in a node's basis function.
    static constexpr int exponent(int node, int corner) { return node == corner ? 1 : 0; }
    /// Product of the exponents' binomials, summed over all pairs of nodes.
    static constexpr double ways_in_all = 20;
};

struct QuadraticBasis {
    // control points of edges 01, 12, 02, 03, 13, 23 are nodes 4 to 9
    static constexpr int nodes = 10, points = 4;
    static constexpr std::array<std::array<int, 4>, points> corner_tetrahedra{
        {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}}};
    static constexpr double gradient_scale = 2;
    static constexpr double coupling(int k, int l) { return (k == l ? 2.0 : 1.0) / 20; }
    static constexpr int exponent(int node, int corner)
    {
        if (node < 4)
            return node == corner ? 2 : 0;
        const auto& edge = tetrahedron_edges[node - 4];
        return edge[0] == corner || edge[1] == corner ? 1 : 0;
    }
    static constexpr double ways_in_all = 210;
};
//! [bases]

constexpr int nodes_of(Basis basis)
{
    return basis == Basis::linear ? LinearBasis::nodes : QuadraticBasis::nodes;
}

/// Calls work(LinearBasis{}) or work(QuadraticBasis{}).
template <class Work>
auto with_basis(Basis basis, const Work& work)
{
    return basis == Basis::linear ? work(LinearBasis{}) : work(QuadraticBasis{});
}

}  // namespace enduring
