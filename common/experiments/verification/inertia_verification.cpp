#include "common/experiments/verification/inertia_verification.hpp"

#include "common/experiments/verification/verification_bars.hpp"
#include "common/fem/tetrahedron_quadrature.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/input/source_directory.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace enduring::verification {
namespace {

/// From the second moments int rho x x^T dV: J = tr - them.
Mat3 inertia_of(const Mat3& second_moments)
{
    return second_moments.trace() * Mat3::Identity() - second_moments;
}

/// The integral over the volume, about the centre of all positions.
Mat3 exact_inertia(const ElasticMesh& mesh, double density, const Vec3& centre)
{
    Mat3 sum = Mat3::Zero();
    for (const ElasticElement& element : mesh.elements())
        for (const auto& [barycentric, weight] : degree_five_quadrature()) {
            Vec3 lever = -centre;
            for (int i = 0; i < 4; ++i)
                lever += barycentric[i] * mesh.rest().col(element.nodes[i]);
            sum += density * element.volume * weight * lever * lever.transpose();
        }
    return inertia_of(sum);
}

struct InertiaRatios {
    Vec3 lumped, consistent;  ///< about x, y and z
};

InertiaRatios ratios_of(const TetrahedralMesh& tetrahedra, Basis basis)
{
    const ElasticBody body(with_elements(tetrahedra, basis), {});
    const Eigen::SparseMatrix<double> lumps(body.masses().asDiagonal());
    const Vec3 exact = exact_inertia(body.mesh(), body.material().density, body.centre_of_mass()).diagonal();
    return {inertia(lumps, body.positions()).diagonal().cwiseQuotient(exact),
            inertia(body.mass_matrix(), body.positions()).diagonal().cwiseQuotient(exact)};
}

double farthest_from_one(const Vec3& ratios)
{
    Eigen::Index worst = 0;
    (ratios.array() - 1).abs().maxCoeff(&worst);
    return ratios[worst];
}

TetrahedralMesh bunny(int elements)
{
    return read_gmsh(source_directory() / "common/meshes" / ("bunny_" + std::to_string(elements) + ".msh"));
}

}  // namespace

Mat3 inertia(const Eigen::SparseMatrix<double>& masses, const NodalVectors& positions)
{
    const Eigen::VectorXd of_nodes = lumped_masses(masses);
    const NodalVectors levers = positions.colwise() - Vec3(positions * of_nodes / of_nodes.sum());
    return inertia_of(levers * masses * levers.transpose());
}

Table inertia_ratios()
{
    const std::vector<std::pair<std::string, TetrahedralMesh>> shapes{
        {"bar of bar_on_cube, 3 x 0.4 x 0.4 m, 8 x 1 x 1 cells", bar({3, 0.4, 0.4}, {8, 1, 1})},
        {"the same, 16 x 2 x 2 cells", bar({3, 0.4, 0.4}, {16, 2, 2})},
        {"bar of bar_friction, 3 x 0.3 x 0.8 m, 12 x 1 x 3 cells", bar({3, 0.3, 0.8}, {12, 1, 3})},
        {"bunny, 363 elements", bunny(363)},
        {"bunny, 785 elements", bunny(785)},
        {"bunny, 1452 elements", bunny(1452)}};
    Table table({"shape", "basis", "lumped_x", "lumped_y", "lumped_z", "consistent"});
    for (const auto& [name, mesh] : shapes)
        for (Basis basis : both_bases) {
            const auto [lumped, consistent] = ratios_of(mesh, basis);
            table.add(
                {name, name_of(basis), lumped.x(), lumped.y(), lumped.z(), farthest_from_one(consistent)});
        }
    return table;
}

Table inertia_over_cells()
{
    Table table({"cells_across", "linear", "quadratic", "consistent"});
    for (int across : {1, 2, 3, 4, 6}) {
        const TetrahedralMesh mesh = bar({3, 0.4, 0.4}, {8 * across, across, across});
        const InertiaRatios linear = ratios_of(mesh, Basis::linear),
                            quadratic = ratios_of(mesh, Basis::quadratic);
        table.add({long{across}, linear.lumped.x(), quadratic.lumped.x(), quadratic.consistent.x()});
    }
    return table;
}

}  // namespace enduring::verification
