#include "common/experiments/render/clip.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/experiments/render/text.hpp"
#include "common/experiments/report/report.hpp"
#include "common/experiments/report/subprocess.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

using namespace enduring;

namespace {

int count(const std::string& text, const std::string& part)
{
    int times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++times;
    return times;
}

int darkest(const Picture& picture) { return *std::min_element(picture.rgb.begin(), picture.rgb.end()); }

}  // namespace

TEST_SUITE_BEGIN("pictures");

TEST_CASE("strip: pictures stand in rows, untouched, with room for their captions")
{
    const Picture dark(60, 40, 10), light(60, 40, 200);
    const Picture page = strip({{dark, ""}, {light, ""}, {dark, ""}}, 2);
    CHECK(page.width > 120);
    CHECK(page.width < 140);
    CHECK(*page.at(0, 0) == 10);
    CHECK(*page.at(page.width - 1, 0) == 200);
    CHECK(*page.at(0, page.height - 1) == 10);
    CHECK(*page.at(page.width - 1, page.height - 1) > 240);
    CHECK(strip({{dark, ""}, {light, "t = 0.1 s"}}).height > 50);
    CHECK_THROWS_AS(strip({{dark, ""}, {Picture(61, 40), ""}}), InputError);
    CHECK(strip({}).empty());
}

TEST_CASE("text: a line is dark where it stands, as wide as it says, and cut at the border" *
          doctest::skip(!pictures_are_on))
{
    Picture picture(200, 40);
    const double width = text_width("τ = ½ (δ < 0)", 16);
    CHECK(width > 60);
    CHECK(width < 140);
    draw_text(picture, "τ = ½ (δ < 0)", 5, 25, 16, Vec3::Zero());
    CHECK(darkest(picture) < 40);
    for (int y = 0; y < picture.height; ++y)
        for (int x = static_cast<int>(width) + 8; x < picture.width; ++x)
            CHECK(*picture.at(x, y) == 255);
    draw_text(picture, "beyond every border", 150, 3, 40, Vec3::Zero());
    draw_text(picture, "beyond", -60, 45, 40, Vec3::Zero());
}

TEST_CASE("clip: every frame arrives, the film loops, and an unfinished one leaves nothing" *
          doctest::skip(!is_installed("ffmpeg")))
{
    const TemporaryFolder folder;
    {
        Clip clip(folder.path / "run.webp", 20);
        for (int i = 0; i < 5; ++i)
            clip.add(Picture(64, 48, static_cast<std::uint8_t>(50 * i)));
        CHECK_FALSE(std::filesystem::exists(folder.path / "run.webp"));
        clip.finish();
        Clip unfinished(folder.path / "half.webp", 20);
        unfinished.add(Picture(64, 48));
    }
    const std::string film = content(folder.path / "run.webp");
    CHECK(film.substr(0, 4) == "RIFF");
    CHECK(count(film, "ANMF") == 5);
    const std::size_t animation = film.find("ANIM");
    REQUIRE(animation != std::string::npos);
    CHECK(film[animation + 12] + film[animation + 13] == 0);  // times to play; 0 is without end
    CHECK(folder.count() == 1);
}

TEST_CASE("clip: the same frames give the same bytes, as .mp4 too" * doctest::skip(!is_installed("ffmpeg")))
{
    const TemporaryFolder folder;
    for (const std::string name : {"a.mp4", "b.mp4", "a.webp", "b.webp"}) {
        Clip clip(folder.path / name);
        for (int i = 0; i < 4; ++i)
            clip.add(Picture(64, 48, static_cast<std::uint8_t>(60 * i)));
        clip.finish();
    }
    CHECK(content(folder.path / "a.mp4") == content(folder.path / "b.mp4"));
    CHECK(content(folder.path / "a.webp") == content(folder.path / "b.webp"));
    CHECK(content(folder.path / "a.mp4").find("ftyp") != std::string::npos);
}

TEST_CASE("clip: without ffmpeg there is no film, not an old one either, and the run goes on")
{
    const TemporaryFolder folder;
    write_file(folder.path / "run.mp4", "of an earlier run");
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", folder.path.c_str(), 1);
    Clip clip(folder.path / "run.mp4");
    CHECK_NOTHROW(clip.add(Picture(64, 48)));
    CHECK_NOTHROW(clip.add(Picture(64, 48)));
    CHECK_NOTHROW(clip.finish());
    ::setenv("PATH", path.c_str(), 1);
    CHECK(folder.count() == 0);
}

TEST_CASE("clip: what cannot become a film is refused" * doctest::skip(!is_installed("ffmpeg")))
{
    const TemporaryFolder folder;
    CHECK_THROWS_AS(Clip(folder.path / "run.avi"), InputError);
    CHECK_THROWS_AS(Clip(folder.path / "run.webp", 0), InputError);
    Clip clip(folder.path / "run.webp");
    CHECK_THROWS_AS(clip.add(Picture(65, 48)), InputError);
    clip.add(Picture(64, 48));
    CHECK_THROWS_AS(clip.add(Picture(64, 64)), InputError);
}

TEST_SUITE_END();
