#pragma once

#include <algorithm>
#include <ctime>

namespace enduring::chapter02 {

/// CPU time of one call [s]: the best of several rounds, each long enough for the clock's resolution; one round for work
/// of a second or more. Other processes on the machine can only make a round slower, so the best one says most about
/// the work.
template <class Work>
double best_cpu_seconds(const Work& work, int rounds = 5, double shortest_round = 0.02)
{
    const auto clock = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    double best = 1e300;
    for (int round = 0; round < rounds && (round == 0 || best < 1); ++round) {
        const double start = clock();
        double spent = 0;
        int calls = 0;
        while (spent < shortest_round) {
            work();
            ++calls;
            spent = clock() - start;
        }
        best = std::min(best, spent / calls);
    }
    return best;
}

}  // namespace enduring::chapter02
