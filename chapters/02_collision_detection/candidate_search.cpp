#include "chapters/02_collision_detection/candidate_search.hpp"

#include "chapters/02_collision_detection/body_broad_phase.hpp"
#include "chapters/02_collision_detection/slabs.hpp"

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

void sort_by_keys(Contacts& contacts)
{
    std::sort(contacts.begin(), contacts.end(),
              [](const Contact& one, const Contact& other) { return key_of(one) < key_of(other); });
}

bool bodies_may_meet(const World& world, int body_a, int body_b)
{
    return !(world.bodies[at(body_a)]->is_static() && world.bodies[at(body_b)]->is_static()) &&
           !are_joined(world.joints, body_a, body_b);
}

void CandidateSearch::build(const World& world)
{
    bodies_.clear();
    trees_.clear();
    for (const auto& body : world.bodies) {
        bodies_.push_back(body.get());
        trees_.emplace_back(
            body->surface(), body->contact_t0(), [&](int vertex) { return vertex_may_meet(*body, vertex); },
            [&](int edge) { return edge_may_meet(*body, edge); });
    }
}

void CandidateSearch::find_candidates(const World& world, std::span<const double> margins)
{
    const auto same = [](const Body* mine, const std::unique_ptr<Body>& theirs) {
        return mine == theirs.get();
    };
    if (!std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(), same))
        build(world);
    refit_candidates(world, margins, std::vector<bool>(trees_.size(), true));
}

//! [refit]
void CandidateSearch::refit_candidates(const World& world, std::span<const double> margins,
                                       const std::vector<bool>& moved)
{
    std::vector<SweptBox> boxes;
    const auto margin = [&](std::size_t i) { return margins.empty() ? 0 : margins[i]; };
    for (std::size_t i = 0; i < trees_.size(); ++i) {
        if (moved[i])
            trees_[i].refit(surface_step(*world.bodies[i]), margin(i));
        boxes.push_back(trees_[i].box());
    }
    BodySlabs slabs(
        boxes, [&](std::size_t i) { return slabs_along_faces(surface_step(*world.bodies[i]), margin(i)); });
    last_pairs_.swap(body_pairs_);
    auto last = last_pairs_.begin();
    std::size_t count = 0;
    for (const auto& [a, b] : overlapping_bodies(boxes)) {
        if (!bodies_may_meet(world, a, b) || slabs.keep_apart(at(a), at(b)))
            continue;
        if (count == body_pairs_.size())
            body_pairs_.emplace_back();
        BodyPair& pair = body_pairs_[count++];  // one of an earlier step: its lists keep their memory
        pair.a = a;
        pair.b = b;
        if (!moved[at(a)] && !moved[at(b)] && find_onwards(last, last_pairs_.end(), {a, b}))
            std::swap(pair.pairs, last->pairs);
        else
            collect_pairs(trees_[at(a)], trees_[at(b)], pair.pairs);
    }
    body_pairs_.resize(count);
    find_more(world);
}
//! [refit]

std::size_t CandidateSearch::candidate_count() const
{
    std::size_t count = 0;
    for (const BodyPair& pair : body_pairs_)
        count += pair.pairs.size();
    return count;
}

}  // namespace enduring
