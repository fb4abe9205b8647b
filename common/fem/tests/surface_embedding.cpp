#include "common/fem/surface_embedding.hpp"
#include "common/fem/tests/bodies.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::test;

TEST_CASE(
    "surface embedding: rest positions are the surface's, and follow the curved edge of the Bernstein form")
{
    const QuadraticTetrahedralMesh mesh = with_edge_midpoints(small_bar());
    const ExtractedSurface surface = surface_of(mesh);
    const SurfaceEmbedding embedding(mesh, surface.nodes);
    const ElasticMesh elements(mesh);
    std::vector<Vec3> positions(surface.nodes.size());
    embedding.evaluate(elements.rest(), positions);
    for (std::size_t v = 0; v < positions.size(); ++v)
        CHECK((positions[v] - surface.mesh.vertices[v]).norm() <= 1e-15);

    // A quadratic motion is a member of the space: y += x^2 with control
    // points from polarisation, y_ab += x_a x_b.
    NodalVectors curved = elements.rest();
    for (const auto& element : mesh.elements)
        for (std::size_t i = 0; i < 10; ++i) {
            const auto [a, b] = i < 4 ? std::array{int(i), int(i)} : tetrahedron_edges[i - 4];
            const int node = element[i];
            curved(1, node) = elements.rest()(1, node) +
                              mesh.nodes[element[a]].x() * mesh.nodes[element[b]].x();
        }
    embedding.evaluate(curved, positions);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Vec3& p = surface.mesh.vertices[v];
        CHECK((positions[v] - (p + p.x() * p.x() * Vec3::UnitY())).norm() <= 1e-15);
    }
}

TEST_CASE(
    "surface embedding: an impulse on lumped masses keeps its linear momentum, and moves its vertex by the inverse mass there")
{
    const QuadraticTetrahedralMesh mesh = with_edge_midpoints(small_bar());
    const SurfaceEmbedding embedding(mesh, surface_of(mesh).nodes);
    const Vec3 impulse(0.3, -1, 2);
    for (int vertex = 0; vertex < embedding.vertex_count(); ++vertex) {
        CAPTURE(vertex);
        ElasticBody body(ElasticMesh(mesh), {});
        embedding.apply_impulse(vertex, impulse, body.inverse_masses(), body.velocities());
        const Vec3 change = embedding.at(vertex, body.velocities());
        CHECK((body.linear_momentum() - impulse).norm() <= 1e-13);
        CHECK((change - embedding.inverse_mass(vertex, body.inverse_masses()) * impulse).norm() <=
              1e-13 * change.norm());
        const double of_lumps = 0.5 * body.velocities().colwise().squaredNorm() * body.masses();
        CHECK(of_lumps == doctest::Approx(0.5 * impulse.dot(change)));  // the work the impulse did
        CHECK(body.kinetic_energy() < 0.9 * of_lumps);  // between the nodes the body lags behind them
    }
    const std::vector<int> wrong{0, 9999};
    CHECK_THROWS_AS(SurfaceEmbedding(mesh, wrong), InputError);
}
