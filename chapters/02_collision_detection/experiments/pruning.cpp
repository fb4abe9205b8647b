// How many pairs each way of the broad phase leaves to the query, and what finding and answering them takes,
// against the size of the meshes.
#include "chapters/02_collision_detection/broad_phase.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/experiments/bullet_tree.hpp"
#include "chapters/02_collision_detection/experiments/cpu_time.hpp"
#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "common/geometry/round_shapes.hpp"

namespace enduring::chapter02 {
namespace {

/// Two balls of radius 1; in this step the upper one comes down until they overlap by 7 cm.
struct Balls {
    SurfaceTopology topology;
    std::vector<Vec3> lower, upper_t0, upper_t1;
    FaceTree lower_tree, upper_tree;
    std::optional<BulletTree> lower_bullet, upper_bullet;

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
        lower_bullet.emplace(lower_step());
        upper_bullet.emplace(upper_step());
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
    int max_subdivisions, max_if_quick;
    void (*visit)(Balls&, Tally&);
};

const std::vector<Way> ways{
    {"all pairs", 4, 2,
     [](Balls& balls, Tally& tally) { visit_all_pairs(balls.upper_step(), balls.lower_step(), tally); }},
    {"boxes", 5, 3,
     [](Balls& balls, Tally& tally) {
         balls.refit();
         visit_boxed_pairs(balls.upper_step(), balls.upper_tree, balls.lower_step(), balls.lower_tree, tally);
     }},
    {"tree", 6, 4,
     [](Balls& balls, Tally& tally) {
         balls.refit();
         visit_tree_pairs(balls.upper_tree, balls.lower_tree, tally);
     }},
    {"Bullet's tree", 6, 4,
     [](Balls& balls, Tally& tally) {
         balls.refit();
         balls.upper_bullet->refit(balls.upper_step());
         balls.lower_bullet->refit(balls.lower_step());
         BulletTree::overlapping_faces(*balls.upper_bullet, *balls.lower_bullet, [&](int f, int g) {
             visit_owned_pairs(balls.upper_tree, f, balls.lower_tree, g, tally);
         });
     }},
};

/// One way on one size of mesh.
struct Outcome {
    long pairs = 0, touching = 0;
    double milliseconds = 0;
};

Outcome measure(const Way& way, Balls& balls)
{
    Tally tally{balls.upper_step(), balls.lower_step()};
    const double seconds = best_cpu_seconds([&] {
        tally.pairs = tally.touching = 0;
        way.visit(balls, tally);
    });
    return {tally.pairs, tally.touching, 1e3 * seconds};
}

Cell or_dash(const std::optional<Outcome>& outcome, double Outcome::*value)
{
    return outcome ? Cell((*outcome).*value) : Cell("–");
}

}  // namespace

void pruning(const RunOptions& options, Report& report)
{
    Table table({"faces", "method", "pairs", "touching", "time_ms"});
    std::vector<std::vector<std::optional<Outcome>>> outcomes(ways.size());
    const auto faces_at = [](int subdivisions) { return 20L << (2 * subdivisions); };
    const auto most = [&](const Way& way) { return options.quick ? way.max_if_quick : way.max_subdivisions; };
    const int largest = most(ways.back());
    for (std::size_t w = 0; w < ways.size(); ++w) {
        for (int subdivisions = 1; subdivisions <= most(ways[w]); ++subdivisions) {
            Balls balls(subdivisions);
            const Outcome outcome = measure(ways[w], balls);
            table.add({faces_at(subdivisions), ways[w].name, outcome.pairs, outcome.touching,
                       outcome.milliseconds});
            outcomes[w].push_back(outcome);
        }
        outcomes[w].resize(static_cast<std::size_t>(largest));
    }

    Table page({"faces", "all pairs", "boxed pairs", "touching", "all [ms]", "boxes [ms]", "tree [ms]",
                "Bullet's tree [ms]"});
    for (std::size_t i = 0; i < static_cast<std::size_t>(largest); ++i) {
        const auto &all = outcomes[0][i], &tree = outcomes[2][i];
        page.add({faces_at(static_cast<int>(i) + 1), all ? Cell(static_cast<double>(all->pairs)) : Cell("–"),
                  tree->pairs, tree->touching, or_dash(all, &Outcome::milliseconds),
                  or_dash(outcomes[1][i], &Outcome::milliseconds), or_dash(tree, &Outcome::milliseconds),
                  or_dash(outcomes[3][i], &Outcome::milliseconds)});
    }
    const std::size_t shown = options.quick ? 1 : 3;  // the largest size on which all ways ran
    report.fact("pruning", "faces", static_cast<double>(faces_at(static_cast<int>(shown) + 1)), 5);
    report.fact("pruning", "all_pairs", static_cast<double>(outcomes[0][shown]->pairs), 3);
    report.fact("pruning", "boxed_pairs", static_cast<double>(outcomes[2][shown]->pairs), 4);
    report.fact("pruning", "all_ms", outcomes[0][shown]->milliseconds, 3);
    report.fact("pruning", "boxes_ms", outcomes[1][shown]->milliseconds, 3);
    report.fact("pruning", "tree_ms", outcomes[2][shown]->milliseconds, 2);
    report.fact("pruning", "bullet_over_tree",
                outcomes[3].back()->milliseconds / outcomes[2].back()->milliseconds, 2);
    report.table("pruning", table);
    report.page_table("pruning", page);
    report.plot("chapters/02_collision_detection/plots/pruning.gp");
}

}  // namespace enduring::chapter02
