#include "common/fem/point_elasticity.hpp"

#include "common/fem/corner_gradients.hpp"
#include "common/fem/point_laws.hpp"
#include "common/input/input_error.hpp"

namespace enduring {
namespace {

//! [points]
/// A quadratic element is strained at its four corners and at its centroid. With these weights of its volume
/// the rule is exact for products of two barycentric coordinates: 1/20 + 4/5 * 1/16 = 1/10 for a square, 4/5
/// * 1/16 = 1/20 else.
constexpr double corner_weight = 1.0 / 20, centroid_weight = 4.0 / 5;

template <class B>
constexpr int strained_points = B::points == 1 ? 1 : B::points + 1;

template <class B>
constexpr double weight(int point)
{
    return B::points == 1 ? 1 : point < B::points ? corner_weight : centroid_weight;
}

/// What the gradient at a corner has of that at a point: the centroid's is the mean of all.
template <class B>
constexpr double corner_share(int point, int corner)
{
    return point == B::points ? 1.0 / B::points : point == corner ? 1 : 0;
}
//! [points]

template <class B>
using StrainedPoints = std::array<Mat3, strained_points<B>>;

template <class B>
StrainedPoints<B> gradients_at_points(const ElasticElement& element, const NodalVectors& field)
{
    const PointGradients<B> corners = corner_gradients<B>(element, field);
    StrainedPoints<B> result;
    result.back().setZero();
    for (int k = 0; k < B::points; ++k) {
        result.back() += corners[k] / B::points;
        if (B::points > 1)
            result[k] = corners[k];
    }
    return result;
}

/// result += scale times the forces of these stresses.
template <class B>
void add_forces_of(const StrainedPoints<B>& stresses, const ElasticElement& element, double scale,
                   NodalVectors& result)
{
    const Mat3 of_all = weight<B>(strained_points<B> - 1) / B::points * stresses.back();
    for (int k = 0; k < B::points; ++k) {
        Mat3 stress = of_all;
        if (B::points > 1)
            stress += weight<B>(k) * stresses[k];
        const Mat3 pull = (scale * element.volume * B::gradient_scale) * stress;
        for (int j = 0; j < 4; ++j)
            result.col(element.nodes[B::corner_tetrahedra[k][j]]).noalias() += pull *
                                                                               element.gradients.col(j);
    }
}

/// Gradients of the basis functions at a point, one a column.
template <class B>
Eigen::Matrix<double, 3, B::nodes> basis_gradients(const ElasticElement& element, int point)
{
    Eigen::Matrix<double, 3, B::nodes> gradients = Eigen::Matrix<double, 3, B::nodes>::Zero();
    for (int k = 0; k < B::points; ++k)
        for (int j = 0; j < 4; ++j)
            gradients.col(B::corner_tetrahedra[k][j]) += corner_share<B>(point, k) * B::gradient_scale *
                                                         element.gradients.col(j);
    return gradients;
}

/// result += scale times int grad phi_a . map . grad phi_b for all pairs of nodes.
template <class B>
void add_stiffness_at(const GradientMap& map, const Eigen::Matrix<double, 3, B::nodes>& gradients,
                      double scale, Eigen::MatrixXd& result)
{
    for (int b = 0; b < B::nodes; ++b) {
        Eigen::Matrix<double, 9, 3> stress = Eigen::Matrix<double, 9, 3>::Zero();  // by moving node b
        for (int l = 0; l < 3; ++l)
            stress += (scale * gradients(l, b)) * map.middleCols<3>(3 * l);
        for (int a = 0; a < B::nodes; ++a)
            for (int j = 0; j < 3; ++j)
                result.block<3, 3>(3 * a, 3 * b) += gradients(j, a) * stress.middleRows<3>(3 * j);
    }
}

template <class Law>
class PointElasticity final : public Elasticity {
public:
    PointElasticity(const ElasticMesh& mesh, const Law& law, const ElementRotations& rotations)
        : Elasticity(mesh, rotations), law_(law)
    {
        linearise(mesh.rest());
    }

    void linearise(const NodalVectors& positions) override
    {
        stiffness_.clear();
        with_basis(mesh_.basis(), [&]<class B>(B) {
            stiffness_.reserve(strained_points<B> * mesh_.elements().size());
            for (const ElasticElement& element : mesh_.elements())
                for (const Mat3& gradient : gradients_at_points<B>(element, positions))
                    stiffness_.push_back(law_.stiffness(gradient));
        });
    }

    void add_forces(const NodalVectors& positions, NodalVectors& forces) const override
    {
        with_basis(mesh_.basis(), [&]<class B>(B) {
            for (const ElasticElement& element : mesh_.elements()) {
                StrainedPoints<B> values = gradients_at_points<B>(element, positions);
                for (Mat3& value : values)
                    value = law_.stress(value);
                add_forces_of<B>(values, element, -1, forces);
            }
        });
    }

    void add_stiffness_times(const NodalVectors& v, double scale, NodalVectors& result) const override
    {
        with_basis(mesh_.basis(), [&]<class B>(B) {
            auto map = stiffness_.begin();
            for (const ElasticElement& element : mesh_.elements()) {
                StrainedPoints<B> values = gradients_at_points<B>(element, v);
                for (Mat3& value : values)
                    value.reshaped() = (*map++ * value.reshaped()).eval();
                add_forces_of<B>(values, element, scale, result);
            }
        });
    }

    double energy(const NodalVectors& positions) const override
    {
        return with_basis(mesh_.basis(), [&]<class B>(B) {
            double sum = 0;
            for (const ElasticElement& element : mesh_.elements()) {
                const StrainedPoints<B> gradients = gradients_at_points<B>(element, positions);
                for (int q = 0; q < strained_points<B>; ++q)
                    sum += weight<B>(q) * element.volume * law_.energy(gradients[q]);
            }
            return sum;
        });
    }

    Eigen::MatrixXd stiffness_of(int element) const override
    {
        return with_basis(mesh_.basis(), [&]<class B>(B) {
            Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * B::nodes, 3 * B::nodes);
            const ElasticElement& own = mesh_.elements()[element];
            for (int q = 0; q < strained_points<B>; ++q)
                add_stiffness_at<B>(stiffness_[strained_points<B> * element + q], basis_gradients<B>(own, q),
                                    weight<B>(q) * own.volume, result);
            return result;
        });
    }

    Mat3 axes_of(int) const override { return Mat3::Identity(); }

private:
    Law law_;
    std::vector<GradientMap> stiffness_;  ///< of each point, element by element
};

}  // namespace

std::unique_ptr<Elasticity> point_elasticity(ElasticLaw law, const ElasticMesh& mesh,
                                             const LameConstants& lame, const ElementRotations& rotations)
{
    switch (law) {
        case ElasticLaw::corotated_at_points:
            return std::make_unique<PointElasticity<CorotatedLaw>>(mesh, CorotatedLaw(lame), rotations);
        case ElasticLaw::neo_hookean:
            return std::make_unique<PointElasticity<NeoHookeanLaw>>(mesh, NeoHookeanLaw(lame), rotations);
        case ElasticLaw::corotated: break;
    }
    throw InputError("the corotated law has one frame an element, so it is not taken at points");
}

}  // namespace enduring
