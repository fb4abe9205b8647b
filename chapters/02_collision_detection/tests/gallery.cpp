#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/experiments/gallery_stage.hpp"
#include "chapters/02_collision_detection/swept_box.hpp"
#include "chapters/02_collision_detection/textbook.hpp"
#include "common/experiments/render/reference.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter02;

TEST_CASE("tunnelling: the discrete test sees nothing at either end, the continuous one finds the touch")
{
    const Tunnelling scene = tunnelling();
    CHECK(discrete_hits(scene.spike_t0, scene.plate) == 0);
    CHECK(discrete_hits(scene.spike_t1, scene.plate) == 0);
    // The tip sinks from 0.35 by 1.4 to the plate at 0.
    const auto touch = first_touch(scene);
    REQUIRE(touch.has_value());
    CHECK(*touch == doctest::Approx(0.35 / 1.4).epsilon(1e-9));

    // In between there is something to see.
    std::vector<Vec3> half_way;
    for (std::size_t v = 0; v < scene.spike_t0.size(); ++v)
        half_way.push_back(at_time(scene.spike_t0[v], scene.spike_t1[v], 0.5));
    CHECK(discrete_hits(half_way, scene.plate) > 0);
}

TEST_CASE("gallery: each case is what its name says")
{
    for (const GalleryCase& one : gallery_cases()) {
        CAPTURE(one.name);
        const auto touch = std::visit([](const auto& step) { return time_of_impact(step); }, one.step);
        const auto textbook = std::visit([](const auto& step) { return textbook_time_of_impact(step); },
                                         one.step);
        CHECK(touch.has_value() == (one.name != "near_miss"));
        CHECK(textbook.has_value() == touch.has_value());
        if (touch && textbook)
            CHECK(*touch == doctest::Approx(*textbook).epsilon(1e-9));
        if (one.name == "grazing")  // the root of (1 - 2 tau)^2
            CHECK(*touch == doctest::Approx(0.5).epsilon(1e-9));
    }
}

TEST_CASE("gallery: the near miss comes so near that its boxes overlap")
{
    // a copy: the list is gone after this line
    const auto step = std::get<VertexFaceStep>(gallery_cases()[2].step);
    const std::vector<Vec3> t0{step.v_t0, step.f0_t0, step.f1_t0, step.f2_t0},
        t1{step.v_t1, step.f0_t1, step.f1_t1, step.f2_t1};
    const SurfaceTopology face(4, {{1, 2, 3}});
    const SurfaceStep surface{face, t0, t1};
    CHECK(vertex_box(surface, 0).overlaps(face_box(surface, 0)));
}

TEST_CASE("gallery: two of its strips are as in their reference pictures" * doctest::skip(!pictures_are_on))
{
    GalleryStage stage;
    const Tunnelling scene = tunnelling();
    const ReferenceCheck tunnelled = check_reference_picture(
        stage.draw_tunnelling(scene, first_touch(scene).value_or(0.5)),
        "02_collision_detection/gallery_tunnelling.png");
    CHECK_MESSAGE(tunnelled.passed, tunnelled.message);
    const GalleryCase one = gallery_cases()[0];
    const auto touch = std::visit([](const auto& step) { return time_of_impact(step); }, one.step);
    const ReferenceCheck through = check_reference_picture(stage.draw_case(one, touch),
                                                           "02_collision_detection/gallery_vertex_face.png");
    CHECK_MESSAGE(through.passed, through.message);
}
