#include "chapters/07_implicit_contact/rim_pairs.hpp"

#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "common/geometry/triangle_distance.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

bool pushes_a_vertex(const Contact& contact)
{
    return contact.kind == ContactKind::vertex_face && contact.endures() && contact.is_spring() &&
           contact.category == ContactCategory::regular;
}

std::tuple<int, int, int> vertex_and_body(const Contact& contact)
{
    return {contact.body_a, contact.feature_a, contact.body_b};
}

/// How far a vertex' foot lies from its face at the end of the step [m]; none for a vertex that is not below
/// the face's plane.
std::optional<double> beyond_rim(const World& world, const Contact& contact)
{
    const PairSurfaces surfaces(world, contact, 1);
    const std::optional<TriangleFoot> foot = foot_on_face(surfaces.a, contact.feature_a, surfaces.b,
                                                          contact.feature_b);
    if (!foot || foot->depth >= 0)
        return std::nullopt;
    if (overshoot(foot->weights) == 0)
        return 0;
    const auto [f0, f1, f2] = surfaces.b.step.face(contact.feature_b);
    const Vec3 &x0 = surfaces.b.position(f0), &x1 = surfaces.b.position(f1), &x2 = surfaces.b.position(f2);
    const auto [w0, w1, w2] = foot->weights;
    return distance_to_triangle(w0 * x0 + w1 * x1 + w2 * x2, x0, x1, x2);
}

/// Whether the edges are far enough from parallel to have feet at the start of the step.
bool have_feet(const World& world, const Contact& pair)
{
    const PairSurfaces surfaces(world, pair, 0);
    return feet_of_edges(edge_vertices(surfaces, pair.feature_a, pair.feature_b), pair.orientation,
                         smallest_edge_sine)
        .has_value();
}

/// How far the feet of a pair of edges lie from them at the start of the step [m].
double beyond_ends(const World& world, const Contact& pair)
{
    const auto beyond = [&](int first, double place) {
        const Vec3 along = contact_vertex(world, pair, first + 1, 0) - contact_vertex(world, pair, first, 0);
        return along.norm() * std::max({0.0, -place, place - 1});
    };
    return std::max(beyond(0, pair.weights[1]), beyond(2, -pair.weights[3]));
}

/// How far beyond its rim or its end a pair goes on [m].
double hair(const World& world, const Contact& contact, const StiffnessChoice& choice)
{
    return choice.depth(natural_length(world, contact));
}

}  // namespace

//! [keep]
void RimPairs::keep(const World& world, const Contacts& before, const StiffnessChoice& choice,
                    Contacts& contacts)
{
    std::set<Key> going_on, outside;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Key key = vertex_and_body(before[i]);
        Contact& contact = contacts[i];
        if (!pushes_a_vertex(before[i]) || (!contact.resolved && !outside_.contains(key)))
            continue;
        const std::optional<double> from_face = beyond_rim(world, contact);
        contact.resolved = !from_face || *from_face > hair(world, contact, choice);
        if (!contact.resolved)
            going_on.insert(key);
        if (!contact.resolved && *from_face > 0)
            outside.insert(key);
    }
    outside_ = std::move(outside);
    // A vertex that left and came back within the step has a new pair, too.
    contacts.erase(
        std::remove_if(contacts.begin() + static_cast<std::ptrdiff_t>(before.size()), contacts.end(),
                       [&](const Contact& pair) { return going_on.contains(vertex_and_body(pair)); }),
        contacts.end());
}
//! [keep]

void push_beyond_ends(const World& world, const Contacts& before, const StiffnessChoice& choice,
                      Contacts& contacts)
{
    for (std::size_t i = 0; i < before.size(); ++i) {
        Contact& pair = contacts[i];
        const bool is_held_at_an_end = pair.kind == ContactKind::edge_edge && pair.held() && !pair.resolved &&
                                       pair.category == ContactCategory::regular && have_feet(world, pair);
        if (is_held_at_an_end && before[i].is_spring() &&
            beyond_ends(world, pair) <= hair(world, pair, choice))
            pair.hold(false);
    }
}

}  // namespace enduring
