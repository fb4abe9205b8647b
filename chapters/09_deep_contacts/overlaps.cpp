#include "chapters/09_deep_contacts/overlaps.hpp"

#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/07_implicit_contact/joined_sets.hpp"
#include "common/geometry/triangle_distance.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace enduring {
namespace {

/// Vector areas that are smaller than this part of what they are summed from have cancelled.
constexpr double cancelled_area = 1e-3;

Vec3 normal_of(const StillSurface& surface, int face)
{
    const auto [a, b, c] = surface.topology.faces()[face];
    const Vec3& corner = surface.positions[a];
    return (surface.positions[b] - corner).cross(surface.positions[c] - corner);
}

/// Along the curve A's inside lies to the left, seen from outside of A, if its pieces run along n_a x n_b.
double along_the_piece(const Piercing& piercing, const Vec3& piece, const StillSurface& a,
                       const StillSurface& b)
{
    const SurfaceTopology& of_edge = (piercing.edge_of_a ? a : b).topology;
    double along = 0;
    for (const int face : of_edge.faces_at_edge(piercing.edge))
        if (face >= 0)
            along += piece.dot(normal_of(a, piercing.face_of_a(face))
                                   .cross(normal_of(b, piercing.face_of_b(face)))
                                   .stableNormalized());
    return along;
}

}  // namespace

//! [vector_area]
Vec3 vector_area(const Intersection& intersection, const IntersectionCurve& curve, const StillSurface& a,
                 const StillSurface& b)
{
    const std::size_t count = curve.piercings.size();
    std::vector<Vec3> points;
    for (const int piercing : curve.piercings)
        points.push_back(point_of(intersection.piercings[piercing], a, b));
    Vec3 area = Vec3::Zero();
    double direction = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 &now = points[i], &next = points[(i + 1) % count],
                   &before = points[(i + count - 1) % count];
        area += (now - points[0]).cross(next - points[0]) / 2;
        direction += along_the_piece(intersection.piercings[curve.piercings[i]], next - before, a, b);
    }
    return direction < 0 ? Vec3(-area) : area;
}
//! [vector_area]

Vec3 nearest_normal(const StillSurface& surface, const Vec3& point)
{
    double bound = INFINITY;
    int nearest = 0;
    surface.tree.visit_near(point, bound, [&](int face) {
        const auto [a, b, c] = surface.topology.faces()[face];
        const double distance = distance_to_triangle(point, surface.positions[a], surface.positions[b],
                                                     surface.positions[c]);
        if (distance * distance < bound) {
            bound = distance * distance;
            nearest = face;
        }
    });
    return normal_of(surface, nearest).normalized();
}

//! [flood_regions]
SurfaceRegions flood_regions(const std::vector<Piercing>& piercings, const StillSurface& a,
                             const StillSurface& b, bool of_a)
{
    const StillSurface &mine = of_a ? a : b, &other = of_a ? b : a;
    const SurfaceTopology& surface = mine.topology;
    std::vector<bool> is_pierced(surface.edges().size());
    for (const Piercing& piercing : piercings)
        if (piercing.edge_of_a == of_a)
            is_pierced[piercing.edge] = true;

    SurfaceRegions regions{std::vector<int>(static_cast<std::size_t>(surface.vertex_count()), -1), {}};
    for (int first = 0; first < surface.vertex_count(); ++first) {
        if (regions.region_of_vertex[first] >= 0)
            continue;
        const int region = static_cast<int>(regions.winding.size());
        regions.winding.push_back(winding_by_ray(mine.positions[first], other, of_a ? 1 : -1));
        regions.region_of_vertex[first] = region;
        std::vector<int> reached{first};
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (const int edge : surface.edges_around_vertex(reached[i])) {
                const auto [v0, v1] = surface.edges()[edge];
                const int neighbour = v0 == reached[i] ? v1 : v0;
                if (is_pierced[edge] || regions.region_of_vertex[neighbour] >= 0)
                    continue;
                regions.region_of_vertex[neighbour] = region;
                reached.push_back(neighbour);
            }
    }
    return regions;
}
//! [flood_regions]

namespace {

/// Regions inside and curves, each a number; those that meet are of one volume.
class Volumes {
public:
    Volumes(const Intersection& intersection, const StillSurface& a, const StillSurface& b)
        : regions_a_(flood_regions(intersection.piercings, a, b, true)),
          regions_b_(flood_regions(intersection.piercings, a, b, false)),
          volumes_(regions_a_.winding.size() + regions_b_.winding.size() + intersection.curves.size())
    {
        for (std::size_t curve = 0; curve < intersection.curves.size(); ++curve)
            for (const int index : intersection.curves[curve].piercings) {
                const Piercing& piercing = intersection.piercings[index];
                const auto [from, to] = (piercing.edge_of_a ? a : b).topology.edges()[piercing.edge];
                const int vertex = piercing.entry > 0 ? to : from;  // the end on the side that is inside
                if (is_inside(vertex, piercing.edge_of_a))
                    volumes_.join(number_of(curve), number_of(vertex, piercing.edge_of_a));
            }
        join_along_edges(intersection, a, b);
    }
    bool is_inside(int vertex, bool of_a) const
    {
        return (of_a ? regions_a_ : regions_b_).winding_of_vertex(vertex) > 0;
    }
    int of_curve(std::size_t curve) { return volumes_.least_of(number_of(curve)); }
    int of_vertex(int vertex, bool of_a) { return volumes_.least_of(number_of(vertex, of_a)); }

private:
    //! [join_along_edges]
    /// Where an edge goes in and comes out again, the piece between is inside: so both curves bound one
    /// volume, also if no vertex lies in it, as of a body that a plate passes right through.
    void join_along_edges(const Intersection& intersection, const StillSurface& a, const StillSurface& b)
    {
        struct Passage {
            bool edge_of_a;
            int edge;
            double along;  ///< from the smaller vertex on, times the length of the edge [m^2]
            int entry;
            std::size_t curve;
        };
        std::vector<Passage> passages;
        for (std::size_t curve = 0; curve < intersection.curves.size(); ++curve)
            for (const int index : intersection.curves[curve].piercings) {
                const Piercing& piercing = intersection.piercings[index];
                const StillSurface& of_edge = piercing.edge_of_a ? a : b;
                const auto [from, to] = of_edge.topology.edges()[piercing.edge];
                const Vec3 &start = of_edge.positions[from], &end = of_edge.positions[to];
                passages.push_back({piercing.edge_of_a, piercing.edge,
                                    (point_of(piercing, a, b) - start).dot(end - start), piercing.entry,
                                    curve});
            }
        std::sort(passages.begin(), passages.end(), [](const Passage& one, const Passage& other) {
            return std::tie(one.edge_of_a, one.edge, one.along) <
                   std::tie(other.edge_of_a, other.edge, other.along);
        });
        for (std::size_t i = 1; i < passages.size(); ++i) {
            const Passage &in = passages[i - 1], &out = passages[i];
            if (in.edge_of_a == out.edge_of_a && in.edge == out.edge && in.entry > 0 && out.entry < 0)
                volumes_.join(number_of(in.curve), number_of(out.curve));
        }
    }
    //! [join_along_edges]

    int number_of(int vertex, bool of_a) const
    {
        return of_a ? regions_a_.region_of_vertex[vertex]
                    : static_cast<int>(regions_a_.winding.size()) + regions_b_.region_of_vertex[vertex];
    }
    int number_of(std::size_t curve) const
    {
        return static_cast<int>(regions_a_.winding.size() + regions_b_.winding.size() + curve);
    }

    SurfaceRegions regions_a_, regions_b_;
    JoinedSets volumes_;
};

//! [shortest_path]
/// Of the directions along the normals next to some vertices, the one in which the last of them is out first.
Vec3 shortest_path(const StillSurface& inner, const std::vector<int>& vertices, const StillSurface& outer)
{
    Vec3 best = Vec3::Zero();
    double shortest = INFINITY;
    for (const int vertex : vertices) {
        const Vec3 direction = nearest_normal(outer, inner.positions[vertex]);
        double longest = 0;
        for (const int other : vertices)
            if (longest < shortest)
                longest = std::max(longest, find_exit(outer, inner.positions[other], direction).distance);
        if (longest < shortest) {
            shortest = longest;
            best = direction;
        }
    }
    return best;
}
//! [shortest_path]

}  // namespace

//! [find_overlaps]
std::vector<Overlap> find_overlaps(const StillSurface& a, const StillSurface& b)
{
    const Intersection intersection = trace_intersection(a, b);
    Volumes volumes(intersection, a, b);
    struct Sum {
        Overlap overlap;
        Vec3 area = Vec3::Zero(), largest = Vec3::Zero();  ///< of all curves, and of one of them
        double size = 0;
    };
    std::map<int, Sum> sums;
    for (const bool of_a : {true, false})
        for (int vertex = 0; vertex < (of_a ? a : b).topology.vertex_count(); ++vertex)
            if (volumes.is_inside(vertex, of_a)) {
                Overlap& overlap = sums[volumes.of_vertex(vertex, of_a)].overlap;
                (of_a ? overlap.vertices_of_a : overlap.vertices_of_b).push_back(vertex);
            }
    for (std::size_t i = 0; i < intersection.curves.size(); ++i) {
        const Vec3 area = vector_area(intersection, intersection.curves[i], a, b);
        Sum& sum = sums[volumes.of_curve(i)];
        std::vector<Piercing>& curve = sum.overlap.curves.emplace_back();
        for (const int piercing : intersection.curves[i].piercings)
            curve.push_back(intersection.piercings[piercing]);
        sum.area += area;
        if (area.norm() > sum.largest.norm())
            sum.largest = area;
        sum.size += area.norm();
    }
    std::vector<Overlap> overlaps;
    for (auto& [volume, sum] : sums) {
        Overlap& overlap = sum.overlap;
        if (sum.area.norm() > cancelled_area * sum.size)
            overlap.separation_direction = -sum.area.normalized();
        else if (sum.size > 0)  // of a beam through a plate: it leaves along itself
            overlap.separation_direction = -sum.largest.normalized();
        else if (!overlap.vertices_of_a.empty())
            overlap.separation_direction = shortest_path(a, overlap.vertices_of_a, b);
        else if (!overlap.vertices_of_b.empty())
            overlap.separation_direction = -shortest_path(b, overlap.vertices_of_b, a);
        overlaps.push_back(std::move(overlap));
    }
    return overlaps;
}
//! [find_overlaps]

Exit find_exit(const StillSurface& surface, const Vec3& point, const Vec3& direction)
{
    const SweptBox box = surface.tree.box();
    const Vec3 outside = point + 2 * (box.high - box.low).norm() * direction;
    const double length = (outside - point).norm();
    Exit exit;
    surface.tree.faces_near({point.cwiseMin(outside), point.cwiseMax(outside)}, [&](int face) {
        if (normal_of(surface, face).dot(direction) <= 0)
            return;
        const auto [a, b, c] = surface.topology.faces()[face];
        const auto hit = find_edge_triangle_hit(point, outside, surface.positions[a], surface.positions[b],
                                                surface.positions[c]);
        if (hit && hit->along_edge * length < exit.distance)
            exit = {face,
                    {1 - hit->weight_b - hit->weight_c, hit->weight_b, hit->weight_c},
                    hit->along_edge * length};
    });
    return exit;
}

}  // namespace enduring
