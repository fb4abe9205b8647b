#pragma once

#include "common/geometry/meshes.hpp"
#include "common/scenes/scene.hpp"

#include <random>
#include <string>
#include <vector>

namespace enduring::chapter08 {

/// Numbers from 0 to 1, the same on every machine.
class Numbers {
public:
    explicit Numbers(unsigned seed) : random_(seed) {}
    double next() { return static_cast<double>(random_()) / std::mt19937::max(); }
    double within(double least, double most) { return least + (most - least) * next(); }
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    /// Every turn is as likely as any other.
    Eigen::Quaterniond turn();

private:
    std::mt19937 random_;
};

/// Of which shapes a heap may be: eight, and one of all of them.
inline constexpr int family_count = 9, mixed_family = 8;
std::string family_name(int family);
/// One body of a family, half a metre large, around the origin.
SurfaceMesh shape_of(int family, Numbers& numbers);

/// A heap that nobody has chosen.
struct HeapPlan {
    int family = mixed_family;
    int bodies = 8;
    double dt = 0.01;  ///< [s]
    double mu = 0.5;
    unsigned seed = 1;
    double spin = 0;  ///< of each body at first, at most [rad/s]
};
/// Bodies of 1 to 10 kg, each turned at random, in layers above the ground. They do not fall yet, but may
/// spin.
Scene random_heap(const HeapPlan& plan);

}  // namespace enduring::chapter08
