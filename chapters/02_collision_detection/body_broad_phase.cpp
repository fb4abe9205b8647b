#include "chapters/02_collision_detection/body_broad_phase.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>

namespace enduring {
namespace {

btVector3 to_bullet(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

struct CollectPairs final : btDbvt::ICollide {
    std::vector<OverlappingBodies> pairs;
    int newest = 0;
    void Process(const btDbvtNode* leaf) override { pairs.push_back({leaf->dataAsInt, newest}); }
};

}  // namespace

//! [overlapping_bodies]
std::vector<OverlappingBodies> overlapping_bodies(std::span<const SweptBox> boxes)
{
    btDbvt tree;
    CollectPairs collect;
    for (const SweptBox& box : boxes) {
        if (box.low.allFinite() && box.high.allFinite()) {
            const btDbvtVolume volume = btDbvtVolume::FromMM(to_bullet(box.low), to_bullet(box.high));
            tree.collideTV(tree.m_root, volume, collect);
            tree.insert(volume, nullptr)->dataAsInt = collect.newest;
        }
        ++collect.newest;
    }
    std::sort(collect.pairs.begin(), collect.pairs.end());  // the tree's order is its own business
    return collect.pairs;
}
//! [overlapping_bodies]

}  // namespace enduring
