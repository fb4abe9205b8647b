#include "chapters/06_redefinition/face_choice.hpp"

#include "chapters/02_collision_detection/impact_weights.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {
namespace {

/// Of a vertex from the closest point of a face [m].
double distance_from_face(const PairSurfaces& surfaces, int vertex, int face)
{
    const VertexFaceStep step = vertex_face_step(surfaces.a.step, vertex, surfaces.b.step, face);
    const auto [w0, w1, w2] = impact_weights(step, surfaces.a.tau);
    const auto [f0, f1, f2] = surfaces.b.step.face(face);
    return (w0 * surfaces.b.position(f0) + w1 * surfaces.b.position(f1) + w2 * surfaces.b.position(f2) -
            surfaces.a.position(vertex))
        .norm();
}

}  // namespace

FaceLimits limits_of_shifted(const World& world, const Contact& contact, double tau, double overshoot)
{
    const PairSurfaces surfaces(world, contact, tau);
    return {.tolerance = overshoot,
            .deepest = distance_from_face(surfaces, contact.feature_a, contact.feature_b)};
}

FaceLimits limits_of_hooked(const World& world, const Contact& contact, double tau)
{
    const PairSurfaces surfaces(world, contact, tau);
    FaceLimits limits{.came_through = surfaces.b.face_normal(contact.feature_b)};
    visit_candidates(surfaces, contact, all_corners, [&](int face) {
        const Vec3 normal = surfaces.b.face_normal(face);
        if (normal.squaredNorm() > 0 && !is_hooked_vertex(surfaces.a, contact.feature_a, normal))
            limits.deepest = std::min(limits.deepest,
                                      (1 + 1e-9) * distance_from_face(surfaces, contact.feature_a, face));
    });
    return limits;
}

FaceTrial try_face(const PairSurfaces& surfaces, int vertex, int face, const FaceLimits& limits)
{
    not_implemented_yet("6.1");
}

bool is_better(const FaceTrial& one, const FaceTrial& other)
{
    not_implemented_yet("6.1");
}

std::optional<FaceTrial> find_face(const World& world, const Contact& contact, double tau,
                                   const Corners& around, const FaceLimits& limits)
{
    not_implemented_yet("6.1");
}

}  // namespace enduring
