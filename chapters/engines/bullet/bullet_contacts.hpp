#pragma once

#include "common/simulation/step.hpp"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

namespace enduring::bullet {

constexpr int no_body = -1;  ///< user index of what is not in World::bodies, or does not answer

/// While it lives, Bullet asks its edge utility about each new contact with static triangles: on an edge
/// inside a flat side the normal is that of the side. Bullet has one such hook for all its worlds.
class InnerEdges {
public:
    InnerEdges();
    ~InnerEdges();
    InnerEdges(const InnerEdges&) = delete;
    InnerEdges& operator=(const InnerEdges&) = delete;
};

/// Bullet's points between two bodies that touch or push, each as the pair of the nearest vertex of A and the
/// nearest face of B, held. The collision objects' user indices are those of the bodies.
Contacts contacts_of(const World& world, btCollisionDispatcher& dispatcher);

}  // namespace enduring::bullet
