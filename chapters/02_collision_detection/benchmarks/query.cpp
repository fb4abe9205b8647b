// What one query costs over the pairs whose swept boxes overlap: certified, and the textbook's beside it.
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/textbook.hpp"
#include "common/geometry/round_shapes.hpp"

#include <benchmark/benchmark.h>

#include <vector>

namespace enduring {
namespace {

struct Box {
    Vec3 low, high;

    explicit Box(std::initializer_list<Vec3> points) : low(*points.begin()), high(*points.begin())
    {
        for (const Vec3& p : points)
            low = low.cwiseMin(p), high = high.cwiseMax(p);
    }
    bool overlaps(const Box& other) const
    {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
};

/// A surface at both ends of a step.
struct MovingSurface {
    std::vector<Vec3> t0, t1;
    SurfaceTopology topology;
};

/// A ball that lands on a slowly turning ball: it moves by `travel` of an
/// edge length and is deformed a little on the way.
struct LandingBalls {
    std::vector<VertexFaceStep> vertex_face;
    std::vector<EdgeEdgeStep> edge_edge;

    explicit LandingBalls(double travel)
    {
        const SurfaceMesh mesh = sphere(1.0, 3);
        const double edge = 0.15;
        const MovingSurface lower = moved(mesh, Vec3::Zero(), Vec3::Zero(), 0.01);
        const MovingSurface upper = moved(mesh, Vec3(0.03, 2 - 0.2 * edge, 0.02),
                                          Vec3(0.2, -1, 0.1) * travel * edge, -0.005);
        add_vertex_faces(upper, lower);
        add_vertex_faces(lower, upper);
        add_edge_edges(upper, lower);
    }

private:
    static MovingSurface moved(const SurfaceMesh& mesh, const Vec3& place, const Vec3& travel, double turn)
    {
        MovingSurface surface{{}, {}, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces)};
        const Mat3 tilt = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        const Mat3 rotation = Eigen::AngleAxisd(turn, Vec3(2, -1, 1).normalized()).toRotationMatrix();
        for (const Vec3& x : mesh.vertices) {
            const Vec3 bulge = 0.003 * Vec3(std::sin(9 * x.y()), std::sin(7 * x.z()), std::sin(8 * x.x()));
            surface.t0.push_back(place + tilt * x);
            surface.t1.push_back(place + travel + rotation * tilt * (x + bulge));
        }
        return surface;
    }

    void add_vertex_faces(const MovingSurface& a, const MovingSurface& b)
    {
        for (std::size_t v = 0; v < a.t0.size(); ++v)
            for (const Face& f : b.topology.faces()) {
                const auto i = static_cast<std::size_t>(f[0]), j = static_cast<std::size_t>(f[1]),
                           k = static_cast<std::size_t>(f[2]);
                if (Box({a.t0[v], a.t1[v]})
                        .overlaps(Box({b.t0[i], b.t0[j], b.t0[k], b.t1[i], b.t1[j], b.t1[k]})))
                    vertex_face.push_back(
                        {a.t0[v], b.t0[i], b.t0[j], b.t0[k], a.t1[v], b.t1[i], b.t1[j], b.t1[k]});
            }
    }

    void add_edge_edges(const MovingSurface& a, const MovingSurface& b)
    {
        for (const Edge& e : a.topology.edges())
            for (const Edge& f : b.topology.edges()) {
                const auto i = static_cast<std::size_t>(e[0]), j = static_cast<std::size_t>(e[1]);
                const auto k = static_cast<std::size_t>(f[0]), l = static_cast<std::size_t>(f[1]);
                if (Box({a.t0[i], a.t0[j], a.t1[i], a.t1[j]})
                        .overlaps(Box({b.t0[k], b.t0[l], b.t1[k], b.t1[l]})))
                    edge_edge.push_back(
                        {a.t0[i], a.t0[j], b.t0[k], b.t0[l], a.t1[i], a.t1[j], b.t1[k], b.t1[l]});
            }
    }
};

/// Mean time of one query, over both kinds, in the pairs of the balls;
/// `travel` is in hundredths of an edge length.
template <class Query>
void measure(benchmark::State& state, const Query& query)
{
    const LandingBalls pairs(0.01 * static_cast<double>(state.range(0)));
    const auto count = pairs.vertex_face.size() + pairs.edge_edge.size();
    std::size_t hits = 0;
    for (auto _ : state) {
        hits = 0;
        for (const auto& step : pairs.vertex_face)
            hits += query(step).has_value();
        for (const auto& step : pairs.edge_edge)
            hits += query(step).has_value();
        benchmark::DoNotOptimize(hits);
    }
    state.counters["pairs"] = static_cast<double>(count);
    state.counters["hits"] = static_cast<double>(hits);
    state.counters["per_query"] = benchmark::Counter(
        static_cast<double>(count),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void certified_query(benchmark::State& state)
{
    measure(state, [](const auto& step) { return time_of_impact(step); });
}
void textbook_query(benchmark::State& state)
{
    measure(state, [](const auto& step) { return textbook_time_of_impact(step); });
}

BENCHMARK(certified_query)->Arg(5)->Arg(25)->Arg(100);
BENCHMARK(textbook_query)->Arg(5)->Arg(25)->Arg(100);

}  // namespace
}  // namespace enduring
