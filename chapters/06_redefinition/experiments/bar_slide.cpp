#include "bar_slide.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter06 {
namespace {

Contacts those(const Contacts& contacts, bool (*wanted)(const Contact&))
{
    Contacts some;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(some), wanted);
    return some;
}

/// Angle between a face normal that was upright at first and the vertical: the steepest of all face normals.
double tilt_of(const Body& cube)
{
    double steepest = 0;
    const auto x = cube.positions_t0();
    for (const auto& [f0, f1, f2] : cube.surface().faces()) {
        const Vec3 &corner = x[static_cast<std::size_t>(f0)], &second = x[static_cast<std::size_t>(f1)], &third = x[static_cast<std::size_t>(f2)];
        steepest = std::max(steepest, std::abs((second - corner).cross(third - corner).normalized().y()));
    }
    return std::acos(std::min(1.0, steepest));
}

/// The contacts lie under the cube: let it be seen through.
void open_up(Stage& stage)
{
    for (Drawable& drawable : stage.bodies) {
        drawable.wireframe = true;
        drawable.opacity = 0.55;
    }
}

}  // namespace

BarSlideProbe::BarSlideProbe(std::string solver)
    : TableProbe({"solver", "time_s", "x_m", "speed_m_per_s", "force_n", "pairs", "held"}), solver_(std::move(solver)), force_("cube", "bar")
{
}

void BarSlideProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    force_.observe(world, contacts, dt);
    const Body& cube = body_named(world, "cube");
    Vec3 middle = Vec3::Zero();
    for (const Vec3& x : cube.positions_t0())
        middle += x / static_cast<double>(cube.positions_t0().size());
    const double speed = cube.linear_momentum().x() / cube.mass(), force = std::get<double>(force_.table().rows().back()[2]);
    weight_ = -cube.mass() * world.gravity.y();
    moments_.push_back({world.time, middle.x(), speed, force, tilt_of(cube)});
    const long pairs = std::count_if(contacts.begin(), contacts.end(), [](const Contact& c) { return c.handled; }),
               held = std::count_if(contacts.begin(), contacts.end(), [](const Contact& c) { return c.held; });
    table_.add({solver_, world.time, middle.x(), speed, force, pairs, held});
}

BarSlideOutcome outcome_of(const BarSlideProbe& probe, double settled, double end)
{
    BarSlideOutcome outcome;
    const auto& moments = probe.moments();
    long leaps = 0, large = 0;
    for (std::size_t i = 1; i < moments.size(); ++i) {
        const auto& now = moments[i];
        outcome.largest_tilt = std::max(outcome.largest_tilt, now.tilt);
        if (outcome.stopped_at < 0 && now.speed <= 0)
            outcome.stopped_at = now.time;
        if (now.x > end)
            continue;
        outcome.speed_kept = now.speed / moments.front().speed;
        if (now.time < settled)
            continue;
        const double leap = std::abs(now.force - moments[i - 1].force) / probe.weight();
        outcome.largest_leap = std::max(outcome.largest_leap, leap);
        outcome.mean_leap += leap;
        large += leap > 0.01;
        ++leaps;
    }
    outcome.mean_leap /= static_cast<double>(std::max(leaps, 1L));
    outcome.leaps_above_percent = static_cast<double>(large) / static_cast<double>(std::max(leaps, 1L));
    return outcome;
}

void mark_vertex_pairs(Stage& stage, const World& world, const Contacts& contacts)
{
    open_up(stage);
    mark_contacts(stage, world, those(contacts, [](const Contact& c) { return c.kind == ContactKind::vertex_face && c.handled; }));
}

void mark_edge_pairs(Stage& stage, const World& world, const Contacts& contacts)
{
    open_up(stage);
    for (const Contact& contact : those(contacts, [](const Contact& c) { return c.kind == ContactKind::edge_edge && c.held; }))
        for (const int first : {0, 2})
            stage.segments.push_back({contact_vertex(world, contact, first, 0), contact_vertex(world, contact, first + 1, 0),
                                      palette::colliding_vertex, 2});
    mark_contacts(stage, world, those(contacts, [](const Contact& c) { return c.kind == ContactKind::edge_edge && c.handled; }));
}

}  // namespace enduring::chapter06
