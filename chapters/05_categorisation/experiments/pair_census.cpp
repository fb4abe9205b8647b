#include "chapters/05_categorisation/experiments/pair_census.hpp"

#include <algorithm>

namespace enduring::chapter05 {
namespace {

double horizontal_part(const Vec3& impulse) { return Vec3(impulse.x(), 0, impulse.z()).norm(); }

}  // namespace

PairCensus& PairCensus::operator+=(const PairCensus& other)
{
    vertex_face_regular += other.vertex_face_regular;
    vertex_face_hooked += other.vertex_face_hooked;
    edge_edge_regular += other.edge_edge_regular;
    edge_edge_hooked += other.edge_edge_hooked;
    without_normal += other.without_normal;
    sideways += other.sideways;
    hooked_sideways += other.hooked_sideways;
    return *this;
}

//! [census]
PairCensus census(const Contacts& contacts)
{
    PairCensus found;
    for (const Contact& contact : contacts) {
        if (contact.category == ContactCategory::unknown) {
            ++found.without_normal;
            continue;
        }
        const bool hooked = contact.category == ContactCategory::hooked;
        if (contact.kind == ContactKind::edge_edge)
            ++(hooked ? found.edge_edge_hooked : found.edge_edge_regular);
        else
            ++(hooked ? found.vertex_face_hooked : found.vertex_face_regular);
        const double sideways = horizontal_part(contact.impulse);
        found.sideways += sideways;
        found.hooked_sideways += hooked ? sideways : 0;
    }
    return found;
}
//! [census]

CensusProbe::CensusProbe(std::string body)
    : TableProbe({"time_s", "x_m", "speed_m_per_s", "lowest_m", "vf_regular", "vf_hooked", "ee_regular",
                  "ee_hooked", "without_normal", "sideways_n_s", "hooked_sideways_n_s"}),
      body_(std::move(body))
{}

void CensusProbe::observe(const World& world, const Contacts& contacts, double)
{
    const Body& body = body_named(world, body_);
    const Vec3 middle = body.centre();
    double lowest = body.positions_t0()[0].y();
    for (const Vec3& x : body.positions_t0())
        lowest = std::min(lowest, x.y());
    if (world.step == 0) {
        first_x_ = farthest_ = middle.x();
        first_y_ = lowest_ = lowest;
    }
    farthest_ = std::max(farthest_, middle.x());
    lowest_ = std::min(lowest_, lowest);
    last_speed_ = body.mean_velocity().x();
    if (stopped_at_ < 0 && world.step > 0 && last_speed_ <= 0)
        stopped_at_ = world.time;

    const PairCensus now = census(contacts);
    total_ += now;
    steps_ = world.step;
    table_.add({world.time, middle.x(), last_speed_, lowest, now.vertex_face_regular, now.vertex_face_hooked,
                now.edge_edge_regular, now.edge_edge_hooked, now.without_normal, now.sideways,
                now.hooked_sideways});
}

}  // namespace enduring::chapter05
