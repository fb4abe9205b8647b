#include "chapters/09_deep_contacts/piercing.hpp"

#include <cmath>

namespace enduring {
namespace {

/// A moves by the infinitesimal step, so B moves against it.
constexpr int shift_of_a = 1, shift_of_b = -1;

int edge_pierces(const StillSurface& of_edge, int edge, const StillSurface& of_face, int face, int shift)
{
    const auto [p, q] = of_edge.topology.edges()[edge];
    const auto [a, b, c] = of_face.topology.faces()[face];
    return pierces(of_edge.positions[p], of_edge.positions[q], of_face.positions[a], of_face.positions[b],
                   of_face.positions[c], shift);
}

}  // namespace

//! [pierces]
int pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, int shift)
{
    const int side_p = side_of_plane({p, a}, {b, a}, {c, a}, shift);
    if (side_p == side_of_plane({q, a}, {b, a}, {c, a}, shift))
        return 0;
    const int past_ab = side_of_plane({p, a}, {q, p}, {b, a}, shift);
    return past_ab == side_of_plane({p, b}, {q, p}, {c, b}, shift) &&
                   past_ab == side_of_plane({p, c}, {q, p}, {a, c}, shift)
               ? side_p
               : 0;
}
//! [pierces]

//! [find_piercings]
std::vector<Piercing> find_piercings(const StillSurface& a, const StillSurface& b)
{
    std::vector<Piercing> found;
    FaceTree::overlapping_faces(a.tree, b.tree, [&](int face_a, int face_b) {
        for (const int edge : a.tree.owned_edges(face_a))
            if (a.tree.edge_box(edge).overlaps(b.tree.face_box(face_b)))
                if (const int entry = edge_pierces(a, edge, b, face_b, shift_of_a))
                    found.push_back({true, edge, face_b, entry});
        for (const int edge : b.tree.owned_edges(face_b))
            if (b.tree.edge_box(edge).overlaps(a.tree.face_box(face_a)))
                if (const int entry = edge_pierces(b, edge, a, face_a, shift_of_b))
                    found.push_back({false, edge, face_a, entry});
    });
    return found;
}
//! [find_piercings]

Vec3 point_of(const Piercing& piercing, const StillSurface& a, const StillSurface& b)
{
    const StillSurface &of_edge = piercing.edge_of_a ? a : b, &of_face = piercing.edge_of_a ? b : a;
    const auto [p, q] = of_edge.topology.edges()[piercing.edge];
    const auto [f0, f1, f2] = of_face.topology.faces()[piercing.face];
    const Vec3 &from = of_edge.positions[p], &to = of_edge.positions[q], &corner = of_face.positions[f0];
    const Vec3 normal = (of_face.positions[f1] - corner).cross(of_face.positions[f2] - corner);
    const double before = std::abs(normal.dot(from - corner)), behind = std::abs(normal.dot(to - corner));
    const double along = before + behind > 0 ? before / (before + behind) : 0.5;
    return from + along * (to - from);
}

int winding_by_ray(const Vec3& point, const StillSurface& b, int shift)
{
    const SweptBox box = b.tree.box();
    const Vec3 outside(point.x(), box.high.y() + (box.high - box.low).norm(), point.z());
    int winding = 0;
    b.tree.faces_near({point, outside}, [&](int face) {
        const auto [f0, f1, f2] = b.topology.faces()[face];
        winding -= pierces(point, outside, b.positions[f0], b.positions[f1], b.positions[f2], shift);
    });
    return winding;
}

}  // namespace enduring
