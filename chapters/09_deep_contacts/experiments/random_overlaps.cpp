#include "chapters/09_deep_contacts/experiments/random_overlaps.hpp"

#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter09 {
namespace {

/// Scaled and moved so that its box is 2 m large and around the origin.
SurfaceMesh centred(SurfaceMesh mesh)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& x : mesh.vertices)
        box.extend(x);
    for (Vec3& x : mesh.vertices)
        x = 2 / box.sizes().maxCoeff() * (x - box.center());
    return mesh;
}

/// A ball with every third vertex pulled out.
SurfaceMesh spikes()
{
    SurfaceMesh mesh = sphere(1, 2);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3)
        mesh.vertices[i] *= 2.2;
    return mesh;
}

Eigen::Quaterniond any_turn(std::mt19937_64& random)
{
    std::normal_distribution<double> normal;
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    return Eigen::Quaterniond(w, x, y, z).normalized();
}

/// About two axes by whole quarters.
Eigen::Matrix3d quarter_turns(std::mt19937_64& random)
{
    std::uniform_int_distribution<int> quarters(0, 3);
    Eigen::Matrix3d about_y, about_x, turn = Eigen::Matrix3d::Identity();
    about_y << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    about_x << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    for (int i = quarters(random); i > 0; --i)
        turn = about_y * turn;
    for (int i = quarters(random); i > 0; --i)
        turn = about_x * turn;
    return turn;
}

double on_lattice_line(double x) { return lattice * std::round(x / lattice); }

/// Where the vertices of a shape stand after the shift that tracing only thinks of, if its numbers are on the
/// lattice: a step so small that no product of lattice numbers but zero can tell.
Vec3 after_shift(const Vec3& x, int shift)
{
    const double step = std::ldexp(1.0, -14);
    return x + shift * Vec3(step, step * step, step * step * step);
}

void check_regions(const OverlapShape& a, const OverlapShape& b, const SurfaceRegions& regions, bool of_a,
                   bool on_lattice, int max_asked, OverlapCheck& check)
{
    const OverlapShape &mine = of_a ? a : b, &other = of_a ? b : a;
    const int count = static_cast<int>(mine.positions().size());
    const int every = std::max(1, count / max_asked);
    for (int vertex = 0; vertex < count; ++vertex) {
        check.inside += regions.winding_of_vertex(vertex) > 0;
        if (vertex % every != 0)
            continue;
        const Vec3& x = mine.positions()[vertex];
        const double winding = winding_number(other.still().topology.faces(), other.positions(),
                                              on_lattice ? after_shift(x, of_a ? 1 : -1) : x);
        ++check.asked;
        check.wrong += std::abs(winding - regions.winding_of_vertex(vertex)) > 0.25;
    }
}

}  // namespace

std::vector<std::pair<std::string, SurfaceMesh>> overlap_meshes()
{
    BowlShape shape;
    shape.segments_around = 16;
    shape.segments_along = 6;
    shape.segments_rim = 2;
    const SurfaceMesh bunny = surface_of(read_gmsh(source_directory() / "common/meshes/bunny_363.msh")).mesh;
    return {{"bunny", centred(bunny)},
            {"bowl", centred(bowl(shape))},
            {"spikes", centred(spikes())},
            {"box", centred(box({2, 2, 2}, {4, 4, 4}))},
            {"plate", centred(box({2, 0.25, 2}, {8, 1, 4}))}};
}

SurfaceMesh place_at_random(SurfaceMesh mesh, std::mt19937_64& random, bool on_lattice)
{
    std::uniform_real_distribution<double> way(-1, 1);
    const Eigen::Matrix3d turn = on_lattice ? quarter_turns(random) : any_turn(random).toRotationMatrix();
    const double x = way(random), y = way(random), z = way(random);
    for (Vec3& vertex : mesh.vertices) {
        vertex = turn * vertex + Vec3(x, y, z);
        if (on_lattice)
            vertex = vertex.unaryExpr(&on_lattice_line).eval();
    }
    return mesh;
}

std::vector<Piercing> textbook_piercings(const StillSurface& a, const StillSurface& b)
{
    std::vector<Piercing> found;
    const auto ask = [&](const StillSurface& of_edge, int edge, const StillSurface& of_face, int face) {
        const auto [p, q] = of_edge.topology.edges()[edge];
        const auto [f0, f1, f2] = of_face.topology.faces()[face];
        const auto& x = of_face.positions;
        if (find_edge_triangle_hit(of_edge.positions[p], of_edge.positions[q], x[f0], x[f1], x[f2]))
            found.push_back({&of_edge == &a, edge, face, 1});
    };
    FaceTree::overlapping_faces(a.tree, b.tree, [&](int face_a, int face_b) {
        for (const int edge : a.tree.owned_edges(face_a))
            ask(a, edge, b, face_b);
        for (const int edge : b.tree.owned_edges(face_b))
            ask(b, edge, a, face_a);
    });
    return found;
}

OverlapCheck check_overlap(const SurfaceMesh& a, const SurfaceMesh& b, bool on_lattice, int max_asked)
{
    const OverlapShape one(a), other(b);
    const Intersection intersection = trace_intersection(one.still(), other.still());
    OverlapCheck check;
    check.piercings = static_cast<long>(intersection.piercings.size());
    check.curves = static_cast<long>(intersection.curves.size());
    for (const IntersectionCurve& curve : intersection.curves)
        check.open_curves += !curve.closed;
    const StillSurface still_a = one.still(), still_b = other.still();
    for (const IntersectionCurve& curve :
         join_piercings(textbook_piercings(still_a, still_b), still_a, still_b).curves)
        check.textbook_closes = check.textbook_closes && curve.closed;
    for (const bool of_a : {true, false})
        check_regions(one, other, flood_regions(intersection.piercings, one.still(), other.still(), of_a),
                      of_a, on_lattice, max_asked, check);
    return check;
}

}  // namespace enduring::chapter09
