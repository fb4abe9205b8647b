#include "chapters/05_categorisation/experiments/ambiguity.hpp"

#include "chapters/05_categorisation/experiments/experiments.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace enduring::chapter05 {
namespace {

// Lengths and counts in powers of two, so that the arrangements agree in every bit and not only nearly.
constexpr double cell = 0.5;  ///< of both bodies' grids [m]
/// the vertex lies so far above the lower edge of B's face, and half as far behind it [m]
constexpr double sunk = 0.0625;

const Vec3 the_vertex = Vec3::Zero();

/// A box of whole cells between two corners.
std::unique_ptr<StaticBody> block(const std::string& name, const Vec3& low, const Vec3& high)
{
    std::array<int, 3> cells;
    for (int axis = 0; axis < 3; ++axis)
        cells[axis] = static_cast<int>(std::lround((high[axis] - low[axis]) / cell));
    SurfaceMesh mesh = box(high - low, cells);
    for (Vec3& x : mesh.vertices)
        x += 0.5 * (low + high);
    SurfaceTopology topology(static_cast<int>(mesh.vertices.size()), std::move(mesh.faces));
    return std::make_unique<StaticBody>(name, std::move(topology), std::move(mesh.vertices));
}

int vertex_at(const Body& body, const Vec3& point)
{
    const auto found = std::find(body.positions_t0().begin(), body.positions_t0().end(), point);
    if (found == body.positions_t0().end())
        throw InputError("body '" + body.name() + "' has no vertex at the place of the pair");
    return static_cast<int>(found - body.positions_t0().begin());
}

/// The face of B that the vertex would leave through: it looks to +x, and the vertex lies inside its outline.
int face_behind(const Body& body)
{
    const SurfaceMoment surface = surface_at(body, 0);
    for (int face = 0; face < static_cast<int>(body.surface().faces().size()); ++face) {
        const Vec3 normal = surface.face_normal(face).normalized();
        const auto [f0, f1, f2] = surface.step.face(face);
        if (normal.x() < 0.99)
            continue;
        bool within = true;
        for (const auto& [from, to] : {std::array{f0, f1}, {f1, f2}, {f2, f0}})
            within = within && (surface.position(to) - surface.position(from))
                                       .cross(the_vertex - surface.position(from))
                                       .x() >= 0;
        if (within)
            return face;
    }
    throw InputError("body '" + body.name() + "' has no face in front of the vertex");
}

struct Extent {
    Vec3 low, high;
};

Extent extent(const Body& body)
{
    Extent all{body.positions_t0()[0], body.positions_t0()[0]};
    for (const Vec3& x : body.positions_t0())
        all = {all.low.cwiseMin(x), all.high.cwiseMax(x)};
    return all;
}

/// The shortest of the six translations of A that part two boxes.
Vec3 shortest_way_out(const Body& a, const Body& b)
{
    const Extent of_a = extent(a), of_b = extent(b);
    Vec3 shortest = Vec3::Constant(1e9);
    for (int axis = 0; axis < 3; ++axis)
        for (const double way : {of_b.high[axis] - of_a.low[axis], of_b.low[axis] - of_a.high[axis]})
            if (std::abs(way) < shortest.norm())
                shortest = way * Vec3::Unit(axis);
    return shortest;
}

Arrangement arrange(std::string name, std::unique_ptr<StaticBody> a, std::unique_ptr<StaticBody> b)
{
    Arrangement one;
    one.name = std::move(name);
    one.way_out = shortest_way_out(*a, *b);
    const int vertex = vertex_at(*a, the_vertex), face = face_behind(*b);
    const auto [f0, f1, f2] = b->surface().faces()[face];
    one.contact = {ContactKind::vertex_face,         0, 1, vertex, face, {vertex, f0, f1, f2},
                   {1, -1 / 3.0, -1 / 3.0, -1 / 3.0}};
    one.world.bodies.push_back(std::move(a));
    one.world.bodies.push_back(std::move(b));
    one.truly_regular = contact_geometry(one.world, one.contact, 0).normal.dot(one.way_out.normalized()) >
                        hook_cosine;
    return one;
}

Picture draw(Renderer& renderer, const Arrangement& one)
{
    const Scene plain;  // no camera and no colours
    Stage stage = stage_of(one.world, plain);
    stage.bodies[0].color = palette::sand;
    stage.bodies[1].color = palette::blue;
    stage.bodies[1].opacity = 0.45;
    for (Drawable& body : stage.bodies)
        body.wireframe = true;
    mark_contacts(stage, one.world, {one.contact});
    // Along the line on which the bodies part: A's way where it can be seen, else B's.
    const Vec3 arrow = one.way_out.y() < 0 ? Vec3::UnitY() : Vec3(one.way_out.normalized());
    stage.segments.push_back({.from = the_vertex,
                              .to = the_vertex + 0.8 * arrow,
                              .color = palette::colliding_edge,
                              .width_px = 5,
                              .arrow = true});
    stage.camera.target = {0, 0, 0};
    stage.camera.eye = {2.4, 2.0, 5.2};
    stage.camera.field_of_view_deg = 32;
    return renderer.draw(stage);
}

}  // namespace

//! [arrangements]
std::vector<Arrangement> arrangements()
{
    const double front = 0.5 * sunk;  // of B's upright side
    std::vector<Arrangement> all;
    all.push_back(arrange("a) stands in the ground", block("ground", {-2, -1, -1}, {2, 0, 1}),
                          block("box", {front - 1, -sunk, -0.375}, {front, 1 - sunk, 0.625})));
    all.push_back(arrange("b) stuck in a wall", block("plate", {-0.5, -0.5, -1}, {1.5, 0, 1}),
                          block("wall", {front - 1, -1 - sunk, -0.875}, {front, 1 - sunk, 1.125})));
    all.push_back(arrange("c) sunk deep into the ground", block("ground", {-2, -1, -1}, {2, 0, 1}),
                          block("box", {front - 1, -0.5 - sunk, -0.375}, {front, 0.5 - sunk, 0.625})));
    return all;
}
//! [arrangements]

std::vector<Vec3> local_positions(const Arrangement& arrangement)
{
    const Body &a = *arrangement.world.bodies[0], &b = *arrangement.world.bodies[1];
    std::vector<Vec3> positions;
    const auto add_face = [&](const Body& body, int face) {
        for (const int vertex : body.surface().faces()[face])
            positions.push_back(body.positions_t0()[vertex]);
    };
    positions.push_back(a.positions_t0()[arrangement.contact.feature_a]);
    add_face(b, arrangement.contact.feature_b);
    for (const int face : a.surface().faces_around_vertex(arrangement.contact.feature_a))
        add_face(a, face);
    return positions;
}

void ambiguity(const RunOptions&, Report& report)
{
    Renderer renderer(500, 400);
    std::vector<StripPicture> pictures;
    Table table({"arrangement", "way out of A [m]", "the pair is", "label"});
    for (const Arrangement& one : arrangements()) {
        pictures.push_back({draw(renderer, one), one.name});
        const Vec3& way = one.way_out;
        const std::string direction = way.x() != 0 ? "sideways" : way.y() != 0 ? "down" : "across";
        const bool hooked = categorise(one.world, one.contact, 0) == ContactCategory::hooked;
        char length[32];
        std::snprintf(length, sizeof length, "%.4f ", way.norm());
        table.add({one.name, length + direction, std::string(one.truly_regular ? "regular" : "hooked"),
                   std::string(hooked ? "hooked" : "regular")});
    }
    report.table("ambiguity", table);
    report.page_table("ambiguity", table);
    write_png(strip(pictures), report.file("ambiguity.png"));
}

}  // namespace enduring::chapter05
