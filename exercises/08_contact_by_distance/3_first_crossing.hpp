#pragma once

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace enduring {

using Vec2 = Eigen::Vector2d;  // in a plane

/// A body that stands: its corners, counter-clockwise. Side i leads from corner i to the next one, the last
/// side to corner 0.
using Outline = std::vector<Vec2>;

/// A moving point passes a side of a body.
struct Passage {
    double time;  ///< in the step, from 0 at its start to 1 at its end
    int body, side;
};

/// A pair of the point with a side: in this step the point stays in front of the side's line.
struct SidePair {
    int body, side;
    Vec2 place;  ///< some place of the line [m]
    Vec2
        normal;  ///< at right angles to the line, unit length, to where the point is at the start of the step
};

/// What passages ask for.
struct Decision {
    std::vector<Passage> new_pairs;  ///< they become pairs
    bool halve = false;              ///< the step is to be halved
};

/// Given: whether the passed side has a pair already.
inline bool is_known(const Passage& passage, const std::vector<SidePair>& known)
{
    for (const SidePair& pair : known)
        if (pair.body == passage.body && pair.side == passage.side)
            return true;
    return false;
}

/// Passages of the point and one body within this part of the step are one impact [1].
constexpr double together = 0.02;

/// Given: the query. All sides that a straight path passes, in no order. A path that ends on a line, up to
/// 1e-9 m, does not pass it.
inline std::vector<Passage> passages(const std::vector<Outline>& bodies, const Vec2& from, const Vec2& to)
{
    std::vector<Passage> found;
    for (int body = static_cast<int>(bodies.size()) - 1; body >= 0; --body)
        for (std::size_t side = 0; side < bodies[static_cast<std::size_t>(body)].size(); ++side) {
            const Outline& outline = bodies[static_cast<std::size_t>(body)];
            const Vec2 p = outline[side], along = outline[(side + 1) % outline.size()] - p;
            const Vec2 across = Vec2(along.y(), -along.x()).normalized();
            const double before = across.dot(from - p), after = across.dot(to - p);
            if (std::abs(after) < 1e-9 || (before > 0) == (after > 0))
                continue;
            const double time = before / (before - after);
            const double part = (from + time * (to - from) - p).dot(along) / along.squaredNorm();
            if (part >= 0 && part <= 1)
                found.push_back({time, body, static_cast<int>(side)});
        }
    return found;
}

/// Given: a solve. The end that is nearest to the free one, of those in front of the lines of all pairs:
/// free, on one line, or where two lines meet.
inline Vec2 nearest_end(const Vec2& free_end, const std::vector<SidePair>& pairs)
{
    std::vector<Vec2> ends{free_end};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const SidePair& one = pairs[i];
        ends.push_back(free_end - one.normal.dot(free_end - one.place) * one.normal);
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 along(-one.normal.y(), one.normal.x());
            const double slope = pairs[j].normal.dot(along);
            if (std::abs(slope) > 1e-9)
                ends.push_back(one.place - pairs[j].normal.dot(one.place - pairs[j].place) / slope * along);
        }
    }
    Vec2 best = free_end;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& end : ends) {
        bool in_front = true;
        for (const SidePair& pair : pairs)
            in_front = in_front && pair.normal.dot(end - pair.place) > -1e-10;
        if (in_front && (end - free_end).norm() < least) {
            best = end;
            least = (end - free_end).norm();
        }
    }
    return best;
}

/// A solve: from the end without contact and all pairs to the end of the step.
using Solve = std::function<Vec2(const Vec2& free_end, const std::vector<SidePair>& pairs)>;

/// What becomes of passages. Of each body only the first one counts, with those that follow it within
/// `together`; later ones are consequences. What counts becomes a pair, if it is none yet. If all that counts
/// of a body are known pairs, the step is halved.
/// @param found  in no order
/// @return       new pairs, ascending by body, and for one body by time
Decision decide(std::vector<Passage> found, const std::vector<SidePair>& known);

/// The pair of a side that the point passes in a step which begins at `start`, not on the line.
SidePair pair_with(const std::vector<Outline>& bodies, const Passage& passage, const Vec2& start);

/// The end of a step: the query, the decision, and a solve of the whole step with all pairs so far, again and
/// again until nothing is passed any more. None if the step is to be halved.
std::optional<Vec2> end_by_first(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                                 const Solve& solve);

/// For comparison: everything that the free path passes becomes a pair, and the step is solved once.
Vec2 end_by_all(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end,
                const Solve& solve);

}  // namespace enduring
