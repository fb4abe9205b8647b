#pragma once

#include <cstddef>
#include <vector>

namespace enduring {

/// Numbers from 0 on, each in a set of its own until sets are joined; a set is known by its least number.
class JoinedSets {
public:
    explicit JoinedSets(std::size_t count);

    int least_of(int one);
    void join(int one, int other);

private:
    int& next(int one) { return towards_least_[static_cast<std::size_t>(one)]; }

    std::vector<int> towards_least_;
};

}  // namespace enduring
