#include "chapters/07_implicit_contact/experiments/spinning.hpp"

#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace enduring::chapter07 {

Scene spinning_box(double turn, double dt, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<double>(random()) / std::mt19937::max(); };  // 0 to 1
    const auto direction = [&] {
        const double x = number(), y = number(), z = number();
        return Vec3(Vec3(x, y, z) - Vec3::Constant(0.5)).normalized();
    };
    const double flat = 0.2 + 0.8 * number(), narrow = 0.2 + 0.8 * number(), mass = 1 + 99 * number();
    Box below{10, Vec3(0, 0.5, 0)}, spinning{mass, Vec3(0.2, 1.9, 0.1), 90 * number(), direction()};
    spinning.size = Vec3(1, flat, narrow);
    spinning.spin = turn / dt * direction();
    return scene_of({below, spinning}, dt, 0, 0.5, 0.5);
}

double most_energy(Scene scene, double most_turn, SolveStatistics& solves)
{
    Solver solver = counting_solver(solves)(scene.contact);
    solver.most_turn = most_turn;
    Contacts contacts;
    const double first = total_energy(scene.world).total();
    double most = 0;
    for (int i = 0; i < 50; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        most = std::max(most, total_energy(scene.world).total() / first);
    }
    return most;
}

/// Boxes that turn far in a step land on a box: with whole steps, and with steps in parts.
void spinning(const RunOptions& options, Report& report)
{
    constexpr double whole = std::numeric_limits<double>::infinity();
    const unsigned seeds = options.quick ? 10 : 50;
    GrowingTable table(report, "spinning",
                       {"turn_rad", "most turn", "runs", "gain", "most_energy", "unconverged", "solves"},
                       6 * 4);
    std::map<double, double> most_of;  // by the most turn, of all runs
    for (const double turn : {0.2, 0.5, 1.0, 2.0, 3.0, 6.0})
        for (const double most_turn : {whole, 1.0, 0.5, 0.25}) {
            SolveStatistics solves;
            long gains = 0;
            double most = 0;
            for (unsigned seed = 1; seed <= seeds; ++seed) {
                const double dt = seed % 2 == 0 ? 0.01 : 1.0 / 60;
                const double energy = most_energy(spinning_box(turn, dt, seed), most_turn, solves);
                gains += energy > 1.001;
                most = std::max(most, energy);
            }
            table.add({turn, most_turn == whole ? Cell("whole steps") : Cell(most_turn),
                       static_cast<long>(seeds), gains, most, solves.unconverged, solves.solves});
            most_of[most_turn] = std::max(most_of[most_turn], most);
        }
    report.table("spinning", table);
    report.page_table("spinning", table, 2);
    report.fact("spinning", "whole_most", most_of[whole], 2);
    report.fact("spinning", "parts_gain", std::max(0.0, most_of[0.5] - 1), 1);
}

}  // namespace enduring::chapter07
