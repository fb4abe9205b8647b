#pragma once

#include "chapters/05_categorisation/normal_span.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// How the two edges of a pair decide together, thesis (6.3).
enum class EdgeRule {
    both,   ///< hooked when both edges say so: "and", as the thesis prints it
    either  ///< hooked when one of them says so: "or", with which a cube slides
};

/// A normal closer than 45 degrees to the span pushes mostly off the surface, a farther one mostly along it.
inline constexpr double hook_cosine = 0.70710678118654752440;

/// Whether two directions of any length but zero are less than 45 degrees apart.
inline bool is_within_45_degrees(const Vec3& one, const Vec3& other)
{
    return one.dot(other) > hook_cosine * one.norm() * other.norm();
}

/// Thesis (6.2): whether a vertex of A that is pushed along `normal` is
/// pushed along its own surface rather than off it.
/// @param normal  of the contact, out of B; any length but zero
bool is_hooked_vertex(const SurfaceMoment& a, int vertex, const Vec3& normal);

/// Thesis (6.3): the same question for two edges. A's surface has to face against the normal, B's along it.
/// @param normal  of the contact, from B to A; any length but zero
bool is_hooked_edge_pair(const SurfaceMoment& a, int edge_a, const SurfaceMoment& b, int edge_b,
                         const Vec3& normal, EdgeRule rule = EdgeRule::either);

/// The category of a contact of any kind, from its features at one moment. A vertex on
/// a plane is always regular: planes have no edges to hook in. A pair without a normal
/// (a face without area, parallel edges) stays unknown.
/// @param tau  moment of the step, in [0, 1]; labels are taken at contact.start, see label_contacts
ContactCategory categorise(const World& world, const Contact& contact, double tau,
                           EdgeRule rule = EdgeRule::either);

/// The category that a vertex of one body and a face of another would
/// have as a pair, for choosing among faces.
ContactCategory categorise_vertex_face(const World& world, int body_a, int vertex, int body_b, int face,
                                       double tau);

/// Labels every contact, each at the moment from which it pushes in this step (contact.start): the start of
/// the step for one that endures, the time of impact for a new one. Before, the pair does not act; later, the
/// positions depend on the very impulse that the label is to judge.
void label_contacts(const World& world, Contacts& contacts, EdgeRule rule = EdgeRule::either);

/// Labels those that have no label yet. An answered pair keeps its label for the step.
void label_new_contacts(const World& world, Contacts& contacts, EdgeRule rule = EdgeRule::either);

}  // namespace enduring
