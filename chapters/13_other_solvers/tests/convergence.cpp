#include "chapters/11_exact_contact/solver.hpp"
#include "chapters/13_other_solvers/tests/small_scenes.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace enduring;

namespace {

/// A cube slides at 1 m/s on another one, which its friction cannot move.
Scene slide_on_a_cube()
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.5, 0), 0}, {10, Vec3(0, 1.5, 0), 0}}, 0.01, 0, 0.5,
                                      0.5);
    scene.world.bodies[1]->kick({}, (Eigen::VectorXd(6) << 10, 0, 0, 0, 0, 0).finished(), scene.dt);
    return scene;
}

/// Where both cubes are after 0.1 s.
std::array<Vec3, 2> places(const Solver& solver)
{
    Scene scene = slide_on_a_cube();
    run(scene, solver, 0.1);
    return {scene.world.bodies[0]->centre(), scene.world.bodies[1]->centre()};
}

/// The farthest that a cube is from where chapter 11 has it [m].
double gap(const std::array<Vec3, 2>& found)
{
    static const std::array<Vec3, 2> exact = places(chapter11_solver(slide_on_a_cube().contact));
    return std::max((found[0] - exact[0]).norm(), (found[1] - exact[1]).norm());
}

}  // namespace

TEST_CASE(
    "other solvers: with iterations, sequential impulses and AVBD come to chapter 11's exact answer, and the others to their own")
{
    const ContactParameters contact = slide_on_a_cube().contact;
    const std::map<std::string, const OtherMethod*> by_name = [] {
        std::map<std::string, const OtherMethod*> methods;
        for (const OtherMethod& method : other_methods())
            methods[method.name] = &method;
        return methods;
    }();
    const auto left = [&](const std::string& method, int n) {
        return gap(places(by_name.at(method)->make_with(contact, n)));
    };
    const double dt = 0.01, t = 0.1;
    const Vec3 by_law(t - 0.5 * 9.81 * 0.5 * t * (t + dt), 1.5, 0);
    CHECK(gap({Vec3(0, 0.5, 0), by_law}) <= 1e-7);  // so does the formula

    // velocities of the same problem: all of it goes
    CHECK(left("sequential", 8) >= 1e-4);
    CHECK(left("sequential", 128) <= 1e-7);
    // multipliers that take over step by step
    CHECK(left("avbd", 128) <= 0.05 * left("avbd", 8));
    // other problems: the softness and the lift, the gap of the barriers, the spring of a contact, friction
    // by substeps
    CHECK(left("relaxation", 8) == doctest::Approx(left("relaxation", 32)).scale(0).epsilon(1e-3));
    CHECK(left("relaxation", 32) == doctest::Approx(2.85e-3).scale(0).epsilon(0.02));
    CHECK(left("barrier", 64) == doctest::Approx(5.95e-4).scale(0).epsilon(0.02));
    CHECK(left("soft_step", 32) == doctest::Approx(2.56e-3).scale(0).epsilon(0.05));
    CHECK(left("xpbd", 32) == doctest::Approx(6.65e-3).scale(0).epsilon(0.1));
}
