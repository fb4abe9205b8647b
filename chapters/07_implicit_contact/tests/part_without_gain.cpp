#include "chapters/07_implicit_contact/part_without_gain.hpp"
#include "chapters/07_implicit_contact/tests/cube_above_plane.hpp"
#include "chapters/07_implicit_contact/tests/only_island.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE(
    "part without gain: of impulses that are too large, pairs give what leaves no more than bodies and springs had")
{
    for (const double load : {0.0, 300.0})
        for (const double times : {0.5, 2.5, 1000.0}) {
            const double dt = 0.01, speed = 2, k = 1e6;
            World world = cube_above_plane(0, dt, 1, Vec3(0, -speed, 0));
            const std::vector<int> lower = lower_corners(*world.bodies[0]);
            Contacts contacts;
            for (const int corner : lower) {
                contacts.push_back(corner_on_plane(corner));
                contacts.back().spring.stiffness = k;
                contacts.back().spring.load = load;
            }
            StepProblem step = set_up_only_island(world, contacts, {}, {}, {1, dt}, false);
            Eigen::VectorXd impulses(3 * lower.size());
            for (std::size_t i = 0; i < lower.size(); ++i)  // once would stop the cube
                impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) = times * corner_mass * speed *
                                                                        Vec3::UnitY();
            apply_impulses(world, step, impulses);
            const double part = part_without_gain(world, step);
            update_kinematics(world, step);
            apply_impulses(world, step, part * impulses);
            const double upwards = world.bodies[0]->mean_velocity().y(),
                         pushed = part * times * corner_mass * speed / dt,
                         held = 0.5 * 10 * upwards * upwards + 4 * 0.5 * pushed * pushed / k,
                         before = 0.5 * 10 * speed * speed + 4 * 0.5 * load * load / k;
            CAPTURE(load);
            CAPTURE(times);
            CHECK((part == 1) == (times < 1));
            CHECK(held <= before * (1 + 1e-9));
            if (part < 1)
                CHECK(held == doctest::Approx(before));
        }
}
