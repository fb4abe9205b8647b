#include "common/experiments/verification/hard_verification.hpp"

#include "common/experiments/verification/verification_bars.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace enduring::verification {
namespace {

constexpr ElasticLaw all_laws[] = {ElasticLaw::corotated, ElasticLaw::corotated_at_points,
                                   ElasticLaw::neo_hookean};

double all_energy(const ElasticBody& body) { return body.kinetic_energy() + body.elastic_energy(); }

/// Which nodes are held, and where a held node that moves is at the share s in [0, 1] of its path.
struct Grip {
    int axis;       ///< both faces across it are held
    double half;    ///< of the size along it [m]
    double period;  ///< of the deformation [s]
    Vec3 (*place)(const Vec3& rest, double s);
};

bool is_at(const ElasticMesh& mesh, int node, const Grip& grip, double side)
{
    return side * mesh.rest()(grip.axis, node) > grip.half - 1e-9;
}

/// Moves the upper face, then goes on with a body of which the lower face alone is held.
HardOutcome deform(const ElasticMesh& mesh, const HardLoad& load, double poisson, const Grip& grip)
{
    const ElasticMaterial material{
        .young = load.young, .poisson = poisson, .stiffness_damping = 0.002, .law = load.law};
    ElasticBody held(mesh, material), free(mesh, material);
    std::vector<int> moved;
    for (int node = 0; node < mesh.node_count(); ++node) {
        if (is_at(mesh, node, grip, 1))
            moved.push_back(node);
        if (is_at(mesh, node, grip, -1))
            free.fix(node);
        if (is_at(mesh, node, grip, -1) || is_at(mesh, node, grip, 1))
            held.fix(node);
    }
    HardOutcome outcome;
    const int steps = static_cast<int>(std::lround(grip.period / load.dt));
    for (int step = 1; step <= steps; ++step) {
        for (const int node : moved)
            held.positions().col(node) = grip.place(mesh.rest().col(node), step / double(steps));
        held.predict(Vec3::Zero(), load.dt);
        held.commit(load.dt);
        outcome.inverted_held = std::max(outcome.inverted_held, held.inverted_elements());
    }
    free.positions() = held.positions();
    free.velocities() = held.velocities();
    outcome.held = all_energy(free);
    constexpr double duration = 2;  // [s]
    for (double time = 0; time < duration; time += load.dt) {
        free.predict(Vec3::Zero(), load.dt);
        free.commit(load.dt);
        outcome.inverted_free = std::max(outcome.inverted_free, free.inverted_elements());
        outcome.gain = std::max(outcome.gain, all_energy(free) - outcome.held);
    }
    outcome.left = (free.positions() - mesh.rest()).colwise().norm().maxCoeff();
    return outcome;
}

}  // namespace

const char* name_of(ElasticLaw law)
{
    switch (law) {
        case ElasticLaw::corotated_at_points: return "corotated_at_points";
        case ElasticLaw::neo_hookean: return "neo_hookean";
        case ElasticLaw::corotated: break;
    }
    return "corotated";
}

HardOutcome twist_once(const HardLoad& load)
{
    const auto turned = [](const Vec3& rest, double s) -> Vec3 {
        return Eigen::AngleAxisd(2 * std::numbers::pi * s, Vec3::UnitX()) * rest;
    };
    return deform(with_elements(bar({1, 0.2, 0.2}, {10, 2, 2}), load.basis), load, 0.3, {0, 0.5, 1, turned});
}

HardOutcome press_flat(const HardLoad& load)
{
    const auto lowered = [](const Vec3& rest, double s) -> Vec3 {
        return rest - 0.7 * 0.4 * s * Vec3::UnitY();
    };
    return deform(with_elements(bar({0.4, 0.4, 0.4}, {3, 3, 3}), load.basis), load, 0.4,
                  {1, 0.2, 0.5, lowered});
}

Table hard_loads(HardOutcome (*run)(const HardLoad&), bool quick)
{
    Table table({"basis", "elasticity", "young_pa", "dt_s", "inverted_held", "inverted_free", "held_j",
                 "gain_j", "left_mm"});
    for (const Basis basis : both_bases)
        for (const ElasticLaw law : all_laws)
            for (const double young : {1e4, 1e6})
                for (const double dt : {0.01, 0.002}) {
                    if (quick && (young < 1e6 || dt < 0.01))
                        continue;
                    const HardOutcome found = run({law, basis, young, dt});
                    table.add({name_of(basis), name_of(law), young, dt, long{found.inverted_held},
                               long{found.inverted_free}, found.held, found.gain, 1e3 * found.left});
                }
    return table;
}

double lost_while_tumbling(const HardLoad& load)
{
    ElasticBody body(with_elements(bar({1, 0.2, 0.2}, {5, 1, 1}), load.basis),
                     {.young = load.young, .poisson = 0.3, .law = load.law});
    const Vec3 omega(0, 5, 1);
    for (int node = 0; node < body.node_count(); ++node) {
        const Vec3 x = body.positions().col(node);
        body.velocities().col(node) = omega.cross(x) + Vec3(1.5 * std::sin(3 * x.x()), 2 * x.x() * x.x(), 0);
    }
    const Vec3 start = body.angular_momentum(body.centre_of_mass());
    const int steps = static_cast<int>(std::lround(1 / load.dt));
    for (int step = 0; step < steps; ++step) {
        body.predict(Vec3::Zero(), load.dt);
        body.commit(load.dt);
    }
    return (body.angular_momentum(body.centre_of_mass()) - start).norm() / start.norm();
}

Table tumbling_losses()
{
    Table table({"basis", "elasticity", "at_10_ms_percent", "at_5_ms_percent", "at_1_ms_percent"});
    for (const Basis basis : both_bases)
        for (const ElasticLaw law : all_laws) {
            const auto percent = [&](double dt) { return 100 * lost_while_tumbling({law, basis, 1e5, dt}); };
            table.add({name_of(basis), name_of(law), percent(0.01), percent(0.005), percent(0.001)});
        }
    return table;
}

}  // namespace enduring::verification
