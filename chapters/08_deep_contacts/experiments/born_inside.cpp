#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

/// A body of 20 kg whose lowest vertex begins so deep in a floor of 1 m [m].
Scene in_floor(SurfaceMesh mesh, const Eigen::Quaterniond& turn, double depth, double dt)
{
    Scene scene;
    scene.name = "born_inside";
    scene.dt = dt;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.4};
    double lowest = 0;
    for (Vec3& x : mesh.vertices) {
        x = turn * x;
        lowest = std::min(lowest, x.y());
    }
    for (Vec3& x : mesh.vertices)
        x += Vec3(0.013, -lowest - depth, 0.021);
    SurfaceMesh floor = box({2, 1, 2}, {7, 3, 7});
    for (Vec3& x : floor.vertices)
        x.y() -= 0.5;
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "floor", SurfaceTopology(static_cast<int>(floor.vertices.size()), floor.faces), floor.vertices));
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("body", mesh, with_mass(mass_properties(mesh, 1000), 20)));
    scene.camera = {{1.6, 0.7, 2.4}, {0, -0.05, 0}, 30};
    return scene;
}

struct Case {
    std::string name;
    SurfaceMesh mesh;
    Eigen::Quaterniond turn;
};

std::vector<Case> cases()
{
    const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
    const Eigen::Quaterniond leaning(Eigen::AngleAxisd(0.3, Vec3(1, 0.2, 0.7).normalized()));
    return {{"block", box(Vec3::Constant(0.4), {2, 2, 2}), none},
            {"leaning block", box(Vec3::Constant(0.4), {2, 2, 2}), leaning},
            {"plate", box({0.6, 0.05, 0.6}, {3, 1, 3}), none},
            {"ball", sphere(0.2, 2), none}};
}

/// Where a body comes to, and how.
struct Way {
    double height = 0;      ///< of its lowest vertex at the end [m]
    double highest = -1e9;  ///< that of any step
    double fastest = 0;     ///< its middle, in any step [m/s]
    long left = 0;          ///< vertices that are more than 1 mm deep at the end
};

/// How many of a run's problems were solved, and how many were not solved to a millionth.
struct Solves {
    long all = 0, unconverged = 0;
};

ImplicitSettings counting(Solves& solves)
{
    ImplicitSettings settings;
    settings.record = [&solves](const SolveRecord& record) {
        ++solves.all;
        solves.unconverged += !record.converged;
    };
    return settings;
}

double lowest(const Body& body)
{
    double height = 1e9;
    for (const Vec3& x : body.positions_t0())
        height = std::min(height, x.y());
    return height;
}

Way watch(Scene& scene, const Solver& solver, double duration, Probe* film = nullptr)
{
    Way way;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const Body& body = *world.bodies[1];
        way.height = lowest(body);
        way.highest = std::max(way.highest, way.height);
        way.fastest = std::max(way.fastest, body.mean_velocity().y());
    });
    std::vector<Probe*> probes{&watch};
    if (film != nullptr)
        probes.push_back(film);
    run(scene, solver, probes, failure_on_purpose({.steps = static_cast<int>(duration / scene.dt + 0.5)}));
    const World& world = scene.world;
    for (const Vec3& x : world.bodies[1]->positions_t0())
        way.left += motivating::depth_inside(*world.bodies[0], x) > 1e-3;
    return way;
}

/// How fast the leaning block rises from the depth where it is wholly inside if handed-on springs do not keep
/// their compression [m/s].
double fastest_without_keeping()
{
    const Case leaning = cases()[1];
    Scene scene = in_floor(leaning.mesh, leaning.turn, 0.4, 0.01);
    Solves solves;
    Solver solver = chapter08_solver(scene.contact, counting(solves));
    solver.remove("keep compressions");
    return watch(scene, solver, 2).fastest;
}

void show(Report& report)
{
    const Case shown = cases()[1];
    Scene scene = in_floor(shown.mesh, shown.turn, 0.3, 0.01);
    StripProbe film(
        scene, {0, 0.4, 0.8, 2.5}, [](auto&&...) {}, 400, 284);
    Solves solves;
    watch(scene, chapter08_solver(scene.contact, counting(solves)), 2.6, &film);
    write_png(film.all(2), report.file("born_inside.png"));
}

}  // namespace

/// Bodies that begin inside a floor, from a millimetre to wholly: what becomes of them.
void born_inside(const RunOptions& options, Report& report)
{
    Table table({"body", "dt_s", "depth_mm", "height_with_chapter_7_m", "height_mm", "highest_mm",
                 "fastest_up_m_per_s", "left_inside"});
    double highest = -1e9, fastest = 0;
    long left = 0;
    Solves solves;
    for (const Case& c : cases())
        for (const double dt : {0.01, 1.0 / 60})
            for (const double depth : {0.001, 0.01, 0.05, 0.1, 0.4}) {
                if (options.quick && (dt != 0.01 || depth == 0.05 || depth == 0.01))
                    continue;
                Scene without = in_floor(c.mesh, c.turn, depth, dt),
                      scene = in_floor(c.mesh, c.turn, depth, dt);
                const Way before = watch(without, chapter07_solver(without.contact), 1);
                const Way way = watch(scene, chapter08_solver(scene.contact, counting(solves)), 3);
                table.add({c.name, dt, 1000 * depth, before.height, 1000 * way.height, 1000 * way.highest,
                           way.fastest, way.left});
                highest = std::max(highest, 1000 * way.highest);
                fastest = std::max(fastest, way.fastest);
                left += way.left;
            }
    show(report);
    report.fact("born_inside", "thrown", fastest_without_keeping());
    report.table("born_inside", table);
    report.page_table("born_inside", table);
    report.fact("born_inside", "highest_mm", std::max(0.0, highest));
    report.fact("born_inside", "fastest", fastest);
    report.fact("born_inside", "solves", static_cast<double>(solves.all), 6);
    report.fact("born_inside", "unconverged", static_cast<double>(solves.unconverged), 6);
    report.fact("born_inside", "left", static_cast<double>(left));
}

}  // namespace enduring::chapter08
