#include "chapters/02_collision_detection/body_broad_phase.hpp"

namespace enduring {

/// In place of Bullet's tree, which is no library for the browser
/// here: a live figure has two bodies or three.
std::vector<OverlappingBodies> overlapping_bodies(std::span<const SweptBox> boxes)
{
    std::vector<OverlappingBodies> pairs;
    for (int a = 0; a < static_cast<int>(boxes.size()); ++a)
        for (int b = a + 1; b < static_cast<int>(boxes.size()); ++b)
            if (boxes[a].overlaps(boxes[b]))
                pairs.push_back({a, b});
    return pairs;
}

}  // namespace enduring
