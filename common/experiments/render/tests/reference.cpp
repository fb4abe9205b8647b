#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/difference.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/tests/sample_stages.hpp"
#include "common/experiments/report/report.hpp"
#include "common/experiments/report/subprocess.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

using namespace enduring;

namespace {

Picture draw(const Stage& stage)
{
    static Renderer renderer(480, 270);
    return renderer.draw(stage);
}

/// Two bodies, the second a small one: a ball of about 12 pixels.
Stage box_and_small_ball()
{
    Stage stage = box_and_ball();
    stage.bodies[1] = drawable(sphere(0.05, 3), {-0.9, 0.05, 0.2}, palette::blue, true);
    return stage;
}

Stage moved(Stage stage, std::size_t body, const Vec3& shift)
{
    for (Vec3& position : stage.bodies[body].positions)
        position += shift;
    return stage;
}

/// For the length of a scope, as `ENDURING_RENEW_RENDERS=...` before a command.
struct RenewWish {
    explicit RenewWish(const char* value)
    {
        if (const char* before = std::getenv("ENDURING_RENEW_RENDERS"))
            kept = before;
        ::setenv("ENDURING_RENEW_RENDERS", value, 1);
    }
    ~RenewWish() { ::setenv("ENDURING_RENEW_RENDERS", kept.c_str(), 1); }
    std::string kept = "0";
};

}  // namespace

TEST_SUITE_BEGIN("pictures");

TEST_CASE("picture difference: rounding of another CPU passes, two levels up or down at every pixel" *
          doctest::skip(!pictures_are_on))
{
    const Picture expected = draw(box_and_ball());
    Picture got = expected;
    std::mt19937 random(1);
    for (std::uint8_t& level : got.rgb)
        level = static_cast<std::uint8_t>(std::clamp(level + static_cast<int>(random() % 5) - 2, 0, 255));
    const PictureDifference difference = compare_pictures(got, expected);
    CHECK_MESSAGE(difference.same, difference.message);
    CHECK(difference.tiles_off == 0);
}

TEST_CASE("picture difference: positions that differ by rounding pass" * doctest::skip(!pictures_are_on))
{
    const PictureDifference difference = compare_pictures(draw(moved(box_and_ball(), 1, {1e-5, -1e-5, 1e-5})),
                                                          draw(box_and_ball()));
    CHECK_MESSAGE(difference.same, difference.message);
}

TEST_CASE("picture difference: a missing body fails, however small" * doctest::skip(!pictures_are_on))
{
    const Picture expected = draw(box_and_small_ball());
    Stage without = box_and_small_ball();
    without.bodies[1] = drawable(sphere(0.001, 1), {-0.9, 0.05, 0.2}, palette::blue);
    const PictureDifference difference = compare_pictures(draw(without), expected);
    CHECK_MESSAGE(!difference.same, difference.message);
}

TEST_CASE("picture difference: a body that moved by two hundredths of the picture's width fails" *
          doctest::skip(!pictures_are_on))
{
    const Stage stage = box_and_small_ball();
    const double width = stage.camera.pixel_size(Vec3::Zero(), 270) * 480;
    for (const std::size_t body : {0U, 1U})
        for (const Vec3& direction : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
            CAPTURE(body);
            CAPTURE(direction.transpose());
            const PictureDifference difference = compare_pictures(
                draw(moved(stage, body, 0.02 * width * direction)), draw(stage));
            CHECK_MESSAGE(!difference.same, difference.message);
        }
}

TEST_CASE("picture difference: a body of another colour fails, and so does another size" *
          doctest::skip(!pictures_are_on))
{
    Stage other = box_and_ball();
    other.bodies[1].color = palette::plum;
    CHECK_FALSE(compare_pictures(draw(other), draw(box_and_ball())).same);
    CHECK_FALSE(compare_pictures(Picture(64, 64), Picture(64, 65)).same);
}

TEST_CASE("reference: it is written when asked for, then compared, and a difference leaves two pictures" *
          doctest::skip(!pictures_are_on))
{
    const TemporaryFolder folder;
    const ReferencePlaces places{folder.path / "renders", folder.path / "differences"};
    const Picture picture = draw(box_and_ball()), other = draw(moved(box_and_ball(), 0, {0.2, 0, 0}));
    const auto check = [&](const char* renew, const Picture& got) {
        const RenewWish wish(renew);
        return check_reference_picture(got, "99_trial/box.png", places).passed;
    };
    CHECK_FALSE(check("0", picture));  // there is none yet
    CHECK(check("1", picture));
    CHECK(check("0", picture));
    CHECK_FALSE(check("0", other));
    CHECK(read_png(folder.path / "differences/99_trial/box.got.png").rgb == other.rgb);
    CHECK(std::filesystem::exists(folder.path / "differences/99_trial/box.difference.png"));
    CHECK(check("1", other));
    CHECK(check("0", other));
}

TEST_CASE("reference: a CPU without AVX passes" * doctest::skip(!pictures_are_on))
{
    // The graphics library compiles its shaders for the CPU it finds; told that
    // there is only SSE2, it rounds as an old one.
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    Subprocess old_cpu(
        {"env", "ENDURING_RENEW_RENDERS=0", "GALLIUM_OVERRIDE_CPU_CAPS=sse2", "LP_NATIVE_VECTOR_WIDTH=128",
         program, "--test-case=*as in their reference picture*", "--minimal"},
        "coreutils");
    CHECK_NOTHROW(old_cpu.finish());
}

TEST_CASE("pictures: a PNG reads back pixel by pixel, and a file that is none is named" *
          doctest::skip(!pictures_are_on))
{
    const TemporaryFolder folder;
    const Picture picture = draw(box_and_ball());
    write_png(picture, folder.path / "a.png");
    CHECK(read_png(folder.path / "a.png").rgb == picture.rgb);
    write_file(folder.path / "b.png", "no picture");
    CHECK_THROWS_AS(read_png(folder.path / "b.png"), InputError);
    CHECK_THROWS_AS(read_png(folder.path / "none.png"), InputError);
    CHECK_THROWS_AS(write_png(picture, folder.path / "b.png" / "c.png"), InputError);
}

TEST_SUITE_END();
