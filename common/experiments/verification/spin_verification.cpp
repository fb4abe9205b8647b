#include "common/experiments/verification/spin_verification.hpp"

#include "common/experiments/verification/verification_bars.hpp"
#include "common/fem/elastic_body.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace enduring::verification {
namespace {

const Vec3 bar_size(1, 0.2, 0.2);

double energy(const ElasticBody& body) { return body.kinetic_energy() + body.elastic_energy(); }

//! [stretch]
/// The first step moves every node along its tangent, p to p + dt omega x p: a rotation by
/// atan(theta) and a stretch of the plane of rotation by sqrt(1 + theta^2). The elements, still in
/// their old rotation, cannot see the stretch, so no force answers it. The new rotations do see
/// it: energy 2 (lambda + mu) strain^2 a volume, out of nothing.
double first_step_growth(const ElasticBody& body, double theta, double start)
{
    const LameConstants lame = lame_constants(body.material());
    const double strain = std::sqrt(1 + theta * theta) - 1;
    return 2 * (lame.lambda + lame.mu) * strain * strain * body.mesh().volume() / start;
}
//! [stretch]

}  // namespace

SpinGrowth spin(const SpinningBar& bar_of)
{
    const ElasticMaterial material{.young = bar_of.young, .poisson = 0.3};
    ElasticBody body(ElasticMesh(with_edge_midpoints(bar(bar_size, {5, 1, 1}))), material,
                     {.freeze_rotations = bar_of.freeze_rotations});
    const Vec3 omega(0, bar_of.omega_dt / bar_of.dt, 0);
    for (int n = 0; n < body.node_count(); ++n)
        body.velocities().col(n) = omega.cross(Vec3(body.positions().col(n)));
    const double start = energy(body);
    const Vec3 angular_start = body.angular_momentum(Vec3::Zero());

    SpinGrowth growth;
    growth.first_step_formula = first_step_growth(body, bar_of.omega_dt, start);
    for (int step = 0; step < bar_of.steps; ++step) {
        body.predict(Vec3::Zero(), bar_of.dt);
        body.commit(bar_of.dt);
        growth.final_energy = energy(body) / start;
        if (step == 0)
            growth.first_step = growth.final_energy - 1;
        growth.largest = std::max(growth.largest, growth.final_energy - 1);
        growth.linear_momentum = std::max(growth.linear_momentum,
                                          body.linear_momentum().norm() / (body.mass() * 0.5 * omega.norm()));
    }
    growth.angular_momentum =
        body.angular_momentum(body.centre_of_mass()).dot(angular_start) / angular_start.squaredNorm() - 1;
    return growth;
}

Table spinning_bar_growth()
{
    Table table({"young_pa", "omega_dt", "first_step_percent", "formula_percent", "largest_percent",
                 "final_percent", "angular_percent"});
    for (double young : {1e5, 1e6, 2.5e6, 1e7})
        for (double omega_dt : {0.0125, 0.025, 0.05, 0.1, 0.2}) {
            const SpinGrowth growth = spin({.young = young, .omega_dt = omega_dt});
            table.add({young, omega_dt, 100 * growth.first_step, 100 * growth.first_step_formula,
                       100 * growth.largest, 100 * (growth.final_energy - 1), 100 * growth.angular_momentum});
        }
    return table;
}

}  // namespace enduring::verification
