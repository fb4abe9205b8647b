#include "chapters/09_deep_contacts/neighbours.hpp"

#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/06_redefinition/face_choice.hpp"

namespace enduring {
namespace {

bool pushes_already(const Contact& contact)
{
    return contact.category == ContactCategory::regular && !contact.held() && !contact.resolved &&
           (contact.endures() || contact.answered());
}

//! [direction]
std::optional<Vec3> direction_among(const World& world, const Contacts& contacts,
                                    const VertexContacts& in_contact, const Contact& contact, double tau)
{
    const SurfaceTopology& surface = world.bodies[contact.body_a]->surface();
    const SurfaceMoment b = surface_at(*world.bodies[contact.body_b], tau);
    Vec3 sum = Vec3::Zero();
    for (const int edge : surface.edges_around_vertex(contact.feature_a)) {
        const auto [v0, v1] = surface.edges()[edge];
        const int neighbour = v0 == contact.feature_a ? v1 : v0;
        const int index = in_contact.find(contact.body_a, neighbour, contact.body_b);
        if (index >= 0 && pushes_already(contacts[index]))
            sum += b.face_normal(contacts[index].feature_b).normalized();
    }
    const double length = sum.norm();
    return length > tolerance::cancelled ? std::optional<Vec3>(sum / length) : std::nullopt;
}
//! [direction]

//! [vouched]
/// The direction of its neighbours, for a vertex-face pair that only they call regular.
std::optional<Vec3> vouched_direction(const World& world, const Contacts& contacts,
                                      const VertexContacts& in_contact, const Contact& contact, double tau)
{
    if (contact.kind != ContactKind::vertex_face || contact.resolved)
        return std::nullopt;
    const PairSurfaces surfaces(world, contact, tau);
    const Vec3 normal = surfaces.b.face_normal(contact.feature_b);
    if (!(normal.squaredNorm() > 0) || !is_hooked_vertex(surfaces.a, contact.feature_a, normal))
        return std::nullopt;
    const std::optional<Vec3> direction = direction_among(world, contacts, in_contact, contact, tau);
    return direction && is_within_45_degrees(normal, *direction) ? direction : std::nullopt;
}
//! [vouched]

//! [follow]
/// The best face around the present one among those that look in a direction.
std::optional<FaceTrial> face_in_direction(const World& world, const Contact& contact,
                                           const TriangleFoot& foot, const Vec3& direction)
{
    const PairSurfaces surfaces(world, contact, 0);
    const FaceLimits limits = limits_of_shifted(world, contact, 0, overshoot(foot.weights));
    std::optional<FaceTrial> best;
    visit_candidates(surfaces, contact, corners_towards(foot), [&](int face) {
        const FaceTrial trial = try_face(surfaces, contact.feature_a, face, limits);
        const bool lies_below = trial.verdict == FaceVerdict::fit || trial.verdict == FaceVerdict::hooked;
        if (lies_below && is_within_45_degrees(surfaces.b.face_normal(face), direction) &&
            (!best || is_better(trial, *best)))
            best = trial;
    });
    return best;
}

void follow(const World& world, Contact& contact, const Vec3& direction)
{
    const PairSurfaces surfaces(world, contact, 0);
    const TriangleFoot foot = *foot_on_face(surfaces.a, contact.feature_a, surfaces.b,
                                            contact.feature_b);  // it has an area
    contact.category = ContactCategory::regular;
    contact.hold(false);
    put_on_face(contact, surfaces.b.step.topology, contact.feature_b, foot.weights);
    contact.resolved = foot.depth > 0;
    if (overshoot(foot.weights) > 0 || foot.depth > 0)
        if (const std::optional<FaceTrial> choice = face_in_direction(world, contact, foot, direction)) {
            put_on_face(contact, surfaces.b.step.topology, choice->face, choice->foot.weights);
            contact.resolved = false;
        }
}
//! [follow]

}  // namespace

std::optional<Vec3> direction_of_neighbours(const World& world, const Contacts& contacts,
                                            const Contact& contact, double tau)
{
    return direction_among(world, contacts, VertexContacts(contacts), contact, tau);
}

//! [vouch]
void vouch_for_new_pairs(const World& world, Contacts& contacts)
{
    const VertexContacts in_contact(contacts);
    for (Contact& contact : contacts)
        if (contact.waiting() && !contact.endures() && contact.category == ContactCategory::hooked &&
            vouched_direction(world, contacts, in_contact, contact, contact.start))
            contact.category = ContactCategory::regular;
}

std::vector<VouchedPair> take_vouched_pairs(const World& world, Contacts& contacts)
{
    const VertexContacts in_contact(contacts);
    std::vector<VouchedPair> vouched;
    Contacts others;
    for (const Contact& contact : contacts)
        if (const auto direction = vouched_direction(world, contacts, in_contact, contact, 0))
            vouched.push_back({contact, *direction});
        else
            others.push_back(contact);
    contacts = std::move(others);
    return vouched;
}
//! [vouch]

void follow_vouched_pairs(const World& world, const std::vector<VouchedPair>& vouched, Contacts& contacts)
{
    for (const VouchedPair& pair : vouched) {
        contacts.push_back(pair.contact);
        follow(world, contacts.back(), pair.direction);
    }
}

}  // namespace enduring
