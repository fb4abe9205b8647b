#pragma once

#include "chapters/09_deep_contacts/experiments/overlap_shape.hpp"
#include "chapters/09_deep_contacts/intersection_curve.hpp"
#include "common/geometry/meshes.hpp"

#include <random>
#include <string>
#include <vector>

namespace enduring::chapter09 {

/// Bunny, bowl, spikes and two boxes, each about 2 m large.
std::vector<std::pair<std::string, SurfaceMesh>> overlap_meshes();

/// Coordinates on the lattice are multiples of this [m].
inline constexpr double lattice = 0.125;

/// A mesh somewhere near the origin: turned and moved at random; or, on the lattice, turned by right angles,
/// moved by whole cells, and every vertex rounded to it, so that features of two such meshes touch and
/// coincide.
SurfaceMesh place_at_random(SurfaceMesh mesh, std::mt19937_64& random, bool on_lattice);

/// The piercings by the test of the textbook, which rounds and knows no ties.
std::vector<Piercing> textbook_piercings(const StillSurface& a, const StillSurface& b);

/// What tracing two surfaces gave, against the solid angles under which the vertices see the other surface.
struct OverlapCheck {
    long piercings = 0, curves = 0, open_curves = 0;
    bool textbook_closes = true;            ///< with chapter 2's textbook test all curves are closed as well
    long inside = 0, wrong = 0, asked = 0;  ///< vertices of both; `wrong` of those that were asked
};

/// @param max_asked  vertices of each surface that are compared with the solid angle, which takes its time
OverlapCheck check_overlap(const SurfaceMesh& a, const SurfaceMesh& b, bool on_lattice, int max_asked);

}  // namespace enduring::chapter09
