#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <utility>
#include <vector>

namespace enduring::exact {

using Integer = boost::multiprecision::cpp_int;

/// numerator / 2^power: halving an interval never leaves these numbers, so no fraction is ever reduced.
struct Dyadic {
    Integer numerator = 0;
    unsigned power = 0;

    double rounded() const;
    friend bool operator==(const Dyadic& a, const Dyadic& b)
    {
        return (a.numerator << b.power) == (b.numerator << a.power);
    }
    friend bool operator<(const Dyadic& a, const Dyadic& b)
    {
        return (a.numerator << b.power) < (b.numerator << a.power);
    }
};

Dyadic middle(const Dyadic& a, const Dyadic& b);

/// A polynomial with integer coefficients, lowest power first, without
/// leading zeros; the zero polynomial is empty.
class Polynomial {
public:
    Polynomial() = default;
    explicit Polynomial(std::vector<Integer> coefficients);

    bool is_zero() const { return c_.empty(); }
    int degree() const { return static_cast<int>(c_.size()) - 1; }
    int sign_at(const Dyadic& t) const;
    Polynomial derivative() const;
    /// Divided by the largest integer that divides every coefficient: the
    /// same roots and signs from shorter numbers.
    Polynomial primitive() const;

    friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
    /// Quotient and remainder of a positive multiple of a by b, each up to a positive factor; b is not zero.
    friend std::pair<Polynomial, Polynomial> divide(const Polynomial& a, const Polynomial& b);

private:
    std::vector<Integer> c_;
};

Polynomial greatest_common_divisor(Polynomial a, Polynomial b);

/// Counts the different roots of a polynomial, by Sturm's theorem.
class SturmSequence {
public:
    /// @param p  not zero
    explicit SturmSequence(const Polynomial& p);
    /// In (from, to].
    int roots_between(const Dyadic& from, const Dyadic& to) const
    {
        return changes_at(from) - changes_at(to);
    }

private:
    int changes_at(const Dyadic& t) const;
    std::vector<Polynomial> sequence_;
};

/// The only root in (low, high] of a polynomial without multiple roots; low may equal high, the root itself.
struct AlgebraicNumber {
    Polynomial polynomial;
    Dyadic low, high;

    void refine();
    /// The exact sign that another polynomial has here.
    int sign_of(const Polynomial& q);
};

/// All roots in [0, 1], ascending.
/// @param p  not zero
std::vector<AlgebraicNumber> roots_in_step(const Polynomial& p);

}  // namespace enduring::exact
