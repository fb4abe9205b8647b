#include "exercises/08_contact_by_distance/3_first_crossing.hpp"

#include <algorithm>
#include <map>

namespace enduring {

Decision decide(std::vector<Passage> found, const std::vector<SidePair>& known)
{
    std::map<int, std::vector<Passage>> of_bodies;
    for (const Passage& passage : found)
        of_bodies[passage.body].push_back(passage);
    Decision decision;
    for (auto& [body, ascending] : of_bodies) {
        std::sort(ascending.begin(), ascending.end(),
                  [](const Passage& one, const Passage& other) { return one.time < other.time; });
        bool any = false;
        for (const Passage& passage : ascending)
            if (passage.time <= ascending.front().time + together && !is_known(passage, known)) {
                decision.new_pairs.push_back(passage);
                any = true;
            }
        decision.halve = decision.halve || !any;
    }
    return decision;
}

SidePair pair_with(const std::vector<Outline>& bodies, const Passage& passage, const Vec2& start)
{
    const Outline& outline = bodies[static_cast<std::size_t>(passage.body)];
    const auto side = static_cast<std::size_t>(passage.side);
    const Vec2 along = outline[(side + 1) % outline.size()] - outline[side];
    Vec2 normal = Vec2(along.y(), -along.x()).normalized();
    if (normal.dot(start - outline[side]) < 0)
        normal = -normal;
    return {passage.body, passage.side, outline[side], normal};
}

std::optional<Vec2> end_by_first(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                                 const Solve& solve)
{
    std::vector<SidePair> pairs;
    Vec2 end = free_end;
    for (;;) {
        const Decision decision = decide(passages(bodies, start, end), pairs);
        if (decision.halve)
            return std::nullopt;
        if (decision.new_pairs.empty())
            return end;
        for (const Passage& passage : decision.new_pairs)
            pairs.push_back(pair_with(bodies, passage, start));
        end = solve(free_end, pairs);
    }
}

Vec2 end_by_all(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                const Solve& solve)
{
    std::vector<SidePair> pairs;
    for (const Passage& passage : passages(bodies, start, free_end))
        pairs.push_back(pair_with(bodies, passage, start));
    return solve(free_end, pairs);
}

}  // namespace enduring
