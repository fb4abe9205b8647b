#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

Scene falling_sphere()
{
    return load_scene(scene_file("falling_sphere"), R"({"dt": 0.01, "duration": 0.3})");
}

}  // namespace

TEST_CASE("film probes: the strip takes each of its moments once, at the step next to it" *
          doctest::skip(!pictures_are_on))
{
    Scene scene = falling_sphere();
    std::vector<double> marked_at;
    StripProbe strip(
        scene, {0.0, 0.104, 0.2, 9.0},
        [&](Stage&, const World& world, const Contacts&) { marked_at.push_back(world.time); }, 64, 48);
    run(scene, Solver{}, {&strip});
    REQUIRE(marked_at.size() == 3);
    CHECK(marked_at[0] == 0);
    CHECK(marked_at[1] == doctest::Approx(0.1));
    CHECK(marked_at[2] == doctest::Approx(0.2));
    CHECK(strip.all(1).height > 2 * strip.all(3).height);
}

TEST_CASE("film probes: a second of the run takes a second of the clip" * doctest::skip(!pictures_are_on))
{
    const TemporaryFolder folder;
    Scene scene = falling_sphere();
    ClipProbe clip(scene, folder.path / "fall.webp", 10, 64, 48);
    run(scene, Solver{}, {&clip});
    CHECK(clip.frames() == 4);  // at 0, 0.1, 0.2 and 0.3 s
    CHECK_FALSE(std::filesystem::exists(folder.path / "fall.webp"));
    clip.finish();
    CHECK(std::filesystem::file_size(folder.path / "fall.webp") > 100);
}

TEST_CASE("film probes: in slow motion three seconds of the clip are one of the run, until it ends" *
          doctest::skip(!pictures_are_on))
{
    const TemporaryFolder folder;
    Scene scene = falling_sphere();
    int marked = 0;
    ClipProbe clip(scene, folder.path / "fall.webp", 10, 64, 48,
                   {.slow_motion = 3, .until = 0.2, .mark = [&](auto&&...) { ++marked; }});
    run(scene, Solver{}, {&clip});
    CHECK(clip.frames() == 7);  // thirty in a second, up to 0.2 s
    CHECK(marked == 7);
}
