#include "common/simulation/outside_load.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace enduring {

TimedVector::TimedVector(std::vector<Row> rows) : rows_(std::move(rows))
{
    const auto not_later = [](const Row& one, const Row& next) { return !(one.time < next.time); };
    if (rows_.size() < 2 || std::adjacent_find(rows_.begin(), rows_.end(), not_later) != rows_.end())
        throw std::invalid_argument(
            "a vector over time: two rows or more are needed, and their times ascend");
}

//! [integral]
Vec3 TimedVector::integral(double from, double to) const
{
    if (rows_.empty())
        return (to - from) * constant_;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        const Row &one = rows_[i - 1], &next = rows_[i];
        const double begin = std::max(from, one.time), end = std::min(to, next.time);
        if (begin >= end)
            continue;
        const double middle = (0.5 * (begin + end) - one.time) / (next.time - one.time);
        sum += (end - begin) * lerp(one.value, next.value, middle);
    }
    return sum;
}
//! [integral]

Vec3 AnchoredSpring::force_on(const Vec3& point) const
{
    const Vec3 to_anchor = anchor - point;
    const double distance = to_anchor.norm();
    return distance > 0 ? Vec3(stiffness * (1 - rest_length / distance) * to_anchor) : Vec3(Vec3::Zero());
}

TimedVector TimedVector::turned(const Quaternion& turn) const
{
    TimedVector result = *this;
    result.constant_ = turn * constant_;
    for (Row& row : result.rows_)
        row.value = turn * row.value;
    return result;
}

}  // namespace enduring
