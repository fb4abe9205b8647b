#include "chapters/05_categorisation/experiments/corner.hpp"

#include "chapters/05_categorisation/category.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace enduring::chapter05 {

Corner fan(std::string name, const std::vector<Vec3>& rim, bool closed)
{
    std::vector<Vec3> positions{Vec3::Zero()};
    positions.insert(positions.end(), rim.begin(), rim.end());
    const int n = static_cast<int>(rim.size());
    std::vector<Face> faces;
    for (int i = 0; i < (closed ? n : n - 1); ++i)
        faces.push_back({0, 1 + i, 1 + (i + 1) % n});
    return {std::move(name), SurfaceTopology(n + 1, std::move(faces)), std::move(positions)};
}

Corner cone_corner(std::string name, int edges, double angle)
{
    std::vector<Vec3> rim;
    for (int i = 0; i < edges; ++i) {
        // turned, so that pictures show two sides
        const double phi = 0.45 - 2 * std::numbers::pi * i / edges;
        rim.emplace_back(std::sin(angle) * std::cos(phi), -std::cos(angle), std::sin(angle) * std::sin(phi));
    }
    return fan(std::move(name), rim);
}

std::vector<Corner> sphere_corners()
{
    std::vector<Vec3> saddle;
    for (int i = 0; i < 8; ++i) {
        const double phi = -std::numbers::pi * i / 4;
        saddle.emplace_back(std::cos(phi), 0.6 * std::cos(2 * phi), std::sin(phi));
    }
    return {cone_corner("tetrahedron's tip", 3, std::acos(std::sqrt(2.0 / 3))),
            cone_corner("cube's corner", 3, std::acos(std::sqrt(1.0 / 3))),
            cone_corner("flat surface", 6, std::numbers::pi / 2), fan("saddle", saddle)};
}

Corner sphere_corner(const std::string& part)
{
    for (const Corner& corner : sphere_corners())
        if (corner.name.find(part) != std::string::npos)
            return corner;
    throw std::invalid_argument("no corner is called " + part);
}

Corner wedge_corner(std::string name, double opening)
{
    const double x = std::sin(opening / 2), y = std::cos(opening / 2);
    return fan(std::move(name), {{x, y, 0}, {0, 0, 1}, {-x, y, 0}, {0, 0, -1}});
}

//! [can_touch]
bool can_touch(const Corner& corner, const Vec3& contact_normal)
{
    return std::all_of(corner.positions.begin() + 1, corner.positions.end(),
                       [&](const Vec3& neighbour) { return neighbour.dot(contact_normal) >= -1e-12; });
}
//! [can_touch]

bool average_says_regular(const Corner& corner, const Vec3& contact_normal)
{
    return -normal_span(corner.surface(), corner.faces()).back().dot(contact_normal) >= hook_cosine;
}

bool span_says_regular(const Corner& corner, const Vec3& contact_normal)
{
    return !is_hooked_vertex(corner.surface(), 0, contact_normal);
}

}  // namespace enduring::chapter05
