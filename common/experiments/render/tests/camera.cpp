#include "common/experiments/render/camera.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace enduring;

TEST_CASE("camera: the target is in the middle, and a pixel there is as large as it says")
{
    const Camera camera{{3, 2, 5}, {0.5, 0.2, -1}};
    const Eigen::Vector2d middle = camera.project(camera.target, 640, 360);
    CHECK(middle.isApprox(Eigen::Vector2d(320, 180), 1e-12));
    const Vec3 step = 10 * camera.pixel_size(camera.target, 360) * camera.right();
    CHECK(camera.project(camera.target + step, 640, 360).isApprox(Eigen::Vector2d(330, 180), 1e-12));
    CHECK(camera.project(camera.target + Vec3::UnitY(), 640, 360).y() < 180);
}

TEST_CASE("camera: a framed cloud of points fills the picture up to its margin and no further")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Vec3> points;
        for (int i = 0; i < 30; ++i)
            points.emplace_back(3 * anywhere(random), anywhere(random), anywhere(random));
        const Camera camera = frame(points, {anywhere(random), anywhere(random), 1}, 16.0 / 9, 0.1);
        Eigen::AlignedBox2d box;
        for (const Vec3& point : points)
            box.extend(camera.project(point, 1600, 900));
        CAPTURE(trial);
        CAPTURE(box.min().transpose());
        CAPTURE(box.max().transpose());
        CHECK(box.min().x() >= 160 - 1e-6);
        CHECK(box.max().x() <= 1440 + 1e-6);
        CHECK(box.min().y() >= 90 - 1e-6);
        CHECK(box.max().y() <= 810 + 1e-6);
        const double rest_offset = std::min(box.min().x() - 160, box.min().y() - 90);
        CHECK(rest_offset < 1e-6);  // one direction is filled
    }
}
