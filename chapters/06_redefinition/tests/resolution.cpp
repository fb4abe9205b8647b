#include "chapters/06_redefinition/resolution.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/solver.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <memory>

using namespace enduring;
using namespace enduring::small_worlds;

namespace {

/// An open surface of two ridges along z: over x from -2 to 2 its height goes 0, 0.8, 0, 0.8, 0.
SurfaceMesh two_ridges()
{
    SurfaceMesh mesh = plane_grid(4, 2, {4, 1});
    for (Vec3& x : mesh.vertices)
        x.y() = std::abs(std::abs(x.x()) - 1) < 0.5 ? 0.8 : 0;
    return mesh;
}

double middle_x(const World& world, const Contact& contact)
{
    double sum = 0;
    for (const std::size_t i : {1u, 2u, 3u})
        sum += world.bodies[0]->positions_t0()[contact.vertices[i]].x() / 3;
    return sum;
}

}  // namespace

TEST_CASE(
    "resolution: a vertex that enters by the top of a box and leaves by its side is let go, and chapter 5 still pushes it")
{
    // In at (0.4, 0.5), out at x = 0.5 after 0.05 s, 5 mm below the top.
    for (const bool redefined : {true, false}) {
        CAPTURE(redefined);
        const double dt = 0.02;
        World world = tip_and(box({1, 1, 1}), {0.38, 0.502, 0.1}, {2, -0.1, 0});
        Contacts contacts;
        const ContactParameters weak{PenaltyMethod::continuous, 1e-6};
        const Solver solver = redefined ? chapter06_solver(weak) : chapter05_solver(weak);
        std::vector<std::size_t> alive;
        double pushed_outside = 0;
        for (int step = 0; step < 8; ++step) {
            const bool outside = tip_place(world).x() > 0.5;
            advance(world, contacts, solver, dt);
            alive.push_back(of_tip(contacts).size());
            for (const Contact& contact : of_tip(contacts))
                pushed_outside += outside ? contact.impulse.norm() : 0;
        }
        CHECK(alive[2] == 1);
        CHECK(alive[7] == (redefined ? 0 : 1));
        CHECK((pushed_outside == 0) == redefined);
    }
}

TEST_CASE(
    "resolution: an edge pair below its face ends when an edge has no end inside and pierces nothing, and not before (6.2.1)")
{
    struct Lies {
        double height;  ///< of the lower edge of a sheet through a box whose top is at 0.5 [m]
        double reach;   ///< that edge goes from -reach to reach; the box from -0.5 to 0.5 [m]
        bool end_pair;  ///< one of its ends has a pair with the box
        bool ends;
    };
    for (const Lies& lies : {Lies{0.4, 1, false, false}, Lies{0.6, 1, false, true},
                             Lies{0.4, 0.3, true, false}, Lies{0.4, 0.3, false, true}})
        for (const bool sheet_is_a : {true, false}) {
            CAPTURE(lies.height);
            CAPTURE(lies.reach);
            CAPTURE(sheet_is_a);
            World world;
            world.bodies.push_back(still("box", box({1, 1, 1})));
            const std::vector<Vec3> sheet{
                {-lies.reach, lies.height, 0}, {lies.reach, lies.height, 0}, {0, 3, 0}};
            world.bodies.push_back(
                std::make_unique<PointMasses>("sheet", sheet, std::vector<Face>{{0, 1, 2}}, 1.0));
            const auto edges = world.bodies[1]->surface().edges();
            const int lower =
                static_cast<int>(std::find(edges.begin(), edges.end(), Edge{0, 1}) - edges.begin());
            const int of_box = 0, box_end = world.bodies[0]->surface().edges()[0][0];
            // The box' own edge has an end with a pair, so it is the sheet's edge that decides.
            Contacts contacts{{ContactKind::vertex_face,
                               0,
                               1,
                               box_end,
                               0,
                               {box_end, 0, 1, 2},
                               {1, -1 / 3.0, -1 / 3.0, -1 / 3.0}}};
            if (lies.end_pair)
                contacts.push_back(
                    {ContactKind::vertex_face, 1, 0, 0, 0, {0, 0, 1, 2}, {1, -1 / 3.0, -1 / 3.0, -1 / 3.0}});
            Contact pair;
            pair.kind = ContactKind::edge_edge;
            pair.body_a = sheet_is_a ? 1 : 0;
            pair.body_b = sheet_is_a ? 0 : 1;
            pair.feature_a = sheet_is_a ? lower : of_box;
            pair.feature_b = sheet_is_a ? of_box : lower;
            contacts.push_back(pair);
            CandidateSearch search;
            search.find_candidates(world);
            resolve_edges_that_left(world, search, contacts);
            CHECK(contacts.back().resolved == lies.ends);
        }
}

TEST_CASE("resolution: a vertex whose entry impulses have undone has no pair in the next step")
{
    const double dt = 0.1;
    World world = tip_and(plane_grid(2, 2, {2, 2}), {0.3, 1e-3, 0.2}, {0, -0.02, 0});
    Contacts contacts;
    const Solver solver = weak_solver(5000);  // k dt^2 / m = 50: thrown back within the step
    advance(world, contacts, solver, dt);
    REQUIRE(tip_place(world).y() > 0);
    contacts = of_tip(contacts);
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].impulse.y() > 0);  // the probes see what it gave
    CHECK(contacts[0].resolved);
    advance(world, contacts, solver, dt);
    CHECK(of_tip(contacts).empty());
}

TEST_CASE(
    "resolution: a vertex that leaves one ridge and enters the next in one step has a pair with the next")
{
    World world = tip_and(two_ridges(), {-1.2, 0.4, 0.1}, {20, 0, 0});
    Contacts contacts;
    for (int face = 0; face < 8; ++face)
        if (contacts.empty()) {
            Contacts trial{on_face(world, face)};
            Redefinitions redefinitions;
            redefine_enduring_vertices(world, trial, redefinitions);
            if (redefinitions.empty() && !trial[0].resolved)
                contacts = trial;
        }
    REQUIRE(contacts.size() == 1);
    REQUIRE(middle_x(world, contacts[0]) < 0);

    advance(world, contacts, weak_solver(), 0.1);  // from x = -1.2 to 0.8
    contacts = of_tip(contacts);
    const auto alive = [](const Contact& c) { return !c.resolved; };
    REQUIRE(std::count_if(contacts.begin(), contacts.end(), alive) == 1);
    const Contact& contact = *std::find_if(contacts.begin(), contacts.end(), alive);
    CHECK(middle_x(world, contact) > 0);
    CHECK(contact_geometry(world, contact, 0).depth < 0);
}

TEST_CASE("resolution: a vertex that leaves through its own face is let go at once, one that stays is not")
{
    for (const double speed : {0.5, 2.0}) {
        CAPTURE(speed);
        World world = tip_and(box({1, 1, 1}), {0.1, 0.4, 0.15}, {0, speed, 0});
        Contacts contacts;
        for (int face = 0; face < 12 && contacts.empty(); ++face) {
            Contacts trial{on_face(world, face)};
            Redefinitions redefinitions;
            redefine_enduring_vertices(world, trial, redefinitions);
            if (redefinitions.empty() && contact_geometry(world, trial[0], 0).normal.y() > 0.9)
                contacts = trial;
        }
        REQUIRE(contacts.size() == 1);
        advance(world, contacts, weak_solver(), 0.1);
        contacts = of_tip(contacts);
        REQUIRE(contacts.size() == 1);
        CHECK(contacts[0].resolved == (speed > 1));
    }
}

TEST_CASE(
    "resolution: a vertex that grazes a ridge, in by one side and out by the other at once, counts as inside")
{
    // The ridge lies along z in y = 0; the vertex passes it at mid-step.
    const SurfaceMesh roof{{{0, 0, -1}, {0, 0, 1}, {-2, -2, 0}, {2, -2, 0}}, {{0, 2, 1}, {0, 1, 3}}};
    World world = tip_and(roof, {-1, 0, 0.1}, {2, 0, 0});
    world.bodies[1]->predict(Vec3::Zero(), 1);
    CandidateSearch search;
    search.find_candidates(world);
    Contacts contacts{on_face(world, 0)};
    contacts[0].start = 0.5;
    Redefinitions redefinitions;
    resolve_vertices_that_left(world, search, contacts, redefinitions);
    CHECK(contacts.size() == 1);
    CHECK_FALSE(contacts[0].resolved);
}

namespace {

/// The pair of an upright edge of body 0, which pierces body 1 where that stays, and the edge of body 1
/// between its vertices 0 and 1, which pierces nothing.
struct PiercedSheet {
    World world;
    CandidateSearch search;
    Contacts contacts;

    explicit PiercedSheet(double rise)
    {
        world.bodies.push_back(
            std::make_unique<PointMasses>("upright", std::vector<Vec3>{{0, -1, 0}, {0, 1, 0}, {-1, 1, 0}},
                                          std::vector<Face>{{0, 1, 2}}, 1, Vec3(0, rise, 0)));
        world.bodies.push_back(still("sheet", {{{-3, 0, -1}, {2, 0, -1}, {0, 0, 3}}, {{0, 2, 1}}}));
        world.bodies[0]->predict(Vec3::Zero(), 1);
        search.find_candidates(world);
        const auto edge = [&](std::size_t body) {
            const auto edges = world.bodies[body]->surface().edges();
            return static_cast<int>(std::find(edges.begin(), edges.end(), Edge{0, 1}) - edges.begin());
        };
        contacts.push_back({ContactKind::edge_edge, 0, 1, edge(0), edge(1), {0, 1, 0, 1}});
    }
    bool resolved()
    {
        resolve_edges_that_left(world, search, contacts);
        return contacts[0].resolved;
    }
    void touch(int vertex_of_sheet)
    {
        contacts.push_back({ContactKind::vertex_face, 1, 0, vertex_of_sheet, 0});
    }
};

}  // namespace

TEST_CASE("resolution: an edge pair ends when either edge is outside, and one with an end in contact is not")
{
    CHECK(PiercedSheet(0).resolved());  // edge B pierces nothing
    for (const int end : {0, 1}) {
        CAPTURE(end);
        PiercedSheet held(0);
        held.touch(end);
        CHECK_FALSE(held.resolved());
        PiercedSheet risen(5);  // edge A pierces nothing any more at the end of the step
        risen.touch(end);
        CHECK(risen.resolved());
    }
}
