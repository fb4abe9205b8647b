#include "chapters/13_other_solvers/barrier_terms.hpp"

#include "chapters/02_collision_detection/certified.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace enduring {

//! [log_barrier]
BarrierValue log_barrier(double ratio)
{
    if (ratio >= 1)
        return {};
    const double short_of = ratio - 1, log = std::log(ratio);
    return {-short_of * short_of * log, -2 * short_of * log - short_of * short_of / ratio,
            -2 * log - 4 * short_of / ratio + short_of * short_of / (ratio * ratio)};
}
//! [log_barrier]

namespace {

/// Part of the product of both squared lengths from which on edges are not parallel [1]; Li 2020.
constexpr double parallel = 1e-3;

/// Above the plane of a pair, which lies lower by half of d^hat [m].
double height(const ContactPoint& pair, const Vec3& vertex, double distance)
{
    return pair.normal.dot(vertex - pair.on_b) + distance / 2;
}

/// Of the nearest corners: each body and its vertices that have a part, the smaller body first.
using FeatureKey = std::tuple<std::array<int, 5>, std::array<int, 5>, int>;
/// @param own  makes it differ from all others; -1 for none
FeatureKey key_of(const ContactPoint& pair, const NearestPoints& nearest, int own)
{
    std::array<std::array<int, 5>, 2> sides;
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1 : -1;
        sides[side][0] = side == 0 ? pair.a : pair.b;
        for (std::size_t i = 0; i < 4; ++i)
            sides[side][i + 1] = sign * nearest.weights[i] > 0 ? pair.vertices[i] : -1;
        std::sort(sides[side].begin() + 1, sides[side].end());
    }
    return {std::min(sides[0], sides[1]), std::max(sides[0], sides[1]), own};
}

bool boxes_are_near(const FourPoints& x, int corners_of_a, double distance)
{
    std::array<Eigen::AlignedBox3d, 2> boxes;
    for (int i = 0; i < 4; ++i)
        boxes[i < corners_of_a ? 0 : 1].extend(x[static_cast<std::size_t>(i)]);
    return ((boxes[0].min() - boxes[1].max()).array() < distance).all() &&
           ((boxes[1].min() - boxes[0].max()).array() < distance).all();
}

bool boxes_overlap(const FourPoints& from, const FourPoints& to, int corners_of_a)
{
    std::array<Eigen::AlignedBox3d, 2> boxes;
    for (int i = 0; i < 4; ++i)
        for (const FourPoints* x : {&from, &to})
            boxes[i < corners_of_a ? 0 : 1].extend((*x)[static_cast<std::size_t>(i)]);
    return boxes[0].intersects(boxes[1]);
}

}  // namespace

FourPoints corners_of(const ContactPoint& pair, const Places& places)
{
    FourPoints x;
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const int body = i < pair.corners_of_a() ? pair.a : pair.b;
        if (pair.nodes[k] >= 0)
            x[k] = places.nodes[static_cast<std::size_t>(pair.nodes[k])];
        else
            x[k] = i < pair.corner_count()
                       ? places.poses[static_cast<std::size_t>(body)].to_world(pair.corners[k])
                       : Vec3(Vec3::Zero());
    }
    return x;
}

Derivatives BarrierTerm::potential(const ContactPoint& pair, double kappa, double distance) const
{
    Derivatives squared;
    if (pair.on_plane()) {
        squared.gradient.head<3>() = 2 * nearest.difference;
        squared.hessian.topLeftCorner<3, 3>() = 2 * pair.normal * pair.normal.transpose();
    } else
        squared = squared_distance(x, nearest);
    const double scale = kappa * count, unit = distance * distance;
    const Vector12 g = squared.gradient / unit, &m = mollifier.gradient;
    Derivatives of;
    of.value = scale * mollifier.value * barrier.value;
    of.gradient = scale * (mollifier.value * barrier.slope * g + barrier.value * m);
    of.hessian =
        scale *
        (mollifier.value * (barrier.bend * g * g.transpose() + barrier.slope * squared.hessian / unit) +
         barrier.slope * (m * g.transpose() + g * m.transpose()) + barrier.value * mollifier.hessian);
    return of;
}

PairPlaces near_pairs(const MethodStep& step, const Places& places, double distance)
{
    PairPlaces near;
    for (std::size_t n = 0; n < step.points.size(); ++n)
        if (const ContactPoint& pair = step.points[n];
            pair.on_plane() || boxes_are_near(corners_of(pair, places), pair.corners_of_a(), distance))
            near.push_back(n);
    return near;
}

//! [terms]
std::vector<BarrierTerm> barrier_terms(const MethodStep& step, const PairPlaces& among, const Places& places,
                                       double distance)
{
    std::vector<BarrierTerm> terms;
    std::map<FeatureKey, std::size_t> known;
    for (const std::size_t n : among) {
        const ContactPoint& pair = step.points[n];
        const ContactKind kind = pair.kind();
        BarrierTerm term{n, corners_of(pair, places), {}, {1, Vector12::Zero(), Matrix12::Zero()}, 1, {}};
        if (!pair.on_plane() && !boxes_are_near(term.x, pair.corners_of_a(), distance))
            continue;
        if (pair.on_plane())
            term.nearest = {{1, 0, 0, 0}, height(pair, term.x[0], distance) * pair.normal};
        else
            term.nearest = kind == ContactKind::edge_edge ? nearest_of_edges(term.x)
                                                          : nearest_of_point_triangle(term.x);
        const double ratio = term.nearest.difference.squaredNorm() / (distance * distance);
        if (ratio >= 1)
            continue;
        term.barrier = log_barrier(ratio);
        if (kind == ContactKind::edge_edge)
            term.mollifier = edge_mollifier(term.x, parallel * (term.x[1] - term.x[0]).squaredNorm() *
                                                        (term.x[3] - term.x[2]).squaredNorm());
        const bool is_own = pair.on_plane() || term.mollifier.value < 1;
        const auto [found, is_new] = known.try_emplace(
            key_of(pair, term.nearest, is_own ? static_cast<int>(n) : -1), terms.size());
        if (is_new)
            terms.push_back(term);
        else
            terms[found->second].count += 1;
    }
    return terms;
}
//! [terms]

//! [first_meeting]
std::pair<double, bool> first_meeting(const MethodStep& step, const PairPlaces& among, const Places& from,
                                      const Places& to, double distance)
{
    std::pair<double, bool> first{1, false};
    for (const std::size_t n : among) {
        const ContactPoint& pair = step.points[n];
        const FourPoints p = corners_of(pair, from), q = corners_of(pair, to);
        std::optional<double> time;
        if (pair.on_plane()) {
            const double before = height(pair, p[0], distance), behind = height(pair, q[0], distance);
            if (behind <= 0)
                time = before / (before - behind);
        } else if (boxes_overlap(p, q, pair.corners_of_a()))
            time = pair.kind() == ContactKind::edge_edge
                       ? time_of_impact(EdgeEdgeStep{p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3]})
                       : time_of_impact(VertexFaceStep{p[0], p[1], p[2], p[3], q[0], q[1], q[2], q[3]});
        if (time)
            first = {std::min(first.first, *time), true};
    }
    return first;
}
//! [first_meeting]

}  // namespace enduring
