#pragma once

#include "chapters/04_friction/tangent_plane.hpp"
#include "common/simulation/step.hpp"

#include <vector>

namespace enduring {

/// The normal impulse that friction works with is longer than this [N
/// s]; a shorter one has no direction to trust.
constexpr double least_impulse = 1e-30;

/// Does the pair wait for its impulses, and push?
inline bool pushes_now(const Contact& contact)
{
    return contact.waiting() && contact.impulse.norm() > least_impulse;
}

/// How easily each pair's slip changes, when all pairs that push now change theirs at once.
///
/// Impulses of one response act together. So each pair reckons with a share of its bodies
/// only, as if they were split among all pairs that push them (mass splitting, Tonge et al.
/// 2012): what every share can bear alone, the whole can bear.
class MassShares {
public:
    MassShares(const World& world, const Contacts& contacts);

    /// The most that a unit impulse on the pair's shares changes the velocity of p against q, over the
    /// directions of the plane [1/kg]; zero where nothing can move.
    ///
    /// A bound: the largest eigenvalue of sum_i |w_i| n_i K_i, with K_i the inverse mass at vertex i and n_i
    /// the pairs that share it, or MassParts::response_bound() in the place of n_i K_i if that is less. At a
    /// point between vertices the true one is smaller, for an inverse mass is a convex function of the place.
    double inverse_mass(const World& world, const Contact& contact, const TangentPlane& plane);

private:
    struct OfBody {
        std::vector<int> pairs_of_part;
        std::vector<Push> pushes;      ///< each pushed vertex once, with the weights of all its pairs
        std::vector<double> together;  ///< by surface vertex, negative until asked for
    };
    int pairs_sharing(const World& world, const Contact& contact, int i) const;
    double response_bound(const Body& body, OfBody& of_body, int vertex) const;

    std::vector<OfBody> bodies_;
};

}  // namespace enduring
