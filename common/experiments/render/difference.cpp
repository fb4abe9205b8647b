#include "common/experiments/render/difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace enduring {
namespace {

constexpr int tile = 4;             ///< pixels along a tile
constexpr int visible_levels = 12;  ///< two tiles look different from here on

using Color = std::array<double, 3>;

Color mean(const Picture& picture, int left, int top)
{
    Color sum{};
    int count = 0;
    for (int y = top; y < std::min(top + tile, picture.height); ++y)
        for (int x = left; x < std::min(left + tile, picture.width); ++x, ++count)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += picture.at(x, y)[c];
    for (double& level : sum)
        level /= count;
    return sum;
}

double distance(const Color& a, const Color& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// Calls visit(left, top, difference in levels) for every tile of two pictures of one size.
template <class Visit>
void for_each_tile(const Picture& a, const Picture& b, Visit&& visit)
{
    for (int top = 0; top < a.height; top += tile)
        for (int left = 0; left < a.width; left += tile)
            visit(left, top, distance(mean(a, left, top), mean(b, left, top)));
}

bool have_one_size(const Picture& a, const Picture& b) { return a.width == b.width && a.height == b.height; }

std::string size_text(const Picture& picture)
{
    return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

}  // namespace

PictureDifference compare_pictures(const Picture& got, const Picture& expected)
{
    PictureDifference difference;
    if (!have_one_size(got, expected)) {
        difference.message = "the picture is " + size_text(got) + " pixels, expected were " +
                             size_text(expected);
        return difference;
    }
    int tiles = 0;
    for_each_tile(got, expected, [&](int, int, double levels) {
        ++tiles;
        difference.tiles_off += levels > visible_levels;
        difference.largest = std::max(difference.largest, static_cast<int>(std::lround(levels)));
    });
    difference.tiles_allowed = std::max(2, tiles / 5000);
    difference.same = difference.tiles_off <= difference.tiles_allowed;
    difference.message = std::to_string(difference.tiles_off) + " of " + std::to_string(tiles) +
                         " tiles look different (allowed are " + std::to_string(difference.tiles_allowed) +
                         "), by up to " + std::to_string(difference.largest) + " levels";
    return difference;
}

Picture difference_picture(const Picture& got, const Picture& expected)
{
    if (!have_one_size(got, expected))
        return got;
    Picture picture(got.width, got.height);
    for_each_tile(got, expected, [&](int left, int top, double levels) {
        for (int y = top; y < std::min(top + tile, picture.height); ++y)
            for (int x = left; x < std::min(left + tile, picture.width); ++x) {
                const auto pale = static_cast<std::uint8_t>(150 + got.at(x, y)[1] / 3);
                const auto fading = static_cast<std::uint8_t>(pale - std::min(150.0, 4 * levels));
                const std::array<std::uint8_t, 3> color{pale, fading, fading};
                std::copy(color.begin(), color.end(), picture.at(x, y));
            }
    });
    return picture;
}

}  // namespace enduring
