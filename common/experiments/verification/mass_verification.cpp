#include "common/experiments/verification/mass_verification.hpp"

#include "common/fem/tetrahedron_quadrature.hpp"

namespace enduring::verification {
namespace {

/// Mean over the element of a function of the barycentric coordinates.
template <class Function>
double mean(const Function& function)
{
    double sum = 0;
    for (const auto& [barycentric, weight] : degree_five_quadrature())
        sum += weight * function(barycentric);
    return sum;
}

}  // namespace

//! [lumping]
Table ways_of_lumping()
{
    using Point = Eigen::Vector4d;
    // The basis that is 1 at one node and 0 at the nine others, at a corner and in the middle of an edge ...
    const auto nodal_corner = [](const Point& l) { return l[0] * (2 * l[0] - 1); };
    const auto nodal_edge = [](const Point& l) { return 4 * l[0] * l[1]; };
    // ... and in Bernstein form.
    const auto bernstein_corner = [](const Point& l) { return l[0] * l[0]; };
    const auto bernstein_edge = [](const Point& l) { return 2 * l[0] * l[1]; };
    // Scaled lumping takes the diagonal of the full mass matrix instead, scaled to the right sum.
    const double corner_squared = mean([&](const Point& l) { return nodal_corner(l) * nodal_corner(l); });
    const double edge_squared = mean([&](const Point& l) { return nodal_edge(l) * nodal_edge(l); });
    const double diagonal_sum = 4 * corner_squared + 6 * edge_squared;

    Table table({"lumping", "corner", "edge"});
    table.add({"row sums of the nodal basis", mean(nodal_corner), mean(nodal_edge)});
    table.add(
        {"scaled diagonal of the nodal basis", corner_squared / diagonal_sum, edge_squared / diagonal_sum});
    table.add({"row sums of the Bernstein basis", mean(bernstein_corner), mean(bernstein_edge)});
    return table;
}
//! [lumping]

}  // namespace enduring::verification
