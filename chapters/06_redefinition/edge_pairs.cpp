#include "chapters/06_redefinition/edge_pairs.hpp"

#include "chapters/05_categorisation/category.hpp"

#include <tuple>

namespace enduring {
namespace {

//! [dismiss]
void dismiss_or_hold(const World& world, Contact& contact)
{
    const PairSurfaces surfaces(world, contact, 0);
    const PairVertices x = edge_vertices(surfaces, contact.feature_a, contact.feature_b);
    const std::optional<EdgeFeet> feet = feet_of_edges(x, contact.orientation, smallest_edge_sine);
    if (!feet)
        return contact.hold(true);

    put_at(contact, *feet);
    const bool hooked = is_hooked_edge_pair(surfaces.a, contact.feature_a, surfaces.b, contact.feature_b,
                                            feet->normal);
    contact.category = hooked ? ContactCategory::hooked : ContactCategory::regular;
    contact.hold(hooked || !feet->overlap(0));
    contact.resolved = feet->depth > 0 || !feet->overlap(edge_tolerance);
}
//! [dismiss]

}  // namespace

void dismiss_enduring_edges(const World& world, Contacts& contacts)
{
    for (Contact& contact : contacts)
        if (contact.kind == ContactKind::edge_edge && !contact.resolved)
            dismiss_or_hold(world, contact);
}

namespace {

bool is_known(const Contact& pair, const Contacts& contacts)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
        return c.kind == ContactKind::edge_edge && !c.resolved && c.body_a == pair.body_a &&
               c.body_b == pair.body_b && c.feature_a == pair.feature_a && c.feature_b == pair.feature_b;
    });
}

bool has_vertex(const Face& face, int vertex)
{
    return std::find(face.begin(), face.end(), vertex) != face.end();
}

/// L_B: edges at the vertices that both faces have; at all those of the new face if they
/// have none in common, as after a step that crossed a whole face. An edge between two
/// such vertices comes twice: the second time it is known.
template <class Visit>
void visit_edges_between(const SurfaceTopology& surface, int old_face, int new_face, Visit&& visit)
{
    const Face &old_corners = surface.faces()[old_face], &new_corners = surface.faces()[new_face];
    const auto is_mutual = [&](int vertex) { return has_vertex(old_corners, vertex); };
    const bool apart = std::none_of(new_corners.begin(), new_corners.end(), is_mutual);
    for (const int vertex : new_corners)
        if (apart || is_mutual(vertex))
            for (const int edge : surface.edges_around_vertex(vertex))
                visit(edge);
}

//! [append_edge_pair]
/// Whether a pair pushes as the vertex's pair does, give or take 45 degrees. Without it, the
/// upright edge of a box that lies far inside the rim of the one below would count as regular,
/// and push it out sideways (the ambiguity of figure 6.9).
bool pushes_along(const Vec3& normal, const Vec3& reference)
{
    return normal.dot(reference) > hook_cosine * reference.norm();
}

/// @param reference  points from the pair's B to its A
void append_if_touching(const World& world, Contact pair, const Vec3& reference, double tau,
                        Contacts& contacts)
{
    const PairSurfaces surfaces(world, pair, tau);
    if (surfaces.neighbours && surfaces.neighbours->edges(pair.feature_a, pair.feature_b))
        return;
    const PairVertices x = edge_vertices(surfaces, pair.feature_a, pair.feature_b);
    pair.orientation = (x[1] - x[0]).cross(x[3] - x[2]).dot(reference) < 0 ? -1 : 1;
    const std::optional<EdgeFeet> feet = feet_of_edges(x, pair.orientation, smallest_edge_sine);
    if (!feet || feet->depth >= 0 || !feet->overlap(edge_tolerance) ||
        !pushes_along(feet->normal, reference) || is_known(pair, contacts) ||
        is_hooked_edge_pair(surfaces.a, pair.feature_a, surfaces.b, pair.feature_b, feet->normal))
        return;
    const auto [a0, a1] = surfaces.a.step.edge(pair.feature_a);
    const auto [b0, b1] = surfaces.b.step.edge(pair.feature_b);
    pair.vertices = {a0, a1, b0, b1};
    pair.category = ContactCategory::regular;
    pair.hold(!feet->overlap(0));
    put_at(pair, *feet);
    contacts.push_back(pair);
}
//! [append_edge_pair]

/// Edge pairs stand in the list with the smaller body first, as detection makes them; those of a body with
/// itself with the smaller edge first.
bool stands_first(const Redefinition& of, int edge_at_vertex, int edge_between)
{
    return std::tie(of.body_a, edge_at_vertex) < std::tie(of.body_b, edge_between);
}

Contact edge_pair(const Redefinition& of, int edge_at_vertex, int edge_between)
{
    Contact pair{ContactKind::edge_edge, of.body_a, of.body_b, edge_at_vertex, edge_between};
    if (!stands_first(of, edge_at_vertex, edge_between))
        pair = {ContactKind::edge_edge, of.body_b, of.body_a, edge_between, edge_at_vertex};
    pair.start = of.start;
    return pair;
}

}  // namespace

//! [append_edge_pairs]
void append_edge_pairs(const World& world, const Redefinitions& redefinitions, double tau, Contacts& contacts)
{
    for (const Redefinition& of : redefinitions) {
        const SurfaceTopology &surface_a = world.bodies[of.body_a]->surface(),
                              &surface_b = world.bodies[of.body_b]->surface();
        visit_edges_between(surface_b, of.old_face, of.new_face, [&](int edge_between) {
            for (const int edge_at_vertex : surface_a.edges_around_vertex(of.vertex)) {
                const double sign = stands_first(of, edge_at_vertex, edge_between) ? 1 : -1;
                append_if_touching(world, edge_pair(of, edge_at_vertex, edge_between),
                                   sign * of.reference_normal, tau, contacts);
            }
        });
    }
}
//! [append_edge_pairs]

}  // namespace enduring
