#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/experiments/friction_arrows.hpp"
#include "chapters/04_friction/experiments/launch.hpp"
#include "chapters/04_friction/experiments/spring_energy.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace enduring::chapter04 {
namespace {

/// The scene's friction under another name, and what about it changes.
struct Series {
    std::string name;
    nlohmann::json change;
};

nlohmann::json friction_change(const nlohmann::json& friction)
{
    return {{"contact", {{"friction", friction}}}};
}

/// (5.22) read as an impulse, its velocity as the way of one step: spring / dt
/// and damper as they stand (see printed_constants).
nlohmann::json as_impulse(double mu_s, double dt)
{
    return friction_change({{"mu_s", mu_s}, {"spring", 100 / dt}, {"damper", 25}});
}

nlohmann::json mass_splitting(double mu_s)
{
    return friction_change({{"model", "mass_splitting"},
                            {"mu_s", mu_s},
                            {"spring", nullptr},
                            {"damper", nullptr},
                            {"weighting", nullptr}});
}

/// series, time_s, distance_m, speed_m_per_s along the slope.
class DistanceProbe final : public TableProbe {
public:
    DistanceProbe(std::string series, double angle_deg)
        : TableProbe({"series", "time_s", "distance_m", "speed_m_per_s"}), series_(std::move(series)),
          angle_deg_(angle_deg)
    {}
    void observe(const World& world, const Contacts&, double) override
    {
        last_ = along_slope(world, angle_deg_);
        if (turned_at_ == 0 && last_.speed < 0)
            turned_at_ = world.time;
        table_.add({series_, last_.time, last_.way, last_.speed});
    }
    const Progress1d& last() const { return last_; }
    double turned_at() const { return turned_at_; }  ///< first time it does not move uphill [s]

private:
    std::string series_;
    double angle_deg_, turned_at_ = 0;
    Progress1d last_{};
};

}  // namespace

/// Thesis figure 7.15: a cube is pushed up a slope of 10 degrees, and slides back or stays.
void slope(const RunOptions& options, Report& report)
{
    constexpr double angle_deg = 10, dt = 0.01;
    const std::filesystem::path file = options.scene.value_or(scene_file("slope"));
    Table ways({"series", "time_s", "distance_m", "speed_m_per_s"}),
        energies({"series", "time_s", "energy_j"});
    Table outcome({"friction", "way at the end [m]", "speed there [m/s]", "largest rise of energy [J]"});
    double mass_splitting_rise = 0;
    for (const Series& series :
         {Series{"as printed 0.3", nlohmann::json::object()},
          Series{"as printed 0.4", friction_change({{"mu_s", 0.4}})},
          Series{"as impulse 0.3", as_impulse(0.3, dt)}, Series{"as impulse 0.4", as_impulse(0.4, dt)},
          Series{"mass splitting 0.3", mass_splitting(0.3)},
          Series{"mass splitting 0.4", mass_splitting(0.4)},
          Series{"mass splitting 0.16", mass_splitting(0.16)}}) {
        Scene scene = load_scene(file, series.change.dump());
        DistanceProbe way(series.name, angle_deg);
        SpringEnergyProbe energy(series.name, scene.contact);
        StripProbe pictures(scene, {0.05, 0.8, 1.15, 3}, friction_arrows(0.02, scene.dt), 560, 380);
        std::vector<Probe*> probes{&way, &energy};
        if (series.name == "mass splitting 0.4")
            probes.push_back(&pictures);
        run(scene, chapter04_solver(scene.contact), probes);
        ways.append(way.table());
        energies.append(energy.table());
        if (series.name.starts_with("mass_splitting"))
            mass_splitting_rise = std::max(mass_splitting_rise, energy.largest_rise());
        outcome.add({series.name, way.last().way, way.last().speed, energy.largest_rise()});
        if (series.name == "mass splitting 0.4") {
            write_png(pictures.all(2), report.file("slope.png"));
            report.fact("slope", "turned_at", way.turned_at(), 3);
        }
    }
    report.fact("slope", "mass_splitting_rise_j", mass_splitting_rise, 1);
    report.table("slope", ways);
    report.table("slope_energy", energies);
    report.page_table("slope_outcome", outcome, 3);
    report.table("slope_outcome", outcome);
    report.plot("chapters/04_friction/plots/slope.gp");
}

}  // namespace enduring::chapter04
