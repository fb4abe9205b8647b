#pragma once

#include "chapters/02_collision_detection/swept_box.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <vector>

namespace enduring::chapter02 {

/// Bullet's dynamic tree over the boxes of a surface's faces, to compare ours with. It takes boxes one at a
/// time, as a world of moving objects needs it; a leaf is put in anew only when its box leaves the old one.
class BulletTree {
public:
    explicit BulletTree(const SurfaceStep& surface)
    {
        for (int f = 0; f < static_cast<int>(surface.topology.faces().size()); ++f) {
            leaves_.push_back(tree_.insert(volume(face_box(surface, f)), nullptr));
            leaves_.back()->dataAsInt = f;
        }
        tree_.optimizeTopDown();
    }
    BulletTree(const BulletTree&) = delete;
    BulletTree& operator=(const BulletTree&) = delete;

    void refit(const SurfaceStep& surface)
    {
        for (std::size_t f = 0; f < leaves_.size(); ++f) {
            btDbvtVolume box = volume(face_box(surface, static_cast<int>(f)));
            tree_.update(leaves_[f], box);
        }
    }

    /// Calls visit(face of a, face of b) for all pairs of faces whose boxes overlap.
    template <class Visit>
    static void overlapping_faces(BulletTree& a, BulletTree& b, Visit&& visit)
    {
        struct Policy final : btDbvt::ICollide {
            explicit Policy(Visit& to_call) : visit(to_call) {}
            void Process(const btDbvtNode* i, const btDbvtNode* j) override
            {
                visit(i->dataAsInt, j->dataAsInt);
            }
            Visit& visit;
        } policy(visit);
        a.tree_.collideTT(a.tree_.m_root, b.tree_.m_root, policy);
    }

private:
    static btDbvtVolume volume(const SweptBox& box)
    {
        return btDbvtVolume::FromMM({box.low.x(), box.low.y(), box.low.z()},
                                    {box.high.x(), box.high.y(), box.high.z()});
    }

    btDbvt tree_;
    std::vector<btDbvtNode*> leaves_;
};

}  // namespace enduring::chapter02
