#pragma once

#include "chapters/08_speculative_contacts/meeting.hpp"

#include <vector>

namespace enduring {

struct FaceMeeting {
    int face;
    Meeting meeting;
};

/// Which of the faces that a vertex may meet count: the nearest one, and every other one that stands before all those
/// chosen, and they before it, as the walls of a valley do. Every face that a vertex passes counts, too: it comes through that
/// one, whatever the others hold.
std::vector<FaceMeeting> choose_walls(const SurfaceStep& surface, std::vector<FaceMeeting> meetings);

}  // namespace enduring
