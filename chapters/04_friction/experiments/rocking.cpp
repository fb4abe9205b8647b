#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/experiments/launch.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter04 {
namespace {

/// height_m, time_s, speed_m_per_s, uphill_share: the share of the
/// weight on the pairs of the box's uphill half.
class RockingProbe final : public TableProbe {
public:
    RockingProbe(double height, double angle_deg)
        : TableProbe({"height_m", "time_s", "speed_m_per_s", "uphill_share"}), height_(height),
          angle_deg_(angle_deg)
    {}
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        const Progress1d now = along_slope(world, angle_deg_);
        const Vec3 up = uphill(angle_deg_);
        double uphill_force = 0;
        for (const Contact& contact : contacts)
            if (world.bodies.front()->positions_t0()[contact.vertices[0]].dot(up) > now.way)
                uphill_force += contact.impulse.norm() / dt;
        table_.add(
            {height_, now.time, now.speed, uphill_force / (world.bodies.front()->mass() * 9.81 * up.x())});
    }

private:
    double height_, angle_deg_;
};

}  // namespace

/// A finding: the launched cube rocks, and needs more friction than its angle says.
void rocking(const RunOptions& options, Report& report)
{
    const MassSplitting mass_splitting{.spring = 20000};
    Table thresholds({"angle_deg", "dt_s", "block_ratio", "cube_ratio"});
    for (const double angle : options.quick ? std::vector{10.0} : std::vector{5.0, 10.0, 20.0, 30.0})
        for (const double dt : options.quick ? std::vector{0.01} : std::vector{0.01, 0.002}) {
            const double tangent = std::tan(angle * std::numbers::pi / 180);
            thresholds.add({angle, dt, smallest_mu_s({angle, dt, 0.1, 3, mass_splitting}) / tangent,
                            smallest_mu_s({angle, dt, 1, 3, mass_splitting}) / tangent});
        }
    report.table("rocking_threshold", thresholds);
    report.page_table("rocking_threshold", thresholds, 3);

    Table loads({"height_m", "time_s", "speed_m_per_s", "uphill_share"});
    for (const double height : {0.1, 1.0}) {
        Launch launch{10, 0.01, height, 3, with_mu_s(mass_splitting, 0.25)};
        Scene scene = scene_of(launch);
        RockingProbe probe(height, launch.angle_deg);
        run(scene, chapter04_solver(scene.contact), {&probe});
        for (const std::vector<Cell>& row : probe.table().rows())
            loads.add(row);
    }
    report.table("rocking", loads);
    report.plot("chapters/04_friction/plots/rocking.gp");
}

}  // namespace enduring::chapter04
