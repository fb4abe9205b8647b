#include "chapters/03_penalty_impulses/crossing_detection.hpp"

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/03_penalty_impulses/crossing.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {

Vec3 outward_at_edge(const SurfaceStep& surface, int edge)
{
    Vec3 sum = Vec3::Zero();
    for (const int index : surface.topology.faces_at_edge(edge)) {
        if (index < 0)
            continue;
        const auto [f0, f1, f2] = surface.face(index);
        const Vec3& corner = surface.start(f0);
        sum += (surface.start(f1) - corner).cross(surface.start(f2) - corner).stableNormalized();
    }
    return sum.stableNormalized();
}

//! [append_entries]
void CrossingDetection::append_entries(const World& world, Contacts& contacts) const
{
    const auto enters_by_face = [](const VertexFaceStep& step) { return find_entry(step, enters_face); };
    const auto enters_by_edge = [](const EdgeEdgeStep& step, const SurfaceStep& a, int edge_a,
                                   const SurfaceStep& b, int edge_b) {
        return find_entry(step, [&](const Crossing& crossing) {
            return enters_edge(step, crossing, outward_at_edge(b, edge_b) - outward_at_edge(a, edge_a));
        });
    };
    append_pairs(world, *this, enters_by_face, enters_by_edge, contacts);
}
//! [append_entries]

namespace {

double depth_at_start(const World& world, const Contact& contact)
{
    const PairInstant start = pair_step(world, contact).t0;
    return start.side_1.cross(start.side_2).dot(start.offset);
}

}  // namespace

//! [resolve]
void resolve_separated_pairs(const World& world, Contacts& contacts)
{
    const auto separated = [&](const Contact& contact) {
        return !contact.on_plane() && depth_at_start(world, contact) > 0;
    };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), separated), contacts.end());
}
//! [resolve]

}  // namespace enduring
