#include "vertex_face_redefinition.hpp"

#include "chapters/05_categorisation/category.hpp"

namespace enduring {
namespace {

/// Corners of a face around which neighbours are looked at.
using Corners = std::array<bool, 3>;

constexpr Corners all_corners{true, true, true};

//! [algorithm_6_1]
struct FaceChoice {
    int face = -1;
    FaceFoot foot{};
    double overshoot = 0;
};

/// Feet on a face before feet beside one; among equals the smaller penetration.
bool is_better(const FaceChoice& one, const FaceChoice& other)
{
    const bool beside = one.overshoot > 0, other_beside = other.overshoot > 0;
    return beside != other_beside ? other_beside : one.foot.depth > other.foot.depth;
}

/// The best regular face around some corners of a contact's present one; none if nothing is better than that.
///
/// @param tolerance  eps_v of (6.4): in the dead wedge below a valley no face has the foot. A face is taken only if its foot
///                   overshoots less than the present one's, so a vertex is not passed to and fro.
std::optional<FaceChoice> find_face(const World& world, const Contact& contact, double tau, const Corners& around, double tolerance)
{
    const PairSurfaces surfaces(world, contact, tau);
    std::optional<FaceChoice> best;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (!around[corner])
            continue;
        for (const int face : surfaces.b.step.topology.faces_around_vertex(contact.vertices[corner + 1])) {
            const std::optional<FaceFoot> foot =
                face == contact.feature_b ? std::nullopt : foot_on_face(surfaces.a, contact.feature_a, surfaces.b, face);
            if (!foot || foot->depth >= 0)
                continue;
            const FaceChoice candidate{face, *foot, overshoot(foot->weights)};
            const bool near_enough = candidate.overshoot == 0 || candidate.overshoot < tolerance;
            if (near_enough && (!best || is_better(candidate, *best)) &&
                !is_hooked_vertex(surfaces.a, contact.feature_a, surfaces.b.face_normal(face)))
                best = candidate;
        }
    }
    return best;
}
//! [algorithm_6_1]

void hand_on(const World& world, Contact& contact, double tau, const FaceChoice& choice, Redefinitions& redefinitions)
{
    const SurfaceMoment b = surface_at(*world.bodies[static_cast<std::size_t>(contact.body_b)], tau);
    redefinitions.push_back({contact.body_a, contact.feature_a, contact.body_b, contact.feature_b, choice.face, b.face_normal(choice.face)});
    put_on_face(contact, b.step.topology, choice.face, choice.foot.weights);
    contact.category = ContactCategory::regular;
    contact.held = false;
}

/// Whether a foot beyond the face lies beyond an edge that has no other face.
bool past_border(const SurfaceTopology& surface, int face, const std::array<double, 3>& weights)
{
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const int opposite = surface.edges_of_face(face)[(corner + 1) % 3];  // edge i runs from corner i to i + 1
        if (weights[corner] < 0 && surface.faces_at_edge(opposite)[1] < 0)
            return true;
    }
    return false;
}

//! [redefine_enduring]
void redefine(const World& world, Contact& contact, Redefinitions& redefinitions)
{
    const PairSurfaces surfaces(world, contact, 0);
    const std::optional<FaceFoot> foot = foot_on_face(surfaces.a, contact.feature_a, surfaces.b, contact.feature_b);
    if (!foot)  // no area, no direction: wait until it has one
        return void(contact.held = true);

    const auto& w = foot->weights;
    const double beyond = overshoot(w);
    const bool hooked = is_hooked_vertex(surfaces.a, contact.feature_a, surfaces.b.face_normal(contact.feature_b));
    const Corners around = hooked ? all_corners : Corners{w[0] > 0, w[1] > 0, w[2] > 0};
    if (hooked || beyond > 0 || foot->depth > 0)
        if (const std::optional<FaceChoice> choice = find_face(world, contact, 0, around, beyond))
            return hand_on(world, contact, 0, *choice, redefinitions);

    put_on_face(contact, surfaces.b.step.topology, contact.feature_b, w);
    contact.category = hooked ? ContactCategory::hooked : ContactCategory::regular;
    contact.held = hooked;
    contact.resolved = foot->depth > 0 || past_border(surfaces.b.step.topology, contact.feature_b, w);
}
//! [redefine_enduring]

}  // namespace

void redefine_enduring_vertices(const World& world, Contacts& contacts, Redefinitions& redefinitions)
{
    for (Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && !contact.resolved)
            redefine(world, contact, redefinitions);
}

//! [redefine_hooked_entry]
void redefine_hooked_entry(const World& world, Contact& contact, Redefinitions& redefinitions)
{
    if (const std::optional<FaceChoice> choice = find_face(world, contact, 1, all_corners, 0))
        hand_on(world, contact, 1, *choice, redefinitions);
    else
        contact.held = true;
}
//! [redefine_hooked_entry]

}  // namespace enduring
