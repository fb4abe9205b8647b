#include "chapters/06_redefinition/vertex_face_redefinition.hpp"

#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/face_choice.hpp"
#include "common/geometry/shortest_turn.hpp"

namespace enduring {
namespace {

void hand_on(const World& world, Contact& contact, double tau, const FaceTrial& choice,
             Redefinitions& redefinitions)
{
    const SurfaceMoment b = surface_at(*world.bodies[contact.body_b], tau);
    redefinitions.push_back({contact.body_a, contact.feature_a, contact.body_b, contact.feature_b,
                             choice.face, b.face_normal(choice.face), contact.start});
    // Over the edge between two faces the friction anchor's stretch goes on as it would on a flat surface.
    contact.spring.stretch = shortest_turn(b.face_normal(contact.feature_b), b.face_normal(choice.face)) *
                             contact.spring.stretch;
    put_on_face(contact, b.step.topology, choice.face, choice.foot.weights);
    contact.category = ContactCategory::regular;
    contact.hold(false);
}

}  // namespace

bool past_border(const SurfaceTopology& surface, int face, const std::array<double, 3>& weights)
{
    for (std::size_t corner = 0; corner < 3; ++corner) {
        // edge i runs from corner i to i + 1
        const int opposite = surface.edges_of_face(face)[(corner + 1) % 3];
        if (weights[corner] < 0 && surface.faces_at_edge(opposite)[1] < 0)
            return true;
    }
    return false;
}

namespace {

//! [redefine_enduring]
void redefine(const World& world, Contact& contact, Redefinitions& redefinitions)
{
    const PairSurfaces surfaces(world, contact, 0);
    const std::optional<TriangleFoot> foot = foot_on_face(surfaces.a, contact.feature_a, surfaces.b,
                                                          contact.feature_b);
    if (!foot)  // no area, no direction: wait until it has one
        return contact.hold(true);

    const auto& w = foot->weights;
    const double beyond = overshoot(w);
    const bool hooked = is_hooked_vertex(surfaces.a, contact.feature_a,
                                         surfaces.b.face_normal(contact.feature_b));
    if (hooked || beyond > 0 || foot->depth > 0) {
        const Corners around = hooked ? all_corners : corners_towards(*foot);
        const FaceLimits limits = hooked ? limits_of_hooked(world, contact, 0)
                                         : limits_of_shifted(world, contact, 0, beyond);
        if (const std::optional<FaceTrial> choice = find_face(world, contact, 0, around, limits))
            return hand_on(world, contact, 0, *choice, redefinitions);
    }

    put_on_face(contact, surfaces.b.step.topology, contact.feature_b, w);
    contact.category = hooked ? ContactCategory::hooked : ContactCategory::regular;
    contact.hold(hooked);
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
    if (const std::optional<FaceTrial> choice = find_face(world, contact, 1, all_corners,
                                                          limits_of_hooked(world, contact, 1)))
        hand_on(world, contact, 1, *choice, redefinitions);
    else
        contact.hold(true);
}
//! [redefine_hooked_entry]

}  // namespace enduring
