// What one label costs, from the positions in cache: a cube on a grid, with pairs that are regular or hooked.

#include "chapters/05_categorisation/category.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/static_body.hpp"

#include <benchmark/benchmark.h>

#include <memory>

namespace {

using namespace enduring;

constexpr int floor_body = 0, cube_body = 1;

World cube_on_grid()
{
    const auto still = [](const char* name, SurfaceMesh mesh, const Vec3& at) {
        for (Vec3& x : mesh.vertices)
            x += at;
        SurfaceTopology topology(static_cast<int>(mesh.vertices.size()), std::move(mesh.faces));
        return std::make_unique<StaticBody>(name, std::move(topology), std::move(mesh.vertices));
    };
    World world;
    world.bodies.push_back(still("floor", plane_grid(4, 2, {10, 5}), Vec3::Zero()));
    world.bodies.push_back(still("cube", box({0.5, 0.5, 0.5}), {0.03, 0.249, 0.02}));
    return world;
}

/// Every pair of this kind and category that cube and floor can form; of edges those that are not parallel.
Contacts pairs(const World& world, ContactKind kind, ContactCategory category)
{
    Contacts all;
    const auto add = [&](const Contact& contact) {
        if (categorise(world, contact, 0) == category)
            all.push_back(contact);
    };
    const SurfaceTopology &floor = world.bodies[floor_body]->surface(),
                          &cube = world.bodies[cube_body]->surface();
    if (kind == ContactKind::vertex_face) {
        for (int vertex = 0; vertex < cube.vertex_count(); ++vertex)
            for (int face = 0; face < static_cast<int>(floor.faces().size()); ++face)
                add({kind, cube_body, floor_body, vertex, face});
        for (int vertex = 24; vertex < 32; ++vertex)  // of the grid's inside, six faces each
            for (int face = 0; face < static_cast<int>(cube.faces().size()); ++face)
                add({kind, floor_body, cube_body, vertex, face});
    } else
        for (int edge_a = 0; edge_a < static_cast<int>(floor.edges().size()); ++edge_a)
            for (int edge_b = 0; edge_b < static_cast<int>(cube.edges().size()); ++edge_b)
                for (const double orientation : {1.0, -1.0}) {
                    Contact contact{kind, floor_body, cube_body, edge_a, edge_b};
                    contact.orientation = orientation;
                    add(contact);
                }
    all.resize(std::min<std::size_t>(all.size(), 64));
    return all;
}

void label(benchmark::State& state, ContactKind kind, ContactCategory category, double tau)
{
    const World world = cube_on_grid();
    const Contacts contacts = pairs(world, kind, category);
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(categorise(world, contacts[i], tau));
        if (++i == contacts.size())
            i = 0;
    }
}

BENCHMARK_CAPTURE(label, vertex_face_regular, ContactKind::vertex_face, ContactCategory::regular, 0.0);
BENCHMARK_CAPTURE(label, vertex_face_hooked, ContactKind::vertex_face, ContactCategory::hooked, 0.0);
BENCHMARK_CAPTURE(label, vertex_face_hooked_at_impact, ContactKind::vertex_face, ContactCategory::hooked,
                  0.3);
BENCHMARK_CAPTURE(label, edge_edge_regular, ContactKind::edge_edge, ContactCategory::regular, 0.0);
BENCHMARK_CAPTURE(label, edge_edge_hooked, ContactKind::edge_edge, ContactCategory::hooked, 0.0);
BENCHMARK_CAPTURE(label, edge_edge_hooked_at_impact, ContactKind::edge_edge, ContactCategory::hooked, 0.3);

}  // namespace
