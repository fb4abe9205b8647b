#include "chapters/07_implicit_contact/experiments/levers.hpp"

#include "chapters/06_redefinition/experiments/rolling.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace enduring::chapter07 {
namespace {

/// A wheel of a kilogram that rolls to the right.
struct RollingWheel {
    static constexpr double radius = 0.1;  ///< [m]
    static constexpr double speed = 2;     ///< [m/s]
    static constexpr double spin = speed / radius;
};

/// The wheel at the start of its step.
/// @param sides   of the wheel, a vertex at each corner of both ends
/// @param turned  by how much it stands beyond the position in which its first vertex is at the right [rad]
std::unique_ptr<RigidBody> rolling_wheel(int sides, double turned, double dt)
{
    SurfaceMesh mesh = chapter06::prism(sides, RollingWheel::radius, RollingWheel::radius / 2);
    for (Vec3& vertex : mesh.vertices)
        vertex = Eigen::AngleAxisd(turned, Vec3::UnitZ()) * vertex;
    auto wheel = std::make_unique<RigidBody>("wheel", mesh, with_mass(mass_properties(mesh, 1), 1),
                                             Vec3(RollingWheel::speed, 0, 0),
                                             Vec3(0, 0, -RollingWheel::spin));
    wheel->predict(Vec3::Zero(), dt);
    return wheel;
}

/// The lever of a vertex, as the solver takes it for an impulse at this moment of the step [m].
Vec3 lever_of(const RigidBody& wheel, int vertex, double tau)
{
    const std::array touched{vertex};
    const auto rate = wheel.contact_motion(touched, 0, tau).rate;
    return {rate(1, 5), -rate(0, 5), 0};  // what a unit turn about z makes of the vertex
}

/// The vertex of one end of the wheel that is lowest at the end of the step.
int lowest_at_end(const RigidBody& wheel, int sides)
{
    const auto begin = wheel.positions_t1().begin();
    const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
    return static_cast<int>(std::min_element(begin, begin + sides, lower) - begin);
}

struct StepMoment {
    const char* name;
    double tau;
};
constexpr std::array step_moments{StepMoment{"start", 0}, StepMoment{"middle", 0.5}, StepMoment{"end", 1}};

/// The wheel of the drawing: twelve vertices, one of which comes to the bottom, and a turn that can be seen.
Table drawn_levers()
{
    constexpr int sides = 12;
    constexpr double turn = 40 * std::numbers::pi / 180, dt = turn / RollingWheel::spin;
    const auto wheel = rolling_wheel(sides, turn, dt);
    const int carrying = lowest_at_end(*wheel, sides);
    Table table({"tau", "vertex", "carries", "x", "y"});
    for (const StepMoment& moment : step_moments)
        for (int vertex = 0; vertex < sides; ++vertex) {
            const Vec3 lever = lever_of(*wheel, vertex, moment.tau) / RollingWheel::radius;
            table.add({moment.tau, static_cast<long>(vertex), static_cast<long>(vertex == carrying),
                       lever.x(), lever.y()});
        }
    return table;
}

}  // namespace

double mean_ahead(double tau, double dt)
{
    constexpr int sides = 64, turns = 1000;
    double sum = 0;
    for (int i = 0; i < turns; ++i) {
        const auto wheel = rolling_wheel(sides, 2 * std::numbers::pi / sides * (i + 0.5) / turns, dt);
        sum += lever_of(*wheel, lowest_at_end(*wheel, sides), tau).x();
    }
    return sum / turns;
}

/// A wheel rolls: where is the vertex that carries it, in which moment of the step, and what do levers of
/// this moment cost?
void levers(const RunOptions&, Report& report)
{
    Table table({"dt_s", "lever_of", "ahead_mm", "by_formula_mm", "lost_j"});
    for (const double dt : {1.0 / 60, 1.0 / 240})
        for (const auto& [name, tau] : step_moments) {
            const double ahead = mean_ahead(tau, dt);
            const double by_formula = (1 - tau) * RollingWheel::radius * std::sin(RollingWheel::spin * dt);
            const double braking = 9.81 * dt *
                                   ahead;  // what the weight takes from the angular momentum [N m s]
            table.add({dt, std::string(name), 1e3 * ahead, 1e3 * by_formula, braking * RollingWheel::spin});
        }
    report.table("levers", table);
    report.page_table("levers", table);
    report.table("levers_drawn", drawn_levers());
    report.plot("chapters/07_implicit_contact/plots/levers.gp");
}

}  // namespace enduring::chapter07
