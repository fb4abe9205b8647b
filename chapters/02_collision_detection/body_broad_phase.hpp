#pragma once

#include "chapters/02_collision_detection/swept_box.hpp"

#include <span>
#include <vector>

namespace enduring {

/// Two bodies by their numbers, a < b.
struct OverlappingBodies {
    int a, b;
    auto operator<=>(const OverlappingBodies&) const = default;
};

/// The pairs of boxes that overlap, in ascending order. For many bodies, few of which are near each other,
/// this takes O(n log n + pairs): Bullet's dynamic tree (btDbvt) is asked for every box as it grows.
/// @param boxes  one around each body over the step; one that is not finite (or holds nothing) overlaps none
std::vector<OverlappingBodies> overlapping_bodies(std::span<const SweptBox> boxes);

/// Whether a list in ascending order has an entry for two bodies. Who asks for pairs in ascending order, too,
/// goes through the list once.
/// @param place  in the list, from which it moves on to the entry, or to where it would stand
template <class Iterator>
bool find_onwards(Iterator& place, Iterator end, const OverlappingBodies& pair)
{
    while (place != end && OverlappingBodies{place->a, place->b} < pair)
        ++place;
    return place != end && OverlappingBodies{place->a, place->b} == pair;
}

}  // namespace enduring
