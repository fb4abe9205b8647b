#include "common/experiments/paraview/vtk_text.hpp"

#include "common/experiments/paraview/vtk_document.hpp"
#include "common/input/number_text.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

constexpr int vtk_tetrahedron = 10, vtk_quadratic_tetrahedron = 24;

/// Nodes, elements and what is known of them, of one body after the other.
struct ElementArrays {
    std::vector<Vec3> points, velocities;
    std::vector<long> point_bodies, corners, ends, types, inverted, cell_bodies;
};

/// A nodal field at the points that VTK means: of a quadratic element the
/// middles of its edges, c_a/4 + c_ab/2 + c_b/4.
std::vector<Vec3> at_vtk_points(const ElasticMesh& mesh, const NodalVectors& field)
{
    std::vector<Vec3> values;
    for (Eigen::Index node = 0; node < field.cols(); ++node)
        values.emplace_back(field.col(node));
    if (mesh.basis() == Basis::quadratic)
        for (const ElasticElement& element : mesh.elements())
            for (std::size_t edge = 0; edge < tetrahedron_edges.size(); ++edge) {
                const auto [a, b] = tetrahedron_edges[edge];
                const int middle = element.nodes[4 + edge];
                values[middle] = field.col(middle) / 2 +
                                 (field.col(element.nodes[a]) + field.col(element.nodes[b])) / 4;
            }
    return values;
}

void append(ElementArrays& arrays, const ElasticBody& elastic, long body)
{
    const ElasticMesh& mesh = elastic.mesh();
    const long first = static_cast<long>(arrays.points.size());
    const std::vector<Vec3> points = at_vtk_points(mesh, elastic.positions()),
                            velocities = at_vtk_points(mesh, elastic.velocities());
    arrays.points.insert(arrays.points.end(), points.begin(), points.end());
    arrays.velocities.insert(arrays.velocities.end(), velocities.begin(), velocities.end());
    arrays.point_bodies.resize(arrays.points.size(), body);

    const int nodes = nodes_of(mesh.basis());
    for (const ElasticElement& element : mesh.elements()) {
        for (int i = 0; i < nodes; ++i)
            arrays.corners.push_back(first + element.nodes[i]);
        arrays.ends.push_back(static_cast<long>(arrays.corners.size()));
        arrays.types.push_back(mesh.basis() == Basis::quadratic ? vtk_quadratic_tetrahedron
                                                                : vtk_tetrahedron);
        arrays.inverted.push_back(is_inverted(mesh.basis(), element, elastic.positions()) ? 1 : 0);
        arrays.cell_bodies.push_back(body);
    }
}

/// Faces, edges or points of all bodies, by the places of their vertices among those of all.
struct Cells {
    std::vector<long> corners, ends, bodies;

    template <class Corners>
    void add(const Corners& of_body, long first, std::size_t body)
    {
        for (const int corner : of_body)
            corners.push_back(first + corner);
        ends.push_back(static_cast<long>(corners.size()));
        bodies.push_back(static_cast<long>(body));
    }
};

}  // namespace

std::string surfaces_vtp(const World& world, const Contacts& contacts, double dt)
{
    std::vector<Vec3> points, velocities, forces;
    std::vector<long> point_bodies;
    Cells polygons, wires, lonely;
    const std::vector<std::vector<Vec3>> forces_of = vertex_forces(world, contacts, dt);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
        const Body& body = *world.bodies[b];
        const long first = static_cast<long>(points.size());
        points.insert(points.end(), body.positions_t0().begin(), body.positions_t0().end());
        for (int v = 0; v < body.surface().vertex_count(); ++v)
            velocities.push_back(body.velocity(v));
        forces.insert(forces.end(), forces_of[b].begin(), forces_of[b].end());
        point_bodies.resize(points.size(), static_cast<long>(b));
        const SurfaceTopology& surface = body.surface();
        for (const Face& face : surface.faces())
            polygons.add(face, first, b);
        for (std::size_t e = 0; surface.faces().empty() && e < surface.edges().size(); ++e)
            wires.add(surface.edges()[e], first, b);
        for (int v = 0; surface.faces().empty() && v < surface.vertex_count(); ++v)
            if (surface.edges_around_vertex(v).empty())
                lonely.add(std::array{v}, first, b);
    }
    // VTK's order of cells, and of what they carry
    std::vector<long> cell_bodies = lonely.bodies;
    for (const Cells* more : {&wires, &polygons})
        cell_bodies.insert(cell_bodies.end(), more->bodies.begin(), more->bodies.end());
    VtkDocument document("PolyData", {{"NumberOfPoints", points.size()},
                                      {"NumberOfVerts", lonely.ends.size()},
                                      {"NumberOfLines", wires.ends.size()},
                                      {"NumberOfPolys", polygons.ends.size()}});
    document.section("Points").add("points", points);
    for (const auto& [name, cells] :
         {std::pair{"Verts", &lonely}, std::pair{"Lines", &wires}, std::pair{"Polys", &polygons}})
        document.section(name).add("connectivity", cells->corners).add("offsets", cells->ends);
    document.section("PointData")
        .add("velocity", velocities)
        .add("contact_force", forces)
        .add("body", point_bodies);
    document.section("CellData").add("body", cell_bodies);
    return document.text();
}

bool has_elements(const World& world)
{
    return std::any_of(world.bodies.begin(), world.bodies.end(), [](const auto& body) {
        return dynamic_cast<const DeformableBody*>(body.get()) != nullptr;
    });
}

std::string elements_vtu(const World& world)
{
    ElementArrays arrays;
    for (std::size_t b = 0; b < world.bodies.size(); ++b)
        if (const auto* const body = dynamic_cast<const DeformableBody*>(world.bodies[b].get()))
            append(arrays, body->elastic(), static_cast<long>(b));
    VtkDocument document("UnstructuredGrid",
                         {{"NumberOfPoints", arrays.points.size()}, {"NumberOfCells", arrays.ends.size()}});
    document.section("Points").add("points", arrays.points);
    document.section("Cells")
        .add("connectivity", arrays.corners)
        .add("offsets", arrays.ends)
        .add("types", arrays.types);
    document.section("PointData").add("velocity", arrays.velocities).add("body", arrays.point_bodies);
    document.section("CellData").add("inverted", arrays.inverted).add("body", arrays.cell_bodies);
    return document.text();
}

std::string pairs_vtp(const World& world, const Contacts& contacts, double dt)
{
    std::vector<Vec3> points, normal_forces, friction_forces, impulses;
    std::vector<double> depths;
    std::vector<long> ends, corners, kinds, categories, held, a, b;
    const double part = last_part(world, dt);
    for (const Contact& contact : contacts) {
        const ContactGeometry geometry = contact_geometry(world, contact, 1);
        for (const Vec3& point : {geometry.q, geometry.p}) {
            corners.push_back(static_cast<long>(points.size()));
            points.push_back(point);
        }
        ends.push_back(static_cast<long>(corners.size()));
        const PairForce force = pair_force(contact, part);
        normal_forces.push_back(force.normal);
        friction_forces.push_back(force.friction);
        impulses.push_back(contact.impulse + contact.friction);
        depths.push_back(geometry.depth);
        kinds.push_back(static_cast<long>(contact.kind));
        categories.push_back(static_cast<long>(contact.category));
        held.push_back(contact.held() ? 1 : 0);
        a.push_back(contact.body_a);
        b.push_back(contact.on_plane() ? -1 - contact.body_b : contact.body_b);
    }
    VtkDocument document("PolyData", {{"NumberOfPoints", points.size()}, {"NumberOfLines", ends.size()}});
    document.section("Points").add("points", points);
    document.section("Lines").add("connectivity", corners).add("offsets", ends);
    document.section("CellData")
        .add("normal_force", normal_forces)
        .add("friction_force", friction_forces)
        .add("impulse", impulses)
        .add("depth", depths)
        .add("kind", kinds)
        .add("category", categories)
        .add("held", held)
        .add("body_a", a)
        .add("body_b", b);
    return document.text();
}

std::string series_pvd(const std::vector<VtkMoment>& moments)
{
    pugi::xml_document document;
    pugi::xml_node collection = begin_vtk_file(document, "Collection");
    for (const VtkMoment& moment : moments) {
        pugi::xml_node entry = collection.append_child("DataSet");
        entry.append_attribute("timestep") = shortest(moment.time).c_str();
        entry.append_attribute("part") = 0;
        entry.append_attribute("file") = moment.file.c_str();
    }
    return xml_text(document);
}

}  // namespace enduring
