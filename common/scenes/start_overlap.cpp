#include "common/scenes/start_overlap.hpp"

#include "common/geometry/surface_checks.hpp"
#include "common/geometry/surface_tree.hpp"
#include "common/simulation/rest_neighbours.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace enduring {
namespace {

using Box = Eigen::AlignedBox3d;

/// A body as it lies at the start. Its tree is made when somebody asks for it: most bodies are near no other.
class Placed {
public:
    explicit Placed(const Body& body) : body_(body)
    {
        for (const Vec3& vertex : positions())
            box_.extend(vertex);
    }
    const Body& body() const { return body_; }
    const Box& box() const { return box_; }
    std::span<const Vec3> positions() const { return body_.positions_t0(); }
    const Vec3& position(int vertex) const { return positions()[vertex]; }
    const SurfaceTree& tree()
    {
        if (!tree_)
            tree_.emplace(body_.surface().faces(), positions());
        return *tree_;
    }

private:
    const Body& body_;
    Box box_;
    std::optional<SurfaceTree> tree_;
};

/// What rounding may do to places of this size [m]: a body that is put on another touches it, and no more.
double rounding(const Box& one, const Box& other)
{
    const Box both = one.merged(other);
    return 1e-9 * (both.diagonal().norm() + both.center().norm());
}

std::vector<Vec3> points_of(const Placed& placed)
{
    const SurfaceTopology& surface = placed.body().surface();
    std::vector<Vec3> points(placed.positions().begin(), placed.positions().end());
    for (const auto& [a, b] : surface.edges())
        points.push_back((placed.position(a) + placed.position(b)) / 2);
    for (const auto& [a, b, c] : surface.faces())
        points.push_back((placed.position(a) + placed.position(b) + placed.position(c)) / 3);
    return points;
}

/// How deep the deepest point of one body lies in another with an inside [m], 0 if none does.
double depth_in_closed(const Placed& inner, Placed& outer)
{
    double deepest = 0;
    for (const Vec3& point : points_of(inner))
        if (outer.box().contains(point) && outer.tree().contains(point))
            deepest = std::max(deepest, outer.tree().distance(point));
    return deepest;
}

/// How far the edges of a body reach behind an open surface that they pass through [m].
double depth_in_open(const Placed& inner, Placed& outer)
{
    double deepest = 0;
    if (outer.body().surface().faces().empty())
        return deepest;
    const auto look = [&](int from, int to) {
        if (outer.tree().is_passed(inner.position(from), inner.position(to)))
            deepest = std::max(deepest, outer.tree().distance(inner.position(to)));
    };
    for (const auto& [a, b] : inner.body().surface().edges()) {
        look(a, b);
        look(b, a);
    }
    return deepest;
}

double depth_in(const Placed& inner, Placed& outer)
{
    return outer.body().surface().is_closed() ? depth_in_closed(inner, outer) : depth_in_open(inner, outer);
}

bool lies_wholly_in(const Placed& inner, Placed& outer)
{
    const auto vertices = inner.positions();
    return outer.body().surface().is_closed() &&
           std::all_of(vertices.begin(), vertices.end(),
                       [&](const Vec3& vertex) { return outer.tree().contains(vertex); });
}

std::optional<StartOverlap> overlap_of(Placed& one, Placed& other)
{
    if ((one.body().is_static() && other.body().is_static()) || !one.box().intersects(other.box()))
        return std::nullopt;
    const double of_one = depth_in(one, other), of_other = depth_in(other, one);
    if (std::max(of_one, of_other) <= rounding(one.box(), other.box()))
        return std::nullopt;
    const bool is_one = one.body().is_static() ? false
                                               : other.body().is_static() ||
                                                     of_one > of_other + rounding(one.box(), other.box());
    Placed &inner = is_one ? one : other, &outer = is_one ? other : one;
    return StartOverlap{inner.body().name(),
                        outer.body().name(),
                        std::max(of_one, of_other),
                        lies_wholly_in(inner, outer),
                        false,
                        false,
                        one.body().surface().is_closed() && other.body().surface().is_closed()};
}

/// A scene may begin with its bodies as deep in the ground as they rest, so
/// only what presses harder than all weight is told.
std::optional<StartOverlap> overlap_of(const Placed& placed, const Plane& plane, double stiffness,
                                       double weight)
{
    double deepest = 0, push = 0;
    bool whole = true;
    for (const Vec3& vertex : placed.positions()) {
        const double depth = std::max(0.0, plane.normal.dot(plane.point - vertex));
        deepest = std::max(deepest, depth);
        push += plane.stiffness.value_or(stiffness) * depth;
        whole = whole && depth > 0;
    }
    const Box at_plane(plane.point);
    constexpr double margin = 1.1;
    if (deepest <= rounding(placed.box(), at_plane) || push <= margin * weight)
        return std::nullopt;
    return StartOverlap{placed.body().name(), plane.name, deepest, whole, true};
}

bool is_room(const Body& body)
{
    if (!body.is_static() || !body.surface().is_closed())
        return false;
    const std::span<const Vec3> vertices = body.positions_t0();
    const std::span<const Face> faces = body.surface().faces();
    return enclosed_volume({{vertices.begin(), vertices.end()}, {faces.begin(), faces.end()}}) < 0;
}

/// The room in whose walls a body begins least deep; none where one holds all of it, or where there is no
/// room.
std::optional<StartOverlap> overlap_with_rooms(const Placed& placed, const std::vector<Placed*>& rooms)
{
    std::optional<StartOverlap> least;
    if (placed.body().is_static())
        return least;
    for (Placed* room : rooms) {
        StartOverlap found{placed.body().name(), room->body().name(), 0, true, false, true};
        for (const Vec3& point : points_of(placed))
            if (room->tree().winding(point) < 0)
                found.whole = false;
            else
                found.depth = std::max(found.depth, room->tree().distance(point));
        if (found.depth <= rounding(placed.box(), room->box()))
            return std::nullopt;
        if (!least || found.depth < least->depth)
            least = found;
    }
    return least;
}

}  // namespace

std::vector<StartOverlap> start_overlaps(const World& world, const ContactParameters& contact)
{
    std::vector<Placed> bodies;
    double weight = 0;
    for (const auto& body : world.bodies) {
        bodies.emplace_back(*body);
        weight += body->mass() * world.gravity.norm();
    }
    std::vector<Placed*> rooms;
    for (Placed& placed : bodies)
        if (is_room(placed.body()))
            rooms.push_back(&placed);
    std::vector<StartOverlap> all;
    const auto keep = [&](const std::optional<StartOverlap>& overlap) {
        if (overlap)
            all.push_back(*overlap);
    };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j)
            if (!are_joined(world.joints, static_cast<int>(i), static_cast<int>(j)))
                keep(overlap_of(bodies[i], bodies[j]));
        if (!bodies[i].body().is_static())
            for (const Plane& plane : world.planes)
                keep(overlap_of(bodies[i], plane, contact.stiffness, weight));
    }
    const auto is_told = [&](const StartOverlap& overlap) {
        return std::any_of(all.begin(), all.end(), [&](const StartOverlap& told) {
            return told.inner == overlap.inner && told.outer == overlap.outer;
        });
    };
    for (const Placed& placed : bodies)
        if (const auto overlap = overlap_with_rooms(placed, rooms); overlap && !is_told(*overlap))
            all.push_back(*overlap);
    return all;
}

std::vector<StartSelfOverlap> start_self_overlaps(const World& world)
{
    std::vector<StartSelfOverlap> all;
    for (const auto& body : world.bodies) {
        if (rest_neighbours(*body) == nullptr)
            continue;
        Placed placed(*body);
        const double outwards = 10 * rounding(placed.box(), placed.box());
        const auto inside = std::count_if(
            body->surface().faces().begin(), body->surface().faces().end(), [&](const Face& face) {
                const Vec3 &a = placed.position(face[0]), &b = placed.position(face[1]),
                           &c = placed.position(face[2]), normal = (b - a).cross(c - a).stableNormalized();
                const Vec3 middle = (a + b + c) / 3;
                const std::array places{middle,           a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2),
                                        Vec3((c + a) / 2)};
                return std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
                    constexpr double towards_middle = 0.02;  // off the faces around it
                    return placed.tree().contains(lerp(place, middle, towards_middle) + outwards * normal);
                });
            });
        if (inside > 0)
            all.push_back({body->name(), static_cast<int>(inside)});
    }
    return all;
}

}  // namespace enduring
