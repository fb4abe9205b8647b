#include "chapters/07_implicit_contact/joined_sets.hpp"

#include <algorithm>
#include <numeric>

namespace enduring {

JoinedSets::JoinedSets(std::size_t count) : towards_least_(count)
{
    std::iota(towards_least_.begin(), towards_least_.end(), 0);
}

int JoinedSets::least_of(int one)
{
    while (next(one) != one) {
        next(one) = next(next(one));  // halves the path for whoever asks again
        one = next(one);
    }
    return one;
}

void JoinedSets::join(int one, int other)
{
    one = least_of(one);
    other = least_of(other);
    next(std::max(one, other)) = std::min(one, other);
}

}  // namespace enduring
