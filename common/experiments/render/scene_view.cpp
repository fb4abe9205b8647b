#include "common/experiments/render/scene_view.hpp"

#include "common/scenes/drawn_body.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <iterator>

namespace enduring {
namespace {

Drawable drawable_of(const Body& body, const Vec3& own_color, const Scene& scene)
{
    Drawable drawable;
    drawable.positions = drawn_points(body);
    drawable.faces = drawn_faces(body);
    drawable.color = own_color;
    // An open static surface is a piece of ground: it would stretch the shadow maps and shade nothing.
    drawable.casts_shadow = !body.is_static() || body.surface().is_closed() || body.surface().faces().empty();
    drawable.wireframe = !drawable.casts_shadow;
    if (const auto look = scene.looks.find(body.name()); look != scene.looks.end()) {
        drawable.color = look->second.color;
        drawable.smooth = look->second.smooth;
    }
    return drawable;
}

struct MarkColors {
    Vec3 vertex, face, edge;
};

void mark(Stage& stage, const World& world, const Contact& contact, const MarkColors& colors)
{
    std::array<Vec3, 4> points;
    for (int i = 0; i < contact.vertex_count(); ++i)
        points[i] = contact_vertex(world, contact, i, 0);
    if (contact.kind == ContactKind::edge_edge) {
        stage.segments.push_back({points[0], points[1], colors.edge, 4});
        stage.segments.push_back({points[2], points[3], colors.edge, 4});
        return;
    }
    stage.dots.push_back({points[0], colors.vertex});
    if (contact.kind == ContactKind::vertex_face)
        stage.triangles.push_back({{points[1], points[2], points[3]}, colors.face});
}

}  // namespace

Stage stage_of(const World& world, const Scene& scene)
{
    Stage stage;
    std::size_t moving = 0;
    for (const auto& body : world.bodies) {
        const Vec3& color = body->is_static() ? palette::sand
                                              : palette::bodies[moving++ % palette::bodies.size()];
        stage.bodies.push_back(drawable_of(*body, color, scene));
    }
    for (const Plane& plane : world.planes)
        stage.grounds.push_back({plane.point, plane.normal});
    stage.camera.eye = scene.camera.eye;
    stage.camera.target = scene.camera.target;
    stage.camera.field_of_view_deg = scene.camera.field_of_view_deg;
    return stage;
}

void mark_contacts(Stage& stage, const World& world, const Contacts& contacts)
{
    for (const Contact& contact : contacts)
        mark(stage, world, contact,
             {palette::colliding_vertex, palette::colliding_face, palette::colliding_edge});
}

void mark_pairs(Stage& stage, const World& world, const Contacts& contacts)
{
    for (Drawable& drawable : stage.bodies)
        drawable.wireframe = drawable.faces.size() < 800;  // finer ones would be all lines
    Contacts pushing;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(pushing),
                 [](const Contact& contact) { return !contact.held(); });
    mark_contacts(stage, world, pushing);
}

void mark_artefacts(Stage& stage, const World& world, const Contacts& contacts)
{
    for (const Contact& contact : contacts)
        mark(stage, world, contact, {palette::artefact, palette::artefact, palette::artefact});
}

}  // namespace enduring
