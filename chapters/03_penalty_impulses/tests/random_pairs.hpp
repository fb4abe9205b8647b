#pragma once

#include "chapters/03_penalty_impulses/penetration.hpp"

#include <random>
#include <vector>

namespace enduring::testing {

/// A pair that moves at random: the vertices of both ends of a step in a box of side 2.
struct RandomPair {
    bool edge_edge = false;
    PairVertices t0, t1;

    PairInstant instant(const PairVertices& x) const
    {
        return edge_edge ? edge_edge_instant(x, 1) : vertex_face_instant(x);
    }
    PairStep step() const { return {instant(t0), instant(t1)}; }

    /// The pair at a time between, from its vertices: every vertex on its straight line.
    PairInstant at(double tau) const
    {
        PairVertices x;
        for (std::size_t i = 0; i < 4; ++i)
            x[i] = (1 - tau) * t0[i] + tau * t1[i];
        return instant(x);
    }
};

/// @param motion  how far vertices move in the step, beside a size of about 1
inline std::vector<RandomPair> random_pairs(int count, unsigned seed, double motion = 2)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] {
        const double x = unit(generator), y = unit(generator), z = unit(generator);
        return Vec3(x, y, z);
    };
    std::vector<RandomPair> pairs(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i].edge_edge = i % 2 == 1;
        for (std::size_t v = 0; v < 4; ++v) {
            pairs[i].t0[v] = point();
            pairs[i].t1[v] = pairs[i].t0[v] + 0.5 * motion * point();
        }
    }
    return pairs;
}

}  // namespace enduring::testing
