#include "common/fem/mass_matrix.hpp"

#include <array>
#include <vector>

namespace enduring {
namespace {

//! [mass_share]
/// (a + b)! / (a! b!): in how many ways a factor lambda^(a + b) of a
/// product comes from lambda^a and lambda^b.
constexpr std::array<std::array<int, 3>, 3> ways{{{1, 1, 1}, {1, 2, 3}, {1, 3, 6}}};

template <class B>
double share(int i, int j)
{
    int count = 1;
    for (int corner = 0; corner < 4; ++corner)
        count *= ways[B::exponent(i, corner)][B::exponent(j, corner)];
    return count / B::ways_in_all;
}
//! [mass_share]

}  // namespace

double mass_share(Basis basis, int i, int j)
{
    return with_basis(basis, [&]<class B>(B) { return share<B>(i, j); });
}

Eigen::SparseMatrix<double> mass_matrix(const ElasticMesh& mesh, double density)
{
    const int per_element = nodes_of(mesh.basis());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(mesh.elements().size() * static_cast<std::size_t>(per_element * per_element));
    for (const ElasticElement& element : mesh.elements())
        for (int i = 0; i < per_element; ++i)
            for (int j = 0; j < per_element; ++j)
                entries.emplace_back(element.nodes[i], element.nodes[j],
                                     density * element.volume * mass_share(mesh.basis(), i, j));
    Eigen::SparseMatrix<double> masses(mesh.node_count(), mesh.node_count());
    masses.setFromTriplets(entries.begin(), entries.end());  // sums what several elements give
    return masses;
}

Eigen::VectorXd lumped_masses(const Eigen::SparseMatrix<double>& mass_matrix)
{
    return mass_matrix * Eigen::VectorXd::Ones(mass_matrix.cols());
}

}  // namespace enduring
