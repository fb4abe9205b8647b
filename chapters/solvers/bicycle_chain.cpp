#include "chapters/solvers/bicycle_chain.hpp"

#include "common/geometry/polygon_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace enduring::solvers {
namespace {

using Loop = std::vector<long>;  ///< of vertices, counter-clockwise seen against the pins

constexpr int around = 12;  ///< corners of a hole or a pin
constexpr double pin = 0.0018, bore = 0.0019, bushing = 0.0028, end = 0.0042, waist = 0.0034;  ///< radii [m]
constexpr double outer_face = ChainLink::outer_half_height, outer_inside = 0.0028,
                 inner_face = outer_inside - ChainLink::play, inner_inside = 0.0016;  ///< heights [m]

/// A plate's face at a height: its outline and, around each pin, a ring and what surrounds this ring as far
/// as the outline or the middle of the plate.
struct Level {
    Loop outline;
    std::array<Loop, 2> rings, surroundings;
};

class Link {
public:
    /// @param radius  of the rings
    Level add_level(double height, double radius)
    {
        Level level;
        Loop middle;  // of the plate, from one side of the waist to the other
        constexpr int across = around / 2 - 1;
        for (int i = 0; i < across; ++i)
            middle.push_back(add(0, waist * (1 - 2.0 * i / (across - 1)), height));
        for (const std::size_t side : {0U, 1U}) {
            const double sign = side == 0 ? 1 : -1;
            Loop half;
            for (int i = 0; i < around; ++i) {
                const double angle = 2 * std::numbers::pi * i / around, x = std::cos(angle),
                             y = std::sin(angle), centre = 0.5 * ChainLink::pitch;
                level.rings[side].push_back(add(sign * (centre + radius * x), sign * radius * y, height));
                const int beyond = i - around / 4 - 1;  // along the middle
                level.surroundings[side].push_back(
                    beyond >= 0 && beyond < across
                        ? middle[static_cast<std::size_t>(side == 0 ? beyond : across - 1 - beyond)]
                        : add(sign * (centre + end * x), sign * end * y, height));
            }
            for (int i = -around / 4; i <= around / 4; ++i)
                half.push_back(level.surroundings[side][static_cast<std::size_t>((i + around) % around)]);
            level.outline.insert(level.outline.end(), half.begin(), half.end());
            level.outline.push_back(side == 0 ? middle.front() : middle.back());
        }
        return level;
    }

    void add_face(Loop loop, bool up)
    {
        if (!up)
            std::reverse(loop.begin(), loop.end());
        polygons_.push_back(std::move(loop));
    }
    void add_face_with_holes(const Level& level, bool up)
    {
        for (const std::size_t side : {0U, 1U})
            add_strip(level.rings[side], level.surroundings[side], up);
    }
    /// Between a loop and the same one further up, or around it.
    void add_strip(const Loop& first, const Loop& second, bool turned)
    {
        for (std::size_t i = 0; i < first.size(); ++i) {
            const std::size_t next = (i + 1) % first.size();
            add_face({first[i], first[next], second[next], second[i]}, !turned);
        }
    }

    SurfaceMesh surface() const
    {
        return surface_from_polygons(vertices_, polygons_,
                                     [](long, const std::string& why) { throw std::logic_error(why); });
    }

private:
    /// Seen against the pins, so up is y.
    long add(double x, double y, double height)
    {
        vertices_.emplace_back(x, height, -y);
        return static_cast<long>(vertices_.size()) - 1;
    }

    std::vector<Vec3> vertices_;
    std::vector<std::vector<long>> polygons_;
};

/// Two plates joined around the pins by pins or bushings.
/// @param hole  through everything [m]; 0: none
SurfaceMesh plates(double inside, double face, double joined, double hole)
{
    Link link;
    const Level low = link.add_level(-face, hole), low_inside = link.add_level(-inside, joined),
                high_inside = link.add_level(inside, joined), high = link.add_level(face, hole);
    link.add_face_with_holes(low_inside, true);
    link.add_face_with_holes(high_inside, false);
    link.add_strip(low.outline, low_inside.outline, false);
    link.add_strip(high_inside.outline, high.outline, false);
    for (const std::size_t side : {0U, 1U})
        link.add_strip(low_inside.rings[side], high_inside.rings[side], false);
    if (hole == 0) {
        link.add_face(low.outline, false);
        link.add_face(high.outline, true);
        return link.surface();
    }
    link.add_face_with_holes(low, false);
    link.add_face_with_holes(high, true);
    for (const std::size_t side : {0U, 1U})
        link.add_strip(low.rings[side], high.rings[side], true);
    return link.surface();
}

}  // namespace

SurfaceMesh ChainLink::outer() { return plates(outer_inside, outer_face, pin, 0); }

SurfaceMesh ChainLink::inner() { return plates(inner_inside, inner_face, bushing, bore); }

}  // namespace enduring::solvers
