#include "common/simulation/given_motion.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace enduring {
namespace {

//! [slopes]
/// Of the parabola through three values, at the middle one; no steeper than three times the rise to either
/// neighbour. Then the cubic goes one way from row to row: it stands between equal values, and has its
/// highest and lowest ones at rows.
double slope_between(double first, double middle, double last, double before, double after)
{
    const double rise = (middle - first) / before, next = (last - middle) / after;
    if (!(rise * next > 0))
        return 0;
    const double parabola = (after * rise + before * next) / (before + after),
                 most = 3 * std::min(std::abs(rise), std::abs(next));
    return std::clamp(parabola, -most, most);
}
//! [slopes]

}  // namespace

Vec3 slope_between(const Vec3& first, const Vec3& middle, const Vec3& last, double before, double after)
{
    Vec3 slope;
    for (Eigen::Index i = 0; i < 3; ++i)
        slope[i] = slope_between(first[i], middle[i], last[i], before, after);
    return slope;
}

//! [hermite]
ValueAndSlope hermite(const Vec3& from, const Vec3& slope_from, const Vec3& to, const Vec3& slope_to,
                      double length, double s)
{
    const Vec3 way = to - from;
    const double t = 1 - s;
    return {from + s * s * (3 - 2 * s) * way + length * s * t * (t * slope_from - s * slope_to),
            6 * s * t / length * way + t * (1 - 3 * s) * slope_from + s * (3 * s - 2) * slope_to};
}
//! [hermite]

namespace {

/// Angular velocity of a body whose turn is the vector v, which changes at this rate.
Vec3 angular_velocity_of(const Vec3& v, const Vec3& rate)
{
    const double angle = v.norm();
    if (angle < 1e-4)
        return rate + 0.5 * v.cross(rate);
    const Vec3 axis = v / angle;
    return rate + (1 - std::cos(angle)) / angle * axis.cross(rate) +
           (1 - std::sin(angle) / angle) * axis.cross(axis.cross(rate));
}

}  // namespace

std::optional<Vec3> turn_rate(const Vec3& turn, const Vec3& angular_velocity)
{
    constexpr double least_part = 1e-2;  // of the rate about an axis across that turns the body
    Mat3 turns;
    for (Eigen::Index i = 0; i < 3; ++i)
        turns.col(i) = angular_velocity_of(turn, Vec3::Unit(i));
    Eigen::CompleteOrthogonalDecomposition<Mat3> solver;
    solver.setThreshold(least_part);
    const Vec3 rate = solver.compute(turns).solve(angular_velocity);
    if (!((turns * rate - angular_velocity).norm() <= 1e-9 * angular_velocity.norm()))
        return std::nullopt;
    return rate;
}

GivenMotion GivenMotion::steady(const Vec3& velocity, const Vec3& angular_velocity)
{
    GivenMotion motion;
    motion.velocity_ = velocity;
    motion.angular_velocity_ = angular_velocity;
    return motion;
}

GivenMotion GivenMotion::through(std::vector<Row> rows)
{
    const auto not_later = [](const Row& one, const Row& next) { return !(one.time < next.time); };
    if (rows.size() < 2 || std::adjacent_find(rows.begin(), rows.end(), not_later) != rows.end())
        throw std::invalid_argument("given motion: two rows or more are needed, and their times ascend");
    GivenMotion motion;
    motion.slopes_ = slopes_of(rows);
    motion.rows_ = std::move(rows);
    return motion;
}

std::vector<GivenMotion::Slope> GivenMotion::slopes_of(const std::vector<Row>& rows)
{
    std::vector<Slope> slopes(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i > 0 && i + 1 < rows.size()) {
            const Row &last = rows[i - 1], &row = rows[i], &next = rows[i + 1];
            const double before = row.time - last.time, after = next.time - row.time;
            slopes[i] = {slope_between(last.displacement, row.displacement, next.displacement, before, after),
                         slope_between(last.turn, row.turn, next.turn, before, after)};
        }
        if (rows[i].gives_velocity)
            slopes[i].displacement = rows[i].velocity;
        if (rows[i].gives_turn_rate)
            slopes[i].turn = rows[i].turn_rate;
    }
    return slopes;
}

GivenPlace GivenMotion::at(double time) const
{
    if (time < until_)
        return moving_at(time);
    const GivenPlace end = moving_at(until_);
    return {end.displacement, end.turn, Vec3::Zero(), Vec3::Zero()};
}

GivenPlace GivenMotion::moving_at(double time) const
{
    if (rows_.empty())
        return {time * velocity_, time * angular_velocity_, velocity_, angular_velocity_};
    const auto next = std::upper_bound(rows_.begin(), rows_.end(), time,
                                       [](double t, const Row& row) { return t < row.time; });
    if (next == rows_.begin() || next == rows_.end()) {
        const Row& end = next == rows_.begin() ? rows_.front() : rows_.back();
        return {end.displacement, end.turn, Vec3::Zero(), Vec3::Zero()};
    }
    const auto i = static_cast<std::size_t>(next - rows_.begin());
    const Row &from = rows_[i - 1], &to = rows_[i];
    const Slope &slope_from = slopes_[i - 1], &slope_to = slopes_[i];
    const double length = to.time - from.time, s = (time - from.time) / length;
    const ValueAndSlope place = hermite(from.displacement, slope_from.displacement, to.displacement,
                                        slope_to.displacement, length, s),
                        turn = hermite(from.turn, slope_from.turn, to.turn, slope_to.turn, length, s);
    return {place.value, turn.value, place.slope, angular_velocity_of(turn.value, turn.slope)};
}

}  // namespace enduring
