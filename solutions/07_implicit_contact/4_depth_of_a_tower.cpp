#include "exercises/07_implicit_contact/4_depth_of_a_tower.hpp"

#include "chapters/07_implicit_contact/solver.hpp"

#include <cmath>

namespace enduring {

double predicted_factor() { return 100; }

std::vector<double> loads_of(const Tower& tower)
{
    std::vector<double> loads(tower.size());
    double above = 0;
    for (std::size_t joint = tower.size(); joint-- > 0;) {
        above += tower[joint].mass;
        loads[joint] = above * tower_gravity;
    }
    return loads;
}

double mass_of_pair(const Tower& tower, std::size_t joint)
{
    const double lever = tower[joint].radius;
    const auto answer_of = [lever](const TowerPiece& piece) {
        const double inertia = piece.mass *
                               (piece.radius * piece.radius / 8 + piece.height * piece.height / 12);
        return 1 / piece.mass + lever * lever / inertia;
    };
    const double below = joint > 0 ? answer_of(tower[joint - 1]) : 0;
    return 1 / (answer_of(tower[joint]) + below);
}

std::vector<double> law_of_depths(const Tower& tower, const StiffnessChoice& choice, double dt)
{
    std::vector<double> depths;
    for (std::size_t joint = 0; joint < tower.size(); ++joint) {
        const double load = loads_of(tower)[joint] / 3;
        depths.push_back(load / wanted_stiffness(mass_of_pair(tower, joint), load, choice, dt));
    }
    return depths;
}

std::vector<double> measured_depths(const Tower& tower, const StiffnessChoice& choice, double dt,
                                    double seconds)
{
    World world = world_of(tower);
    ImplicitSettings settings;
    settings.stiffness = choice;
    const Solver solver = chapter07_solver({}, settings);
    Contacts contacts;
    for (long step = 0; step < std::lround(seconds / dt); ++step)
        advance(world, contacts, solver, dt);
    std::vector<double> depths;
    double top = 0;
    for (std::size_t i = 0; i < tower.size(); ++i) {
        const double centre = world.bodies[i]->centre().y();
        depths.push_back(top - (centre - tower[i].height / 2));
        top = centre + tower[i].height / 2;
    }
    return depths;
}

}  // namespace enduring
