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
    double error = height.error + blossom_error<Real>(3, height.size());
    double low = 0, high = 1;
    double value_low = rounded(height.c[0]), value_high = rounded(height.c[3]);

    double width() const { return high - low; }
    double middle() const { return 0.5 * (low + high); }
    double secant() const { return low + width() * (value_low / (value_low - value_high)); }

    /// Replaces one end by s; false if the sign there is not certain. A
    /// time outside the bracket changes nothing.
    bool narrow(double s)
    {
        if (s <= low || s >= high)
            return true;
        const double value = rounded(value_at<Real>(height.c, s));
        if (std::abs(value) <= error)
            return false;
        const bool as_low = (value > 0) == (value_low > 0);
        (as_low ? low : high) = s;
        (as_low ? value_low : value_high) = value;
        return true;
    }
};

/// Times at most `slack` apart on both sides of the only root of `height`, or nothing if rounding hides on
/// which side of it a time lies, or `steps_left` runs out.
template <class Real>
std::optional<Bracket<Real>> bracket_root(const BoundedPolynomial<Real, 3>& height, double slack,
                                          int& steps_left)
{
    Bracket<Real> bracket{height};
    while (bracket.width() > slack) {
        if (steps_left-- <= 0)
            return std::nullopt;
        const double width = bracket.width(), guess = bracket.secant();
        // Step to both sides of the guessed root; where the height is too curved for the secant, halve.
        if (!bracket.narrow(guess - 0.4 * slack) || !bracket.narrow(guess + 0.4 * slack))
            return std::nullopt;
        if (bracket.width() > 0.5 * width && !bracket.narrow(bracket.middle()))
            return std::nullopt;
    }
    return bracket;
}

/// Narrowing a span to a root costs as much as this many halvings.
constexpr int cuts_of_a_zoom = 5;

/// A part of the step, and how many cuts led to it.
struct Span {
    double start = 0, width = 1;
    int depth = 0;
};

//! [search]
/// First contact within a span: most spans are settled at once; the others are narrowed to the only root of
/// the height, or halved, earlier half first.
/// @param steps_left  what the whole query may still spend; it bounds its time
template <class Real, std::size_t Corners>
Touch first_touch(const SeparatingDirections<Real, Corners>& directions, const Span& span, int& steps_left)
{
    if (directions.apart(Throughout{}))
        return {Verdict::apart, span.start};
    if (directions.height_changes_once()) {
        const double slack = std::min(time_of_impact_slack / span.width, 0x1p-20);
        if (const auto root = bracket_root(directions.height, slack, steps_left)) {
            const Span narrow{span.start + span.width * root->low, span.width * root->width(),
                              span.depth + cuts_of_a_zoom};
            if (const int within = directions.within_polygon(root->low, root->width()))
                return {within > 0 ? Verdict::touch : Verdict::apart, narrow.start};
            steps_left -= cuts_of_a_zoom;
            if (narrow.depth <= Precision<Real>::deepest)
                return first_touch(part(directions, root->low, root->high), narrow, steps_left);
        }
    }
    if (!directions.apart(AtStart{}) || span.depth >= Precision<Real>::deepest || steps_left-- <= 0)
        return {Verdict::open, span.start};

    SeparatingDirections<Real, Corners> early, late;
    halve(directions, early, late);
    const double half = 0.5 * span.width;
    const Touch touch = first_touch(early, Span{span.start, half, span.depth + 1}, steps_left);
    if (touch.verdict != Verdict::apart)
        return touch;
    return first_touch(late, Span{span.start + half, half, span.depth + 1}, steps_left);
}
//! [search]

/// First contact in [start, 1], in terms of that interval.
template <template <class> class Differences, class Real>
Touch search(const Differences<Real>& differences, double start)
{
    auto directions = separating_directions(differences);
    if (start > 0)
        directions = part(directions, start, 1.0);
    int steps_left = Precision<Real>::budget;
    return first_touch(directions, Span{}, steps_left);
}

}  // namespace enduring::certified
