#include "exercises/08_contact_by_distance/3_first_crossing.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <map>

namespace enduring {

Decision decide(std::vector<Passage> found, const std::vector<SidePair>& known)
{
    not_implemented_yet("8.3");
}

SidePair pair_with(const std::vector<Outline>& bodies, const Passage& passage, const Vec2& start)
{
    not_implemented_yet("8.3");
}

std::optional<Vec2> end_by_first(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                                 const Solve& solve)
{
    not_implemented_yet("8.3");
}

Vec2 end_by_all(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                const Solve& solve)
{
    not_implemented_yet("8.3");
}

}  // namespace enduring
