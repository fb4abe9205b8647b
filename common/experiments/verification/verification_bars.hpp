#pragma once

#include "common/fem/elastic_body.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <memory>

/// What the verifications are made of.
namespace enduring::verification {

inline constexpr Basis both_bases[] = {Basis::linear, Basis::quadratic};

inline ElasticMesh with_elements(const TetrahedralMesh& mesh, Basis basis)
{
    return basis == Basis::linear ? ElasticMesh(mesh) : ElasticMesh(with_edge_midpoints(mesh));
}

inline const char* name_of(Basis basis) { return basis == Basis::linear ? "linear" : "quadratic"; }

/// A square bar along x, clamped at its lower end.
inline std::unique_ptr<ElasticBody> clamped_bar(double length, double thickness, std::array<int, 3> cells,
                                                Basis basis, const ElasticMaterial& material,
                                                CellSplit split = CellSplit::five)
{
    auto body = std::make_unique<ElasticBody>(
        with_elements(bar({length, thickness, thickness}, cells, split), basis), material,
        ElasticOptions{.freeze_rotations = true});
    for (int n = 0; n < body->node_count(); ++n)
        if (body->positions()(0, n) < -0.5 * length + 1e-9)
            body->fix(n);
    return body;
}

}  // namespace enduring::verification
