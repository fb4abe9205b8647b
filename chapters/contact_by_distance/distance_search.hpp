#pragma once

#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "chapters/contact_by_distance/crossings.hpp"
#include "chapters/contact_by_distance/skin.hpp"

#include <set>

namespace enduring {

//! [distance_search]
/// One question: do these two surfaces cross on the way?
///
/// A step begins with the pairs of what is nearer than the skins. After each answer the query looks at the whole way: what crosses first
/// becomes a pair, and the step is solved again; a known pair that lets something through has the step halved; in a part that is not
/// halved any more, what would cross stands still. Two bodies that begin inside each other are left to chapter 9 until they are apart.
class DistanceSearch : public CandidateSearch {
public:
    /// @param own_surfaces  whether a soft body meets itself, as in chapter 10
    explicit DistanceSearch(bool own_surfaces) : own_surfaces_(own_surfaces) {}

    /// The pairs at the start of a step, ascending by their keys.
    Contacts find(World& world, double dt);
    /// After an answer: appends pairs for what it lets cross, or tells trouble, or stops what would cross.
    void check(World& world, Contacts& contacts, double dt);
    void count_answer() { ++answers_; }
    /// When the step is the state: what stood still is where it was, at rest.
    void bring_back(World& world);
    //! [distance_search]

protected:
    void find_more(const World& world) override;
    bool edge_may_meet(const Body& body, int edge) const override;

private:
    void remember_shapes(const World& world);
    void look_for_overlaps(const World& world);
    void append_plane_pairs_of(const World& world, Contacts& contacts) const;
    void append_overlaps(const World& world, Contacts& contacts);
    /// Gap and path of pairs that geometry has found.
    void complete(const World& world, Contacts& contacts) const;
    Vec3 motion_without_answer(const World& world, const Contact& contact) const;
    void leave_what_is_squeezed(const World& world, double dt, Contacts& let_through);
    void stand_still(World& world, const Contacts& contacts, Crossings crossings);
    void fit_boxes(const World& world);
    bool has_moved(const World& world) const;

    bool own_surfaces_;
    Skins skins_;
    std::vector<OwnDirections> directions_;
    Nearness nearness_;
    std::vector<double> margins_;  ///< of the boxes of each body: its skin [m]
    using Ends = std::vector<std::vector<Vec3>>;
    Ends boxed_t1_;      ///< where the boxes expect the vertices at the end
    Ends predicted_t1_;  ///< where they end without an answer
    Grounds grounds_;
    int answers_ = 0;
    double dt_ = 0;
    InsidePairs inside_;
    std::set<std::pair<int, int>> overlapping_;  ///< bodies that chapter 9 serves
    bool begun_ = false;
    std::map<int, std::vector<double>> standing_;  ///< states of bodies that stand still in this step
};

}  // namespace enduring
