#pragma once

#include "chapters/02_collision_detection/query.hpp"

#include <array>
#include <random>
#include <string>
#include <vector>

namespace enduring::generated {

/// Points of a query in the order of both step types: start of the step, then its end.
using Points = std::array<Vec3, 8>;

template <class Step>
Step step_of(const Points& p)
{
    return Step{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]};
}

Points points_of(const VertexFaceStep& step);
Points points_of(const EdgeEdgeStep& step);

/// The same numbers on every machine and with every standard library.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double uniform(double low, double high)
    {
        return low + (high - low) * 0x1p-53 * static_cast<double>(engine_() >> 11);
    }
    int integer(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }
    Vec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
    Vec3 direction();

private:
    std::mt19937_64 engine_;
};

/// A kind of trouble, and how to make a query of it.
struct Category {
    std::string name;
    Points (*make)(Random&, bool edges);
};

/// Every category, from the ordinary to the degenerate.
const std::vector<Category>& categories();

}  // namespace enduring::generated
