#include "chapters/10_self_contact/experiments/self_crossings.hpp"

#include "chapters/02_collision_detection/swept_box.hpp"
#include "chapters/09_deep_contacts/piercing.hpp"
#include "common/geometry/offset_surface.hpp"

#include <algorithm>

namespace enduring::chapter10 {

namespace {

/// Hands on each edge that passes through a face, as two points and three.
template <class Take>
void for_each_crossing(const Body& body, const RestNeighbours& neighbours, double skin, const Take& take)
{
    const std::vector<Vec3> x = offset_surface(body.surface().faces(), body.positions_t0(), -skin);
    const SurfaceStep still{body.surface(), x, x};
    const int faces = static_cast<int>(body.surface().faces().size()),
              edges = static_cast<int>(body.surface().edges().size());
    std::vector<SweptBox> boxes;
    for (int face = 0; face < faces; ++face)
        boxes.push_back(face_box(still, face));
    for (int edge = 0; edge < edges; ++edge) {
        const SweptBox box = edge_box(still, edge);
        const auto [p, q] = still.edge(edge);
        for (int face = 0; face < faces; ++face) {
            if (!box.overlaps(boxes[face]) || neighbours.edge_and_face(edge, face))
                continue;
            const auto [a, b, c] = still.face(face);
            if (pierces(x[p], x[q], x[a], x[b], x[c], 1) != 0)
                take(x[p], x[q], x[a], x[b], x[c]);
        }
    }
}

}  // namespace

long self_crossings(const Body& body, const RestNeighbours& neighbours, double skin)
{
    long count = 0;
    for_each_crossing(body, neighbours, skin, [&](auto&&...) { ++count; });
    return count;
}

std::vector<Vec3> self_crossing_points(const Body& body, const RestNeighbours& neighbours)
{
    std::vector<Vec3> points;
    for_each_crossing(body, neighbours, 0,
                      [&](const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
                          const Vec3 normal = (b - a).cross(c - a);
                          const double before = normal.dot(p - a), after = normal.dot(q - a);
                          points.push_back(before == after ? p : lerp(p, q, before / (before - after)));
                      });
    return points;
}

double crossing_depth(const Body& body, const RestNeighbours& neighbours, double known)
{
    constexpr double smallest = 1e-6, largest = 0.05, finer = 1.1;
    const auto crosses = [&](double skin) { return self_crossings(body, neighbours, skin) > 0; };
    if (!crosses(known))
        return known;
    // in small steps: a skin of more than half of a thin part turns it inside out, and crosses again
    double skin = std::max(smallest, known);
    while (skin < largest && crosses(skin))
        skin *= finer;
    return skin;
}

}  // namespace enduring::chapter10
