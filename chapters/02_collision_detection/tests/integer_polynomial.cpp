#include "chapters/02_collision_detection/tests/integer_polynomial.hpp"

#include <algorithm>

namespace enduring::exact {
namespace {

std::vector<Integer> without_leading_zeros(std::vector<Integer> c)
{
    while (!c.empty() && c.back() == 0)
        c.pop_back();
    return c;
}

}  // namespace

double Dyadic::rounded() const
{
    return boost::multiprecision::cpp_rational(numerator, Integer(1) << power).convert_to<double>();
}

Dyadic middle(const Dyadic& a, const Dyadic& b)
{
    const unsigned power = std::max(a.power, b.power);
    return {(a.numerator << (power - a.power)) + (b.numerator << (power - b.power)), power + 1};
}

Polynomial::Polynomial(std::vector<Integer> coefficients) : c_(without_leading_zeros(std::move(coefficients)))
{}

int Polynomial::sign_at(const Dyadic& t) const
{
    Integer value = 0;
    unsigned shift = 0;
    for (auto c = c_.rbegin(); c != c_.rend(); ++c, shift += t.power)
        value = value * t.numerator + (*c << shift);
    return value.sign();
}

Polynomial Polynomial::derivative() const
{
    std::vector<Integer> d;
    for (std::size_t i = 1; i < c_.size(); ++i)
        d.push_back(c_[i] * i);
    return Polynomial(d);
}

Polynomial Polynomial::primitive() const
{
    Integer common = 0;
    for (const Integer& c : c_)
        common = gcd(common, c);
    std::vector<Integer> shorter = c_;
    for (Integer& c : shorter)
        c /= common;
    return Polynomial(shorter);
}

Polynomial operator+(const Polynomial& a, const Polynomial& b)
{
    std::vector<Integer> sum(std::max(a.c_.size(), b.c_.size()));
    std::copy(a.c_.begin(), a.c_.end(), sum.begin());
    for (std::size_t i = 0; i < b.c_.size(); ++i)
        sum[i] += b.c_[i];
    return Polynomial(sum);
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + Polynomial({Integer(-1)}) * b; }

Polynomial operator*(const Polynomial& a, const Polynomial& b)
{
    if (a.is_zero() || b.is_zero())
        return {};
    std::vector<Integer> product(a.c_.size() + b.c_.size() - 1);
    for (std::size_t i = 0; i < a.c_.size(); ++i)
        for (std::size_t j = 0; j < b.c_.size(); ++j)
            product[i + j] += a.c_[i] * b.c_[j];
    return Polynomial(product);
}

std::pair<Polynomial, Polynomial> divide(const Polynomial& a, const Polynomial& b)
{
    if (a.degree() < b.degree())
        return {{}, a};
    std::vector<Integer> rest = a.c_, quotient(a.c_.size() - b.c_.size() + 1);
    const Integer factor = abs(b.c_.back());
    for (std::size_t i = quotient.size(); i-- > 0;) {
        // Multiply everything instead of dividing the leading coefficient.
        const Integer leading = b.c_.back() > 0 ? rest.back() : Integer(-rest.back());
        for (Integer& r : rest)
            r *= factor;
        for (Integer& q : quotient)
            q *= factor;
        quotient[i] += leading;
        for (std::size_t j = 0; j < b.c_.size(); ++j)
            rest[i + j] -= leading * b.c_[j];
        rest.pop_back();
    }
    return {Polynomial(quotient).primitive(), Polynomial(rest).primitive()};
}

Polynomial greatest_common_divisor(Polynomial a, Polynomial b)
{
    while (!b.is_zero())
        a = std::exchange(b, divide(a, b).second);
    return a;
}

SturmSequence::SturmSequence(const Polynomial& p) : sequence_{p, p.derivative()}
{
    while (!sequence_.back().is_zero())
        sequence_.push_back(Polynomial() - divide(sequence_[sequence_.size() - 2], sequence_.back()).second);
    sequence_.pop_back();
}

int SturmSequence::changes_at(const Dyadic& t) const
{
    int changes = 0, last = 0;
    for (const Polynomial& p : sequence_)
        if (const int sign = p.sign_at(t)) {
            changes += last * sign < 0;
            last = sign;
        }
    return changes;
}

void AlgebraicNumber::refine()
{
    if (low == high)
        return;
    const Dyadic centre = middle(low, high);
    const int there = polynomial.sign_at(centre), at_high = polynomial.sign_at(high);
    if (there == 0)
        low = high = centre;
    else if (at_high == 0)
        low = high;
    else
        (there == at_high ? high : low) = centre;
}

int AlgebraicNumber::sign_of(const Polynomial& q)
{
    if (q.is_zero())
        return 0;
    if (low == high)
        return q.sign_at(low);
    const SturmSequence roots(q);
    const auto clear = [&] { return q.sign_at(low) != 0 && roots.roots_between(low, high) == 0; };
    if (!clear()) {
        const Polynomial common = greatest_common_divisor(polynomial, q);
        if (common.degree() > 0 && SturmSequence(common).roots_between(low, high) > 0)
            return 0;
    }
    while (!(low == high) && !clear())
        refine();
    return q.sign_at(high);
}

std::vector<AlgebraicNumber> roots_in_step(const Polynomial& p)
{
    const Polynomial simple = divide(p, greatest_common_divisor(p, p.derivative())).first;
    const SturmSequence sturm(simple);
    std::vector<AlgebraicNumber> roots, open{{simple, {0}, {1}}};
    if (simple.sign_at({0}) == 0)
        roots.push_back({simple, {0}, {0}});
    while (!open.empty()) {
        const AlgebraicNumber part = open.back();
        open.pop_back();
        const int count = sturm.roots_between(part.low, part.high);
        if (count == 1) {
            roots.push_back(part);
        } else if (count > 1) {
            const Dyadic centre = middle(part.low, part.high);
            open.push_back({simple, centre, part.high});
            open.push_back({simple, part.low, centre});
        }
    }
    return roots;
}

}  // namespace enduring::exact
