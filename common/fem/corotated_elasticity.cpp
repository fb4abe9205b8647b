#include "common/fem/corotated_elasticity.hpp"

#include "common/fem/corner_gradients.hpp"
#include "common/fem/polar_rotation.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>

namespace enduring {
namespace {

/// Values at the points become integrals of the field against each point's weight, per volume.
template <class B>
void couple(PointGradients<B>& values)
{
    if constexpr (B::points > 1) {
        Mat3 sum = Mat3::Zero();
        for (const Mat3& value : values)
            sum += value;
        for (Mat3& value : values)
            value = B::coupling(0, 1) * (sum + value);
    }
}

Mat3 stress(const Mat3& strain, const LameConstants& lame)
{
    Mat3 sigma = 2 * lame.mu * strain;
    sigma.diagonal().array() += lame.lambda * strain.trace();
    return sigma;
}

Mat3 symmetric_part(const Mat3& a) { return 0.5 * (a + a.transpose()); }

//! [force]
/// Turn the gradients back, take the Cauchy strain, Hooke's stress,
/// turn it forward, and hand it to the nodes.
template <class B>
void add_element_forces(const ElasticElement& element, const Mat3& rotation, const LameConstants& lame,
                        const Mat3& unstrained, double scale, const NodalVectors& field, NodalVectors& forces)
{
    PointGradients<B> gradients = corner_gradients<B>(element, field);
    for (Mat3& gradient : gradients)
        gradient = symmetric_part(rotation.transpose() * gradient) - unstrained;
    couple<B>(gradients);
    for (int k = 0; k < B::points; ++k) {
        const Mat3 pull = (scale * element.volume * B::gradient_scale) * rotation *
                          stress(gradients[k], lame);
        for (int j = 0; j < 4; ++j)
            forces.col(element.nodes[B::corner_tetrahedra[k][j]]).noalias() += pull *
                                                                               element.gradients.col(j);
    }
}
//! [force]

/// The strains of xx, yy, zz, xy, yz, zx that moving node j of corner
/// tetrahedron k makes there: a part of B_k.
Eigen::Matrix<double, 6, 3> strain_of_node(const Vec3& g)
{
    Eigen::Matrix<double, 6, 3> b;
    b << g.x(), 0, 0, 0, g.y(), 0, 0, 0, g.z(), g.y(), g.x(), 0, 0, g.z(), g.y(), g.z(), 0, g.x();
    return b;
}

//! [stiffness]
template <class B>
Eigen::MatrixXd stiffness_of(const ElasticElement& element, const Eigen::Matrix<double, 6, 6>& hooke)
{
    using StrainMatrix = Eigen::Matrix<double, 6, 3 * B::nodes>;
    std::array<StrainMatrix, B::points> b;
    for (int k = 0; k < B::points; ++k) {
        b[k].setZero();
        for (int j = 0; j < 4; ++j)
            b[k].template middleCols<3>(3 * B::corner_tetrahedra[k][j]) =
                B::gradient_scale * strain_of_node(element.gradients.col(j));
    }
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * B::nodes, 3 * B::nodes);
    for (int k = 0; k < B::points; ++k) {
        StrainMatrix coupled = StrainMatrix::Zero();
        for (int l = 0; l < B::points; ++l)
            coupled += B::coupling(k, l) * b[l];
        const StrainMatrix stress = element.volume * hooke * coupled;
        stiffness.noalias() += b[k].transpose() * stress;
    }
    return stiffness;
}
//! [stiffness]

}  // namespace

void find_rotations(const ElasticMesh& mesh, const NodalVectors& positions, ElementRotations& rotations)
{
    rotations.resize(mesh.elements().size());
    with_basis(mesh.basis(), [&]<class B>(B) {
        for (std::size_t e = 0; e < rotations.size(); ++e) {
            Mat3 mean = Mat3::Zero();
            for (const Mat3& gradient : corner_gradients<B>(mesh.elements()[e], positions))
                mean += gradient / B::points;
            rotations[e] = polar_rotation(mean);
        }
    });
}

bool is_inverted(Basis basis, const ElasticElement& element, const NodalVectors& positions)
{
    return with_basis(basis, [&]<class B>(B) {
        const auto gradients = corner_gradients<B>(element, positions);
        return std::any_of(gradients.begin(), gradients.end(),
                           [](const Mat3& gradient) { return !(gradient.determinant() > 0); });
    });
}

int inverted_elements(const ElasticMesh& mesh, const NodalVectors& positions)
{
    return static_cast<int>(std::count_if(
        mesh.elements().begin(), mesh.elements().end(),
        [&](const ElasticElement& element) { return is_inverted(mesh.basis(), element, positions); }));
}

Eigen::MatrixXd element_stiffness(const ElasticMesh& mesh, int element,
                                  const Eigen::Matrix<double, 6, 6>& hooke)
{
    return with_basis(mesh.basis(),
                      [&]<class B>(B) { return stiffness_of<B>(mesh.elements()[element], hooke); });
}

Eigen::MatrixXd CorotatedElasticity::stiffness_of(int element) const
{
    return element_stiffness(mesh_, element, hooke_matrix(lame_));
}

void CorotatedElasticity::add_forces(const NodalVectors& positions, NodalVectors& forces) const
{
    with_basis(mesh_.basis(), [&]<class B>(B) {
        for (std::size_t e = 0; e < rotations_.size(); ++e)
            add_element_forces<B>(mesh_.elements()[e], rotations_[e], lame_, Mat3::Identity(), -1, positions,
                                  forces);
    });
}

void CorotatedElasticity::add_stiffness_times(const NodalVectors& v, double scale, NodalVectors& result) const
{
    with_basis(mesh_.basis(), [&]<class B>(B) {
        for (std::size_t e = 0; e < rotations_.size(); ++e)
            add_element_forces<B>(mesh_.elements()[e], rotations_[e], lame_, Mat3::Zero(), scale, v, result);
    });
}

double CorotatedElasticity::energy(const NodalVectors& positions) const
{
    return with_basis(mesh_.basis(), [&]<class B>(B) {
        double sum = 0;
        for (std::size_t e = 0; e < rotations_.size(); ++e) {
            const ElasticElement& element = mesh_.elements()[e];
            PointGradients<B> strains = corner_gradients<B>(element, positions);
            for (Mat3& strain : strains)
                strain = symmetric_part(rotations_[e].transpose() * strain) - Mat3::Identity();
            PointGradients<B> weighted = strains;
            couple<B>(weighted);
            for (int k = 0; k < B::points; ++k)
                sum += 0.5 * element.volume * stress(weighted[k], lame_).cwiseProduct(strains[k]).sum();
        }
        return sum;
    });
}

}  // namespace enduring
