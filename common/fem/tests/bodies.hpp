#pragma once

#include "common/fem/elastic_body.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <random>

/// Small bodies and fields that several tests of this folder use.
namespace enduring::test {

inline TetrahedralMesh small_bar() { return bar({0.4, 0.2, 0.2}, {2, 1, 1}); }

inline ElasticMesh elastic(const TetrahedralMesh& mesh, Basis basis)
{
    return basis == Basis::linear ? ElasticMesh(mesh) : ElasticMesh(with_edge_midpoints(mesh));
}

constexpr Basis both_bases[] = {Basis::linear, Basis::quadratic};

inline const char* name_of(Basis basis) { return basis == Basis::linear ? "linear" : "quadratic"; }

/// Uniform in [-size, size], the same on every machine.
inline NodalVectors random_field(int nodes, double size, unsigned seed)
{
    std::mt19937 generator(seed);
    NodalVectors field(3, nodes);
    for (Eigen::Index n = 0; n < nodes; ++n)
        for (int i = 0; i < 3; ++i)
            field(i, n) = size * (2.0 * static_cast<double>(generator()) / 4294967295.0 - 1);
    return field;
}

inline Mat3 random_rotation(unsigned seed)
{
    const NodalVectors q = random_field(2, 1, seed);
    return Quaternion(q(0, 0), q(1, 0), q(2, 0), q(0, 1)).normalized().toRotationMatrix();
}

inline const Vec3 gravity(0, -9.81, 0);

inline void run(ElasticBody& body, const Vec3& pull, double dt, int steps)
{
    for (int step = 0; step < steps; ++step) {
        body.predict(pull, dt);
        body.commit(dt);
    }
}

}  // namespace enduring::test
