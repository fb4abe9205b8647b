#pragma once

#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>

namespace enduring::chapter02 {

/// CPU time of one call [s]: the best of several rounds, each long enough for the clock's resolution; one
/// round for work of a second or more. Other processes on the machine can only make a round slower, so the
/// best one says most about the work.
template <class Work>
double best_cpu_seconds(const Work& work, int rounds = 5, double shortest_round = 0.02)
{
    double best = 1e300;
    for (int round = 0; round < rounds && (round == 0 || best < 1); ++round) {
        const double start = processor_seconds();
        double spent = 0;
        int calls = 0;
        while (spent < shortest_round) {
            work();
            ++calls;
            spent = processor_seconds() - start;
        }
        best = std::min(best, spent / calls);
    }
    return best;
}

}  // namespace enduring::chapter02
