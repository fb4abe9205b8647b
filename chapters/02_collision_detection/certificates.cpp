#include "chapters/02_collision_detection/certificates.hpp"

namespace enduring::certified {
namespace {

/// Enough to halve twice down to the last bit.
constexpr int most_cuts = 100;

double value(const std::array<double, 4>& f, double s) { return f[0] + s * (f[1] + s * (f[2] + s * f[3])); }

/// Bernstein coefficients over [0, length].
std::array<double, 4> bernstein(const std::array<double, 4>& f, double length)
{
    const double b = f[1] * length / 3, c = f[2] * length * length / 3;
    return {f[0], f[0] + b, f[0] + 2 * b + c, f[0] + 3 * b + 3 * c + f[3] * length * length * length};
}

/// The zero of f between 0, where it is positive, and a time where it is not: Newton's steps, and halves
/// where they lead out.
double zero_before(const std::array<double, 4>& f, double high)
{
    double low = 0, s = high * f[0] / (f[0] - value(f, high));
    for (int i = 0; i < most_cuts; ++i) {
        const double here = value(f, s), slope = f[1] + s * (2 * f[2] + 3 * s * f[3]);
        (here > 0 ? low : high) = s;
        const double next = s - here / slope;
        if (std::abs(next - s) <= 0x1p-26 * s)  // the next one would square it
            return next;
        s = next > low && next < high ? next : 0.5 * (low + high);
    }
    return low;
}

double first_zero_of_quadratic(const std::array<double, 4>& f, double length)
{
    // With f[0] > 0: the root that does not cancel, for either sign of f[2].
    const double discriminant = f[1] * f[1] - 4 * f[2] * f[0];
    if (discriminant < 0)
        return length;
    const double root = 2 * f[0] / (std::sqrt(discriminant) - f[1]);
    return root >= 0 && root < length ? root : length;
}

}  // namespace

double first_zero(const std::array<double, 4>& f, double length)
{
    if (f[3] == 0)
        return first_zero_of_quadratic(f, length);
    double low = 0, high = length;
    std::array<double, 4> rest = f;  // f from `low` on
    const auto move = [&](double by) {
        rest = {value(rest, by), rest[1] + by * (2 * rest[2] + 3 * by * rest[3]), rest[2] + 3 * by * rest[3],
                rest[3]};
        low += by;
    };
    for (int i = 0; i < most_cuts && rest[0] > 0; ++i) {
        const std::array<double, 4> b = bernstein(rest, high - low);
        if (b[1] > 0 && b[2] > 0 && b[3] > 0) {  // no zero up to `high`
            if (high == length)
                return length;
            move(high - low);
            high = length;
        } else if (b[3] <= 0 && (b[1] > 0 || b[2] <= 0)) {  // one change of sign
            return low + zero_before(rest, high - low);
        } else {  // the curve stays above the lower border of its coefficients' hull
            double s = 1;
            for (int k = 1; k < 4; ++k)
                if (b[static_cast<std::size_t>(k)] < b[0])
                    s = std::min(s, k / 3.0 * b[0] / (b[0] - b[static_cast<std::size_t>(k)]));
            const double step = s * (high - low), half = 0.5 * (high - low);
            if (step <= 0x1p-48 * low)
                return low;
            move(step);
            high = std::min(high, low + half);
        }
    }
    return low;
}

double provable_length(const std::array<double, 4>& f, double length)
{
    const double zero = first_zero(f, length);
    if (zero < length)
        return zero;
    const std::array<double, 4> b = bernstein(f, length);
    if (b[1] > 0 && b[2] > 0)
        return length;
    const double turn = -f[1] / (f[2] + std::sqrt(std::max(f[2] * f[2] - 3 * f[1] * f[3], 0.0)));
    return turn > 0 && turn < length ? turn : length;
}

}  // namespace enduring::certified
