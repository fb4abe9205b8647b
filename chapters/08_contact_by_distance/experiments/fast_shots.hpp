#pragma once

#include "common/simulation/step.hpp"

#include <vector>

namespace enduring::chapter08 {

/// Shots of one kind at a plate of 1 m x 2 mm x 1 m.
struct FastVolley {
    enum class Shape { ball, box, tetrahedron };
    enum class Way { straight, oblique, spinning };
    bool free_plate = false;  ///< or held
    double speed = 1;         ///< [m/s]
    Shape shape = Shape::ball;
    Way way = Way::straight;
};
/// By plates, then speeds, then shapes and ways.
std::vector<FastVolley> fast_volleys();

/// Plain numbers, to be kept by sweep().
struct FastOutcome {
    long shots = 0, through = 0;  ///< whose middle comes out on the other side
    double deepest_m = 0;         ///< in the plate or the plate in it, after any step
    double max_energy = 0;        ///< after any step, over that at first
    long unsolved = 0;            ///< steps

    void add(const FastOutcome& other);
};

/// One shot without gravity, from any turn at any place of the plate's middle half.
FastOutcome shoot(const FastVolley& volley, double dt, unsigned seed);

}  // namespace enduring::chapter08
