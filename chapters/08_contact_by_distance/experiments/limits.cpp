#include "chapters/08_contact_by_distance/experiments/limits.hpp"

#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/formula_runs.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace enduring::chapter08 {
namespace {

/// Between a value at which a property holds and one at which it does not.
template <class Holds>
double limit_between(double holds_at, double fails_at, double tolerance, const Holds& holds)
{
    while (std::abs(fails_at - holds_at) > tolerance) {
        const double middle = 0.5 * (holds_at + fails_at);
        (holds(middle) ? holds_at : fails_at) = middle;
    }
    return 0.5 * (holds_at + fails_at);
}

void run_for(Scene& scene, double duration)
{
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    for (long i = std::lround(duration / scene.dt); i > 0; --i)
        advance(scene.world, contacts, solver, scene.dt);
}

/// How far a body ends from where it began [m].
double moved(Scene& scene, std::size_t body, double duration)
{
    const Vec3 from = scene.world.bodies[body]->centre();
    run_for(scene, duration);
    return (scene.world.bodies[body]->centre() - from).norm();
}

RigidBody& add_body(Scene& scene, const std::string& name, const SurfaceMesh& mesh, double mass)
{
    auto body = std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass));
    RigidBody& added = *body;
    scene.world.bodies.push_back(std::move(body));
    return added;
}

}  // namespace

AgainstFormula slope_limit(double mu, double dt)
{
    const double formula = std::atan(mu) / formula_runs::degree;
    const double measured = limit_between(formula - 2, formula + 2, 0.01, [&](double slope_deg) {
        Scene scene = chapter07::scene_of({{.centre = Vec3(0, 0.1, 0), .size = Vec3(1, 0.2, 1)}}, dt,
                                          slope_deg, mu, mu);
        return moved(scene, 0, 1) < 1e-4;
    });
    return {measured, formula};
}

AgainstFormula toppling_limit(double height_over_width, double dt)
{
    const double formula = std::atan(1 / height_over_width) / formula_runs::degree,
                 height = height_over_width;
    const double measured = limit_between(formula - 2, formula + 2, 0.01, [&](double slope_deg) {
        Scene scene = chapter07::scene_of({{.centre = Vec3(0, 0.5 * height, 0), .size = Vec3(1, height, 1)}},
                                          dt, slope_deg, 10, 10);
        run_for(scene, 2);
        return Eigen::AngleAxisd(formula_runs::motion_of(scene, 0).pose().orientation).angle() < 1e-3;
    });
    return {measured, formula};
}

namespace {

/// A wedge that is wider above, and a jaw at each side that can only come nearer. Nothing has weight.
Scene pinched_wedge(double side, double mu, double dt)
{
    constexpr double half_width = 0.1, half_height = 0.1, thickness = 0.1, gap = 1e-6,
                     press = 100;  // [m], [N]
    Scene scene = chapter07::scene_of({}, dt, 0, mu, mu);
    scene.world.planes.clear();
    scene.world.gravity = Vec3::Zero();
    const double more = half_height * std::tan(side);
    add_body(scene, "wedge",
             chapter07::prism({{-half_width + more, -half_height},
                               {half_width - more, -half_height},
                               {half_width + more, half_height},
                               {-half_width - more, half_height}},
                              0.2),
             1);
    for (const int sign : {-1, 1}) {
        SurfaceMesh jaw = box({thickness, 6 * half_height, 0.4});
        const Quaternion turn(Eigen::AngleAxisd(-sign * side, Vec3::UnitZ()));
        const Vec3 centre = Vec3(sign * half_width, 0, 0) + turn * Vec3(sign * (0.5 * thickness + gap), 0, 0);
        for (Vec3& vertex : jaw.vertices)
            vertex = centre + turn * vertex;
        RigidBody& body = add_body(scene, sign < 0 ? "left jaw" : "right jaw", jaw, 1);
        body.hold({.translation = Vec3::UnitX(), .rotation = Vec3::Zero()});
        body.add_load({.force = TimedVector(Vec3(-sign * press, 0, 0))});
    }
    return scene;
}

/// A half circle of wedge-shaped stones, 1 m to their middles.
Scene thin_arch(int stones, double thickness, double dt)
{
    Scene scene = chapter07::scene_of({}, dt, 0, 2, 2);
    const double inner = 1 - 0.5 * thickness, outer = 1 + 0.5 * thickness;
    for (int i = 0; i < stones; ++i) {
        const double from = std::numbers::pi * i / stones, to = std::numbers::pi * (i + 1) / stones;
        add_body(scene, "stone " + std::to_string(i + 1),
                 chapter07::prism({{inner * std::cos(from), inner * std::sin(from)},
                                   {outer * std::cos(from), outer * std::sin(from)},
                                   {outer * std::cos(to), outer * std::sin(to)},
                                   {inner * std::cos(to), inner * std::sin(to)}},
                                  0.2),
                 1);
    }
    return scene;
}

}  // namespace

AgainstFormula pinch_limit(double side_deg, double dt)
{
    const double formula = std::tan(side_deg * formula_runs::degree);
    const double measured = limit_between(1.1 * formula, 0.9 * formula, 1e-4, [&](double mu) {
        Scene scene = pinched_wedge(side_deg * formula_runs::degree, mu, dt);
        return moved(scene, 0, 0.5) < 1e-4;
    });
    return {measured, formula};
}

AgainstFormula arch_limit(int stones, double dt)
{
    const double measured = limit_between(0.13, 0.08, 0.001, [&](double thickness) {
        Scene scene = thin_arch(stones, thickness, dt);
        return moved(scene, static_cast<std::size_t>(stones / 2), 3) < 0.05;
    });
    return {measured, thinnest_arch(stones)};
}

//! [thinnest_arch]
double thinnest_arch(int stones)
{
    const double along = std::numbers::pi / stones;
    const auto stands = [&](double thickness) {
        const double inner = 1 - 0.5 * thickness, outer = 1 + 0.5 * thickness;
        const double area = 0.5 * std::sin(along) * (outer * outer - inner * inner);
        const double first_moment = std::sin(along) * std::cos(0.5 * along) *
                                    (std::pow(outer, 3) - std::pow(inner, 3)) / 3;  // about the arch's middle
        double weight = 0, moment = 0, least_thrust = 0;
        for (int joint = 1; 2 * joint <= stones;
             ++joint) {  // from the top, where the thrust passes the outer corner
            weight += area;
            moment += first_moment * std::sin((joint - 0.5) * along);
            const double angle = joint * along, lever = outer - inner * std::cos(angle);
            least_thrust = std::max(least_thrust, (weight * inner * std::sin(angle) - moment) / lever);
        }
        return least_thrust <= (weight * outer - moment) / outer;
    };
    return limit_between(0.2, 0.01, 1e-6, stands);
}
//! [thinnest_arch]

/// Slopes that hold, boxes that topple, jaws that pinch and arches that stand: where each begins to fail.
void limits(const RunOptions& options, Report& report)
{
    Table table({"limit", "of", "dt_s", "measured", "by_formula", "error_percent"});
    const auto add = [&](const std::string& limit, const std::string& fact, double of, double dt,
                         const AgainstFormula& found, double& worst) {
        table.add({limit, of, dt, found.measured, found.formula, 100 * found.error()});
        worst = std::max(worst, std::abs(100 * found.error()));
        report.fact("limits", fact + "_percent", worst, 2);
    };
    double slope = 0, topple = 0, pinch = 0, arch = 0;
    for (const double dt : options.quick ? std::vector{0.01} : std::vector{0.01, 0.005, 0.002}) {
        for (const double mu : {0.1, 0.3, 0.5, 0.8, 1.2})
            if (!options.quick || mu == 0.1 || mu == 0.8)
                add("slope holds [°], of μ", "slope", mu, dt, slope_limit(mu, dt), slope);
        for (const double tall : {1.0, 2.0, 4.0})
            if (!options.quick || tall == 2)
                add("box stands on a slope [°], of its height over its width", "topple", tall, dt,
                    toppling_limit(tall, dt), topple);
        for (const double side : {5.0, 15.0, 30.0})
            if (!options.quick || side == 15)
                add("jaws hold a wedge [μ], of its sides' angle", "pinch", side, dt, pinch_limit(side, dt),
                    pinch);
        for (const int stones : {10, 20})
            if (stones == 10 || (!options.quick && dt == 0.01)) {
                const AgainstFormula found = arch_limit(stones, dt);
                add("arch stands [thickness / radius], of its stones", "arch", stones, dt, found, arch);
                report.fact("limits", "arch_measured", found.measured, 3);
            }
    }
    report.table("limits", table);
    report.page_table("limits", table, 4);
    report.fact("limits", "arch_of_many", thinnest_arch(2000), 4);
    report.fact("limits", "arch_of_ten", thinnest_arch(10), 4);
}

}  // namespace enduring::chapter08
