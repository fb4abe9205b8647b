#include "chapters/05_categorisation/category.hpp"

#include "chapters/03_penalty_impulses/penetration.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "common/geometry/tolerances.hpp"
#include "exercises/not_implemented_yet.hpp"

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
    not_implemented_yet("5.1");
}

}  // namespace

bool is_hooked_vertex(const SurfaceMoment& a, int vertex, const Vec3& normal)
{
    not_implemented_yet("5.1");
}

bool is_hooked_edge_pair(const SurfaceMoment& a, int edge_a, const SurfaceMoment& b, int edge_b,
                         const Vec3& normal, EdgeRule rule)
{
    not_implemented_yet("5.1");
}

ContactCategory categorise(const World& world, const Contact& contact, double tau, EdgeRule rule)
{
    not_implemented_yet("5.1");
}

ContactCategory categorise_vertex_face(const World& world, int body_a, int vertex, int body_b, int face,
                                       double tau)
{
    not_implemented_yet("5.1");
}

void label_contacts(const World& world, Contacts& contacts, EdgeRule rule)
{
    not_implemented_yet("5.1");
}

void label_new_contacts(const World& world, Contacts& contacts, EdgeRule rule)
{
    not_implemented_yet("5.1");
}

}  // namespace enduring
