#include "chapters/02_collision_detection/body_broad_phase.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>

using namespace enduring;

namespace {

/// Cubes of edge 1, their low corners on whole numbers from 0 to `extent` - 1:
/// many of them touch in a face, an edge or a corner.
std::vector<SweptBox> random_cubes(int count, int extent, unsigned seed)
{
    std::mt19937 generator(seed);
    const auto whole = [&] { return static_cast<double>(generator() % static_cast<unsigned>(extent)); };
    std::vector<SweptBox> boxes;
    for (int i = 0; i < count; ++i) {
        const Vec3 low(whole(), whole(), whole());
        boxes.push_back({low, low + Vec3::Ones()});
    }
    return boxes;
}

std::vector<OverlappingBodies> by_looking_at_all(const std::vector<SweptBox>& boxes)
{
    std::vector<OverlappingBodies> pairs;
    for (std::size_t a = 0; a < boxes.size(); ++a)
        for (std::size_t b = a + 1; b < boxes.size(); ++b)
            if (boxes[a].overlaps(boxes[b]))
                pairs.push_back({static_cast<int>(a), static_cast<int>(b)});
    return pairs;
}

}  // namespace

TEST_CASE(
    "bodies: the tree finds the pairs that looking at all of them finds, in their order, touching ones too")
{
    for (const int count : {0, 1, 2, 10, 300})
        for (const int extent : {1, 3, 10}) {
            CAPTURE(count);
            CAPTURE(extent);
            const std::vector<SweptBox> boxes = random_cubes(count, extent, 4);
            CHECK(overlapping_bodies(boxes) == by_looking_at_all(boxes));
        }
}

TEST_CASE("bodies: a box that is empty, or not finite, overlaps nothing and hides no other pair")
{
    std::vector<SweptBox> boxes = random_cubes(40, 3, 5);
    boxes[0] = SweptBox::empty();
    boxes[7].low.x() = boxes[7].high.x() = std::numeric_limits<double>::quiet_NaN();
    std::vector<OverlappingBodies> expected = by_looking_at_all(boxes);
    std::erase_if(expected,
                  [](const OverlappingBodies& pair) { return pair.a == 0 || pair.a == 7 || pair.b == 7; });
    CHECK(overlapping_bodies(boxes) == expected);
}
