#pragma once

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "common/geometry/box_shapes.hpp"

#include <vector>

namespace enduring {

/// A square plate of 1 m that comes down on a floor and glides along x, within one step. Both are flat grids
/// of the same square cells, each cut into two triangles; the floor reaches 1 m farther on every side.
struct GlidingPlate {
    SurfaceTopology plate, floor;
    std::vector<Vec3> plate_t0, plate_t1, floor_both;  ///< positions [m]; the floor rests

    SurfaceStep plate_step() const { return {plate, plate_t0, plate_t1}; }
    SurfaceStep floor_step() const { return {floor, floor_both, floor_both}; }
};

/// @param cells  along each side of the plate
/// @param glide  way of the plate along x in this step [m], a whole number of cells, at most 0.5
inline GlidingPlate gliding_plate(int cells, double glide)
{
    const SurfaceMesh plate = plane_grid(1, 1, {cells, cells}),
                      floor = plane_grid(3, 3, {3 * cells, 3 * cells});
    GlidingPlate scene{{static_cast<int>(plate.vertices.size()), plate.faces},
                       {static_cast<int>(floor.vertices.size()), floor.faces},
                       {},
                       {},
                       floor.vertices};
    // Off the floor's grid, so that no two boxes meet in a mere border.
    const Vec3 offset(0.37 / cells, 0, 0.21 / cells);
    for (const Vec3& x : plate.vertices) {
        scene.plate_t0.push_back(x + offset + Vec3(0, 0.001, 0));
        scene.plate_t1.push_back(x + offset + Vec3(glide, -0.001, 0));
    }
    return scene;
}

/// The size of a box along x and z [m].
struct Footprint {
    double x = 0, z = 0;
};

/// Your prediction, written down before anything is measured: the plate glides by 0.25
/// m; both grids are made twice as fine, from 16 to 32 cells a side. By which factor do
/// the pairs of features grow that the broad phase leaves?
double predicted_factor();

/// How many pairs of features (vertex-face, face-vertex, edge-edge) the tree leaves to the query.
long pairs_left(const GlidingPlate& scene);

/// The factor that was predicted, measured: pairs left with twice as
/// many cells a side over those with `cells`.
double measured_factor(int cells, double glide);

/// How many of the boxes of a grid a box overlaps, on average over all its places.
/// @param box    its footprint
/// @param other  footprint of each of the grid's boxes, of which there is one a cell
/// @param cell   side of a cell [m]
double mean_overlaps(const Footprint& box, const Footprint& other, double cell);

/// The law: how many pairs are left, from counting features and footprints.
double law_of_pairs(int cells, double glide);

}  // namespace enduring
