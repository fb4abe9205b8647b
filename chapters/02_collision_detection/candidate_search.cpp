#include "chapters/02_collision_detection/candidate_search.hpp"

#include <algorithm>

namespace enduring {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

void CandidateSearch::build(const World& world)
{
    bodies_.clear();
    trees_.clear();
    body_pairs_.clear();
    for (const auto& body : world.bodies) {
        bodies_.push_back(body.get());
        trees_.emplace_back(body->surface(), body->positions_t0());
    }
    for (int a = 0; a < static_cast<int>(bodies_.size()); ++a)
        for (int b = a + 1; b < static_cast<int>(bodies_.size()); ++b)
            if (!bodies_[at(a)]->is_static() || !bodies_[at(b)]->is_static())
                body_pairs_.push_back({a, b, {}});
}

void CandidateSearch::find_candidates(const World& world)
{
    const auto same = [](const Body* mine, const std::unique_ptr<Body>& theirs) { return mine == theirs.get(); };
    if (!std::equal(bodies_.begin(), bodies_.end(), world.bodies.begin(), world.bodies.end(), same))
        build(world);
    for (std::size_t i = 0; i < trees_.size(); ++i)
        trees_[i].refit(surface_step(*world.bodies[i]));
    for (BodyPair& pair : body_pairs_)
        collect_pairs(trees_[at(pair.a)], trees_[at(pair.b)], pair.pairs);
}

std::size_t CandidateSearch::candidate_count() const
{
    std::size_t count = 0;
    for (const BodyPair& pair : body_pairs_)
        count += pair.pairs.size();
    return count;
}

}  // namespace enduring
