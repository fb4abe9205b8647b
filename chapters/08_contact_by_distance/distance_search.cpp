#include "chapters/08_contact_by_distance/distance_search.hpp"

#include "chapters/08_contact_by_distance/begins_inside.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/same_place.hpp"
#include "chapters/08_contact_by_distance/sliding_normal.hpp"
#include "chapters/08_contact_by_distance/touching_end.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

std::vector<std::vector<Vec3>> ends_of(const World& world)
{
    std::vector<std::vector<Vec3>> ends;
    for (const auto& body : world.bodies)
        ends.emplace_back(body->contact_t1().begin(), body->contact_t1().end());
    return ends;
}

}  // namespace

void DistanceSearch::begin(World& world, double dt)
{
    if (!margins_.empty())
        return;
    skins_.put(world);
    for (const auto& body : world.bodies)  // their contact surfaces are new
        if (keeps_shape(*body))
            body->update_prediction(dt);
    for (const auto& [i, j] : bodies_inside_each_other(world)) {
        const Body &a = *world.bodies[static_cast<std::size_t>(i)],
                   &b = *world.bodies[static_cast<std::size_t>(j)];
        if (!takes_what_begins_inside(a, b))
            throw InputError("bodies '" + a.name() + "' and '" + b.name() +
                             "' begin inside each other, and the solver keeps apart only what begins apart");
    }
    for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body)
        margins_.push_back(std::max(skins_.of(body).thickness, skins_.of(body).recess));
    find_candidates(world, margins_);
    skins_.fit_gaps(world, *this);
    nearness_ = {
        [this, &world](int a, int b) { return skins_.distance(a, b) + touching_distance(world, a, b); },
        [this](int a, int b) { return skins_.gap(a, b); },
        [this](int body) { return skins_.of(body).thickness + skins_.of(body).recess; },
        {}};
}

//! [find]
Contacts DistanceSearch::find(World& world, double dt)
{
    dt_ = dt;
    standing_.clear();
    grounds_ = {};
    fit_boxes(world);
    predicted_t1_ = boxed_t1_;

    Contacts found;
    append_plane_pairs(world, found);
    append_near_pairs(world, *this, nearness_, found, grounds_);
    sort_by_keys(found);
    keep_one_at_each_place(world, found);
    complete(world, found);
    return found;
}
//! [find]

//! [check]
void DistanceSearch::check(World& world, Contacts& contacts, double dt)
{
    fit_boxes_of_moved(world);
    Crossings crossings = find_crossings(world, *this, nearness_, contacts);
    hand_over(world, crossings.let_through, dt);
    const bool is_last = world.attempt.responses_left == 0;
    if (crossings.let_through.empty() && (!is_last || world.attempt.may_be_halved)) {
        if (append(world, contacts, crossings.brought))
            return;
        // what is left lies at the places of known pairs: so these let it through, and it may cross on its
        // way as they may
        std::erase_if(crossings.brought, [&](const Contact& contact) { return ends_well(world, contact); });
        hand_over(world, crossings.brought, dt);
    }
    const bool crosses = !crossings.none();
    if (crosses && !world.attempt.may_be_halved)
        return stand_still(world, contacts, std::move(crossings));
    if (crosses) {
        world.attempt.trouble = StepTrouble::too_deep;
        return;
    }
    const auto new_ones = world.attempt.work.responses == 0 ? EndsOf::new_bodies : EndsOf::new_features;
    if (!is_last && append(world, contacts, pairs_at_the_end(world, *this, nearness_, contacts, new_ones)))
        return;
    if (!world.attempt.held_up.empty())
        stand_still(world, contacts, {});
}
//! [check]

/// Takes out what something else keeps apart from now on.
void DistanceSearch::hand_over(const World& world, Contacts& let_through, double dt)
{
    std::erase_if(let_through, [&](const Contact& contact) {
        const bool taken = !contact.on_plane() && takes_over(world, contact, dt);
        if (taken)
            nearness_.left_out.bodies.insert(std::minmax(contact.body_a, contact.body_b));
        return taken;
    });
}

/// @return  whether any is left, of those that lie at the place of no other
bool DistanceSearch::append(const World& world, Contacts& contacts, Contacts brought) const
{
    for (Contact& contact : brought)
        contact.start = 1;  // its spring is at rest until it pushes
    complete(world, brought);
    sort_by_keys(brought);
    const std::size_t known = contacts.size();
    contacts.insert(contacts.end(), brought.begin(), brought.end());
    keep_one_at_each_place(world, contacts, known);
    return contacts.size() > known;
}

void DistanceSearch::fit_boxes(const World& world)
{
    find_candidates(world, margins_);
    boxed_t1_ = ends_of(world);
}

/// Of bodies that end farther from where the boxes expect them than these reach around their path.
void DistanceSearch::fit_boxes_of_moved(const World& world)
{
    std::vector<bool> moved(world.bodies.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const std::span<const Vec3> ends = world.bodies[i]->contact_t1();
        for (std::size_t v = 0; v < ends.size() && !moved[i]; ++v)
            moved[i] = (ends[v] - boxed_t1_[i][v]).norm() > margins_[i];
        if (moved[i])
            boxed_t1_[i].assign(ends.begin(), ends.end());
    }
    if (std::find(moved.begin(), moved.end(), true) != moved.end())
        refit_candidates(world, margins_, moved);
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
        motion += contact.weights[n] * (predicted_t1_[body][vertex] - moved.contact_t0()[vertex] - fall);
    }
    return motion;
}

//! [complete]
void DistanceSearch::complete(const World& world, Contacts& contacts) const
{
    for (Contact& contact : contacts) {
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

/// In a part of a step that is not halved any more.
void DistanceSearch::stand_still(World& world, const Contacts& contacts, Crossings crossings)
{
    for (const std::vector<int>& bodies : world.attempt.held_up)
        for (const int body : bodies)
            standing_.add(world, bodies.front(), body);
    if (!world.attempt.held_up.empty()) {
        fit_boxes(world);
        crossings = find_crossings(world, *this, nearness_, contacts);
    }
    while (!crossings.none()) {
        bool any = false;
        for (const Contacts* list : {&crossings.brought, &crossings.let_through})
            for (const Contact& contact : *list)
                any = standing_.add(world, contact.body_a, contact.on_plane() ? -1 : contact.body_b) || any;
        if (!any)
            return;
        fit_boxes(world);
        crossings = find_crossings(world, *this, nearness_, contacts);
    }
}

//! [may_meet]
bool DistanceSearch::vertex_may_meet(const Body& body, int vertex) const
{
    return has_own_directions(body, vertex);
}

bool DistanceSearch::edge_may_meet(const Body& body, int edge) const
{
    return !keeps_shape(body) || is_ridge(body, edge);
}
//! [may_meet]

void append_plane_pairs(const World& world, Contacts& contacts)
{
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const Body& body = *world.bodies[i];
        for (std::size_t p = 0; p < world.planes.size() && !body.is_static(); ++p) {
            const Plane& plane = world.planes[p];
            const double touching = distance_parts.touching * body.size();
            for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex)
                if (plane.normal.dot(body.position(vertex, 0) - plane.point) <= touching ||
                    plane.normal.dot(body.position(vertex, 1) - plane.point) <= touching)
                    contacts.push_back(plane_pair(static_cast<int>(i), static_cast<int>(p), vertex));
        }
    }
}

}  // namespace enduring
