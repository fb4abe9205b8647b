#include "chapters/08_deep_contacts/experiments/self_crossings.hpp"

#include "chapters/02_collision_detection/swept_box.hpp"
#include "chapters/08_deep_contacts/piercing.hpp"
#include "common/geometry/offset_surface.hpp"

#include <algorithm>

namespace enduring::chapter08 {
long self_crossings(const Body& body, const RestNeighbours& neighbours, double skin)
{
    const std::vector<Vec3> x = offset_surface(body.surface().faces(), body.positions_t0(), -skin);
    const SurfaceStep still{body.surface(), x, x};
    const int faces = static_cast<int>(body.surface().faces().size()),
              edges = static_cast<int>(body.surface().edges().size());
    std::vector<SweptBox> boxes;
    for (int face = 0; face < faces; ++face)
        boxes.push_back(face_box(still, face));
    long count = 0;
    for (int edge = 0; edge < edges; ++edge) {
        const SweptBox box = edge_box(still, edge);
        const auto [p, q] = still.edge(edge);
        for (int face = 0; face < faces; ++face) {
            if (!box.overlaps(boxes[face]) || neighbours.edge_and_face(edge, face))
                continue;
            const auto [a, b, c] = still.face(face);
            count += pierces(x[p], x[q], x[a], x[b], x[c], 1) != 0;
        }
    }
    return count;
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

}  // namespace enduring::chapter08
