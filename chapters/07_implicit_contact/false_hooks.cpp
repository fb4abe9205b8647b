#include "chapters/07_implicit_contact/false_hooks.hpp"

#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/face_choice.hpp"
#include "chapters/06_redefinition/vertex_face_redefinition.hpp"
#include "chapters/07_implicit_contact/normal_cone.hpp"
#include "chapters/07_implicit_contact/plausible_depth.hpp"
#include "common/geometry/shortest_turn.hpp"

#include <algorithm>

namespace enduring {
namespace {

bool vertex_faces_it(const SurfaceMoment& a, int vertex, const Vec3& normal)
{
    return cone_reaches(a, a.step.topology.faces_around_vertex(vertex), -normal, hook_cosine);
}

/// Whether the face to which chapter 6 would hand a hooked pair is one that its vertex cannot have come near.
bool would_go_too_deep(const World& world, const Contacts& contacts, const Contact& hooked, double tau)
{
    const std::optional<FaceTrial> choice = find_face(world, hooked, tau, all_corners,
                                                      limits_of_hooked(world, hooked, tau));
    return choice && -choice->foot.depth > plausible_depth(world, contacts, hooked);
}

//! [falsely]
/// @param tau         moment of the step at which the pair is looked at
/// @param handed_on   and the one at which chapter 6 looks for another face
bool is_falsely_hooked(const World& world, const Contacts& contacts, const Contact& contact, double tau,
                       double handed_on)
{
    if (contact.kind != ContactKind::vertex_face ||
        categorise(world, contact, tau) != ContactCategory::hooked)
        return false;
    const PairSurfaces surfaces(world, contact, tau);
    return vertex_faces_it(surfaces.a, contact.feature_a, surfaces.b.face_normal(contact.feature_b)) ||
           would_go_too_deep(world, contacts, contact, handed_on);
}
//! [falsely]

}  // namespace

void admit_falsely_hooked(const World& world, Contacts& contacts)
{
    for (Contact& contact : contacts)
        if (contact.waiting() && contact.category == ContactCategory::hooked &&
            is_falsely_hooked(world, contacts, contact, contact.start, 1))
            contact.category = ContactCategory::regular;
}

Contacts take_falsely_hooked(const World& world, Contacts& contacts)
{
    Contacts falsely, others;
    for (const Contact& contact : contacts) {
        const bool taken = !contact.resolved && is_falsely_hooked(world, contacts, contact, 0, 0);
        (taken ? falsely : others).push_back(contact);
    }
    contacts = std::move(others);
    return falsely;
}

namespace {

/// Algorithm 6.1 around the corners on the foot's side, with the cone's
/// answer in place of the span's.
std::optional<FaceTrial> find_face_by_cone(const World& world, const Contact& contact,
                                           const TriangleFoot& foot)
{
    const PairSurfaces surfaces(world, contact, 0);
    const FaceLimits limits = limits_of_shifted(world, contact, 0, overshoot(foot.weights));
    std::optional<FaceTrial> best;
    visit_candidates(surfaces, contact, corners_towards(foot), [&](int face) {
        const FaceTrial trial = try_face(surfaces, contact.feature_a, face, limits);
        const bool fits = trial.verdict == FaceVerdict::fit ||
                          (trial.verdict == FaceVerdict::hooked &&
                           vertex_faces_it(surfaces.a, contact.feature_a, surfaces.b.face_normal(face)));
        if (fits && (!best || is_better(trial, *best)))
            best = trial;
    });
    return best;
}

//! [hand_on]
/// The spring keeps what it holds: the depth under another face is another number.
void hand_on(const World& world, Contact& contact, double depth, const FaceTrial& choice)
{
    const SurfaceMoment b = surface_at(*world.bodies[contact.body_b], 0);
    contact.stretch = shortest_turn(b.face_normal(contact.feature_b), b.face_normal(choice.face)) *
                      contact.stretch;
    contact.slack = std::min(0.0, choice.foot.depth - std::min(0.0, depth - contact.slack));
    put_on_face(contact, b.step.topology, choice.face, choice.foot.weights);
    contact.resolved = false;
}

/// The face to which a vertex goes whose foot has left its own.
std::optional<FaceTrial> next_face(const World& world, const Contact& contact, const TriangleFoot& foot)
{
    const bool left = overshoot(foot.weights) > 0 || foot.depth > 0;
    return left ? find_face_by_cone(world, contact, foot) : std::nullopt;
}
//! [hand_on]

/// @param contact  on a face with an area
TriangleFoot foot_of(const World& world, const Contact& contact)
{
    const PairSurfaces surfaces(world, contact, 0);
    return *foot_on_face(surfaces.a, contact.feature_a, surfaces.b, contact.feature_b);
}

void follow(const World& world, Contact& contact)
{
    contact.category = ContactCategory::regular;
    contact.hold(false);
    const TriangleFoot foot = foot_of(world, contact);
    if (const std::optional<FaceTrial> choice = next_face(world, contact, foot))
        return hand_on(world, contact, foot.depth, *choice);
    const SurfaceTopology& surface_b = world.bodies[contact.body_b]->surface();
    put_on_face(contact, surface_b, contact.feature_b, foot.weights);
    contact.resolved = foot.depth > 0 || past_border(surface_b, contact.feature_b, foot.weights);
}

}  // namespace

void follow_by_cone(const World& world, const Contacts& falsely, Contacts& contacts)
{
    for (Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && !contact.held()) {
            const TriangleFoot foot = foot_of(world, contact);
            const std::optional<FaceTrial> choice = next_face(world, contact, foot);
            if (choice && choice->verdict == FaceVerdict::hooked)
                hand_on(world, contact, foot.depth, *choice);
        }
    for (const Contact& contact : falsely) {
        contacts.push_back(contact);
        follow(world, contacts.back());
    }
}

}  // namespace enduring
