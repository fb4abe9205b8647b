#include "common/scenes/stiffness_check.hpp"

#include "common/simulation/pressed_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace enduring {
namespace {

/// What a body gives way by, at its most harmless.
struct Softness {
    const std::string* name;
    int pairs = std::numeric_limits<int>::max();  ///< on which it can stand; what does not move sets none
    double inverse_mass = 0;                      ///< of the body as one [1/kg]
    double inverse_pair = 0;  ///< of the heaviest vertex, for a body whose nodes answer alone [1/kg]
    double stiffness;         ///< k of a pair with it [N/m]
    bool of_its_own = false;  ///< the scene gives it to this plane
};

Softness softness_of(const Body& body, double stiffness)
{
    Softness softness{&body.name(), std::numeric_limits<int>::max(), 0, 0, stiffness};
    if (body.is_static())
        return softness;
    softness.pairs = corners_of_smallest_side(body.surface(), body.positions_t0());
    if (body.mass_parts().count() == 1) {
        softness.inverse_mass = 1 / body.mass();
        return softness;
    }
    softness.inverse_pair = std::numeric_limits<double>::infinity();
    for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex)
        // a fixed node bears any step
        if (const double inverse = body.inverse_mass(vertex).trace() / 3; inverse > 0)
            softness.inverse_pair = std::min(softness.inverse_pair, inverse);
    if (!std::isfinite(softness.inverse_pair))
        softness.inverse_pair = 0;  // all are fixed
    return softness;
}

StiffestContact contact_of(const Softness& a, const Softness& b, PenaltyMethod method)
{
    const int pairs = std::min(a.pairs, b.pairs);
    const double nk = pairs * b.stiffness;
    // A spring of n k moves the bodies as one; where nodes answer alone, each of its n strands moves its own.
    const double inverse = a.inverse_mass + b.inverse_mass + (a.inverse_pair + b.inverse_pair) / pairs;
    return {*a.name, *b.name, pairs, nk, 1 / inverse, stable_step(inverse, nk, method), b.of_its_own};
}

Vec3 normal_of(const Face& face, std::span<const Vec3> positions)
{
    const auto at = [&](int corner) { return positions[face[static_cast<std::size_t>(corner)]]; };
    return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
}

}  // namespace

int corners_of_smallest_side(const SurfaceTopology& surface, std::span<const Vec3> positions)
{
    constexpr double flat = 1 - 1e-9;  // cosine between neighbours
    const auto faces = surface.faces();
    std::vector<bool> seen(faces.size(), false);
    std::size_t fewest = positions.size();
    for (std::size_t first = 0; first < faces.size(); ++first) {
        std::set<int> corners;
        std::vector<std::size_t> waiting;
        const auto take = [&](std::size_t face) {
            if (!seen[face])
                waiting.push_back(face);
            seen[face] = true;
        };
        take(first);
        if (waiting.empty())
            continue;
        while (!waiting.empty()) {
            const std::size_t face = waiting.back();
            waiting.pop_back();
            corners.insert(faces[face].begin(), faces[face].end());
            for (const int edge : surface.edges_of_face(static_cast<int>(face)))
                for (const int next : surface.faces_at_edge(edge))
                    if (next >= 0 &&
                        normal_of(faces[face], positions).dot(normal_of(faces[next], positions)) > flat)
                        take(static_cast<std::size_t>(next));
        }
        fewest = std::min(fewest, corners.size());
    }
    return static_cast<int>(fewest);
}

std::optional<StiffestContact> stiffest_contact(const World& world, const ContactParameters& contact)
{
    std::vector<Softness> moving, still;
    for (const auto& body : world.bodies)
        (body->is_static() ? still : moving).push_back(softness_of(*body, contact.stiffness));
    for (const Plane& plane : world.planes)
        still.push_back({&plane.name, std::numeric_limits<int>::max(), 0, 0,
                         plane.stiffness.value_or(contact.stiffness), plane.stiffness.has_value()});

    std::optional<StiffestContact> stiffest;
    const auto look = [&](const Softness& a, const Softness& b) {
        const StiffestContact one = contact_of(a, b, contact.method);
        if (!stiffest || one.stable_step < stiffest->stable_step)
            stiffest = one;
    };
    for (std::size_t i = 0; i < moving.size(); ++i) {
        for (std::size_t j = i + 1; j < moving.size(); ++j)
            look(moving[i], moving[j]);
        for (const Softness& other : still)
            look(moving[i], other);
    }
    return stiffest;
}

}  // namespace enduring
