#include "chapters/03_penalty_impulses/experiments/bar_drop.hpp"

#include "chapters/03_penalty_impulses/experiments/jitter.hpp"
#include "chapters/03_penalty_impulses/experiments/scene_change.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enduring::chapter03 {
namespace {

/// Sums over the pairs of bar and cube; the plane's contacts are not theirs.
class BarProbe final : public Probe {
public:
    explicit BarProbe(BarRecord& record) : record_(record) {}

    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        double force = 0, depth = 0;
        int pairs = 0;
        for (const Contact& contact : contacts) {
            if (contact.on_plane())
                continue;
            force += (name_of_a(world, contact) == "bar" ? 1 : -1) * contact.impulse.y() / dt;
            const double pair_depth = contact_geometry(world, contact, 0).depth;
            depth -= std::min(pair_depth, 0.0);
            pairs += pair_depth < 0;
        }
        record_.time.push_back(world.time);
        record_.force.push_back(force);
        record_.depth.push_back(depth);
        record_.pairs.push_back(pairs);
    }

private:
    BarRecord& record_;
};

/// The values of a record's column from `at_rest_from` on.
template <class Value>
std::vector<double> at_rest(const BarRecord& record, const std::vector<Value>& column)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < column.size(); ++i)
        if (record.time[i] >= at_rest_from)
            values.push_back(static_cast<double>(column[i]));
    return values;
}

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

std::vector<double> nine_turns(bool quick)
{
    return quick ? std::vector<double>{43, 45, 47} : std::vector<double>{41, 42, 43, 44, 45, 46, 47, 48, 49};
}

}  // namespace

Scene load_bar_scene(const std::filesystem::path& file, const BarDrop& drop)
{
    nlohmann::json bar{{"rotation", {{"axis", {0, 1, 0}}, {"angle_deg", drop.turn_deg}}}};
    if (!drop.basis.empty())
        bar["basis"] = drop.basis;
    nlohmann::json patch = contact_change(drop.method, drop.stiffness, drop.dt);
    patch["/bodies/bar"] = bar;
    return load_scene(file, patch.dump());
}

BarRecord drop_bar(const std::filesystem::path& file, const BarDrop& drop,
                   const std::vector<Probe*>& more_probes)
{
    Scene scene = load_bar_scene(file, drop);
    BarRecord record;
    record.weight = body_named(scene.world, "bar").mass() * scene.world.gravity.norm();
    BarProbe probe(record);
    std::vector<Probe*> probes{&probe};
    probes.insert(probes.end(), more_probes.begin(), more_probes.end());
    // Drops look for the limits of step and stiffness from both sides.
    run(scene, chapter03_solver(scene.contact), probes, failure_on_purpose());
    return record;
}

double stiffness_between_limits(double dt)
{
    constexpr double stiffness = 5000, between = 0.007;  // [N/m], [s]
    return std::round(stiffness * std::pow(between / dt, 2));
}

DepthRatio depths_between_limits(const std::filesystem::path& file, double dt, const std::string& basis)
{
    BarDrop drop{PenaltyMethod::discrete, dt, stiffness_between_limits(dt), 45, basis};
    const double discrete = depth_in_contact(drop_bar(file, drop));
    drop.method = PenaltyMethod::continuous;
    return {discrete, depth_in_contact(drop_bar(file, drop))};
}

double jitter_at_rest(const BarRecord& record)
{
    const std::vector<double> forces = at_rest(record, record.force);
    if (mean(forces) < 0.5 * record.weight)
        return 1;
    return jitter(forces, record.weight);
}

double depth_at_rest(const BarRecord& record) { return mean(at_rest(record, record.depth)); }

double pairs_at_rest(const BarRecord& record) { return mean(at_rest(record, record.pairs)); }

double depth_in_contact(const BarRecord& record)
{
    std::vector<double> depths;
    for (const double depth : record.depth)
        if (depth > 0)
            depths.push_back(depth);
    return mean(depths);
}

NineDrops drop_nine_times(const std::filesystem::path& file, BarDrop drop, bool quick)
{
    std::vector<double> jitters, depths, pairs;
    for (const double turn : nine_turns(quick)) {
        drop.turn_deg = turn;
        const BarRecord record = drop_bar(file, drop);
        jitters.push_back(jitter_at_rest(record));
        depths.push_back(depth_at_rest(record));
        pairs.push_back(pairs_at_rest(record));
    }
    const auto [least, most] = std::minmax_element(jitters.begin(), jitters.end());
    return {.jitter = median(jitters),
            .least_jitter = *least,
            .max_jitter = *most,
            .depth = median(depths),
            .pairs = median(pairs),
            .smooth = std::count_if(jitters.begin(), jitters.end(), [](double j) { return j < 0.01; }),
            .drops = static_cast<long>(jitters.size())};
}

}  // namespace enduring::chapter03
