#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/reference.hpp"
#include "common/experiments/render/tests/sample_stages.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>

using namespace enduring;

namespace {

Renderer& small_renderer()
{
    static Renderer renderer(480, 270);
    return renderer;
}

/// Mean colour of the pixels around a projected point.
std::array<double, 3> color_at(const Picture& picture, const Stage& stage, const Vec3& point, int reach = 2)
{
    const Eigen::Vector2d centre = stage.camera.project(point, picture.width, picture.height);
    std::array<double, 3> sum{};
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += picture.at(static_cast<int>(centre.x()) + x, static_cast<int>(centre.y()) + y)[c];
    for (double& level : sum)
        level /= (2 * reach + 1) * (2 * reach + 1);
    return sum;
}

double brightness(const std::array<double, 3>& color) { return (color[0] + color[1] + color[2]) / 3; }

Stage ball_on_floor(double height)
{
    Stage stage;
    stage.bodies = {drawable(sphere(0.5, 4), {0, 0.5 + height, 0}, palette::blue, true)};
    stage.grounds = {{Vec3::Zero(), Vec3::UnitY(), -1}};
    stage.camera = {{0.5, 2, 5}, {0, 0.5, 0}};
    return stage;
}

}  // namespace

TEST_SUITE_BEGIN("pictures");

TEST_CASE("renderer: the same stage gives the same bytes, whatever was drawn in between" *
          doctest::skip(!pictures_are_on))
{
    const Picture first = small_renderer().draw(box_and_ball());
    small_renderer().draw(ball_on_floor(1));
    CHECK(small_renderer().draw(box_and_ball()).rgb == first.rgb);
    CHECK(Renderer(480, 270).draw(box_and_ball()).rgb == first.rgb);
}

TEST_CASE("renderer: the floor darkens towards the place where a ball touches it" *
          doctest::skip(!pictures_are_on))
{
    const Stage touching = ball_on_floor(0), floating = ball_on_floor(1.5);
    const Picture picture = small_renderer().draw(touching), raised = small_renderer().draw(floating);
    const Vec3 close(0.12, 0, 0.36), farther(0.25, 0, 0.75), far(0.6, 0, 1.8);
    CHECK(brightness(color_at(picture, touching, close)) <
          brightness(color_at(picture, touching, farther)) - 10);
    CHECK(brightness(color_at(picture, touching, farther)) < brightness(color_at(picture, touching, far)));
    CHECK(brightness(color_at(raised, floating, close)) >
          brightness(color_at(picture, touching, close)) + 12);
}

TEST_CASE("renderer: the sun comes from the left of the camera and throws a soft shadow to the right" *
          doctest::skip(!pictures_are_on))
{
    const Stage stage = ball_on_floor(0);
    const Picture picture = small_renderer().draw(stage);
    CHECK(brightness(color_at(picture, stage, {0.75, 0, -0.3})) <
          brightness(color_at(picture, stage, {-0.75, 0, -0.3})) - 25);
    std::set<int> levels;  // walking out of the shadow meets many levels, not two
    for (double x = 0.5; x < 1.6; x += 0.01)
        levels.insert(static_cast<int>(brightness(color_at(picture, stage, {x, 0, -0.35}, 0))));
    CHECK(levels.size() > 15);
}

TEST_CASE("renderer: smooth shading has no facets, flat shading has" * doctest::skip(!pictures_are_on))
{
    const auto largest_jump = [](bool smooth) {
        Stage stage = ball_on_floor(0);
        stage.bodies = {drawable(sphere(0.5, 1), {0, 0.5, 0}, palette::sand, smooth)};
        const Picture picture = small_renderer().draw(stage);
        int largest = 0;
        const int row = picture.height / 2 - 20;
        for (int x = picture.width / 2 - 24; x < picture.width / 2 + 24; ++x)
            largest = std::max(largest, std::abs(*picture.at(x, row) - *picture.at(x + 1, row)));
        return largest;
    };
    CHECK(largest_jump(true) < 6);
    CHECK(largest_jump(false) > 8);
}

TEST_CASE("renderer: an edge between floor and box is antialiased" * doctest::skip(!pictures_are_on))
{
    Stage stage;
    stage.bodies = {drawable(box({1, 1, 1}), {0, 0.5, 0}, palette::ink)};
    stage.camera = {{0, 0.62, 4}, {0, 0.6, 0}, Vec3(0.03, 1, 0)};
    const Picture picture = small_renderer().draw(stage);
    // a nearly level outline against the backdrop steps through the levels between the two
    std::set<int> levels;
    const int middle = static_cast<int>(stage.camera.project({0, 1, 0.5}, picture.width, picture.height).y());
    for (int x = picture.width / 2 - 60; x < picture.width / 2 + 60; ++x)
        for (int y = middle - 4; y < middle + 5; ++y)
            levels.insert(*picture.at(x, y) / 8);
    CHECK(levels.size() >= 8);
}

TEST_CASE("renderer: marks have their colour, and what a body hides shines through it faintly" *
          doctest::skip(!pictures_are_on))
{
    Stage stage = ball_on_floor(0);
    stage.bodies[0].color = palette::ivory;
    const Vec3 in_front(0.0, 0.6, 0.49), inside(0.1, 0.4, 0.0);
    const Picture plain = small_renderer().draw(stage);
    stage.dots = {{in_front, palette::colliding_vertex, 6}, {inside, palette::colliding_vertex, 6}};
    const Picture marked = small_renderer().draw(stage);
    const auto redness = [&](const Picture& picture, const Vec3& point) {
        const auto color = color_at(picture, stage, point, 1);
        return color[0] - color[1];
    };
    CHECK(redness(marked, in_front) > 120);
    CHECK(redness(marked, inside) > redness(plain, inside) + 25);
    CHECK(redness(marked, inside) < redness(marked, in_front) - 40);
}

TEST_CASE("renderer: a stage without bodies is a picture too" * doctest::skip(!pictures_are_on))
{
    Stage stage;
    CHECK_FALSE(small_renderer().draw(stage).empty());
    stage.grounds = {{}};
    stage.segments = {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {1, 1, 0}, palette::artefact, 3, true, true}};
    CHECK_FALSE(small_renderer().draw(stage).empty());
}

TEST_CASE("renderer: a size no picture can have is refused" * doctest::skip(!pictures_are_on))
{
    CHECK_THROWS_AS(Renderer(0, 100), InputError);
    CHECK_THROWS_AS(Renderer(100, 5000), InputError);
}

TEST_CASE("renderer: box and ball look as in their reference picture")
{
    const ReferenceCheck check = check_reference_picture(small_renderer().draw(box_and_ball()),
                                                         "common/box_and_ball.png");
    CHECK_MESSAGE(check.passed, check.message);
}

TEST_CASE("renderer: bunny, bowl, marks and label look as in their reference picture")
{
    const ReferenceCheck check = check_reference_picture(small_renderer().draw(bunny_in_bowl()),
                                                         "common/bunny_in_bowl.png");
    CHECK_MESSAGE(check.passed, check.message);
}

TEST_SUITE_END();
