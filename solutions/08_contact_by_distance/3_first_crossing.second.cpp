#include "exercises/08_contact_by_distance/3_first_crossing.hpp"

#include <set>
#include <tuple>

namespace enduring {

Decision decide(std::vector<Passage> found, const std::vector<SidePair>& known)
{
    const auto first_of = [&](int body) {
        double first = 2;
        for (const Passage& passage : found)
            if (passage.body == body && passage.time < first)
                first = passage.time;
        return first;
    };
    std::set<std::tuple<int, double, int>> chosen;
    std::set<int> let_through, brought;
    for (const Passage& passage : found) {
        let_through.insert(passage.body);
        if (passage.time > first_of(passage.body) + together || is_known(passage, known))
            continue;
        chosen.insert({passage.body, passage.time, passage.side});
        brought.insert(passage.body);
    }
    Decision decision{{}, brought != let_through};
    for (const auto& [body, time, side] : chosen)
        decision.new_pairs.push_back({time, body, side});
    return decision;
}

SidePair pair_with(const std::vector<Outline>& bodies, const Passage& passage, const Vec2& start)
{
    const Outline& outline = bodies[static_cast<std::size_t>(passage.body)];
    const auto side = static_cast<std::size_t>(passage.side);
    const Vec2 place = outline[side], along = (outline[(side + 1) % outline.size()] - place).normalized();
    const Vec2 to_start = start - place;
    return {passage.body, passage.side, place, (to_start - to_start.dot(along) * along).normalized()};
}

namespace {

std::optional<Vec2> end_with(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                             const Solve& solve, std::vector<SidePair> pairs)
{
    const Vec2 end = pairs.empty() ? free_end : solve(free_end, pairs);
    const Decision decision = decide(passages(bodies, start, end), pairs);
    if (decision.halve)
        return {};
    for (const Passage& passage : decision.new_pairs)
        pairs.push_back(pair_with(bodies, passage, start));
    return decision.new_pairs.empty() ? std::optional(end) : end_with(bodies, start, free_end, solve, pairs);
}

}  // namespace

std::optional<Vec2> end_by_first(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                                 const Solve& solve)
{
    return end_with(bodies, start, free_end, solve, {});
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
