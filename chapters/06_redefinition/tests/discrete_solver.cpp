#include "chapters/06_redefinition/baseline/discrete_solver.hpp"
#include "chapters/06_redefinition/baseline/discrete_detection.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <tuple>

using namespace enduring;

namespace {

/// Everything that discrete detection should find, from every vertex and every face.
std::set<std::tuple<int, int, int>> vertices_inside(const World& world)
{
    std::set<std::tuple<int, int, int>> inside;
    const int count = static_cast<int>(world.bodies.size());
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
            const Body &of_vertices = *world.bodies[a], &of_faces = *world.bodies[b];
            const std::span<const Vec3> positions = of_faces.positions_t1();
            FaceTree tree(of_faces.surface(), positions);
            tree.refit({of_faces.surface(), positions, positions});
            for (int v = 0; a != b && v < of_vertices.surface().vertex_count(); ++v) {
                const Vec3& p = of_vertices.positions_t1()[v];
                const ClosestPoint closest = closest_point(tree, of_faces.surface(), positions, p, 1e300);
                if (pseudonormal(of_faces.surface(), positions, closest).dot(p - closest.point) < 0)
                    inside.insert({a, v, b});
            }
        }
    return inside;
}

/// Two soft or rigid bodies that fall on each other, turning, and nothing else.
Scene collision(const std::string& patch = "")
{
    Scene scene = load_scene(scene_file("bunny_bowl"), patch);
    scene.world.planes.clear();
    return scene;
}

const char* floating = R"({"gravity": [0, 0, 0], "dt": 0.005, "contact": {"stiffness": 2000},
    "/bodies/bunny/shape": {"file": "bunny_363.msh", "scale": 0.1}, "/bodies/bunny/velocity": [0.4, -3, 0.2], "/bodies/bunny/rayleigh": {"mass": 0, "stiffness": 0.02},
    "/bodies/bowl/angular_velocity": [0, 0, 1.5]})";

/// A cube against another, each by its lowest corner, edge or side.
Scene cubes(const Vec3& position, const Vec3& velocity, const std::string& rotation, double height = 1)
{
    const auto text = [](const Vec3& v) { return nlohmann::json{v.x(), v.y(), v.z()}.dump(); };
    return load_scene(scene_file("falling_sphere"),
                      R"({"gravity": [0, 0, 0], "dt": 0.01, "planes": null, "bodies": [
        {"name": "table", "type": "static", "shape": {"box": {"size": [1, )" +
                          std::to_string(height) + R"(, 1]}}},
        {"name": "cube", "type": "rigid", "mass": 1, "shape": {"box": {"size": [1, 1, 1]}}, "position": )" +
                          text(position) + R"(, "velocity": )" + text(velocity) + R"(, "rotation": )" +
                          rotation + R"(}]})");
}

const char* straight = R"({"axis": [0, 1, 0], "angle_deg": 0})";

Contacts after_one_step(Scene& scene)
{
    Contacts contacts;
    advance(scene.world, contacts, discrete_solver(scene.contact), scene.dt);
    return contacts;
}

}  // namespace

TEST_CASE("discrete detection: with clearances it finds what looking at every vertex finds, step by step")
{
    Scene scene = collision(floating);
    DiscreteDetection detection;
    const Solver solver = discrete_solver(scene.contact);
    Contacts contacts;
    std::size_t most = 0;
    for (int step = 0; step < 60; ++step) {
        CAPTURE(step);
        advance(scene.world, contacts, solver, scene.dt);
        Contacts found;
        detection.update_inside_vertices(scene.world, found);
        std::set<std::tuple<int, int, int>> keys;
        for (const Contact& contact : found) {
            keys.insert({contact.body_a, contact.feature_a, contact.body_b});
            CHECK(contact_geometry(scene.world, contact, 1).depth <= 0);
        }
        REQUIRE(keys.size() == found.size());
        REQUIRE(keys == vertices_inside(scene.world));
        most = std::max(most, keys.size());
    }
    CHECK(most > 5);
}

TEST_CASE(
    "discrete solver: a corner below the middle of a side gets k times its depth, along the side's normal")
{
    const double depth = 0.05, k = 1000;
    const char* on_its_corner = R"({"axis": [1, 0, -1], "angle_deg": 54.735610317245346})";
    Scene scene = cubes({0.02, 0.5 + std::sqrt(3.0) / 2 - depth, 0.03}, Vec3::Zero(), on_its_corner);
    scene.contact.stiffness = k;
    const Contacts contacts = after_one_step(scene);
    REQUIRE(contacts.size() == 1);
    CHECK((contacts[0].impulse - Vec3(0, k * depth * scene.dt, 0)).norm() <= 1e-9 * k * scene.dt);
}

TEST_CASE(
    "discrete solver: linear momentum is conserved while a soft body and a rigid one bounce off each other")
{
    Scene scene = collision(floating);
    const Solver solver = discrete_solver(scene.contact);
    Contacts contacts;
    const auto momentum = [&] {
        Vec3 sum = Vec3::Zero();
        for (const auto& body : scene.world.bodies)
            sum += body->linear_momentum();
        return sum;
    };
    const Vec3 before = momentum();
    double pushed = 0;
    for (int step = 0; step < 100; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        for (const Contact& contact : contacts)
            pushed += contact.impulse.norm();
    }
    CHECK(pushed > 10);
    CHECK((momentum() - before).norm() <= 1e-11 * pushed);
}

TEST_CASE("discrete solver: it does not see two edges cross")
{
    // An upright edge's middle of the table against the cube's, turned by
    // 45 degrees: corners of neither are inside.
    const double reach = 0.5 * std::sqrt(2.0);
    Scene scene = load_scene(scene_file("falling_sphere"),
                             R"({"gravity": [0, 0, 0], "dt": 0.01, "planes": null, "bodies": [
        {"name": "table", "type": "static", "shape": {"box": {"size": [1, 1, 3]}}, "rotation": {"axis": [0, 0, 1], "angle_deg": 45}},
        {"name": "cube", "type": "rigid", "mass": 1, "shape": {"box": {"size": [3, 1, 1]}}, "rotation": {"axis": [1, 0, 0], "angle_deg": 45},
         "position": [0, )" + std::to_string(2 * reach - 0.1) +
                                 R"(, 0]}]})");
    CHECK(after_one_step(scene).empty());
}

TEST_CASE("discrete solver: a body that passes a thin one within a step is not seen")
{
    Scene slow = cubes({0.1, 0.55, 0.1}, {0, -4, 0}, straight, 0.05);
    CHECK_FALSE(after_one_step(slow).empty());
    Scene fast = cubes({0.1, 0.55, 0.1}, {0, -400, 0}, straight, 0.05);
    CHECK(after_one_step(fast).empty());
}
