#pragma once

#include "common/scenes/scene.hpp"

namespace enduring::chapter08 {

/// A sheet of soft elements, one cell thick, that is let go above a fixed ball of 0.25 m.
struct Sheet {
    int cells = 10;       ///< along each side, of 0.8 m
    double young = 1e5;   ///< [Pa]
    double thick = 0.02;  ///< [m]
    double dt = 0.01;     ///< [s]
};
Scene sheet_over_ball(const Sheet& sheet);

/// Soft blocks of 0.4 m and 10 kg on one another on the ground.
struct SoftStack {
    int blocks = 5;
    double young = 1e5;  ///< [Pa]
    double dt = 0.01;    ///< [s]
};
Scene soft_stack(const SoftStack& stack);

}  // namespace enduring::chapter08
