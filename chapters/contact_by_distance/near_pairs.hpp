#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/contact_by_distance/own_directions.hpp"

#include <functional>
#include <map>
#include <tuple>

namespace enduring {

/// What nearest features are looked for with.
struct Nearness {
    std::function<double(int body_a, int body_b)> distance;   ///< up to which features get a pair [m]
    std::function<bool(int body_a, int body_b)> is_left_out;  ///< two bodies that another rule serves
    std::function<bool(int body, int vertex)> has_own_directions;
};

/// Of each vertex against a body: the nearest of its pairs, and the direction from there to the vertex. It is where the vertex stands
/// when a step begins.
class Grounds {
public:
    void look_at(const Contact& contact, double distance);
    /// Unit length; none for a vertex that has no pair with this body.
    std::optional<Vec3> normal(const Contact& contact) const;

private:
    std::map<std::tuple<int, int, int>, std::pair<double, Vec3>> nearest_;  ///< body_a, vertex, body_b
};

//! [near_pairs]
/// The pairs at the start of a step: where the distance of two surfaces is smallest in their neighbourhood, and no larger than asked.
///
/// A vertex has a pair with each feature of the other surface, a face, an edge or a vertex, that is nearer to it than the
/// features around. Two edges have one if their nearest points lie inside both. The normal leads from point to point, and lies within
/// the cones of both features.
/// @param search  after find_candidates with boxes that are larger by half of the distance, or more
void append_near_pairs(const World& world, const CandidateSearch& search, const Nearness& nearness,
                       Contacts& contacts, Grounds& grounds);
//! [near_pairs]

/// The pair of a vertex with a feature of a face.
/// @param feature  the face, or behind all faces the edges and behind them the vertices of B
Contact vertex_pair(int body_a, int vertex, int body_b, const SurfaceStep& b, int face, int feature,
                    const std::array<double, 3>& weights, const Vec3& normal);
/// The pair of two edges, s and t along them.
Contact edge_pair(int body_a, const SurfaceStep& a, int edge_a, int body_b, const SurfaceStep& b, int edge_b,
                  double s, double t, const Vec3& normal);

SurfaceStep surface_of(const World& world, int body);
/// Nearer than this, the difference of two points has no direction [m].
double touching_distance(const World& world, int body_a, int body_b);

}  // namespace enduring
