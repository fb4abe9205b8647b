#include "chapters/09_deep_contacts/neighbours.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

namespace {

/// Body 0 is a flat grid that faces up, body 1 a box from x = -3 to x = 1 around it. A vertex of the grid
/// that the box's front pushes, towards +x, is hooked by its own normals.
struct Sheet {
    World world;
    int front = -1, top = -1;  ///< faces of the box

    Sheet()
    {
        add(plane_grid(2, 2, {4, 4}));
        SurfaceMesh mesh = box({4, 4, 4});
        for (Vec3& x : mesh.vertices)
            x.x() -= 1;
        add(mesh);
        for (int face = 0; face < static_cast<int>(mesh.faces.size()); ++face) {
            const auto [a, b, c] = mesh.faces[face];
            const Vec3 normal =
                (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized();
            front = normal.x() > 0.9 ? face : front;
            top = normal.y() > 0.9 ? face : top;
        }
    }
    void add(const SurfaceMesh& mesh)
    {
        world.bodies.push_back(std::make_unique<StaticBody>(
            "body", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
    }
    Contact pair(int vertex, int face, ContactCategory category) const
    {
        const Face& f = world.bodies[1]->surface().faces()[face];
        Contact contact{ContactKind::vertex_face, 0, 1, vertex, face, {vertex, f[0], f[1], f[2]},
                        {1, -0.5, -0.5, 0}};
        contact.category = category;
        return contact;
    }
    int vertex_at(double x, double z) const
    {
        const auto positions = world.bodies[0]->positions_t0();
        for (int i = 0; i < static_cast<int>(positions.size()); ++i)
            if ((positions[i] - Vec3(x, 0, z)).norm() < 1e-9)
                return i;
        return -1;
    }
};

}  // namespace

TEST_CASE("neighbours: their direction is the mean of those that push already, and none where none does")
{
    const Sheet sheet;
    const int vertex = sheet.vertex_at(0, 0), beside = sheet.vertex_at(0.5, 0),
              above = sheet.vertex_at(0, 0.5);
    const Contact asks = sheet.pair(vertex, sheet.front, ContactCategory::hooked);
    Contacts contacts{asks};
    CHECK(!direction_of_neighbours(sheet.world, contacts, asks, 0));
    contacts.push_back(sheet.pair(beside, sheet.front, ContactCategory::regular));
    CHECK((*direction_of_neighbours(sheet.world, contacts, asks, 0) - Vec3::UnitX()).norm() < 1e-12);
    contacts.push_back(sheet.pair(above, sheet.top, ContactCategory::regular));
    const Vec3 mean = Vec3(1, 1, 0).normalized();
    CHECK((*direction_of_neighbours(sheet.world, contacts, asks, 0) - mean).norm() < 1e-12);

    for (const auto& [what, silence] :
         {std::pair<const char*, void (*)(Contact&)>{"held", [](Contact& c) { c.hold(true); }},
          {"resolved", [](Contact& c) { c.resolved = true; }},
          {"hooked", [](Contact& c) { c.category = ContactCategory::hooked; }},
          {"new", [](Contact& c) { c.start = 0.5; }}}) {
        const std::string name = what;
        CAPTURE(name);
        Contacts changed = contacts;
        silence(changed[2]);
        CHECK((*direction_of_neighbours(sheet.world, changed, asks, 0) - Vec3::UnitX()).norm() < 1e-12);
    }
    // Not at the other end of an edge: it has no say.
    CHECK(!direction_of_neighbours(
        sheet.world, {asks, sheet.pair(sheet.vertex_at(1, 1), sheet.front, ContactCategory::regular)}, asks,
        0));
}

TEST_CASE("neighbours: they vouch for a new pair that pushes as they do, and for no other")
{
    const Sheet sheet;
    const int vertex = sheet.vertex_at(0, 0), beside = sheet.vertex_at(0.5, 0);
    for (const bool agrees : {true, false}) {
        Contact asks = sheet.pair(vertex, sheet.front, ContactCategory::hooked);
        asks.start = 0.5;
        Contacts contacts{asks,
                          sheet.pair(beside, agrees ? sheet.front : sheet.top, ContactCategory::regular)};
        vouch_for_new_pairs(sheet.world, contacts);
        CHECK(contacts[0].category == (agrees ? ContactCategory::regular : ContactCategory::hooked));
    }
}

TEST_CASE("neighbours: a pair that endures and is vouched for stays, acts at its foot and is not held")
{
    const Sheet sheet;
    const int vertex = sheet.vertex_at(0, 0), beside = sheet.vertex_at(0.5, 0);
    Contacts contacts{sheet.pair(vertex, sheet.front, ContactCategory::hooked),
                      sheet.pair(beside, sheet.front, ContactCategory::regular)};
    contacts[0].hold(true);
    contacts[1].category = ContactCategory::regular;
    const auto vouched = take_vouched_pairs(sheet.world, contacts);
    // Both look hooked on a flat sheet. The held one has a neighbour that pushes; the other has none.
    REQUIRE(vouched.size() == 1);
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].feature_a == beside);
    follow_vouched_pairs(sheet.world, vouched, contacts);
    REQUIRE(contacts.size() == 2);
    const Contact& back = contacts[1];
    CHECK(back.feature_a == vertex);
    CHECK(back.category == ContactCategory::regular);
    CHECK(back.waiting());
    const auto positions = sheet.world.bodies[1]->positions_t0();
    Vec3 foot = Vec3::Zero();
    for (std::size_t i = 1; i < 4; ++i)
        foot -= back.weights[i] * positions[back.vertices[i]];
    CHECK((foot - Vec3(1, 0, 0)).norm() < 1e-12);
}

namespace {

/// Most of the cube's kinetic energy after the ram, over that at first.
double most_energy(const Solver& solver, double speed)
{
    Scene scene = load_scene(scene_file("deep"),
                             R"({"/bodies/cube/velocity": [)" + std::to_string(speed) + ", 0, 0]}");
    double before = 0, most = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const double energy = body_named(world, "cube").energy(world.gravity).kinetic;
        before = world.step == 0 ? energy : before;
        most = std::max(most, energy / before);
    });
    run(scene, solver, {&watch}, failure_on_purpose());
    return most;
}

}  // namespace

TEST_CASE("neighbours: a cube that rams a block gains no energy if pairs ask, and does with chapter 6 alone")
{
    const ContactParameters contact = load_scene(scene_file("deep")).contact;
    for (const double speed : {0.5, 3.0, 5.0, 10.0}) {
        CAPTURE(speed);
        CHECK(most_energy(asking_neighbours(chapter06_solver(contact)), speed) <= 1 + 1e-9);
        CHECK(most_energy(chapter09_solver(contact), speed) <= 1 + 1e-9);
    }
    CHECK(most_energy(chapter06_solver(contact), 3) > 2);
}
