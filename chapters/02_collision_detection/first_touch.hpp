#pragma once

#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/separating_directions.hpp"

#include <optional>

namespace enduring::certified {

/// `open`: no contact before `time`, and too close to call from there on at this precision.
enum class Verdict { apart, touch, open };

struct Touch {
    Verdict verdict;
    double time;
};

/// Two times between which a height certainly changes sign.
template <class Real>
struct Bracket {
    const BoundedPolynomial<Real, 3>& height;
    double low = 0, high = 1;
    double value_low = rounded(height.c[0]), value_high = rounded(height.c[3]);

    double width() const { return high - low; }
    double middle() const { return 0.5 * (low + high); }
    double secant() const { return low + width() * (value_low / (value_low - value_high)); }

    /// Replaces one end by s; false if the sign there is not certain. A time outside the bracket changes nothing.
    bool narrow(double s)
    {
        if (s <= low || s >= high)
            return true;
        const double value = rounded(from<Real>(height.c, s)[0]);
        if (std::abs(value) <= height.error)
            return false;
        const bool as_low = (value > 0) == (value_low > 0);
        (as_low ? low : high) = s;
        (as_low ? value_low : value_high) = value;
        return true;
    }
};

/// A time at most `slack` before the only root of `height`, or nothing if rounding hides on which side of it a time lies.
template <class Real>
std::optional<double> just_before_root(const BoundedPolynomial<Real, 3>& height, double slack)
{
    Bracket<Real> bracket{height};
    while (bracket.width() > slack) {
        const double width = bracket.width(), guess = bracket.secant();
        // Step to both sides of the guessed root; where the height is too curved for the secant, halve.
        if (!bracket.narrow(guess - 0.4 * slack) || !bracket.narrow(guess + 0.4 * slack))
            return std::nullopt;
        if (bracket.width() > 0.5 * width && !bracket.narrow(bracket.middle()))
            return std::nullopt;
    }
    return bracket.low;
}

//! [search]
/// First contact on an interval of length 2^-depth that begins at `start`, found by halving it, earlier half first.
/// @param halvings_left  what the whole query may still spend; it bounds its time
template <class Real, std::size_t Corners>
Touch first_touch(const SeparatingDirections<Real, Corners>& directions, double start, int depth, int& halvings_left)
{
    if (directions.apart(Throughout{}))
        return {Verdict::apart, start};
    if (directions.crosses_once())
        if (const auto before = just_before_root(directions.height, std::ldexp(time_of_impact_slack, depth)))
            return {Verdict::touch, start + std::ldexp(*before, -depth)};
    if (!directions.apart(AtStart{}) || depth == Precision<Real>::deepest || halvings_left-- == 0)
        return {Verdict::open, start};

    SeparatingDirections<Real, Corners> early, late;
    halve(directions, early, late);
    const Touch touch = first_touch(early, start, depth + 1, halvings_left);
    if (touch.verdict != Verdict::apart)
        return touch;
    return first_touch(late, start + std::ldexp(0.5, -depth), depth + 1, halvings_left);
}
//! [search]

/// First contact in [start, 1], in terms of that interval.
template <template <class> class Differences, class Real>
Touch search(const Differences<Real>& differences, double start)
{
    // Roundings to plan for: the deepest halving, a cut at `start`, and one more to look for the root.
    constexpr int planned_halvings = Precision<Real>::deepest + 10;
    int halvings_left = Precision<Real>::budget;
    auto directions = with_halvings(separating_directions(differences), planned_halvings);
    if (start > 0)
        directions = from(directions, start);
    return first_touch(directions, 0.0, 0, halvings_left);
}

}  // namespace enduring::certified
