#include "common/experiments/verification/static_verification.hpp"

#include "common/experiments/verification/verification_bars.hpp"
#include "common/fem/tetrahedron_quadrature.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace enduring::verification {
namespace {

using std::numbers::pi;

/// Long against every period of vibration: inertia is (omega dt)^-2 of the stiffness.
constexpr double eternity = 1e6;

}  // namespace

NodalVectors static_displacement(ElasticBody& body, const NodalVectors& forces)
{
    const NodalVectors positions = body.positions(), velocities = body.velocities(),
                       others = body.external_forces();
    body.velocities().setZero();
    body.external_forces() = forces;
    body.predict(Vec3::Zero(), eternity);
    const NodalVectors displacement = eternity * body.velocities();
    body.positions() = positions;
    body.velocities() = velocities;
    body.external_forces() = others;
    return displacement;
}

Eigen::VectorXd face_weights(const ElasticMesh& mesh, const std::function<bool(const Vec3&)>& on_face)
{
    const int per_face = mesh.basis() == Basis::linear ? 3 : 6;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.node_count());
    for (const ElasticElement& element : mesh.elements())
        for (const auto& face : tetrahedron_faces) {
            std::array<Vec3, 3> corner;
            for (std::size_t i = 0; i < 3; ++i)
                corner[i] = mesh.rest().col(element.nodes[face[i]]);
            if (!on_face(corner[0]) || !on_face(corner[1]) || !on_face(corner[2]))
                continue;
            const double area = 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
            for (int node = 0; node < nodes_of(mesh.basis()); ++node)
                if (on_face(mesh.rest().col(element.nodes[node])))
                    weights[element.nodes[node]] += area / per_face;
        }
    return weights;
}

//! [cantilever]
Table cantilever()
{
    const double length = 1, thickness = 0.1, force = 0.01;
    const ElasticMaterial material{.young = 1e6, .poisson = 0.3};
    const double area = thickness * thickness, inertia = std::pow(thickness, 4) / 12;
    const double shear_modulus = lame_constants(material).mu;
    const double shear_coefficient = 10 * (1 + material.poisson) / (12 + 11 * material.poisson);
    const double theory = force * std::pow(length, 3) / (3 * material.young * inertia) +
                          force * length / (shear_coefficient * shear_modulus * area);

    Table table({"basis", "cells_along", "unknowns", "deflection_m", "theory_m", "ratio"});
    for (Basis basis : {Basis::linear, Basis::quadratic})
        for (int across : {1, 2}) {
            const auto body = clamped_bar(length, thickness, {10 * across, across, across}, basis, material);
            const Eigen::VectorXd tip =
                face_weights(body->mesh(), [&](const Vec3& p) { return p.x() > 0.5 * length - 1e-9; }) / area;
            const NodalVectors u = static_displacement(*body, Vec3(0, -force, 0) * tip.transpose());
            const double deflection = -u.row(1).dot(tip);
            table.add({name_of(basis), 10L * across, 3L * body->node_count(), deflection, theory,
                       deflection / theory});
        }
    return table;
}
//! [cantilever]

namespace {

/// Of the centre of mass of a bar that is clamped at one end, under its own weight: the mean over its length
/// of the deflection by bending and by shear (Timoshenko; Cowper's coefficient) [m].
double theory_of_sag(double length, double thickness, double weight, const ElasticMaterial& material)
{
    const double inertia = std::pow(thickness, 4) / 12, area = thickness * thickness,
                 shear_coefficient = 10 * (1 + material.poisson) / (12 + 11 * material.poisson);
    return weight * std::pow(length, 3) / (20 * material.young * inertia) +
           weight * length / (3 * shear_coefficient * lame_constants(material).mu * area);
}

}  // namespace

Table locking()
{
    constexpr double length = 1, thickness = 0.1, gravity = 0.3;
    struct Kind {
        Basis basis;
        CellSplit split;
        const char* name;
    };
    Table table({"basis", "split", "poisson", "sag_mm", "theory_mm", "ratio", "sideways_percent"});
    for (const auto& [basis, split, name] : {Kind{Basis::linear, CellSplit::six, "six"},
                                             {Basis::linear, CellSplit::five, "five"},
                                             {Basis::quadratic, CellSplit::six, "six"},
                                             {Basis::quadratic, CellSplit::five, "five"}})
        for (const double poisson : {0.0, 0.3, 0.4, 0.45, 0.495}) {
            const ElasticMaterial material{.young = 1e6, .poisson = poisson, .density = 1000};
            const auto body = clamped_bar(length, thickness, {10, 2, 2}, basis, material, split);
            const NodalVectors u = static_displacement(*body,
                                                       Vec3(0, -gravity, 0) * body->masses().transpose());
            const Vec3 moved = u * body->masses() / body->mass();
            const double theory = theory_of_sag(length, thickness, gravity * body->mass(), material);
            table.add({name_of(basis), std::string(name), poisson, -1000 * moved.y(), 1000 * theory,
                       -moved.y() / theory, 100 * std::abs(moved.z() / moved.y())});
        }
    return table;
}

namespace {

/// u = amplitude sin(pi x) sin(pi y) sin(pi z) on the unit cube, zero on its surface.
struct SineBubble {
    Vec3 amplitude{1, -0.5, 0.8};

    Vec3 value(const Vec3& p) const
    {
        return amplitude * std::sin(pi * p.x()) * std::sin(pi * p.y()) * std::sin(pi * p.z());
    }

    Vec3 gradient_of_bubble(const Vec3& p) const
    {
        const Vec3 s = (pi * p).array().sin(), c = (pi * p).array().cos();
        return pi * Vec3(c.x() * s.y() * s.z(), s.x() * c.y() * s.z(), s.x() * s.y() * c.z());
    }

    Mat3 hessian_of_bubble(const Vec3& p) const
    {
        const Vec3 s = (pi * p).array().sin(), c = (pi * p).array().cos();
        const double xx = -s.prod(), xy = c.x() * c.y() * s.z(), yz = s.x() * c.y() * c.z(),
                     zx = c.x() * s.y() * c.z();
        Mat3 h;
        h << xx, xy, zx, xy, xx, yz, zx, yz, xx;
        return pi * pi * h;
    }

    /// The force density that holds it in equilibrium, -div sigma = -mu lap u - (lambda + mu) grad div u.
    Vec3 load(const Vec3& p, const LameConstants& lame) const
    {
        const Mat3 h = hessian_of_bubble(p);
        return -lame.mu * h.trace() * amplitude - (lame.lambda + lame.mu) * h * amplitude;
    }
};

double basis_function(Basis basis, int node, const Eigen::Vector4d& l)
{
    if (basis == Basis::linear)
        return l[node];
    return node < 4 ? l[node] * l[node]
                    : 2 * l[tetrahedron_edges[node - 4][0]] * l[tetrahedron_edges[node - 4][1]];
}

/// Calls visit(element, barycentric, position, weight in m^3) over the whole mesh.
template <class Visit>
void integrate(const ElasticMesh& mesh, const Visit& visit)
{
    for (const ElasticElement& element : mesh.elements())
        for (const auto& [barycentric, weight] : degree_five_quadrature()) {
            Vec3 position = Vec3::Zero();
            for (int i = 0; i < 4; ++i)
                position += barycentric[i] * mesh.rest().col(element.nodes[i]);
            visit(element, barycentric, position, weight * element.volume);
        }
}

Vec3 field_at(Basis basis, const ElasticElement& element, const NodalVectors& field,
              const Eigen::Vector4d& barycentric)
{
    Vec3 value = Vec3::Zero();
    for (int node = 0; node < nodes_of(basis); ++node)
        value += basis_function(basis, node, barycentric) * field.col(element.nodes[node]);
    return value;
}

/// By central differences, exact for a field of degree two.
Mat3 gradient_at(Basis basis, const ElasticElement& element, const NodalVectors& field,
                 const Eigen::Vector4d& barycentric)
{
    Mat3 result;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector4d step = 0.01 * element.gradients.row(axis).transpose();
        result.col(axis) = (field_at(basis, element, field, barycentric + step) -
                            field_at(basis, element, field, barycentric - step)) /
                           0.02;
    }
    return result;
}

struct SpatialError {
    double value = 0, gradient = 0;
};

SpatialError error_on_cube(Basis basis, int cells)
{
    TetrahedralMesh cube = bar({1, 1, 1}, {cells, cells, cells});
    for (Vec3& node : cube.nodes)
        node += Vec3::Constant(0.5);
    const ElasticMaterial material{.young = 1, .poisson = 0.3, .density = 1};
    ElasticBody body(with_elements(cube, basis), material, {.freeze_rotations = true});
    for (int n = 0; n < body.node_count(); ++n)
        if ((body.positions().col(n).array() - 0.5).abs().maxCoeff() > 0.5 - 1e-9)
            body.fix(n);

    const SineBubble exact;
    NodalVectors load = NodalVectors::Zero(3, body.node_count());
    integrate(body.mesh(),
              [&](const ElasticElement& element, const Eigen::Vector4d& l, const Vec3& p, double weight) {
                  for (int node = 0; node < nodes_of(basis); ++node)
                      load.col(element.nodes[node]) += weight * basis_function(basis, node, l) *
                                                       exact.load(p, lame_constants(material));
              });
    const NodalVectors u = static_displacement(body, load);

    SpatialError error;
    integrate(body.mesh(),
              [&](const ElasticElement& element, const Eigen::Vector4d& l, const Vec3& p, double weight) {
                  error.value += weight * (field_at(basis, element, u, l) - exact.value(p)).squaredNorm();
                  const Mat3 gradient = exact.amplitude * exact.gradient_of_bubble(p).transpose();
                  error.gradient += weight * (gradient_at(basis, element, u, l) - gradient).squaredNorm();
              });
    return {std::sqrt(error.value), std::sqrt(error.gradient)};
}

}  // namespace

Table convergence_in_space()
{
    Table table({"basis", "cells", "l2_error", "gradient_error", "l2_order", "gradient_order"});
    for (Basis basis : {Basis::linear, Basis::quadratic}) {
        SpatialError coarse;
        int coarse_cells = 0;
        for (int cells : basis == Basis::linear ? std::vector{4, 8, 12} : std::vector{2, 4, 6}) {
            const SpatialError fine = error_on_cube(basis, cells);
            const double refinement = coarse_cells > 0 ? std::log(double(cells) / coarse_cells) : 1;
            const auto order = [&](double before, double after) -> Cell {  // an order needs two meshes
                return coarse_cells > 0 ? Cell{std::log(before / after) / refinement} : Cell{"-"};
            };
            table.add({name_of(basis), long{cells}, fine.value, fine.gradient,
                       order(coarse.value, fine.value), order(coarse.gradient, fine.gradient)});
            coarse = fine;
            coarse_cells = cells;
        }
    }
    return table;
}

}  // namespace enduring::verification
