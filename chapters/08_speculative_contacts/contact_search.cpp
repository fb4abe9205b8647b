#include "chapters/08_speculative_contacts/contact_search.hpp"

#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/08_speculative_contacts/sliding_normal.hpp"
#include "chapters/08_speculative_contacts/vertex_walls.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enduring {
namespace {

/// The candidates of a search, all faces of a vertex together.
std::vector<std::array<int, 4>> vertex_candidates(const CandidateSearch& search)
{
    std::vector<std::array<int, 4>> all;
    search.visit_candidates(
        [&](int body_a, int vertex, int body_b, int face) {
            all.push_back({body_a, vertex, body_b, face});
        },
        [](int, int, int, int) {});
    std::sort(all.begin(), all.end());
    return all;
}

/// How near the features of two bodies have to be, for all pairs of bodies of a world.
class Reaches {
public:
    /// @param depths  of each body, how deep it may be inside another one
    Reaches(const World& world, double margin, const std::vector<double>& depths)
        : world_(world), margin_(margin), depths_(depths)
    {
        for (const auto& body : world.bodies)
            faces_tell_.push_back(body->inverted_elements() == 0);
    }
    Reach of(int body_a, int body_b) const
    {
        const auto a = static_cast<std::size_t>(body_a), b = static_cast<std::size_t>(body_b);
        const double size = std::min(world_.bodies[a]->size(), world_.bodies[b]->size());
        return {margin_, std::min(search_parts.inside * size, std::max(depths_[a], depths_[b])),
                faces_tell_[a]};
    }

private:
    const World& world_;
    double margin_;
    const std::vector<double>& depths_;
    std::vector<bool> faces_tell_;
};

/// Of the bodies that move [m]; 0 if none does.
double smallest_size(const World& world)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& body : world.bodies)
        if (!body->is_static())
            smallest = std::min(smallest, body->size());
    return std::isfinite(smallest) ? smallest : 0;
}

SurfaceStep surface_of(const World& world, int body)
{
    return surface_step(*world.bodies[static_cast<std::size_t>(body)]);
}

//! [vertex_pairs]
void append_vertex_pairs(const World& world, const CandidateSearch& search, const KnownPairs& known,
                         const Reaches& reaches, double dt, Contacts& contacts)
{
    const auto all = vertex_candidates(search);
    std::vector<FaceMeeting> meetings;
    for (std::size_t i = 0, first = 0; i < all.size(); ++i) {
        const auto [body_a, vertex, body_b, face] = all[i];
        const SurfaceStep a = surface_of(world, body_a), b = surface_of(world, body_b);
        const Reach reach = reaches.of(body_a, body_b);
        Contact pair{ContactKind::vertex_face, body_a, body_b, vertex, face};
        if (const auto meeting = find_meeting(a, vertex, b, face, reach, known.contain(pair)))
            meetings.push_back({face, *meeting});
        const bool last = i + 1 == all.size() ||
                          !std::equal(all[i].begin(), all[i].begin() + 3, all[i + 1].begin());
        if (!last)
            continue;
        Ground ground;
        for (; first <= i; ++first)
            if (!meetings.empty())
                ground.look_at(a, vertex, b, all[first][3]);
        for (const FaceMeeting& chosen : choose_walls(b, std::move(meetings))) {
            const auto [f0, f1, f2] = b.face(chosen.face);
            pair.feature_b = chosen.face;
            pair.vertices = {vertex, f0, f1, f2};
            pair.weights = chosen.meeting.weights;
            pair.start = chosen.meeting.tau;
            const Vec3 start = contact_geometry(world, pair, 0).normal,
                       end = contact_geometry(world, pair, 1).normal,
                       motion = motion_without_gravity(world, pair, dt);
            const bool slides = 0.5 * motion.norm() * (end - start).norm() <=
                                search_parts.turned * reach.margin;
            pair.sliding_normal = slides ? sliding_normal(ground.normal, end, motion) : Vec3(Vec3::Zero());
            contacts.push_back(pair);
        }
        meetings.clear();
    }
}
//! [vertex_pairs]

void append_edge_pairs(const World& world, const CandidateSearch& search, const KnownPairs& known,
                       const Reaches& reaches, Contacts& contacts)
{
    const auto look_at = [&](int body_a, int edge_a, int body_b, int edge_b) {
        Contact pair{ContactKind::edge_edge, body_a, body_b, edge_a, edge_b};
        const SurfaceStep a = surface_of(world, body_a), b = surface_of(world, body_b);
        const auto meeting = find_edge_meeting(a, edge_a, b, edge_b, reaches.of(body_a, body_b),
                                               known.contain(pair));
        if (!meeting)
            return;
        const auto [a0, a1] = a.edge(edge_a);
        const auto [b0, b1] = b.edge(edge_b);
        pair.vertices = {a0, a1, b0, b1};
        pair.weights = meeting->weights;
        pair.start = meeting->tau;
        pair.orientation = meeting->orientation;
        contacts.push_back(pair);
    };
    search.visit_candidates([](int, int, int, int) {}, look_at);
}

}  // namespace

double search_margin(const World& world, double dt)
{
    return std::max(search_parts.fall * world.gravity.norm() * dt * dt,
                    search_parts.nearness * smallest_size(world));
}

void append_plane_pairs(const World& world, double margin, Contacts& contacts)
{
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const Body& body = *world.bodies[i];
        for (std::size_t p = 0; p < world.planes.size() && !body.is_static(); ++p) {
            const Plane& plane = world.planes[p];
            for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex) {
                const auto height = [&](double tau) {
                    return plane.normal.dot(body.position(vertex, tau) - plane.point);
                };
                if (height(0) > margin && height(1) > margin)
                    continue;
                contacts.push_back({ContactKind::vertex_plane,
                                    static_cast<int>(i),
                                    static_cast<int>(p),
                                    vertex,
                                    -1,
                                    {vertex, -1, -1, -1},
                                    {1, 0, 0, 0}});
            }
        }
    }
}

namespace {

/// How deep each body may be inside others at the start of the step, as its deepest pair tells; no less than the margin. A
/// feature without a pair that is behind a face by more is not inside: it is beyond an edge of the face.
std::vector<double> depths_of(const World& world, const Contacts& known, double margin)
{
    std::vector<double> depths(world.bodies.size(), margin);
    for (const Contact& contact : known) {
        const Body& body = *world.bodies[static_cast<std::size_t>(contact.body_a)];
        double& of_body = depths[static_cast<std::size_t>(contact.body_a)];
        of_body = std::max(of_body, std::min(-search_parts.deeper * contact_geometry(world, contact, 0).depth,
                                             search_parts.inside * body.size()));
    }
    return depths;
}

}  // namespace

//! [find]
Contacts ContactSearch::find(const World& world, const Contacts& known, double dt)
{
    margin_ = search_margin(world, dt);
    const std::vector<double> depths = depths_of(world, known, margin_);
    find_candidates(world, depths);
    seen_t1_.clear();
    for (const auto& body : world.bodies)
        seen_t1_.emplace_back(body->positions_t1().begin(), body->positions_t1().end());

    const KnownPairs known_pairs(known);
    Contacts found;
    append_plane_pairs(world, margin_, found);
    const Reaches reaches(world, margin_, depths);
    append_vertex_pairs(world, *this, known_pairs, reaches, dt, found);
    append_edge_pairs(world, *this, known_pairs, reaches, found);
    for (Contact& contact : found)
        contact.category = ContactCategory::regular;
    std::sort(found.begin(), found.end(),
              [](const Contact& one, const Contact& other) { return key_of(one) < key_of(other); });
    return found;
}
//! [find]

namespace {

bool keeps_shape(const Body& body)
{
    return body.is_static() || dynamic_cast<const RigidBody*>(&body) != nullptr;
}

}  // namespace

//! [may_meet]
/// An edge that is not convex has no normal cone, and one of a rigid body stays what it is. Where the body turns within a step, its
/// vertices take straight lines, which changes the fold by less than half.
bool ContactSearch::edge_may_meet(const Body& body, int edge) const
{
    return !keeps_shape(body) || fold_at_edge(surface_at(body, 0), edge) < -0.5 * search_parts.least_fold;
}

/// A vertex inside a flat side of a rigid body or on a straight ridge has no direction of its own: what touches there, touches the side
/// or the ridge. So it does not matter how a side is cut into triangles. A corner has three ridges, and a border of a sheet ends somewhere.
bool ContactSearch::vertex_may_meet(const Body& body, int vertex) const
{
    const auto edges = body.surface().edges_around_vertex(vertex);
    return !keeps_shape(body) || std::any_of(edges.begin(), edges.end(), [&](int edge) {
        return body.surface().faces_at_edge(edge)[1] < 0;
    }) || std::count_if(edges.begin(), edges.end(), [&](int edge) { return edge_may_meet(body, edge); }) > 2;
}
//! [may_meet]

bool ContactSearch::has_moved(const World& world) const
{
    const Vec3 down = world.gravity.stableNormalized();
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        for (std::size_t v = 0; v < seen_t1_[i].size(); ++v) {
            const Vec3 moved = world.bodies[i]->positions_t1()[v] - seen_t1_[i][v];
            const double fallen = down.dot(moved);
            if (std::abs(fallen) > margin_ || (moved - fallen * down).norm() > search_parts.aside * margin_)
                return true;
        }
    return false;
}

}  // namespace enduring
