#pragma once

#include "chapters/08_speculative_contacts/meeting.hpp"

#include <vector>

namespace enduring {

struct FaceMeeting {
    int face;
    Meeting meeting;
};

/// Which of the faces that a vertex may meet count: the nearest one, and every other one that stands before all those
/// chosen, and they before it, as the walls of a valley do. What a vertex passes counts, too, where it does not end behind
/// the chosen ones: then it is outside of them until it passes.
/// @param held  how deep it may end behind a wall that holds it [m]
std::vector<FaceMeeting> choose_walls(const SurfaceStep& surface, std::vector<FaceMeeting> meetings,
                                      double held = 0);

}  // namespace enduring
