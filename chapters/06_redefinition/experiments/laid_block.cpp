#include "chapters/06_redefinition/experiments/laid_block.hpp"

#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <numbers>
#include <set>

namespace enduring::chapter06 {
namespace {

constexpr double half_block = 0.125;

World world_of(const LaidBlock& laid)
{
    const auto rotation = [](double angle, const Vec3& axis) {
        return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    };
    const Mat3 slope = rotation(laid.slope_deg * std::numbers::pi / 180, Vec3::UnitZ()),
               turn = rotation(laid.turned, Vec3::UnitY());
    SurfaceMesh slab = box({4, 0.4, 4}, {8, 1, 8}), block = box({1, 2 * half_block, 1});
    for (Vec3& x : slab.vertices)
        x = slope * (x - Vec3(0, 0.2, 0));
    for (Vec3& x : block.vertices)
        x = slope * (turn * x + Vec3(0.125, half_block + laid.gap, 0.125));
    World world;
    world.bodies.push_back(std::make_unique<StaticBody>(
        "slab", SurfaceTopology(static_cast<int>(slab.vertices.size()), slab.faces), slab.vertices));
    world.bodies.push_back(
        std::make_unique<RigidBody>("block", block, with_mass(mass_properties(block, 1000), 20)));
    return world;
}

/// Vertices of the block that pairs hold.
int corners_in(const Contacts& contacts)
{
    std::set<int> corners;
    for (const Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && contact.body_a == 1)
            corners.insert(contact.feature_a);
    return static_cast<int>(corners.size());
}

}  // namespace

LaidOutcome lay(const LaidBlock& laid, const MakeSolver& make_solver)
{
    World world = world_of(laid);
    const Solver solver = make_solver({PenaltyMethod::continuous, 12000});
    Contacts contacts;
    const auto energy = [&] { return world.bodies[1]->energy(world.gravity).total(); };
    const double before = energy();
    LaidOutcome outcome;
    for (int step = 0; step < 80; ++step) {
        advance(world, contacts, solver, 0.01);
        outcome.energy_gained = std::max(outcome.energy_gained, energy() - before);
        if (step == 2)
            outcome.corners_missed = std::max(0, 4 - corners_in(contacts));
    }
    return outcome;
}

void laid_block(const RunOptions& options, Report& report)
{
    Table table({"gap_m", "placements", "with_a_corner_missed", "most_energy_gained_J"});
    const std::vector<double> slopes = options.quick ? std::vector<double>{10, 15}
                                                     : std::vector<double>{5, 10, 15, 20, 25, 30};
    for (const double gap : {0.0, 1e-12, 1e-9, 1e-6}) {
        long placements = 0, missed = 0;
        double most = 0;
        for (const double slope : slopes)
            for (const double turned : {0.0, 0.3, 0.6, std::numbers::pi / 4}) {
                const LaidOutcome outcome = lay({gap, slope, turned});
                ++placements;
                missed += outcome.corners_missed > 0;
                most = std::max(most, outcome.energy_gained);
            }
        table.add({gap, placements, missed, most});
        if (gap == 0)
            report.fact("laid_block", "max_j", most, 2);
    }
    report.table("laid_block", table);
    report.page_table("laid_block", table, 2);
}

}  // namespace enduring::chapter06
