#include "chapters/02_collision_detection/experiments/tunnelling.hpp"

#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/edge_triangle.hpp"

namespace enduring::chapter02 {

std::vector<Face> plate_faces() { return {{0, 1, 2}, {0, 2, 3}}; }
std::vector<Face> spike_faces() { return {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}}; }

Tunnelling tunnelling()
{
    Tunnelling scene;
    scene.plate = {{-1.2, 0, 1}, {1.2, 0, 1}, {1.2, 0, -1}, {-1.2, 0, -1}};
    const std::vector<Vec3> spike{{0, -0.35, 0}, {-0.3, 0.3, 0.2}, {0.3, 0.3, 0.2}, {0, 0.3, -0.35}};
    for (const Vec3& x : spike) {
        scene.spike_t0.push_back(x + Vec3(-0.4, 0.7, 0.1));
        scene.spike_t1.push_back(x + Vec3(0.4, -0.7, -0.1));
    }
    return scene;
}

int discrete_hits(const std::vector<Vec3>& spike, const std::vector<Vec3>& plate)
{
    int hits = 0;
    for (const Face& face : plate_faces())
        for (const auto& [i, j] : tetrahedron_edges)
            hits += find_edge_triangle_hit(spike[std::size_t(i)], spike[std::size_t(j)],
                                           plate[std::size_t(face[0])], plate[std::size_t(face[1])],
                                           plate[std::size_t(face[2])])
                        .has_value();
    for (const Face& face : spike_faces())
        for (std::size_t i = 0; i < 4; ++i)
            hits += find_edge_triangle_hit(plate[i], plate[(i + 1) % 4], spike[std::size_t(face[0])],
                                           spike[std::size_t(face[1])], spike[std::size_t(face[2])])
                        .has_value();
    return hits;
}

std::optional<double> first_touch(const Tunnelling& scene)
{
    std::optional<double> first;
    for (std::size_t v = 0; v < scene.spike_t0.size(); ++v)
        for (const Face& face : plate_faces()) {
            const auto corner = [&](std::size_t i) { return scene.plate[std::size_t(face[i])]; };
            const VertexFaceStep step{scene.spike_t0[v], corner(0), corner(1), corner(2),
                                      scene.spike_t1[v], corner(0), corner(1), corner(2)};
            if (const auto tau = time_of_impact(step); tau && (!first || *tau < *first))
                first = tau;
        }
    return first;
}

}  // namespace enduring::chapter02
