#include "common/experiments/render/moments.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

constexpr int width = 320, height = 200;

/// A ball that falls and rolls, at its first, a middle and its last moment.
std::vector<Moment> fall()
{
    Scene scene = load_scene(scene_file("falling_sphere"), R"({"dt": 0.01, "duration": 0.3})");
    MomentsProbe probe(scene, {0, 0.104, 0.3, 9}, {}, "ball, ");
    run(scene, Solver{}, {&probe});
    return probe.moments();
}

/// The part of the picture's height that the body of a moment takes.
double height_of(const Moment& moment)
{
    Eigen::AlignedBox2d box;
    for (const Vec3& point : points_of(moment.stage))
        box.extend(moment.stage.camera.project(point, width, height));
    CHECK(box.min().minCoeff() >= 0);
    CHECK(box.max().x() <= width);
    CHECK(box.max().y() <= height);
    return box.sizes().y() / height;
}

}  // namespace

TEST_CASE("moments: one camera sees all of them whole, and one of its own sees each larger")
{
    std::vector<Moment> moments = fall();
    REQUIRE(moments.size() == 3);
    CHECK(moments[1].caption == "ball, 0.10 s");
    const Vec3 towards(0.4, 0.3, 1);
    frame_together(moments, towards, static_cast<double>(width) / height);
    std::vector<double> together;
    for (const Moment& moment : moments)
        together.push_back(height_of(moment));
    CHECK(moments[0].stage.camera.eye == moments[2].stage.camera.eye);
    frame_each(moments, towards, static_cast<double>(width) / height);
    for (std::size_t i = 0; i < moments.size(); ++i)
        CHECK(height_of(moments[i]) > 1.2 * together[i]);
}
