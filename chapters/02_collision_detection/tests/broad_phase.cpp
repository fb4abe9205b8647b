#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace enduring;

namespace {

/// A surface that owns its positions: a shape thrown somewhere, whose vertices all move on their own.
struct Thrown {
    SurfaceTopology topology;
    std::vector<Vec3> t0, t1;
    FaceTree tree;

    Thrown(const SurfaceMesh& mesh, const Vec3& place, double speed, double unrest, std::mt19937_64& engine)
        : topology(topology_of(mesh)), tree(topology, mesh.vertices)
    {
        std::uniform_real_distribution<double> in(-1, 1);
        const auto random = [&] { return Vec3(in(engine), in(engine), in(engine)); };
        const Mat3 turn = Quaternion(1, in(engine), in(engine), in(engine)).normalized().toRotationMatrix();
        const Vec3 travel = speed * random();
        for (const Vec3& x : mesh.vertices) {
            t0.push_back(place + turn * x + unrest * random());
            t1.push_back(t0.back() + travel + unrest * random());
        }
        tree.refit(step());
    }
    SurfaceStep step() const { return {topology, t0, t1}; }
};

struct Lists {
    std::vector<FeaturePair> vertex_face, face_vertex, edge_edge;
    void sort()
    {
        for (auto* list : {&vertex_face, &face_vertex, &edge_edge})
            std::sort(list->begin(), list->end());
    }
    bool operator==(const Lists&) const = default;
};

struct Collect {
    Lists& lists;
    void vertex_face(int v, int f) { lists.vertex_face.push_back({v, f}); }
    void face_vertex(int f, int v) { lists.face_vertex.push_back({f, v}); }
    void edge_edge(int e, int g) { lists.edge_edge.push_back({e, g}); }
};

/// Only the pairs that really touch, by the certified query.
struct CollectTouching {
    const SurfaceStep &a, &b;
    Lists& lists;
    void vertex_face(int v, int f)
    {
        if (time_of_impact(vertex_face_step(a, v, b, f)))
            lists.vertex_face.push_back({v, f});
    }
    void face_vertex(int f, int v)
    {
        if (time_of_impact(vertex_face_step(b, v, a, f)))
            lists.face_vertex.push_back({f, v});
    }
    void edge_edge(int e, int g)
    {
        if (time_of_impact(edge_edge_step(a, e, b, g)))
            lists.edge_edge.push_back({e, g});
    }
};

/// The edges of a surface, with some vertices that have lost theirs.
SurfaceMesh wires_of(const SurfaceMesh& mesh)
{
    SurfaceMesh frame{mesh.vertices, {}, {}};
    const SurfaceTopology topology = topology_of(mesh);
    for (const Edge& edge : topology.edges())
        if (edge[0] % 5 != 0)
            frame.wires.push_back(edge);
    return frame;
}

/// Shapes near each other, also points and edges alone, with open borders, slivers, resting and violently
/// deformed surfaces among them.
template <class Test>
void for_random_pairs(int count, const Test& test)
{
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> in(-1, 1);
    const std::vector<SurfaceMesh> shapes{sphere(1, 1),
                                          box({2, 0.1, 1.5}, {3, 1, 2}),
                                          tetrahedron(2),
                                          bowl({.segments_around = 7, .segments_along = 3}),
                                          plane_grid(3, 3, {3, 4}, GridDiagonals::crossed),
                                          box({3, 1e-6, 1e-3}),
                                          wires_of(sphere(1, 1)),
                                          {sphere(1, 1).vertices, {}, {}}};
    for (int i = 0; i < count; ++i) {
        const auto& first = shapes[engine() % shapes.size()];
        const auto& second = shapes[engine() % shapes.size()];
        const double speed = i % 3 == 0 ? 0 : 0.7, unrest = i % 4 == 0 ? 0 : i % 4 == 1 ? 0.5 : 0.03;
        const Thrown a(first, Vec3::Zero(), speed, unrest, engine);
        const Thrown b(second, 1.5 * Vec3(in(engine), in(engine), in(engine)), speed, unrest, engine);
        CAPTURE(i);
        test(a, b);
    }
}

}  // namespace

TEST_CASE("broad phase: the tree yields the pairs of the boxes, each once")
{
    std::size_t pairs = 0;
    for_random_pairs(300, [&](const Thrown& a, const Thrown& b) {
        Lists boxes, tree;
        visit_boxed_pairs(a.step(), a.tree, b.step(), b.tree, Collect{boxes});
        visit_tree_pairs(a.tree, b.tree, Collect{tree});
        boxes.sort();
        tree.sort();
        CHECK(boxes == tree);
        pairs += tree.edge_edge.size();
    });
    CHECK(pairs > 10000);
}

TEST_CASE("broad phase: all three ways find the same collisions")
{
    std::size_t collisions = 0;
    for_random_pairs(30, [&](const Thrown& a, const Thrown& b) {
        Lists all, boxes, tree;
        const SurfaceStep step_a = a.step(), step_b = b.step();
        visit_all_pairs(step_a, step_b, CollectTouching{step_a, step_b, all});
        visit_boxed_pairs(step_a, a.tree, step_b, b.tree, CollectTouching{step_a, step_b, boxes});
        visit_tree_pairs(a.tree, b.tree, CollectTouching{step_a, step_b, tree});
        for (Lists* lists : {&all, &boxes, &tree})
            lists->sort();
        CHECK(all == boxes);
        CHECK(all == tree);
        collisions += all.vertex_face.size() + all.face_vertex.size() + all.edge_edge.size();
    });
    CHECK(collisions > 200);
}

TEST_CASE("broad phase: two cubes that only share a plane keep the pairs on it")
{
    // The upper cube comes to rest exactly on the lower one at the end of the step.
    const SurfaceMesh cube = box({1, 1, 1});
    const SurfaceTopology topology(8, cube.faces);
    std::vector<Vec3> above, resting;
    for (const Vec3& x : cube.vertices) {
        above.push_back(x + Vec3(0.25, 1.5, 0.25));
        resting.push_back(x + Vec3(0.25, 1.0, 0.25));
    }
    FaceTree lower(topology, cube.vertices), upper(topology, above);
    lower.refit({topology, cube.vertices, cube.vertices});
    upper.refit({topology, above, resting});
    CandidatePairs pairs;
    collect_pairs(upper, lower, pairs);
    // One lower corner of the upper cube stands on the lower cube's top: over both its triangles' boxes.
    const auto corner = std::find_if(resting.begin(), resting.end(),
                                     [](const Vec3& x) { return x == Vec3(-0.25, 0.5, -0.25); });
    REQUIRE(corner != resting.end());
    const int vertex = static_cast<int>(corner - resting.begin());
    CHECK(std::count_if(pairs.vertex_face.begin(), pairs.vertex_face.end(),
                        [&](const FeaturePair& p) { return p.a == vertex; }) >= 2);

    for (Vec3& x : resting)
        x.y() = std::nextafter(x.y(), 2.0);
    upper.refit({topology, above, resting});
    collect_pairs(upper, lower, pairs);
    CHECK(pairs.size() == 0);
}

TEST_CASE("broad phase: collecting again in the same order takes no memory and changes nothing")
{
    std::mt19937_64 engine(3);
    const Thrown a(sphere(1, 2), Vec3::Zero(), 0.1, 0.02, engine),
        b(sphere(1, 2), Vec3(0, 1.8, 0), 0.1, 0.02, engine);
    CandidatePairs pairs;
    collect_pairs(a.tree, b.tree, pairs);
    REQUIRE(pairs.size() > 100);
    const auto first = pairs.edge_edge;
    const FeaturePair* memory = pairs.edge_edge.data();
    collect_pairs(a.tree, b.tree, pairs);
    CHECK(pairs.edge_edge == first);
    CHECK(pairs.edge_edge.data() == memory);
}

TEST_CASE("broad phase: a swept box holds every point of its feature at every time")
{
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> share(0, 1);
    const Thrown thrown(sphere(1, 1), Vec3::Zero(), 1, 0.3, engine);
    const SurfaceStep step = thrown.step();
    for (int f = 0; f < static_cast<int>(thrown.topology.faces().size()); ++f)
        for (int i = 0; i < 20; ++i) {
            const auto [a, b, c] = step.face(f);
            const double tau = share(engine), u = share(engine), v = share(engine) * (1 - u);
            const auto at = [&](int vertex) { return at_time(step.start(vertex), step.end(vertex), tau); };
            const Vec3 x = (1 - u - v) * at(a) + u * at(b) + v * at(c);
            const SweptBox box = face_box(step, f);
            CHECK((x - box.low).minCoeff() >= -1e-15);
            CHECK((box.high - x).minCoeff() >= -1e-15);
        }
}
