#include "chapters/08_speculative_contacts/vertex_walls.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace enduring {
namespace {

/// Whether no corner of a face lies behind the plane of another one, but for rounding.
bool stands_before(const SurfaceMoment& surface, int face, int other)
{
    constexpr double rounding = 1e-6;
    const Vec3 normal = surface.face_normal(other).stableNormalized();
    const Vec3 corner = surface.position(surface.step.face(other)[0]);
    const Face& corners = surface.step.face(face);
    return std::all_of(corners.begin(), corners.end(), [&](int vertex) {
        const Vec3 path = surface.position(vertex) - corner;
        return normal.dot(path) >= -rounding * path.norm();
    });
}

bool are_one_wall(const SurfaceMoment& surface, int face, int other)
{
    return surface.face_normal(face)
               .stableNormalized()
               .cross(surface.face_normal(other).stableNormalized())
               .norm() < search_parts.least_fold;
}

}  // namespace

//! [choose_walls]
std::vector<FaceMeeting> choose_walls(const SurfaceStep& step, std::vector<FaceMeeting> meetings)
{
    std::sort(meetings.begin(), meetings.end(), [](const FaceMeeting& one, const FaceMeeting& other) {
        return std::tuple(one.meeting.tau > 0, one.meeting.cost, one.face) <
               std::tuple(other.meeting.tau > 0, other.meeting.cost, other.face);
    });
    std::vector<FaceMeeting> chosen;
    for (const FaceMeeting& next : meetings) {
        const SurfaceMoment surface{step, next.meeting.tau};
        const bool counts = std::all_of(chosen.begin(), chosen.end(), [&](const FaceMeeting& one) {
            return !are_one_wall(surface, one.face, next.face) &&
                   (next.meeting.passes || (stands_before(surface, one.face, next.face) &&
                                            stands_before(surface, next.face, one.face)));
        });
        if (counts)
            chosen.push_back(next);
    }
    return chosen;
}
//! [choose_walls]

}  // namespace enduring
