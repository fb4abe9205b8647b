#include "common/geometry/tests/complaint.hpp"
#include "common/input/source_directory.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/scenes/tests/steps.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

/// A box of 2 x 1 x 1 m whose file names its ends, in its corner at the origin, and a puck.
const std::string text = R"({
  "name": "soft", "gravity": [0, 0, 0], "dt": 0.01, "duration": 1,
  "bodies": [
    {"name": "bar", "type": "deformable", "shape": {"file": "groups_order1_v41.msh"}, "mass": 40, "young": 1e5, "poisson": 0.3,
     "impulse_response": "implicit", "position": [0, 5, 0]},
    {"name": "puck", "type": "rigid", "shape": {"box": {"size": [0.2, 0.1, 0.2]}}, "mass": 2, "position": [0.3, 0, 0]}
  ]
})";

Scene soft(const std::string& patch = "")
{
    return read_scene(text, patch, "soft.json",
                      {{source_directory() / "common/geometry/fuzz/seeds/gmsh_reader"}, {}});
}

std::string complaint(const std::string& patch)
{
    return complaint_of([&] { soft(patch); });
}

const ElasticBody& bar_of(const Scene& scene)
{
    return dynamic_cast<const DeformableBody&>(*scene.world.bodies[0]).elastic();
}

}  // namespace

TEST_CASE(
    "scene: a group of the mesh file chooses nodes, with the middles of its edges, and beside a box those in both")
{
    for (const std::string basis : {"linear", "quadratic"}) {
        CAPTURE(basis);
        Scene scene = soft(R"({"/bodies/bar": {"basis": ")" + basis + R"(", "fixed": {"group": "left end"},
            "driven": [{"group": "right", "max": [9, 0.6, 9], "motion": {"velocity": [0, 0, 1]}}]}})");
        const NodalVectors start = bar_of(scene).positions();
        step(scene, 10);
        int fixed = 0, driven = 0;
        for (int node = 0; node < bar_of(scene).node_count(); ++node) {
            const Vec3 from = start.col(node), way = bar_of(scene).positions().col(node) - from;
            if (from.x() < 1e-9 && ++fixed)
                CHECK(way.isZero(0));
            else if (from.x() > 2 - 1e-9 && from.y() < 5.6 && ++driven)
                CHECK((way - Vec3(0, 0, 0.1)).norm() < 1e-12);
            else
                CHECK(!way.isZero(0));
        }
        CHECK(fixed == (basis == "linear" ? 5 : 13));
        CHECK(driven == (basis == "linear" ? 3 : 8));
    }
}

TEST_CASE("scene: nodes are held until a time, those that stay and those that move")
{
    Scene scene = soft(R"({"/bodies/bar": {"fixed": {"group": "left end", "until": 0.1},
        "driven": [{"group": "right", "motion": {"velocity": [1, 0, 0]}, "until": 0.05}]}})");
    const NodalVectors start = bar_of(scene).positions();
    const auto way = [&](const Vec3& of) {
        for (int node = 0; node < bar_of(scene).node_count(); ++node)
            if ((start.col(node) - of).norm() < 1e-9)
                return Vec3(bar_of(scene).positions().col(node) - of);
        return Vec3(9, 9, 9);
    };
    const Vec3 left(0, 5, 0), right(2, 5, 0);
    step(scene, 5);
    CHECK((way(right) - Vec3(0.05, 0, 0)).norm() < 1e-12);
    step(scene, 5);
    CHECK((way(right) - Vec3(0.1, 0, 0)).norm() > 1e-3);
    CHECK(way(left).isZero(0));
    step(scene, 5);
    CHECK(way(left).norm() > 1e-4);
}

TEST_CASE("scene: a force acts at a point of a soft body, or on a region of it, by mass")
{
    Scene scene = soft(R"({"/bodies/bar/forces": [
        {"force": [0, 0, 8], "point": [0.25, 0.5, 0.5]}, {"force": [0, 4, 0], "group": "right"},
        {"table": [{"time": 0, "force": [2, 0, 0]}, {"time": 1, "force": [2, 0, 0]}], "min": [1.9, -1, -1]}]})");
    step(scene, 5);
    const Body& bar = *scene.world.bodies[0];
    CHECK((bar.linear_momentum() - 0.05 * Vec3(2, 4, 8)).norm() < 1e-9);
    // levers from the centre, (1, 0.5, 0.5): -0.75 along x of the first, 1 of the other two
    CHECK((bar.angular_momentum({1, 5.5, 0.5}) - 0.05 * Vec3(0, 0.75 * 8, 4)).norm() < 2e-3);
    CHECK(scene.world.driven > 0);
}

TEST_CASE("scene: a spring between a body and the world swings a puck")
{
    Scene scene = soft(R"({"/bodies/puck/forces": [{"spring": {"anchor": [0, 0, 0], "stiffness": 50}}]})");
    const double omega = std::sqrt(50 / 2.0);
    for (int i = 0; i < 100; ++i) {
        step(scene, 1);
        CHECK(std::abs(scene.world.bodies[1]->centre().x() - 0.3 * std::cos(omega * scene.world.time)) <
              0.02);
    }
}

TEST_CASE("scene: mistakes in what holds and pulls soft bodies, and in springs, are named with their place")
{
    CHECK(
        complaint(R"({"/bodies/bar/fixed": {"group": "lid"}})") ==
        "soft.json: /bodies/0/fixed/group: the shape has no group \"lid\"; it has \"all\", \"corner\", \"left end\", \"right\", \"rim\"");
    CHECK(complaint(R"({"/bodies/bar": {"shape": {"bar": {"size": [1, 1, 1]}}, "fixed": {"group": "lid"}}})")
              .find("soft.json: /bodies/0") == 0);
    CHECK(complaint(R"({"/bodies/bar/fixed": {"group": 3}})")
              .find("soft.json: /bodies/0/fixed/group: expected") == 0);
    CHECK(complaint(R"({"/bodies/bar/fixed": {"group": "rim", "max": [0, 9, 9]}})") ==
          "soft.json: /bodies/0/fixed: no node of the shape lies in this region");
    CHECK(complaint(R"({"/bodies/bar/fixed": {"group": "rim", "until": 0}})") ==
          "soft.json: /bodies/0/fixed/until: expected a number above 0 up to 3600 [s], found 0");
    CHECK(complaint(R"({"/bodies/bar/driven": [{"group": "rim", "motion": {}, "until": "never"}]})")
              .find("soft.json: /bodies/0/driven/0/until: expected a number") == 0);
    CHECK(complaint(R"({"/bodies/bar/forces": [{"force": [1, 0, 0], "point": [3, 0, 0]}]})") ==
          "soft.json: /bodies/0/forces/0/point: lies outside of the body");
    CHECK(
        complaint(R"({"/bodies/bar/forces": [{"force": [1, 0, 0], "point": [1, 0, 0], "group": "rim"}]})") ==
        "soft.json: /bodies/0/forces/0/point: stands beside a region of nodes; one of the two is enough");
    CHECK(
        complaint(R"({"/bodies/bar/forces": [{"torque": [1, 0, 0]}]})") ==
        "soft.json: /bodies/0/forces/0/torque: a soft body does not turn as a whole; give forces at two of its points");
    CHECK(
        complaint(R"({"/bodies/bar/forces": [{"force": [1, 0, 0], "axes": "body"}]})") ==
        "soft.json: /bodies/0/forces/0/axes: a soft body has no axes that turn along; its forces are in the world's");
    CHECK(complaint(R"({"/bodies/bar/forces": [{"spring": {}}]})") ==
          "soft.json: /bodies/0/forces/0/spring: pulls rigid bodies only");
    CHECK(complaint(R"({"/bodies/puck/forces": [{"spring": {"anchor": [0, 0, 0]}}]})") ==
          "soft.json: /bodies/1/forces/0/spring: the key \"stiffness\" is missing");
    CHECK(
        complaint(R"({"/bodies/puck/forces": [{"spring": {"anchor": [0, 0, 0], "stiffness": 21000}}]})") ==
        "soft.json: /bodies/1/forces/0/spring/stiffness: is too stiff for steps of 0.01 s by 1000 N/m; make dt shorter");
    CHECK(complaint(R"({"/bodies/puck/forces": [{"spring": {"anchor": [0, 0, 0], "stiffness": 12000}},
        {"spring": {"anchor": [1, 0, 0], "stiffness": 12000}}]})")
              .find("soft.json: /bodies/1/forces/1/spring/stiffness: is too stiff") == 0);
}
