#include "chapters/engines/bullet/bullet_contacts.hpp"

#include "chapters/engines/bullet/bullet_vectors.hpp"
#include "common/geometry/triangle_distance.hpp"
#include "common/geometry/triangle_foot.hpp"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>

namespace enduring::bullet {
namespace {

// In Bullet's pairs of a convex body with triangles the triangles come second.
bool adjust_on_inner_edge(btManifoldPoint& point, const btCollisionObjectWrapper* convex, int, int,
                          const btCollisionObjectWrapper* triangle, int part, int index)
{
    btAdjustInternalEdgeContacts(point, triangle, convex, part, index);
    return true;
}

int nearest_vertex(const Body& body, const Vec3& point)
{
    const auto positions = body.positions_t1();
    const auto nearest = std::min_element(
        positions.begin(), positions.end(), [&](const Vec3& one, const Vec3& other) {
            return (one - point).squaredNorm() < (other - point).squaredNorm();
        });
    return static_cast<int>(nearest - positions.begin());
}

int nearest_face(const Body& body, const Vec3& point)
{
    const auto distance = [&](const Face& face) {
        const auto corner = [&](int i) { return body.positions_t1()[static_cast<std::size_t>(i)]; };
        return distance_to_triangle(point, corner(face[0]), corner(face[1]), corner(face[2]));
    };
    const auto faces = body.surface().faces();
    const auto nearest = std::min_element(
        faces.begin(), faces.end(),
        [&](const Face& one, const Face& other) { return distance(one) < distance(other); });
    return static_cast<int>(nearest - faces.begin());
}

Contact contact_of(const World& world, int body_a, int body_b, const btManifoldPoint& point)
{
    const Body &a = *world.bodies[static_cast<std::size_t>(body_a)],
               &b = *world.bodies[static_cast<std::size_t>(body_b)];
    const Vec3 place = from_bullet(point.getPositionWorldOnB());
    Contact contact;
    contact.body_a = body_a;
    contact.body_b = body_b;
    contact.feature_a = nearest_vertex(a, from_bullet(point.getPositionWorldOnA()));
    contact.feature_b = nearest_face(b, place);
    const auto [f0, f1, f2] = b.surface().faces()[static_cast<std::size_t>(contact.feature_b)];
    contact.vertices = {contact.feature_a, f0, f1, f2};
    const auto corner = [&](int i) { return b.positions_t1()[static_cast<std::size_t>(i)]; };
    if (const auto foot = foot_on_triangle(place, corner(f0), corner(f1), corner(f2)))
        contact.weights = {1, -foot->weights[0], -foot->weights[1], -foot->weights[2]};
    contact.impulse = point.getAppliedImpulse() * from_bullet(point.m_normalWorldOnB);
    contact.hold(true);
    return contact;
}

}  // namespace

InnerEdges::InnerEdges() { gContactAddedCallback = adjust_on_inner_edge; }

InnerEdges::~InnerEdges() { gContactAddedCallback = nullptr; }

Contacts contacts_of(const World& world, btCollisionDispatcher& dispatcher)
{
    Contacts contacts;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const int a = manifold.getBody0()->getUserIndex(), b = manifold.getBody1()->getUserIndex();
        if (a == no_body || b == no_body)
            continue;
        for (int j = 0; j < manifold.getNumContacts(); ++j) {
            const btManifoldPoint& point = manifold.getContactPoint(j);
            if (point.getDistance() <= 0 || point.getAppliedImpulse() > 0)
                contacts.push_back(contact_of(world, a, b, point));
        }
    }
    return contacts;
}

}  // namespace enduring::bullet
