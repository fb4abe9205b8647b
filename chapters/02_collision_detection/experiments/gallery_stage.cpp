#include "chapters/02_collision_detection/experiments/gallery_stage.hpp"

#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/input/number_text.hpp"

namespace enduring::chapter02 {
namespace {

const Vec3 towards_eye(0.55, 0.55, 1);

/// What every picture of a strip shares: its camera sees all that any of them shows.
Camera shared_camera(const std::vector<Vec3>& points, const Renderer& renderer)
{
    return frame(points, towards_eye, double(renderer.width()) / renderer.height(), 0.1);
}

Ground floor_below(const std::vector<Vec3>& points)
{
    double lowest = points.front().y();
    for (const Vec3& x : points)
        lowest = std::min(lowest, x.y());
    return {.point = Vec3(0, lowest - 0.25, 0), .grid = -1};
}

void add_face(Stage& stage, const std::vector<Vec3>& x, const std::vector<Face>& faces, bool touching,
              const Vec3& color)
{
    stage.bodies.push_back({.positions = x, .faces = faces, .color = color});
    for (const auto& [a, b, c] : faces)
        for (const auto& [from, to] : {std::array{a, b}, {b, c}, {c, a}})
            stage.segments.push_back(
                {.from = x[std::size_t(from)], .to = x[std::size_t(to)], .width_px = 1.5});
    if (touching)
        for (const auto& [a, b, c] : faces)
            stage.triangles.push_back({.corners = {x[std::size_t(a)], x[std::size_t(b)], x[std::size_t(c)]}});
}

void add_paths(Stage& stage, const std::vector<Vec3>& start, const std::vector<Vec3>& end)
{
    for (std::size_t i = 0; i < start.size(); ++i)
        if ((end[i] - start[i]).norm() > 0.3)  // shorter ones would only clutter
            stage.segments.push_back({.from = start[i],
                                      .to = end[i],
                                      .color = palette::slate,
                                      .width_px = 1.5,
                                      .arrow = true,
                                      .dashed = true});
}

Stage stage_at(const GalleryCase& one, double tau, bool touching)
{
    const std::vector<Vec3> x = points_at(one, tau);
    Stage stage;
    if (std::holds_alternative<VertexFaceStep>(one.step)) {
        add_face(stage, {x[1], x[2], x[3]}, {{0, 1, 2}}, touching, palette::sand);
        stage.dots.push_back(
            {.point = x[0], .color = touching ? palette::colliding_vertex : palette::ink, .radius_px = 6});
    } else {
        for (std::size_t i = 0; i < 4; i += 2)
            stage.segments.push_back({.from = x[i],
                                      .to = x[i + 1],
                                      .color = touching ? palette::colliding_edge
                                               : i == 0 ? palette::terracotta
                                                        : palette::blue,
                                      .width_px = 5});
    }
    add_paths(stage, points_at(one, 0), points_at(one, 1));
    return stage;
}

}  // namespace

GalleryStage::GalleryStage() : renderer_(440, 380) {}

Picture GalleryStage::draw_case(const GalleryCase& one, const std::optional<double>& touch)
{
    std::vector<Vec3> seen = points_at(one, 0);
    for (const Vec3& x : points_at(one, 1))
        seen.push_back(x);

    const double middle = touch.value_or(one.closest);
    const std::string at = "τ = " + readable(middle, 3);
    const std::array<std::pair<double, std::string>, 3> moments{
        {{0, "τ = 0"}, {middle, touch ? at + ": touch" : at + ": no touch"}, {1, "τ = 1"}}};
    std::vector<StripPicture> pictures;
    for (const auto& [tau, caption] : moments) {
        Stage stage = stage_at(one, tau, touch && tau == middle);
        stage.grounds.push_back(floor_below(seen));
        stage.camera = shared_camera(seen, renderer_);
        pictures.push_back({renderer_.draw(stage), caption});
    }
    return strip(pictures);
}

Picture GalleryStage::draw_tunnelling(const Tunnelling& scene, double touch)
{
    std::vector<Vec3> seen = scene.plate;
    seen.insert(seen.end(), scene.spike_t0.begin(), scene.spike_t0.end());
    seen.insert(seen.end(), scene.spike_t1.begin(), scene.spike_t1.end());
    const auto discrete = [&](const std::vector<Vec3>& spike) {
        return "discrete: " + std::to_string(discrete_hits(spike, scene.plate)) + " hits";
    };
    const std::array<std::pair<double, std::string>, 3> moments{
        {{0, "τ = 0, " + discrete(scene.spike_t0)},
         {touch, "continuous: touch at τ = " + readable(touch, 3)},
         {1, "τ = 1, " + discrete(scene.spike_t1)}}};

    std::vector<StripPicture> pictures;
    for (const auto& [tau, caption] : moments) {
        std::vector<Vec3> spike;
        for (std::size_t v = 0; v < scene.spike_t0.size(); ++v)
            spike.push_back(at_time(scene.spike_t0[v], scene.spike_t1[v], tau));
        const bool touching = tau == touch;
        Stage stage;
        add_face(stage, scene.plate, plate_faces(), false, palette::sand);
        add_face(stage, spike, spike_faces(), false, palette::terracotta);
        if (touching)
            stage.dots.push_back({.point = spike[0], .radius_px = 7});
        add_paths(stage, {scene.spike_t0[0]}, {scene.spike_t1[0]});
        stage.grounds.push_back(floor_below(seen));
        stage.camera = shared_camera(seen, renderer_);
        pictures.push_back({renderer_.draw(stage), caption});
    }
    return strip(pictures);
}

Picture GalleryStage::draw_edge_triangle()
{
    const Vec3 a(-1, 0, 0.8), b(1.1, 0.1, 0.6), c(-0.6, 0, -1.1), up(0.1, 0.7, 0.05);
    const auto in_plane = [&](double weight_b, double weight_c) -> Vec3 {
        return a + weight_b * (b - a) + weight_c * (c - a);
    };
    const Vec3 inside = in_plane(0.35, 0.3), beside = in_plane(0.75, 0.6);
    const std::array<std::array<Vec3, 2>, 3> edges{
        {{inside + 1.6 * up, inside + 0.3 * up}, {inside + up, inside - up}, {beside + up, beside - up}}};
    const std::array<std::string, 3> remark{"it ends before the plane", "all weights fit",
                                            "only the printed condition holds"};

    std::vector<Vec3> seen{a, b, c, b + c - a};
    for (const auto& [p, q] : edges)
        seen.insert(seen.end(), {p, q});
    std::vector<StripPicture> pictures;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [p, q] = edges[i];
        const auto hit = find_edge_triangle_hit(p, q, a, b, c);
        Stage stage;
        add_face(stage, {a, b, c}, {{0, 1, 2}}, hit.has_value(), palette::sand);
        for (const Vec3& corner : {b, c})
            stage.segments.push_back(
                {.from = corner, .to = b + c - a, .color = palette::slate, .width_px = 1.5, .dashed = true});
        stage.segments.push_back(
            {.from = p, .to = q, .color = hit ? palette::colliding_edge : palette::ink, .width_px = 5});
        if (hit)
            stage.dots.push_back({.point = p + hit->along_edge * (q - p), .radius_px = 6});
        stage.grounds.push_back(floor_below(seen));
        stage.camera = shared_camera(seen, renderer_);
        pictures.push_back({renderer_.draw(stage), (hit ? "hit: " : "no hit: ") + remark[i]});
    }
    return strip(pictures);
}

}  // namespace enduring::chapter02
