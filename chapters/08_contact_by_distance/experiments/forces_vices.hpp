#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// What is gripped, 0.2 m wide.
enum class Gripped { box, ball, soft };
std::string name_of(Gripped gripped);

/// Two walls that move as given, further than the body between them leaves room.
struct Vice {
    Gripped gripped = Gripped::box;
    double overclosed = 1e-3;  ///< by both walls together [m]
    double mass = 5;           ///< [kg]
    double aside = 0;          ///< of the body at the start, towards one wall [m]
    double dt = 0.01;          ///< [s]
};
std::string name_of(const Vice& vice);

/// What a run of a second left.
struct Squeezed {
    double force = 0;       ///< of one wall at the end [N]
    double difference = 0;  ///< of both walls' forces, over the larger [1]
    double off_law = 0;     ///< of any step (Stepped::off_law)
    double fastest = 0;     ///< the body [m/s]
    double lifted = 0;      ///< [m]
    double carried = 0;     ///< vertical force on the body at the end, over its weight
    long parts = 1;         ///< the most of a step
    long ended_badly = 0;
};

/// Walls that close within a tenth of a second, without gravity; then they stand.
Squeezed squeeze(const Vice& vice, const MakeSolver& make);
/// Fingers that close on a body that stands on the ground, within 0.3 s, and lift it by 0.3 m, within 0.7 s.
/// Friction 0.5.
Squeezed grip(const Vice& vice, const MakeSolver& make);
inline constexpr double lift = 0.3;                       ///< [m]
inline constexpr double fastest_lift = 1.5 * lift / 0.7;  ///< of a cubic that begins and ends at rest [m/s]

Rows vices(const MakeSolver& make, bool full);
Rows grippers(const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
