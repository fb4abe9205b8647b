#include "face_choice.hpp"

#include "chapters/05_categorisation/category.hpp"

namespace enduring {

//! [algorithm_6_1]
FaceTrial try_face(const PairSurfaces& surfaces, int vertex, int face, double tolerance)
{
    const std::optional<FaceFoot> foot = foot_on_face(surfaces.a, vertex, surfaces.b, face);
    if (!foot)
        return {face, {}, 0, FaceVerdict::above};
    const double beyond = overshoot(foot->weights);
    if (foot->depth >= 0)
        return {face, *foot, beyond, FaceVerdict::above};
    if (beyond > 0 && beyond >= tolerance)
        return {face, *foot, beyond, FaceVerdict::beside};
    const bool hooked = is_hooked_vertex(surfaces.a, vertex, surfaces.b.face_normal(face));
    return {face, *foot, beyond, hooked ? FaceVerdict::hooked : FaceVerdict::fit};
}

bool is_better(const FaceTrial& one, const FaceTrial& other)
{
    const bool beside = one.overshoot > 0, other_beside = other.overshoot > 0;
    return beside != other_beside ? other_beside : one.foot.depth > other.foot.depth;
}

std::optional<FaceTrial> find_face(const World& world, const Contact& contact, double tau, const Corners& around, double tolerance)
{
    const PairSurfaces surfaces(world, contact, tau);
    std::optional<FaceTrial> best;
    visit_candidates(surfaces, contact, around, [&](int face) {
        const FaceTrial trial = try_face(surfaces, contact.feature_a, face, tolerance);
        if (trial.verdict == FaceVerdict::fit && (!best || is_better(trial, *best)))
            best = trial;
    });
    return best;
}
//! [algorithm_6_1]

}  // namespace enduring
