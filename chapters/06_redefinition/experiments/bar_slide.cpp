#include "chapters/06_redefinition/experiments/bar_slide.hpp"

#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter06 {
namespace {

template <typename Wanted>
Contacts those(const Contacts& contacts, const Wanted& wanted)
{
    Contacts some;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(some), wanted);
    return some;
}

/// Those of one kind that push, the hooked ones in orange.
void mark_pushing(Stage& stage, const World& world, const Contacts& contacts, ContactKind kind)
{
    const auto push = [&](bool hooked) {
        return those(contacts, [&](const Contact& c) {
            return c.kind == kind && c.answered() && (c.category == ContactCategory::hooked) == hooked;
        });
    };
    mark_contacts(stage, world, push(false));
    mark_artefacts(stage, world, push(true));
}

/// Unit normal of one face.
Vec3 face_normal(const Body& body, std::size_t face)
{
    const auto x = body.positions_t0();
    const auto [f0, f1, f2] = body.surface().faces()[face];
    const Vec3& corner = x[f0];
    return (x[f1] - corner).cross(x[f2] - corner).normalized();
}

/// The face that looks up most.
std::size_t top_face(const Body& body)
{
    std::size_t top = 0;
    for (std::size_t face = 0; face < body.surface().faces().size(); ++face)
        if (face_normal(body, face).y() > face_normal(body, top).y())
            top = face;
    return top;
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
    : TableProbe({"solver", "time_s", "x_m", "speed_m_per_s", "force_n", "pairs", "held"}),
      solver_(std::move(solver)), force_("cube", "bar")
{}

void BarSlideProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    force_.observe(world, contacts, dt);
    const Body& cube = body_named(world, "cube");
    const Vec3 middle = cube.centre();
    const double speed = cube.mean_velocity().x(), force = std::get<double>(force_.table().rows().back()[2]);
    if (moments_.empty())
        top_ = top_face(cube);
    weight_ = -cube.mass() * world.gravity.y();
    moments_.push_back({world.time, middle.x(), speed, force,
                        std::acos(std::clamp(face_normal(cube, top_).y(), -1.0, 1.0))});
    const long pairs = std::count_if(contacts.begin(), contacts.end(),
                                     [](const Contact&c) { return c.answered(); }),
               held = std::count_if(contacts.begin(), contacts.end(),
                                    [](const Contact&c) { return c.held(); });
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
    mark_pushing(stage, world, contacts, ContactKind::vertex_face);
}

void mark_edge_pairs(Stage& stage, const World& world, const Contacts& contacts)
{
    open_up(stage);
    for (const Contact& contact :
         those(contacts, [](const Contact& c) { return c.kind == ContactKind::edge_edge && c.held(); }))
        for (const int first : {0, 2})
            stage.segments.push_back({contact_vertex(world, contact, first, 0),
                                      contact_vertex(world, contact, first + 1, 0), palette::colliding_vertex,
                                      2});
    mark_pushing(stage, world, contacts, ContactKind::edge_edge);
}

}  // namespace enduring::chapter06
