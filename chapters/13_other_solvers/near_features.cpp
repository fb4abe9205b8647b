#include "chapters/13_other_solvers/near_features.hpp"

#include "chapters/08_contact_by_distance/near_pairs.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace enduring {
namespace {

/// Sine by which a neighbour may be further out than its feature. A hundredth: faces that are pressed
/// together and tilt by a thousandth lose the pairs of one side, and an arch falls. Five times: every feature
/// has a pair.
constexpr double cone_sine = 0.2;
constexpr double beside_a_wall =
    0.1;  ///< of a segment [1]: a plane nearer to an end than this is that of a side it runs along. Without
          ///< it, stones of an arch that tilt lose the pairs of one side.
constexpr double least_fold = 1e-4;  ///< sine between two faces, below which they are one
constexpr double touching =
    1e-9;  ///< of the size of a body: nearer, the difference of two points has no direction

Vec3 normal_of_face(const SurfaceStep& surface, int face)
{
    const auto [f0, f1, f2] = surface.face(face);
    const Vec3& x = surface.start(f0);
    return (surface.start(f1) - x).cross(surface.start(f2) - x).stableNormalized();
}

bool is_folded(const SurfaceStep& surface, int one, int other)
{
    return normal_of_face(surface, one).cross(normal_of_face(surface, other)).norm() > least_fold;
}

/// Whether a direction leaves the body between faces that meet: at the bottom of a dent, what is furthest
/// along one that leads into the body is outermost, too.
bool leads_out(const SurfaceStep& surface, std::span<const int> faces, const Vec3& direction)
{
    double sum = 0;
    for (const int face : faces)
        if (face >= 0)
            sum += direction.dot(normal_of_face(surface, face));
    return sum > 0;
}

/// Whether nothing around a vertex is further out along a direction.
bool is_outermost(const SurfaceStep& surface, int vertex, const Vec3& direction)
{
    bool has_fold = false;
    const auto faces = surface.topology.faces_around_vertex(vertex);
    if (!leads_out(surface, faces, direction))
        return false;
    for (const int face : faces) {
        has_fold = has_fold || is_folded(surface, face, faces.front());
        for (const int other : surface.face(face)) {
            const Vec3 side = surface.start(other) - surface.start(vertex);
            if (direction.dot(side) > cone_sine * side.norm())
                return false;
        }
    }
    return has_fold || faces.size() == 1;
}

/// The same of an edge.
bool is_outermost_edge(const SurfaceStep& surface, int edge, const Vec3& direction)
{
    const Vec3& x = surface.start(surface.edge(edge)[0]);
    if (!leads_out(surface, surface.topology.faces_at_edge(edge), direction))
        return false;
    for (const int face : surface.topology.faces_at_edge(edge))
        for (int i = 0; face >= 0 && i < 3; ++i) {
            const Vec3 side = surface.start(surface.face(face)[static_cast<std::size_t>(i)]) - x;
            if (direction.dot(side) > cone_sine * side.norm())
                return false;
        }
    const auto [one, other] = surface.topology.faces_at_edge(edge);
    return other < 0 || is_folded(surface, one, other);
}

/// The faces around the feature of a face on which a point lies, by its weights; none for the face itself.
std::vector<int> faces_around(const SurfaceStep& surface, int face, const std::array<double, 3>& weights)
{
    const auto& topology = surface.topology;
    const auto zeros = std::count(weights.begin(), weights.end(), 0.0);
    if (zeros == 2) {
        const auto corner = std::find_if(weights.begin(), weights.end(), [](double w) { return w != 0; });
        const auto around = topology.faces_around_vertex(
            surface.face(face)[static_cast<std::size_t>(corner - weights.begin())]);
        return {around.begin(), around.end()};
    }
    if (zeros == 0)
        return {};
    const auto opposite = std::find(weights.begin(), weights.end(), 0.0) - weights.begin();
    const auto [one, other] =
        topology.faces_at_edge(topology.edges_of_face(face)[static_cast<std::size_t>(opposite + 1) % 3]);
    return other < 0 ? std::vector{one} : std::vector{one, other};
}

/// Whether a face lies across a segment, beside those on which its ends lie. Within a wall none does.
/// @param at_end  nearer than this to an end, a plane goes through it [m]
bool is_crossed(const SurfaceStep& surface, const Vec3& from, const Vec3& to, double at_end)
{
    const auto lies_across = [&](const Face& face) {
        const Vec3 &x = surface.start(face[0]), &y = surface.start(face[1]), &z = surface.start(face[2]);
        const Vec3 normal = (y - x).cross(z - x).stableNormalized();
        const double before = normal.dot(from - x), behind = normal.dot(to - x);
        if ((before > 0) == (behind > 0) || std::min(std::abs(before), std::abs(behind)) <= at_end)
            return false;
        const Vec3 at = from + before / (before - behind) * (to - from);
        return normal.dot((y - x).cross(at - x)) >= 0 && normal.dot((z - y).cross(at - y)) >= 0 &&
               normal.dot((x - z).cross(at - z)) >= 0;
    };
    const auto faces = surface.topology.faces();
    return std::any_of(faces.begin(), faces.end(), lies_across);
}

/// Whether the nearest points of two edges lie on two sides of a wall of either body: neither edge is inside.
bool is_beyond_a_wall(const SurfaceStep& a, const SurfaceStep& b, int edge_b, const ClosestOnEdges& closest,
                      double at_end)
{
    const auto [b0, b1] = b.edge(edge_b);
    const Vec3 on_b = b.start(b0) + closest.t * (b.start(b1) - b.start(b0)), on_a = on_b + closest.difference;
    return is_crossed(a, on_a, on_b, at_end) || is_crossed(b, on_a, on_b, at_end);
}

/// Whether two bodies come apart along the normal of a face by less than this [m]: the first one, whose face
/// it is, lies behind it, and of the other one no vertex is farther behind.
bool comes_apart_within(const SurfaceStep& surface, const SurfaceStep& other, double way, double at_face)
{
    const auto faces = surface.topology.faces();
    return std::any_of(faces.begin(), faces.end(), [&](const Face& face) {
        const Vec3& x = surface.start(face[0]);
        const Vec3 normal = (surface.start(face[1]) - x).cross(surface.start(face[2]) - x).stableNormalized();
        return std::all_of(other.t0.begin(), other.t0.end(),
                           [&](const Vec3& vertex) { return normal.dot(vertex - x) > -way; }) &&
               std::all_of(surface.t0.begin(), surface.t0.end(),
                           [&](const Vec3& vertex) { return normal.dot(vertex - x) <= at_face; });
    });
}

/// One vertex of A against the faces of B that come near.
class VertexSearch {
public:
    VertexSearch(const World& world, int body_a, int vertex, int body_b, double reach, double depth)
        : a_(surface_of(world, body_a)), b_(surface_of(world, body_b)), body_a_(body_a), body_b_(body_b),
          vertex_(vertex), reach_(reach), depth_(depth),
          touching_(touching * world.bodies[static_cast<std::size_t>(body_a)]->size())
    {}

    void look_at(int face)
    {
        const ClosestOnTriangle closest = closest_on(face);
        const double height = normal_of_face(b_, face).dot(a_.start(vertex_) - closest.point);
        // of faces that are equally near, the one that the point is most above or below tells the side
        if (closest.distance < nearest_ - touching_ ||
            (closest.distance < nearest_ + touching_ && std::abs(height) > std::abs(height_))) {
            nearest_ = std::min(nearest_, closest.distance);
            height_ = height;
        }
        if (closest.distance <= std::max(reach_, depth_))
            found_.push_back({face, height, closest});
    }

    void append_to(Contacts& contacts)
    {
        std::stable_sort(found_.begin(), found_.end(), [](const Found& one, const Found& other) {
            return one.closest.distance < other.closest.distance;
        });
        is_inside_ = height_ < touching_;
        bool is_out = false;  // one feature lets a vertex out; it may stand before several walls
        for (const Found& found : found_) {
            const bool on_face = found.closest.distance <= std::abs(found.height) + touching_;
            const bool leaves = is_inside_ && (found.height < touching_ || !on_face);
            if (leaves ? !is_out && found.closest.distance <= depth_
                       : (on_face || !is_inside_) && found.height > 0 && found.closest.distance <= reach_)
                is_out = append(found, leaves ? -1 : 1, leaves && on_face, contacts) || is_out;
        }
    }

private:
    struct Found {
        int face;
        double height;
        ClosestOnTriangle closest;
    };

    ClosestOnTriangle closest_on(int face) const
    {
        const auto [f0, f1, f2] = b_.face(face);
        return closest_on_triangle(a_.start(vertex_), b_.start(f0), b_.start(f1), b_.start(f2));
    }

    /// @param side      1 outside, -1 inside
    /// @param any_face  also one whose neighbour is nearer: from inside, a side may be, and be no way out for
    ///     A
    /// @return          whether there is a pair that lets the vertex out
    bool append(const Found& found, double side, bool any_face, Contacts& contacts)
    {
        for (const int other : faces_around(b_, found.face, found.closest.weights))
            if (!any_face && closest_on(other).distance < found.closest.distance - touching_)
                return false;
        const auto is_known = [&](const Vec3& point) {
            return (point - found.closest.point).norm() <= 10 * touching_;
        };
        const Vec3 difference = side * (a_.start(vertex_) - found.closest.point);
        const Vec3 normal = found.closest.distance > touching_ ? Vec3(difference / found.closest.distance)
                                                               : normal_of_face(b_, found.face);
        if (std::any_of(points_.begin(), points_.end(), is_known) || !is_outermost(a_, vertex_, -normal))
            return false;
        points_.push_back(found.closest.point);
        contacts.push_back(vertex_pair(body_a_, vertex_, body_b_, b_, found.face, found.face,
                                       found.closest.weights, normal));
        return side < 0;
    }

    SurfaceStep a_, b_;
    int body_a_, body_b_, vertex_;
    double reach_, depth_, touching_;
    double nearest_ = std::numeric_limits<double>::infinity(), height_ = 0;
    bool is_inside_ = false;
    std::vector<Found> found_;
    std::vector<Vec3> points_;  ///< of its pairs so far
};

double smaller_size(const World& world, int body_a, int body_b)
{
    const Body &a = *world.bodies[static_cast<std::size_t>(body_a)],
               &b = *world.bodies[static_cast<std::size_t>(body_b)];
    return a.is_static() ? b.size() : b.is_static() ? a.size() : std::min(a.size(), b.size());
}

}  // namespace

NearFeatures::Way NearFeatures::way_of(const Body& body)
{
    Way way{Vec3::Zero(), 0};
    const auto count = body.positions_t0().size();
    for (std::size_t v = 0; v < count; ++v)
        way.mean += (body.positions_t1()[v] - body.positions_t0()[v]) / static_cast<double>(count);
    for (std::size_t v = 0; v < count; ++v)
        way.most = std::max(way.most, (body.positions_t1()[v] - body.positions_t0()[v] - way.mean).norm());
    return way;
}

double NearFeatures::reach(const World& world, int body_a, int body_b) const
{
    const Way &a = ways_[static_cast<std::size_t>(body_a)], &b = ways_[static_cast<std::size_t>(body_b)];
    return settings_.reach * smaller_size(world, body_a, body_b) + (a.mean - b.mean).norm() + a.most + b.most;
}

Contacts NearFeatures::find(const World& world)
{
    ways_.clear();
    std::vector<double> margins;
    for (const auto& body : world.bodies) {
        const Way& way = ways_.emplace_back(way_of(*body));
        margins.push_back(std::max(settings_.reach, body->is_static() ? 0 : settings_.depth / 2) *
                              body->size() +
                          way.mean.norm() + way.most);
    }
    search_.find_candidates(world, margins);
    Contacts contacts;
    append_planes(world, contacts);
    append_vertices(world, contacts);
    append_edges(world, contacts);
    sort_by_keys(contacts);
    return contacts;
}

void NearFeatures::append_vertices(const World& world, Contacts& contacts) const
{
    std::vector<std::array<int, 4>> all;  // all faces of a vertex together
    search_.visit_candidates(
        [&](int body_a, int vertex, int body_b, int face) {
            all.push_back({body_a, vertex, body_b, face});
        },
        [](int, int, int, int) {});
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size();) {
        const auto [body_a, vertex, body_b, first] = all[i];
        VertexSearch search(world, body_a, vertex, body_b, reach(world, body_a, body_b),
                            settings_.depth * smaller_size(world, body_a, body_b));
        for (; i < all.size() &&
               std::array{all[i][0], all[i][1], all[i][2]} == std::array{body_a, vertex, body_b};
             ++i)
            search.look_at(all[i][3]);
        search.append_to(contacts);
    }
}

void NearFeatures::append_edges(const World& world, Contacts& contacts) const
{
    const auto edges = [&](int body_a, int edge_a, int body_b, int edge_b) {
        const SurfaceStep a = surface_of(world, body_a), b = surface_of(world, body_b);
        const auto closest = closest_inside(a, edge_a, b, edge_b);
        if (!closest)
            return;
        const double distance = closest->difference.norm(), outside = reach(world, body_a, body_b),
                     inside = settings_.depth * smaller_size(world, body_a, body_b);
        if (distance > std::max(outside, inside))
            return;
        const double at_end = touching * smaller_size(world, body_a, body_b),
                     way = 0.5 * distance - at_end;  // rounding frees nothing
        const Vec3 across = across_edges(a, edge_a, b, edge_b).normalized();
        const Vec3 towards_a = across.dot(closest->difference) < 0 ? Vec3(-across) : across;
        for (const Vec3& normal : {towards_a, Vec3(-towards_a)}) {  // outside first, then inside
            if (distance > (normal == towards_a ? outside : inside) ||
                !is_outermost_edge(b, edge_b, normal) || !is_outermost_edge(a, edge_a, -normal))
                continue;
            if (normal != towards_a &&
                (comes_apart_within(a, b, way, at_end) || comes_apart_within(b, a, way, at_end) ||
                 is_beyond_a_wall(a, b, edge_b, *closest, std::max(at_end, beside_a_wall * distance))))
                return;  // they lie beside each other, below a face that is hardly entered, or apart
            contacts.push_back(
                edge_pair(body_a, a, edge_a, body_b, b, edge_b, closest->s, closest->t, normal));
            return;
        }
    };
    search_.visit_candidates([](int, int, int, int) {}, edges);
}

void NearFeatures::append_planes(const World& world, Contacts& contacts) const
{
    for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body) {
        const Body& moving = *world.bodies[static_cast<std::size_t>(body)];
        for (int plane = 0; !moving.is_static() && plane < static_cast<int>(world.planes.size()); ++plane) {
            const Plane& ground = world.planes[static_cast<std::size_t>(plane)];
            for (int v = 0; v < moving.surface().vertex_count(); ++v) {
                const double height = ground.normal.dot(moving.position(v, 0) - ground.point);
                const double way = (moving.position(v, 1) - moving.position(v, 0)).norm();
                if (height > settings_.reach * moving.size() + way)
                    continue;
                Contact contact = plane_pair(body, plane, v);
                contact.normal_t0 = ground.normal;
                contacts.push_back(contact);
            }
        }
    }
}

double separation_t0(const World& world, const Contact& contact)
{
    if (contact.on_plane()) {
        const Plane& plane = world.planes[static_cast<std::size_t>(contact.body_b)];
        return plane.normal.dot(contact_vertex(world, contact, 0, 0) - plane.point);
    }
    Vec3 difference = Vec3::Zero();
    for (int i = 0; i < 4; ++i)
        difference += contact.weights[static_cast<std::size_t>(i)] * contact_vertex(world, contact, i, 0);
    return contact.normal_t0.dot(difference);
}

}  // namespace enduring
