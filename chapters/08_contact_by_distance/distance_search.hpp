#pragma once

#include "chapters/08_contact_by_distance/crossings.hpp"
#include "chapters/08_contact_by_distance/skin.hpp"
#include "chapters/08_contact_by_distance/standing_bodies.hpp"

namespace enduring {

//! [distance_search]
/// One question: do these two surfaces cross on the way?
///
/// A step begins with the pairs of what is nearer than the skins. After each answer the query looks at the
/// whole way: what crosses first becomes a pair, and the step is solved again; a known pair that lets
/// something through has the step halved; in a part that is not halved any more, what would cross stands
/// still.
///
/// The trees are shaped once, so a search belongs to one world. Nothing else that it keeps lasts beyond a
/// step.
class DistanceSearch : public CandidateSearch {
public:
    /// In the first step: bodies get their skins.
    /// @throws InputError  two bodies begin inside each other, and takes_what_begins_inside() does not hold
    ///     for them
    void begin(World& world, double dt);
    /// The pairs at the start of a step, ascending by their keys.
    virtual Contacts find(World& world, double dt);
    /// After an answer: appends pairs for what it lets cross, or tells trouble, or stops what would cross.
    void check(World& world, Contacts& contacts, double dt);
    /// When the step is the state: what stood still is where it was, and moves on as StandingBodies says.
    void bring_back(World& world) { standing_.move_on(world); }
    //! [distance_search]

    const Skins& skins() const { return skins_; }

protected:
    /// What gets no pair, and may cross in this step.
    void leave_out(LeftOut left_out) { nearness_.left_out = std::move(left_out); }
    bool vertex_may_meet(const Body& body, int vertex) const override;
    bool edge_may_meet(const Body& body, int edge) const override;
    /// Whether something else lets out two bodies that begin inside each other.
    virtual bool takes_what_begins_inside(const Body& /*a*/, const Body& /*b*/) const { return false; }
    /// Whether something else keeps apart what a known pair lets through, from now on. Then both are left out
    /// for the rest of the step.
    virtual bool takes_over(const World& /*world*/, const Contact& /*let_through*/, double /*dt*/) const
    {
        return false;
    }

private:
    void hand_over(const World& world, Contacts& let_through, double dt);
    bool append(const World& world, Contacts& contacts, Contacts brought) const;
    /// Category and path of pairs that geometry has found.
    void complete(const World& world, Contacts& contacts) const;
    Vec3 motion_without_answer(const World& world, const Contact& contact) const;
    void stand_still(World& world, const Contacts& contacts, Crossings crossings);
    void fit_boxes(const World& world);
    void fit_boxes_of_moved(const World& world);

    Skins skins_;
    Nearness nearness_;
    std::vector<double> margins_;  ///< of the boxes of each body: its skin [m]
    using Ends = std::vector<std::vector<Vec3>>;
    Ends boxed_t1_;      ///< where the boxes expect the vertices at the end
    Ends predicted_t1_;  ///< where they end without an answer
    Grounds grounds_;
    double dt_ = 0;
    StandingBodies standing_;  ///< in this step
};

/// The pairs of vertices that touch a plane or lie behind it when the step begins, or would so at its end
/// without an answer: a plane goes on for ever, so what comes behind it does pass it.
void append_plane_pairs(const World& world, Contacts& contacts);

}  // namespace enduring
