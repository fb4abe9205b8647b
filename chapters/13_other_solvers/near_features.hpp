#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/13_other_solvers/settings.hpp"

namespace enduring {

//! [near_features]
/// The search that all methods of this chapter share: the pairs of features at the start of a step, with
/// signs.
///
/// A vertex outside has a pair with the nearest point of a surface around it, be it on a face, an edge or a
/// vertex. A vertex inside has one with the face that it is least below. Two edges have one where their
/// nearest points lie inside both; not below each other, where the bodies come apart sooner. The normal is
/// Contact::normal_t0, out of B; it has to lie within the cones of both features, for what is further out is
/// another pair. Planes have pairs with vertices.
class NearFeatures {
public:
    explicit NearFeatures(SearchSettings settings = {}) : settings_(settings) {}

    /// Ascending by their keys.
    /// @param world  bodies with their predicted ends: the way of the step is looked ahead
    Contacts find(const World& world);
    //! [near_features]

private:
    /// How a body moves in the step: the way of its vertices' mean, and how far one of them moves beside that
    /// [m].
    struct Way {
        Vec3 mean;
        double most;
    };
    static Way way_of(const Body& body);
    double reach(const World& world, int body_a, int body_b) const;
    void append_vertices(const World& world, Contacts& contacts) const;
    void append_edges(const World& world, Contacts& contacts) const;
    void append_planes(const World& world, Contacts& contacts) const;

    SearchSettings settings_;
    CandidateSearch search_;
    std::vector<Way> ways_;  ///< of each body in this step
};

/// n . (p - q) of a pair at the start of the step [m], negative inside.
double separation_t0(const World& world, const Contact& contact);

}  // namespace enduring
