#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/tests/complaint.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace enduring;

namespace {

/// A scene of these bodies after some seconds under chapter 8's solver.
struct Ran {
    Scene scene;
    Contacts contacts;

    Ran(Scene of, double seconds) : scene(std::move(of))
    {
        const Solver solver = chapter08_solver(scene.contact);
        for (int step = 0; step * scene.dt < seconds; ++step)
            advance(scene.world, contacts, solver, scene.dt);
    }
    const Body& body(const std::string& name) const
    {
        return **std::find_if(scene.world.bodies.begin(), scene.world.bodies.end(),
                              [&](const auto& one) { return one->name() == name; });
    }
    /// What pushes a body, without gravity [N].
    Vec3 push_on(const std::string& name) const
    {
        Vec3 push = Vec3::Zero();
        for (const Contact& contact : contacts) {
            const bool is_a = &body_of_vertex(scene.world, contact, 0) == &body(name);
            const bool is_b = !contact.on_plane() &&
                              scene.world.bodies[static_cast<std::size_t>(contact.body_b)].get() ==
                                  &body(name);
            if (is_a || is_b)
                push += (is_a ? 1 : -1) / scene.dt * (contact.impulse + contact.friction);
        }
        return push;
    }
};

Scene of_bodies(const std::string& bodies)
{
    return read_scene(R"({"name": "frames", "dt": 0.005, "duration": 1, "contact": {"friction": {"model":
        "mass_splitting"}}, "bodies": [)" +
                          bodies + "]}",
                      "", "frames.json", {{"/nowhere"}});
}

const std::string box =
    R"({"name": "box", "type": "static", "shape": {"box": {"size": [1, 1, 1]}}, "position": [0, -0.5, 0]})";

}  // namespace

TEST_CASE("frames: rings of wire hang in each other, a pin lies on two bars, a cloud of points on a box")
{
    const Ran ran(load_scene(scene_file("rings")), 2);
    for (const char* name : {"ring", "pin", "cloud"}) {
        const Body& body = ran.body(name);
        CAPTURE(name);
        CHECK(body.mean_velocity().norm() <= 0.02);
        CHECK((ran.push_on(name) - Vec3(0, 9.81 * body.mass(), 0)).norm() <= 0.05 * 9.81 * body.mass());
    }
    // the hook's lowest edge is in y = -0.483 (0.5 cos 15 degrees), and the ring's highest one hangs in it
    double top = -10;
    for (const Vec3& x : ran.body("ring").positions_t0())
        top = std::max(top, x.y());
    CHECK(top >= -0.484);
    CHECK(top <= -0.475);
    double lowest = 10;  // points on the table's upper side
    for (const Vec3& x : ran.body("cloud").positions_t0())
        lowest = std::min(lowest, x.y());
    CHECK(lowest == doctest::Approx(-0.75).epsilon(1e-3));
}

TEST_CASE("frames: points of a cloud meet faces alone, edges of a wire meet edges, and points no points")
{
    const Ran ran(load_scene(scene_file("rings")), 2);
    std::set<std::string> of_edges, of_vertices;
    for (const Contact& contact : ran.contacts)
        (contact.kind == ContactKind::edge_edge ? of_edges : of_vertices)
            .insert(ran.scene.world.bodies[static_cast<std::size_t>(contact.body_a)]->name() + " " +
                    ran.scene.world.bodies[static_cast<std::size_t>(contact.body_b)]->name());
    CHECK(of_edges.count("hook ring") == 1);
    CHECK(of_edges.count("left bar pin") + of_edges.count("pin left bar") == 1);
    CHECK(of_vertices == std::set<std::string>{"cloud table"});
}

TEST_CASE("frames: a cloud that is fast does not fly through a thin plate, nor a wire through a wire")
{
    Ran shot(of_bodies(R"({"name": "plate", "type": "static", "shape": {"box": {"size": [1, 0.002, 1]}}},
      {"name": "cloud", "type": "rigid", "mass": 1, "position": [0, 0.3, 0], "velocity": [0, -80, 0],
       "shape": {"points": {"vertices": [[-0.1, 0, 0], [0.1, 0, 0], [0, 0, 0.1], [0, 0.1, 0]]}}})"),
             0.05);
    for (const Vec3& x : shot.body("cloud").positions_t0())
        CHECK(x.y() >= 0);
    Ran wires(of_bodies(R"({"name": "rail", "type": "static",
       "shape": {"wire": {"vertices": [[-1, 0, 0], [1, 0, 0]], "edges": [[0, 1]]}}},
      {"name": "needle", "type": "rigid", "mass": 1, "position": [0, 0.3, 0], "velocity": [0, -80, 0],
       "shape": {"wire": {"vertices": [[0, 0, -1], [0, 0, 1]], "edges": [[0, 1]]}}})"),
              0.05);
    for (const Vec3& x : wires.body("needle").positions_t0())
        CHECK(x.y() >= 0);
}

TEST_CASE("frames: what begins in a body is refused, an edge through it and each point for itself")
{
    const std::string through = R"(, {"name": "wire", "type": "rigid", "mass": 1,
       "shape": {"wire": {"vertices": [[-2, -0.5, 0.1], [2, -0.5, 0.1]], "edges": [[0, 1]]}}})";
    const std::string inside = R"(, {"name": "wire", "type": "rigid", "mass": 1,
       "shape": {"points": {"vertices": [[-2, 0.5, 0.1], [2, 0.5, 0.1], [0.1, -0.5, 0.1]]}}})";
    const std::string beside = R"(, {"name": "wire", "type": "rigid", "mass": 1,
       "shape": {"points": {"vertices": [[-2, 0.5, 0.1], [2, 0.5, 0.1], [0.1, 0.5, 0.1]]}}})";
    for (const std::string& frame : {through, inside})
        CHECK(complaint_of([&] {
                  Ran(of_bodies(box + frame), 0.01);
              }).find("'box' and 'wire' begin inside each other") != std::string::npos);
    CHECK_NOTHROW(Ran(of_bodies(box + beside), 0.01));
}

TEST_CASE("frames: a pin that spins across itself keeps its momenta and its energy")
{
    Scene scene = of_bodies(R"({"name": "pin", "type": "rigid", "mass": 2, "angular_velocity": [0, 3, 4],
       "shape": {"wire": {"vertices": [[-0.5, 0, 0], [0.5, 0, 0]], "edges": [[0, 1]]}}})");
    scene.world.gravity.setZero();
    const double inertia = 2.0 / 12;  // m l^2 / 12
    const Body& pin = *scene.world.bodies.front();
    CHECK((pin.angular_momentum(Vec3::Zero()) - inertia * Vec3(0, 3, 4)).norm() <= 1e-12);
    const Ran ran(std::move(scene), 1);
    CHECK((ran.body("pin").angular_momentum(Vec3::Zero()) - inertia * Vec3(0, 3, 4)).norm() <= 1e-9);
    CHECK(ran.body("pin").energy(Vec3::Zero()).kinetic == doctest::Approx(inertia * 25 / 2));
}
