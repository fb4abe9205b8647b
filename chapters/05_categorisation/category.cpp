#include "chapters/05_categorisation/category.hpp"

#include "chapters/03_penalty_impulses/penetration.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "common/geometry/tolerances.hpp"

namespace enduring {
namespace {

const Body& body(const World& world, int index) { return *world.bodies[index]; }

/// Two sides whose angle is lost in rounding span no normal.
bool has_normal(const PairInstant& pair, const Vec3& normal)
{
    return normal.squaredNorm() > tolerance::least_sine * tolerance::least_sine * pair.side_1.squaredNorm() *
                                      pair.side_2.squaredNorm();
}

ContactCategory hooked_or_regular(bool hooked)
{
    return hooked ? ContactCategory::hooked : ContactCategory::regular;
}

ContactCategory categorise_edge_pair(const SurfaceMoment& a, const SurfaceMoment& b, const Contact& contact,
                                     EdgeRule rule)
{
    const auto [a0, a1] = a.step.edge(contact.feature_a);
    const auto [b0, b1] = b.step.edge(contact.feature_b);
    const PairInstant pair = edge_edge_instant(
        {a.position(a0), a.position(a1), b.position(b0), b.position(b1)}, contact.orientation);
    const Vec3 normal = pair.side_1.cross(pair.side_2);
    if (!has_normal(pair, normal))
        return ContactCategory::unknown;
    return hooked_or_regular(is_hooked_edge_pair(a, contact.feature_a, b, contact.feature_b, normal, rule));
}

}  // namespace

//! [is_hooked]
bool is_hooked_vertex(const SurfaceMoment& a, int vertex, const Vec3& normal)
{
    return !span_reaches(a, a.step.topology.faces_around_vertex(vertex), -normal, hook_cosine);
}

bool is_hooked_edge_pair(const SurfaceMoment& a, int edge_a, const SurfaceMoment& b, int edge_b,
                         const Vec3& normal, EdgeRule rule)
{
    const bool a_says_hooked = !span_reaches(a, a.step.topology.faces_at_edge(edge_a), -normal, hook_cosine);
    if (rule == EdgeRule::either && a_says_hooked)
        return true;
    if (rule == EdgeRule::both && !a_says_hooked)
        return false;
    return !span_reaches(b, b.step.topology.faces_at_edge(edge_b), normal, hook_cosine);
}
//! [is_hooked]

ContactCategory categorise(const World& world, const Contact& contact, double tau, EdgeRule rule)
{
    switch (contact.kind) {
        case ContactKind::vertex_face:
            return categorise_vertex_face(world, contact.body_a, contact.feature_a, contact.body_b,
                                          contact.feature_b, tau);
        case ContactKind::edge_edge:
            return categorise_edge_pair(surface_at(body(world, contact.body_a), tau),
                                        surface_at(body(world, contact.body_b), tau), contact, rule);
        case ContactKind::vertex_plane: break;
    }
    return ContactCategory::regular;
}

ContactCategory categorise_vertex_face(const World& world, int body_a, int vertex, int body_b, int face,
                                       double tau)
{
    const SurfaceMoment a = surface_at(body(world, body_a), tau), b = surface_at(body(world, body_b), tau);
    const auto [f0, f1, f2] = b.step.face(face);
    const PairInstant pair =
        vertex_face_instant({a.position(vertex), b.position(f0), b.position(f1), b.position(f2)});
    const Vec3 normal = pair.side_1.cross(pair.side_2);
    return has_normal(pair, normal) ? hooked_or_regular(is_hooked_vertex(a, vertex, normal))
                                    : ContactCategory::unknown;
}

//! [label_contacts]
void label_contacts(const World& world, Contacts& contacts, EdgeRule rule)
{
    for (Contact& contact : contacts)
        contact.category = categorise(world, contact, contact.start, rule);
}

void label_new_contacts(const World& world, Contacts& contacts, EdgeRule rule)
{
    for (Contact& contact : contacts)
        if (contact.category == ContactCategory::unknown)
            contact.category = categorise(world, contact, contact.start, rule);
}
//! [label_contacts]

}  // namespace enduring
