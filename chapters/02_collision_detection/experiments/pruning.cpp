// How many pairs each way of the broad phase leaves to the query, and what finding and answering them takes, against the
// size of the meshes.
#include "cpu_time.hpp"
#include "experiments.hpp"

#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/certified.hpp"

#include "common/geometry/shapes.hpp"

namespace enduring::chapter02 {
namespace {

/// Two balls of radius 1; in this step the upper one comes down until they overlap by 7 cm.
struct Balls {
    SurfaceTopology topology;
    std::vector<Vec3> lower, upper_t0, upper_t1;
    FaceTree lower_tree, upper_tree;

    explicit Balls(int subdivisions)
    {
        const SurfaceMesh mesh = sphere(1, subdivisions);
        topology = SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces);
        const Mat3 tilt = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        lower = mesh.vertices;
        for (const Vec3& x : mesh.vertices) {
            upper_t0.push_back(tilt * x + Vec3(0, 2.01, 0));
            upper_t1.push_back(tilt * x + Vec3(0.02, 1.93, 0.01));
        }
        lower_tree = FaceTree(topology, lower);
        upper_tree = FaceTree(topology, upper_t0);
        refit();
    }
    SurfaceStep lower_step() const { return {topology, lower, lower}; }
    SurfaceStep upper_step() const { return {topology, upper_t0, upper_t1}; }
    void refit()
    {
        lower_tree.refit(lower_step());
        upper_tree.refit(upper_step());
    }
};

/// Answers each pair and keeps count.
struct Tally {
    SurfaceStep a, b;
    long pairs = 0, touching = 0;

    void vertex_face(int v, int f) { count(time_of_impact(vertex_face_step(a, v, b, f))); }
    void face_vertex(int f, int v) { count(time_of_impact(vertex_face_step(b, v, a, f))); }
    void edge_edge(int e, int g) { count(time_of_impact(edge_edge_step(a, e, b, g))); }
    void count(const std::optional<double>& tau)
    {
        ++pairs;
        touching += tau.has_value();
    }
};

struct Way {
    std::string name;
    int most_subdivisions, most_if_quick;
    void (*visit)(Balls&, Tally&);
};

const std::vector<Way> ways{
    {"all pairs", 4, 2, [](Balls& balls, Tally& tally) { visit_all_pairs(balls.upper_step(), balls.lower_step(), tally); }},
    {"boxes", 5, 3, [](Balls& balls, Tally& tally) {
         balls.refit();
         visit_boxed_pairs(balls.upper_step(), balls.upper_tree, balls.lower_step(), balls.lower_tree, tally);
     }},
    {"tree", 6, 4, [](Balls& balls, Tally& tally) {
         balls.refit();
         visit_tree_pairs(balls.upper_tree, balls.lower_tree, tally);
     }},
};

}  // namespace

void pruning(const RunOptions& options, Report& report)
{
    Table table({"faces", "method", "pairs", "touching", "time_ms"});
    for (int subdivisions = 1; subdivisions <= ways.back().most_subdivisions; ++subdivisions) {
        Balls balls(subdivisions);
        const long faces = static_cast<long>(balls.topology.faces().size());
        for (const Way& way : ways) {
            if (subdivisions > (options.quick ? way.most_if_quick : way.most_subdivisions))
                continue;
            Tally tally{balls.upper_step(), balls.lower_step()};
            const double seconds = best_cpu_seconds([&] {
                tally.pairs = tally.touching = 0;
                way.visit(balls, tally);
            });
            table.add({faces, way.name, tally.pairs, tally.touching, 1e3 * seconds});
            if (faces == 1280 || (options.quick && faces == 320)) {
                const std::string name = way.name == "all pairs" ? "all" : way.name;
                report.fact("pruning", name + "_pairs", static_cast<double>(tally.pairs), 3);
                report.fact("pruning", name + "_ms", 1e3 * seconds, 2);
                report.fact("pruning", "faces", static_cast<double>(faces), 5);
            }
        }
    }
    report.table("pruning", table);
    report.page_table("pruning", table);
    report.plot(plot_script("pruning"), "pruning");
}

}  // namespace enduring::chapter02
