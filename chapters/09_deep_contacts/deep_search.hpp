#pragma once

#include "chapters/08_contact_by_distance/distance_search.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"

namespace enduring {

//! [deep_search]
/// Chapter 8's search for what is apart. Where bodies overlap when a step begins they get pairs from where
/// their surfaces cross, until they are apart by their skins: what is inside may come out across any face. So
/// it needs no history. Elsewhere they stay apart.
class DeepSearch : public DistanceSearch {
public:
    Contacts find(World& world, double dt) override;
    //! [deep_search]

protected:
    bool takes_what_begins_inside(const Body& a, const Body& b) const override
    {
        return a.surface().is_closed() && b.surface().is_closed();
    }
    bool takes_over(const World& world, const Contact& let_through, double dt) const override;

private:
    InsidePairs inside_;
};

}  // namespace enduring
