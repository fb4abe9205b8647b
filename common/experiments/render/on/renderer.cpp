#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/label.hpp"
#include "common/experiments/render/on/canvas.hpp"
#include "common/experiments/render/on/context.hpp"
#include "common/experiments/render/on/shaders.hpp"
#include "common/experiments/render/on/shadow_maps.hpp"
#include "common/experiments/render/on/view.hpp"
#include "common/experiments/report/pictures_wanted.hpp"
#include "common/input/input_error.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>

namespace enduring {

using namespace graphics;

namespace {

const Vec3 up = Vec3::UnitY();

/// A run of corners in the one buffer, and what draws it.
struct Part {
    GLint first = 0;
    GLsizei count = 0;
};

/// All corners of a stage, sorted as they are drawn.
struct Geometry {
    TriangleSoup soup;
    Part casters, annotations, tints;
    std::vector<Part> bodies, grounds;

    template <class Add>
    Part part(Add&& add)
    {
        const std::size_t first = soup.size();
        add();
        return {static_cast<GLint>(first), static_cast<GLsizei>(soup.size() - first)};
    }
};

Geometry gather(const Stage& stage, const Ball& ball, int height)
{
    Geometry geometry;
    geometry.bodies.resize(stage.bodies.size());
    const auto add_bodies = [&](bool casting) {
        for (std::size_t i = 0; i < stage.bodies.size(); ++i)
            if ((stage.bodies[i].casts_shadow && stage.bodies[i].opacity >= 1) == casting)
                geometry.bodies[i] =
                    geometry.part([&] { add_surface(geometry.soup, stage.bodies[i], ball.centre); });
    };
    geometry.casters = geometry.part([&] { add_bodies(true); });
    add_bodies(false);
    for (const Ground& ground : stage.grounds)
        geometry.grounds.push_back(geometry.part([&] {
            const TriangleSoup square = ground_soup(ground, ball);
            geometry.soup.insert(geometry.soup.end(), square.begin(), square.end());
        }));
    geometry.tints = geometry.part([&] {
        for (const TintedTriangle& triangle : stage.triangles)
            add_triangle(geometry.soup, triangle, ball.centre);
    });
    geometry.annotations = geometry.part([&] {
        for (const Segment& segment : stage.segments)
            add_segment(geometry.soup, segment, stage.camera, height, ball.centre);
        for (const Dot& dot : stage.dots)
            add_dot(geometry.soup, dot, stage.camera, height, ball.centre);
    });
    return geometry;
}

void draw_part(const Part& part) { glDrawArrays(GL_TRIANGLES, part.first, part.count); }

Vec3 open_floor(const std::array<DirectionalLight, light_count>& lights)
{
    Vec3 light = Vec3::Zero();
    for (const DirectionalLight& one : lights)
        light += std::max(0.0, up.dot(one.rows.row(2))) * one.radiance;
    return light;
}

}  // namespace

struct Renderer::Machine {
    Machine(int width, int height)
        : canvas(width, height), surface(make_program(shaders::stage_vertex, shaders::surface_fragment)),
          annotation(make_program(shaders::stage_vertex, shaders::annotation_fragment)),
          corners(make_buffer()), layout(make_vertex_array())
    {
        glBindVertexArray(layout);
        glBindBuffer(GL_ARRAY_BUFFER, corners);
        const std::array<std::size_t, 4> offsets{offsetof(Corner, position), offsetof(Corner, normal),
                                                 offsetof(Corner, color), offsetof(Corner, barycentric)};
        for (GLuint i = 0; i < offsets.size(); ++i) {
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Corner),
                                  reinterpret_cast<const void*>(offsets[i]));
        }
    }

    void upload(const TriangleSoup& soup)
    {
        glBindVertexArray(layout);
        glBindBuffer(GL_ARRAY_BUFFER, corners);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(soup.size() * sizeof(Corner)), soup.data(),
                     GL_STREAM_DRAW);
    }

    ShadowMaps shadows;
    Canvas canvas;
    Handle surface, annotation, corners, layout;

    void draw_grounds(const Stage& stage, const Geometry& geometry, const Ball& ball);
    void draw_bodies(const Stage& stage, const Geometry& geometry);
    void draw_annotations(const Geometry& geometry);
};

void Renderer::Machine::draw_grounds(const Stage& stage, const Geometry& geometry, const Ball& ball)
{
    // What a ground looks like follows from the camera alone, so that it stays as it is while bodies move.
    const double distance = (stage.camera.eye - stage.camera.target).norm();
    set(surface, "is_ground", 1);
    set(surface, "fade_centre", Vec3(stage.camera.target - ball.centre));
    for (std::size_t i = 0; i < stage.grounds.size(); ++i) {
        const Ground& ground = stage.grounds[i];
        set(surface, "grid", ground.grid == 0 ? pleasant_spacing(0.1 * distance) : ground.grid);
        set(surface, "floor_point", Vec3(ground.point - ball.centre));
        draw_part(geometry.grounds[i]);
    }
    set(surface, "is_ground", 0);
}

void Renderer::Machine::draw_bodies(const Stage& stage, const Geometry& geometry)
{
    const auto draw_body = [&](std::size_t i) {
        set(surface, "line_width", stage.bodies[i].wireframe ? 2.2 : 0.0);
        set(surface, "opacity", stage.bodies[i].opacity);
        draw_part(geometry.bodies[i]);
    };
    std::vector<std::size_t> glassy;
    for (std::size_t i = 0; i < stage.bodies.size(); ++i) {
        if (stage.bodies[i].opacity < 1)
            glassy.push_back(i);
        else
            draw_body(i);
    }
    // What shows through is painted over what lies behind it: inner sides first.
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    for (const GLenum hidden : std::initializer_list<GLenum>{GL_FRONT, GL_BACK}) {
        glCullFace(hidden);
        for (const std::size_t i : glassy)
            draw_body(i);
    }
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Renderer::Machine::draw_annotations(const Geometry& geometry)
{
    glEnable(GL_BLEND);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -4);
    const auto draw_both = [&](double opacity) {
        set(annotation, "opacity", 0.95 * opacity);
        draw_part(geometry.tints);
        set(annotation, "opacity", opacity);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        draw_part(geometry.annotations);
        glDisable(GL_CULL_FACE);
    };
    // Contacts lie inside of bodies: what is hidden shines through faintly, what is seen covers it.
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    draw_both(0.4);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    draw_both(1);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

Renderer::Renderer(int width, int height) : width_(width), height_(height)
{
    if (std::min(width, height) < 16 || std::max(width, height) > 4096)
        throw InputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels: both must lie in [16, 4096]");
    if (!pictures_wanted())
        return;
    make_current();
    machine_ = std::make_unique<Machine>(width, height);
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Picture Renderer::draw(const Stage& stage)
{
    if (!pictures_wanted())
        return {};
    make_current();
    const Ball ball = ball_around(stage);
    const auto lights = studio_lights(stage.camera, up);
    const Geometry geometry = gather(stage, ball, height_);
    const Eigen::Matrix4d to_screen = view_projection(stage.camera, ball,
                                                      static_cast<double>(width_) / height_);

    machine_->upload(geometry.soup);
    machine_->shadows.fill(lights, ball.radius, geometry.casters.count);
    machine_->canvas.begin();

    glBindVertexArray(machine_->layout);
    glEnable(GL_DEPTH_TEST);
    const GLuint surface = machine_->surface, annotation = machine_->annotation;
    for (const GLuint program : {annotation, surface}) {
        glUseProgram(program);
        set(program, "view_projection", to_screen);
        set(program, "eye", Vec3(stage.camera.eye - ball.centre));
    }
    machine_->shadows.hand_over(surface, lights, ball.radius);
    const Ground floor = stage.grounds.empty() ? Ground{ball.centre - 10 * ball.radius * up, up, -1}
                                               : stage.grounds.front();
    set(surface, "picture_height", static_cast<double>(machine_->canvas.rows()));
    set(surface, "open_floor", open_floor(lights));
    set(surface, "floor_normal", floor.normal);
    machine_->draw_grounds(stage, geometry, ball);
    set(surface, "floor_point", Vec3(floor.point - ball.centre));
    machine_->draw_bodies(stage, geometry);
    glUseProgram(annotation);
    machine_->draw_annotations(geometry);

    Picture picture = machine_->canvas.develop();
    for (const Label& label : stage.labels)
        draw_label(picture, label, stage.camera);
    return picture;
}

}  // namespace enduring
