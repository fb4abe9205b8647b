#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace enduring {

/// The numbers that a state is made of, in both directions: written into a list, or read back from one. A
/// class names its fields once, in one function that is given an archive, so nothing that is written can be
/// forgotten in reading.
class StateArchive {
public:
    /// Writes.
    StateArchive() = default;
    /// Reads what another one has written.
    explicit StateArchive(std::vector<double> numbers) : numbers_(std::move(numbers)), reads_(true) {}

    bool reads() const { return reads_; }
    const std::vector<double>& numbers() const { return numbers_; }
    /// Whether all that was written has been read.
    bool at_end() const { return next_ == numbers_.size(); }

    void operator()(double& number)
    {
        if (!reads_) {
            numbers_.push_back(number);
            return;
        }
        assert(next_ < numbers_.size());
        number = numbers_[next_++];
    }
    /// Flags, indices and enumerations.
    /// @throws std::out_of_range  what is read is no whole number that the type can hold
    template <class Integer>
    void whole(Integer& value)
    {
        double number = static_cast<double>(value);
        (*this)(number);
        if (reads_ && !holds<Integer>(number))
            throw std::out_of_range("is no whole number of the kind that stands there");
        value = static_cast<Integer>(number);
    }
    /// A vector or matrix, whose size stays.
    template <class Derived>
    void operator()(Eigen::PlainObjectBase<Derived>& matrix)
    {
        for (Eigen::Index i = 0; i < matrix.size(); ++i)
            (*this)(matrix.data()[i]);
    }
    void operator()(Eigen::Quaterniond& quaternion) { (*this)(quaternion.coeffs()); }
    /// A list whose length stays.
    template <class Item>
    void operator()(std::vector<Item>& items)
    {
        for (Item& item : items)
            (*this)(item);
    }

private:
    template <class Integer>
    static bool holds(double number)
    {
        if constexpr (std::is_enum_v<Integer>)
            return holds<std::underlying_type_t<Integer>>(number);
        else
            return number >= static_cast<double>(std::numeric_limits<Integer>::min()) &&
                   number <= static_cast<double>(std::numeric_limits<Integer>::max()) &&
                   number == std::floor(number);
    }

    std::vector<double> numbers_;
    std::size_t next_ = 0;
    bool reads_ = false;
};

}  // namespace enduring
