#include "chapters/06_redefinition/baseline/discrete_detection.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Rounding in a distance between points of this size is far below this share of it.
constexpr double caution = 1 - 1e-9;

Contact new_pair(int body_a, int vertex, int body_b)
{
    Contact contact;
    contact.kind = ContactKind::vertex_face;
    contact.body_a = body_a;
    contact.body_b = body_b;
    contact.feature_a = vertex;
    return contact;
}

void move_pair(Contact& contact, const SurfaceTopology& surface, const ClosestPoint& closest)
{
    const auto [f0, f1, f2] = surface.faces()[at(closest.face)];
    contact.feature_b = closest.face;
    contact.vertices = {contact.feature_a, f0, f1, f2};
    contact.weights = {1, -closest.weights[0], -closest.weights[1], -closest.weights[2]};
}

}  // namespace

void DiscreteDetection::build(const World& world)
{
    bodies_.clear();
    trees_.clear();
    last_.clear();
    sides_.clear();
    for (const auto& body : world.bodies) {
        bodies_.push_back(body.get());
        trees_.emplace_back(body->surface(), body->positions_t0());
        last_.emplace_back(body->positions_t0().begin(), body->positions_t0().end());
    }
    moved_.resize(last_.size());
    const int count = static_cast<int>(bodies_.size());
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            if (a != b && !(bodies_[at(a)]->is_static() && bodies_[at(b)]->is_static()))
                sides_.push_back({a, b, std::vector<double>(last_[at(a)].size(), 0),
                                  std::vector<int>(last_[at(a)].size(), -1)});
}

void DiscreteDetection::refit(const World& world)
{
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const std::span<const Vec3> now = world.bodies[b]->positions_t1();
        trees_[b].refit({world.bodies[b]->surface(), now, now});
        moved_[b].resize(now.size());
        for (std::size_t v = 0; v < now.size(); ++v)
            moved_[b][v] = (now[v] - last_[b][v]).norm();
        last_[b].assign(now.begin(), now.end());
    }
}

//! [clearance]
void DiscreteDetection::use_up_clearances()
{
    for (Side& side : sides_) {
        const std::vector<double>& of_vertices = moved_[at(side.a)];
        const std::vector<double>& of_surface = moved_[at(side.b)];
        const double surface = of_surface.empty() ? 0
                                                  : *std::max_element(of_surface.begin(), of_surface.end());
        for (std::size_t v = 0; v < of_vertices.size(); ++v)
            side.clearance[v] -= of_vertices[v] + surface;
    }
}
//! [clearance]

//! [look_at]
void DiscreteDetection::look_at(const World& world, Side& side, Contacts& contacts) const
{
    const SurfaceTopology& surface = bodies_[at(side.b)]->surface();
    const std::span<const Vec3> vertices = world.bodies[at(side.a)]->positions_t1(),
                                of_surface = world.bodies[at(side.b)]->positions_t1();
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
        const int pair = side.pair[at(v)];
        if (side.clearance[at(v)] > 0 || (pair >= 0 && contacts[at(pair)].answered()))
            continue;
        const Vec3& p = vertices[at(v)];
        const ClosestPoint closest = closest_point(trees_[at(side.b)], surface, of_surface, p,
                                                   std::numeric_limits<double>::infinity());
        if (closest.face < 0)
            continue;
        const double outside = pseudonormal(surface, of_surface, closest).dot(p - closest.point);
        const bool inside = outside < 0;
        // Beyond the border of an open surface a vertex may come in without
        // passing through it: no clearance there.
        side.clearance[at(v)] = outside > 0 ? caution * std::sqrt(closest.squared_distance) : 0;
        if (!inside) {
            if (pair >= 0)
                contacts[at(pair)].feature_b = -1;  // ends: taken off the list below
            continue;
        }
        if (pair < 0)
            contacts.push_back(new_pair(side.a, v, side.b));
        move_pair(pair < 0 ? contacts.back() : contacts[at(pair)], surface, closest);
    }
}
//! [look_at]

void DiscreteDetection::update_inside_vertices(const World& world, Contacts& contacts)
{
    const auto same = [](const Body* mine, const std::unique_ptr<Body>& theirs) {
        return mine == theirs.get();
    };
    if (!std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(), same))
        build(world);
    refit(world);
    use_up_clearances();
    for (Side& side : sides_) {
        std::fill(side.pair.begin(), side.pair.end(), -1);
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (contacts[i].kind == ContactKind::vertex_face && contacts[i].body_a == side.a &&
                contacts[i].body_b == side.b)
                side.pair[at(contacts[i].feature_a)] = static_cast<int>(i);
        look_at(world, side, contacts);
    }
    const auto ended = [](const Contact& contact) {
        return contact.kind == ContactKind::vertex_face && contact.feature_b < 0;
    };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), ended), contacts.end());
}

}  // namespace enduring
