#pragma once

#include "chapters/06_redefinition/pair_projection.hpp"

namespace enduring {

/// Corners of a face around which neighbours are looked at.
using Corners = std::array<bool, 3>;

inline constexpr Corners all_corners{true, true, true};

/// The corners on whose side a foot beyond the face lies: those of positive weight.
inline Corners corners_towards(const TriangleFoot& foot)
{
    return {foot.weights[0] > 0, foot.weights[1] > 0, foot.weights[2] > 0};
}

/// What algorithm 6.1 finds out about a candidate. It asks whether it is
/// above, beside, deep, hooked, in this order.
enum class FaceVerdict {
    above,   ///< the vertex is not below this face, or the face has no area
    deep,    ///< on the far side of the body, see FaceLimits
    beside,  ///< its foot lies outside the face, by more than the tolerance
    hooked,  ///< the pair would push the vertex along its own surface
    fit
};

/// A candidate and what came of it.
struct FaceTrial {
    int face = -1;
    TriangleFoot foot{};
    double overshoot = 0;  ///< (6.4) of the foot
    FaceVerdict verdict = FaceVerdict::above;
};

/// What keeps a vertex near: on a coarse mesh the faces around a face's corners reach to the far side of the
/// body, where the foot is fine, the pair regular, and the penetration that of the whole body.
struct FaceLimits {
    /// eps_v of (6.4): in the dead wedge below a valley no face has the foot. A face is taken only if its
    /// foot overshoots less than the present one's, so a vertex is not passed to and fro.
    double tolerance = 0;
    /// [m]; see limits_of_shifted and limits_of_hooked.
    double deepest = INFINITY;
    /// Normal of the face through which a hooked pair came in, any length; zero if that does not matter. A
    /// face that looks the other way is the body's far side.
    Vec3 came_through = Vec3::Zero();
};

/// For a vertex whose foot has left its face. The face across the border that it passed is never farther away
/// than its present face, for the border lies in the plane of both.
/// @param overshoot  (6.4) of its foot
FaceLimits limits_of_shifted(const World& world, const Contact& contact, double tau, double overshoot);

/// For a hooked pair. No face is farther away than the nearest regular one: if the vertex is not below that,
/// or only just beside it, it waits, and no other face is meant.
FaceLimits limits_of_hooked(const World& world, const Contact& contact, double tau);

/// Asks about one face.
FaceTrial try_face(const PairSurfaces& surfaces, int vertex, int face, const FaceLimits& limits);

/// Feet on a face before feet beside one; among equals the smaller penetration.
bool is_better(const FaceTrial& one, const FaceTrial& other);

/// Visits the faces around some corners of a contact's present face, which is left out, and so are those that
/// the vertex never meets; a face at two corners comes twice.
template <typename Visit>
void visit_candidates(const PairSurfaces& surfaces, const Contact& contact, const Corners& around,
                      Visit&& visit)
{
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (around[corner])
            for (const int face : surfaces.b.step.topology.faces_around_vertex(contact.vertices[corner + 1]))
                if (face != contact.feature_b &&
                    !(surfaces.neighbours && surfaces.neighbours->vertex_and_face(contact.feature_a, face)))
                    visit(face);
}

/// Algorithm 6.1: the best regular face around some corners of a vertex-face
/// contact's present one; none if there is none.
/// @param tau  moment of the step at which positions are looked at
std::optional<FaceTrial> find_face(const World& world, const Contact& contact, double tau,
                                   const Corners& around, const FaceLimits& limits);

}  // namespace enduring
