#pragma once

#include "common/experiments/render/annotation_soup.hpp"
#include "common/experiments/render/stage.hpp"
#include "common/experiments/render/surface_soup.hpp"

namespace enduring {

/// The ball around all that casts a shadow.
struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = 1;
};

Ball ball_around(const Stage& stage);

/// From positions relative to the ball's centre to the screen's cube.
/// @param aspect  width / height of the picture
Eigen::Matrix4d view_projection(const Camera& camera, const Ball& ball, double aspect);

/// 1, 2 or 5 times a power of ten, not far from `about`.
double pleasant_spacing(double about);

/// A square far larger than the ball, relative to its centre.
TriangleSoup ground_soup(const Ground& ground, const Ball& ball);

}  // namespace enduring
