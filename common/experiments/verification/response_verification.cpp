#include "common/experiments/verification/response_verification.hpp"

#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <memory>

namespace enduring::verification {
namespace {

constexpr double dt = 0.008;  // [s]

std::unique_ptr<DeformableBody> free_bar(ImpulseResponse response, bool quadratic, int across)
{
    const TetrahedralMesh mesh = bar({3, 0.4, 0.4}, {8 * across, across, across});
    DeformableSettings settings;
    settings.material = {.young = 2e5, .poisson = 0.3, .density = 80 / 0.48};
    settings.impulse_response = response;
    if (quadratic)
        return std::make_unique<DeformableBody>("bar", with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>("bar", mesh, settings);
}

/// The surface vertex at a place.
int vertex_at(const Body& body, const Vec3& place)
{
    int nearest = 0;
    const std::span<const Vec3> at = body.positions_t0();
    for (int vertex = 1; vertex < body.surface().vertex_count(); ++vertex)
        if ((at[vertex] - place).norm() < (at[nearest] - place).norm())
            nearest = vertex;
    return nearest;
}

struct Gain {
    double angular;  ///< of the push's lever times it
    /// of its work: at once, and with the strain that it brings about, at the end of the step
    double kinetic, energy;
};

//! [push]
Gain push(DeformableBody& body)
{
    const Vec3 edge(0, 0.2, 0.2), impulse(0, -0.01, 0);  // small: no element turns in the step
    const int vertex = vertex_at(body, edge);
    body.predict(Vec3::Zero(), dt);
    body.apply_impulse(vertex, impulse);
    body.update_prediction(dt);
    const double lever = body.positions_t0()[vertex].cross(impulse).x();
    const double work = 0.5 * impulse.dot(body.velocity(vertex));
    const double angular = body.angular_momentum(Vec3::Zero()).x(),
                 kinetic = body.energy(Vec3::Zero()).kinetic;
    body.commit(dt);
    return {angular / lever, kinetic / work, body.energy(Vec3::Zero()).total() / work};
}
//! [push]

}  // namespace

Table pushed_bar()
{
    Table table(
        {"response", "basis", "cells_across", "angular_percent", "kinetic_percent", "energy_percent"});
    for (const ImpulseResponse response : {ImpulseResponse::lumped, ImpulseResponse::implicit})
        for (const bool quadratic : {false, true})
            for (const int across : {1, 2, 4}) {
                const Gain gain = push(*free_bar(response, quadratic, across));
                table.add({response == ImpulseResponse::lumped ? "lumped" : "implicit",
                           quadratic ? "quadratic" : "linear", long{across}, 100 * gain.angular,
                           100 * gain.kinetic, 100 * gain.energy});
            }
    return table;
}

}  // namespace enduring::verification
