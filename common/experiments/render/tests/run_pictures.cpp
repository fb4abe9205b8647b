#include "common/experiments/render/run_pictures.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// Two cubes 12 m apart, that fall and drift aside with no solver to stop them.
Scene falling_cubes(const TemporaryFolder& folder, const std::string& keys,
                    const std::string& more_bodies = "")
{
    write_file(folder.path / "cubes.json", R"({"name": "cubes", )" + keys + R"(, "bodies": [
        {"name": "low", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "mass": 1, "position": [0, 1, 0]},
        {"name": "high", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "mass": 1,
         "position": [0, 13, 0], "velocity": [3, 0, -2]})" +
                                               more_bodies + "]}");
    return load_scene(folder.path / "cubes.json");
}

bool is_seen(const Camera& camera, const Vec3& point)
{
    const Eigen::Vector2d at = camera.project(point, 560, 400);
    return camera.depth(point) > 0 && at.x() >= 0 && at.x() <= 560 && at.y() >= 0 && at.y() <= 400;
}

}  // namespace

TEST_CASE(
    "run pictures: a scene without a camera gets one that sees every vertex that moves, at every shown moment")
{
    const TemporaryFolder folder;
    for (const bool filmed : {false, true}) {
        Scene scene = falling_cubes(folder, R"("dt": 0.01, "duration": 1.5)");
        RunPictures pictures(scene, {.filmed = filmed});
        std::vector<Vec3> all;
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            if (filmed ? world.step % 5 == 0 : world.step % 30 == 0)
                for (const auto& body : world.bodies)
                    all.insert(all.end(), body->positions_t0().begin(), body->positions_t0().end());
        });
        run(scene, Solver{}, {&pictures, &watch});
        const Camera camera = pictures.camera();
        for (const Vec3& point : all) {
            CAPTURE(point.transpose());
            CHECK(is_seen(camera, point));
        }
        CHECK_FALSE(is_seen(stage_of(scene.world, scene).camera, {0, 13, 0}));  // the usual one does not
        CHECK((camera.eye - camera.target).normalized().isApprox(Vec3(3, 2, 4).normalized()));
    }
}

TEST_CASE(
    "run pictures: a static body is seen with the others unless it is ground, and a scene's own camera is kept")
{
    const TemporaryFolder folder;
    const auto camera_of = [&](const std::string& keys, const std::string& more) {
        Scene scene = falling_cubes(folder, R"("dt": 0.01, "duration": 0.1)" + keys, more);
        RunPictures pictures(scene, {.filmed = false});
        run(scene, Solver{}, {&pictures});
        return pictures.camera();
    };
    const auto post = [](const std::string& size, const std::string& at) {
        return R"(, {"name": "post", "type": "static", "shape": {"box": {"size": )" + size +
               R"(}}, "position": )" + at + "}";
    };
    const Vec3 beside(9, 0.5, 9);
    CHECK_FALSE(is_seen(camera_of("", ""), beside));
    CHECK(is_seen(camera_of("", post("[1, 1, 1]", "[9, 0, 9]")), beside));
    CHECK_FALSE(is_seen(camera_of("", post("[200, 1, 200]", "[0, -1, 0]")), beside));
    const Camera own = camera_of(R"(, "camera": {"eye": [1, 2, 3], "target": [0, 1, 0]})", "");
    CHECK(own.eye == Vec3(1, 2, 3));
    CHECK(own.target == Vec3(0, 1, 0));
}

TEST_CASE(
    "run pictures: a film has twenty frames a second however short the steps are, and never more than 600")
{
    const TemporaryFolder folder;
    const auto frames = [&](double dt, double duration, int steps) {
        Scene scene = falling_cubes(
            folder, R"("dt": )" + std::to_string(dt) + R"(, "duration": )" + std::to_string(duration));
        RunPictures pictures(scene);
        run(scene, Solver{}, {&pictures}, {.steps = steps});
        return pictures.frames();
    };
    CHECK(frames(0.01, 0.5, 50) == 11);
    CHECK(frames(0.001, 0.5, 500) == 11);
    CHECK(frames(0.1, 1, 10) == 11);      // a frame a step is all there is
    CHECK(frames(1, 3600, 3600) == 600);  // an hour is not 72,000 frames
    CHECK(frames(0.01, 0.504, 51) == 11);
}

TEST_CASE("run pictures: what is kept is drawn as it is drawn during the run" *
          doctest::skip(!pictures_are_on))
{
    const TemporaryFolder folder;
    Scene scene = falling_cubes(folder, R"("dt": 0.01, "duration": 0.5, "planes": [{"name": "ground"}],
        "camera": {"eye": [9, 7, 12], "target": [0, 5, 0]})");
    RunPictures later(scene, {.pictures = 3});
    StripProbe at_once(scene, {0, 0.25, 0.5}, mark_pairs, 560, 400);
    run(scene, Solver{}, {&later, &at_once});
    CHECK(later.strip_of_all(3).rgb == at_once.all(3).rgb);
    later.write_film(folder.path / "film.webp");
    CHECK(std::filesystem::file_size(folder.path / "film.webp") > 100);
}
