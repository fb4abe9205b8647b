#include "chapters/08_speculative_contacts/contact_search.hpp"
#include "chapters/08_speculative_contacts/feature_cones.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

constexpr double dt = 0.01;

void add_static(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "fixed", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

void predict(World& world)
{
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
}

/// Of the second of two bodies, the edges that the search looks at.
std::set<int> edges_looked_at(const World& world)
{
    ContactSearch search;
    search.find(world, {}, dt);
    std::set<int> edges;
    search.visit_candidates([](int, int, int, int) {},
                            [&](int, int, int body_b, int edge_b) {
                                REQUIRE(body_b == 1);
                                edges.insert(edge_b);
                            });
    return edges;
}

}  // namespace

TEST_CASE("contact search: of a rigid body the edges that are convex are looked at, whatever lies around it")
{
    for (const SurfaceMesh& mesh : {box(Vec3::Ones()), prism_over_l()}) {
        World world;
        // its long edge leads from corner to corner of a box around the body
        add_static(world, placed(hinge(-0.5), 12, Quaternion::FromTwoVectors(Vec3::UnitZ(), Vec3::Ones()),
                                 Vec3::Constant(-3.5)));
        world.bodies.push_back(std::make_unique<RigidBody>("body", mesh, mass_properties(mesh, 1000)));
        predict(world);
        const SurfaceMoment surface = surface_at(*world.bodies[1], 0);
        std::set<int> convex;
        for (int edge = 0; edge < static_cast<int>(surface.step.topology.edges().size()); ++edge)
            if (fold_at_edge(surface, edge) < -search_parts.least_fold)
                convex.insert(edge);
        CHECK(convex.size() < surface.step.topology.edges().size());
        CHECK(edges_looked_at(world) == convex);
    }
}

TEST_CASE("contact search: an edge of a sheet that is flat at first has a pair when the sheet has folded")
{
    World world;
    world.gravity.setZero();
    // a ridge that hangs across the sheet's inner edge
    add_static(world, placed(hinge(-0.5), 1,
                             Quaternion(Eigen::AngleAxisd(std::numbers::pi, Vec3(1, 0, 1).normalized())),
                             Vec3(-0.5, 1e-5, 0.5)));
    const SurfaceMesh flat = hinge(0);
    auto sheet = std::make_unique<PointMasses>("sheet", flat.vertices, flat.faces, 1.0);
    PointMasses& points = *sheet;
    world.bodies.push_back(std::move(sheet));
    ContactSearch search;
    const auto meets_inner_edge = [&] {
        predict(world);
        const Contacts found = search.find(world, {}, dt);
        return std::any_of(found.begin(), found.end(), [](const Contact& contact) {
            return contact.kind == ContactKind::edge_edge && contact.body_b == 1 && contact.feature_b == 0;
        });
    };
    CHECK_FALSE(meets_inner_edge());
    for (const int wing : {2, 3})
        points.set_velocity(wing, Vec3(0, -0.4 / dt, 0));
    predict(world);
    points.commit(dt);
    for (const int wing : {2, 3})
        points.set_velocity(wing, Vec3::Zero());
    CHECK(meets_inner_edge());
}
