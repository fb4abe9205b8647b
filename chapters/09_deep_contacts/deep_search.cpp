#include "chapters/09_deep_contacts/deep_search.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

/// Halvings after which two bodies that given motion presses through each other are left to overlap: no step
/// is short enough to keep them apart. One: grips slip; ten: jams take ten times as long.
constexpr int squeezed_after = 1;

bool moves_as_given(const Body& body)
{
    return body.is_static() &&
           !std::equal(body.contact_t0().begin(), body.contact_t0().end(), body.contact_t1().begin());
}

}  // namespace

//! [find]
Contacts DeepSearch::find(World& world, double dt)
{
    inside_.trace(world);
    leave_out(inside_.left_out([this](int a, int b) { return skins().distance(a, b); }));
    Contacts found = DistanceSearch::find(world, dt), deep;
    inside_.append_pairs(world, deep);
    for (Contact& contact : deep) {
        contact.outward = inside_.part_along_direction(world, contact);
        found.push_back(contact);
    }
    sort_by_keys(found);
    return found;
}
//! [find]

//! [takes_over]
bool DeepSearch::takes_over(const World& world, const Contact& let_through, double dt) const
{
    if (world.attempt.may_be_halved && dt > 1.001 * std::ldexp(world.whole_dt, -squeezed_after))
        return false;
    const Body &a = *world.bodies[static_cast<std::size_t>(let_through.body_a)],
               &b = *world.bodies[static_cast<std::size_t>(let_through.body_b)];
    return &a != &b && (moves_as_given(a) || moves_as_given(b)) && takes_what_begins_inside(a, b);
}
//! [takes_over]

}  // namespace enduring
