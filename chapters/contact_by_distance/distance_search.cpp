#include "chapters/contact_by_distance/distance_search.hpp"

#include "chapters/08_speculative_contacts/contact_search.hpp"
#include "chapters/08_speculative_contacts/sliding_normal.hpp"
#include "chapters/10_self_contact/self_search.hpp"
#include "chapters/contact_by_distance/distance_parts.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

const Body& body_of(const World& world, int body) { return *world.bodies[static_cast<std::size_t>(body)]; }

std::vector<std::vector<Vec3>> ends_of(const World& world)
{
    std::vector<std::vector<Vec3>> ends;
    for (const auto& body : world.bodies)
        ends.emplace_back(body->positions_t1().begin(), body->positions_t1().end());
    return ends;
}

void sort(Contacts& contacts)
{
    std::sort(contacts.begin(), contacts.end(),
              [](const Contact& one, const Contact& other) { return key_of(one) < key_of(other); });
}

bool moves_as_given(const Body& body)
{
    return body.is_static() &&
           !std::equal(body.positions_t0().begin(), body.positions_t0().end(), body.positions_t1().begin());
}

}  // namespace

//! [find]
Contacts DistanceSearch::find(World& world, double dt)
{
    dt_ = dt;
    answers_ = 0;
    standing_.clear();
    grounds_ = {};
    skins_.put(world);
    for (const auto& body : world.bodies)
        body->update_prediction(dt);
    remember_shapes(world);
    predicted_t1_ = ends_of(world);
    fit_boxes(world);
    look_for_overlaps(world);

    Contacts found;
    append_plane_pairs_of(world, found);
    append_near_pairs(world, *this, nearness_, found, grounds_);
    complete(world, found);
    append_overlaps(world, found);
    sort(found);
    return found;
}
//! [find]

//! [check]
void DistanceSearch::check(World& world, Contacts& contacts, double dt)
{
    if (has_moved(world))
        fit_boxes(world);
    Crossings crossings = find_crossings(world, *this, nearness_, contacts);
    leave_what_is_squeezed(world, dt, crossings.let_through);
    const bool goes_on = crossings.let_through.empty() && answers_ < distance_parts.most_answers;
    if (!goes_on && !crossings.none() && !world.attempt.may_be_halved)
        return stand_still(world, contacts, std::move(crossings));
    if (!crossings.let_through.empty()) {
        world.attempt.trouble = StepTrouble::too_deep;
        return;
    }
    complete(world, crossings.brought);
    sort(crossings.brought);
    contacts.insert(contacts.end(), crossings.brought.begin(), crossings.brought.end());
}
//! [check]

void DistanceSearch::remember_shapes(const World& world)
{
    if (!directions_.empty())
        return;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        directions_.emplace_back(*world.bodies[i]);
        margins_.push_back(skins_.of(static_cast<int>(i)).thickness);
    }
    nearness_ = {
        [this](int a, int b) { return skins_.between(a, b); },
        [this](int a, int b) { return overlapping_.count(std::minmax(a, b)) > 0; },
        [this](int body, int vertex) -> bool {
            return directions_[static_cast<std::size_t>(body)].of_vertex[static_cast<std::size_t>(vertex)];
        }};
}

void DistanceSearch::fit_boxes(const World& world)
{
    find_candidates(world, margins_);
    boxed_t1_ = ends_of(world);
}

/// Further than the boxes reach around its path.
bool DistanceSearch::has_moved(const World& world) const
{
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        for (std::size_t v = 0; v < boxed_t1_[i].size(); ++v)
            if ((world.bodies[i]->positions_t1()[v] - boxed_t1_[i][v]).norm() > margins_[i])
                return true;
    return false;
}

/// Bodies that overlap when the run begins, or since something squeezed them, until they are apart.
void DistanceSearch::look_for_overlaps(const World& world)
{
    if (begun_ && overlapping_.empty())
        return;
    inside_.trace(world);
    std::set<std::pair<int, int>> still;
    for (const auto& bodies : inside_.overlapping_bodies())
        if (!begun_ || overlapping_.count(bodies) > 0)
            still.insert(bodies);
    overlapping_ = std::move(still);
    begun_ = true;
}

void DistanceSearch::append_overlaps(const World& world, Contacts& contacts)
{
    if (overlapping_.empty())
        return;
    Contacts deep;
    inside_.append_pairs(world, 0, deep);
    for (Contact& contact : deep) {
        if (overlapping_.count(std::minmax(contact.body_a, contact.body_b)) == 0)
            continue;
        contact.outward = inside_.part_along_direction(world, contact);
        contact.gap = skins_.gap(contact);  // so they push until the skins are apart
        contact.category = ContactCategory::regular;
        contacts.push_back(contact);
    }
}

void DistanceSearch::append_plane_pairs_of(const World& world, Contacts& contacts) const
{
    double inset = 0;
    for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body)
        inset = std::max(inset, skins_.of(body).inset);
    append_plane_pairs(world, inset, contacts);
}

/// Of the pair's points against each other, as the step would end without an answer and without gravity [m].
Vec3 DistanceSearch::motion_without_answer(const World& world, const Contact& contact) const
{
    Vec3 motion = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
        const std::size_t body = body_index(contact, i);
        const auto n = static_cast<std::size_t>(i), vertex = static_cast<std::size_t>(contact.vertices[n]);
        const Body& moved = *world.bodies[body];
        const Vec3 fall = dt_ * dt_ * moved.acceleration(contact.vertices[n], world.gravity);
        motion += contact.weights[n] * (predicted_t1_[body][vertex] - moved.positions_t0()[vertex] - fall);
    }
    return motion;
}

//! [complete]
void DistanceSearch::complete(const World& world, Contacts& contacts) const
{
    for (Contact& contact : contacts) {
        contact.gap = skins_.gap(contact);
        contact.category = ContactCategory::regular;
        if (contact.kind != ContactKind::vertex_face)
            continue;
        // a vertex that comes along a surface which bends is pushed along the normal of its path
        const auto ground = grounds_.normal(contact);
        if (ground && (*ground - contact.normal_t0).norm() > distance_parts.touching)
            contact.sliding_normal = sliding_normal(*ground, contact_geometry(world, contact, 1).normal,
                                                    motion_without_answer(world, contact));
    }
}
//! [complete]

/// No step is short enough to keep apart what given motion presses through each other: from here on that is chapter 9's.
void DistanceSearch::leave_what_is_squeezed(const World& world, double dt, Contacts& let_through)
{
    const bool is_short = dt <= 1.001 * std::ldexp(world.whole_dt, -distance_parts.squeezed_after);
    if (!is_short && world.attempt.may_be_halved)
        return;
    std::erase_if(let_through, [&](const Contact& contact) {
        const Body &a = body_of(world, contact.body_a), &b = body_of(world, contact.body_b);
        if (contact.body_a == contact.body_b || !(moves_as_given(a) || moves_as_given(b)) ||
            !a.surface().is_closed() || !b.surface().is_closed())
            return false;
        overlapping_.insert(std::minmax(contact.body_a, contact.body_b));
        return true;
    });
}

/// In a part of a step that is not halved any more.
void DistanceSearch::stand_still(World& world, const Contacts& contacts, Crossings crossings)
{
    while (!crossings.none()) {
        bool any = false;
        for (const Contacts* list : {&crossings.brought, &crossings.let_through})
            for (const Contact& contact : *list)
                for (const int index : {contact.body_a, contact.body_b}) {
                    Body& body = *world.bodies[static_cast<std::size_t>(index)];
                    if (body.is_static() || standing_.count(index) > 0)
                        continue;
                    standing_[index] = state_of(body);
                    body.stand_still();
                    any = true;
                }
        if (!any)
            return;
        fit_boxes(world);
        crossings = find_crossings(world, *this, nearness_, contacts);
    }
}

void DistanceSearch::bring_back(World& world)
{
    for (const auto& [index, state] : standing_) {
        Body& body = *world.bodies[static_cast<std::size_t>(index)];
        restore_state(body, state);
        body.stop();
    }
    standing_.clear();
}

void DistanceSearch::find_more(const World& world)
{
    for (int body = 0; own_surfaces_ && body < static_cast<int>(world.bodies.size()); ++body)
        if (const RestNeighbours* neighbours = rest_neighbours(body_of(world, body)))
            collect_own_pairs(tree(body), *neighbours, append_body_pair(body, body));
}

bool DistanceSearch::edge_may_meet(const Body& body, int edge) const
{
    return !keeps_shape(body) || is_ridge(body, edge);
}

}  // namespace enduring
