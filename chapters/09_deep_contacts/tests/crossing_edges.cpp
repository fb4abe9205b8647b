#include "chapters/09_deep_contacts/experiments/crossed_beams.hpp"
#include "chapters/09_deep_contacts/experiments/overlap_shape.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/natural_units.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

/// A cube of 1 m, and one on it that is shifted by this, `depth` into it.
struct TwoCubes {
    World world;
    std::vector<Overlap> overlaps;

    TwoCubes(double across_x, double across_z, double depth)
        : TwoCubes(moved(box(Vec3::Ones()), {across_x, 1 - depth, across_z}), box(Vec3::Ones()))
    {}
    TwoCubes(const SurfaceMesh& above, const SurfaceMesh& below)
    {
        for (const SurfaceMesh& cube : {above, below})
            world.bodies.push_back(std::make_unique<StaticBody>(
                "cube", SurfaceTopology(static_cast<int>(cube.vertices.size()), cube.faces), cube.vertices));
        const OverlapShape a(above), b(below);
        overlaps = find_overlaps(a.still(), b.still());
    }
    Contacts pairs(Contacts known = {}) const
    {
        for (const Overlap& overlap : overlaps)
            append_crossing_edges(world, 0, 1, overlap, known);
        return known;
    }
};

}  // namespace

TEST_CASE("crossing edges: where the corners of two cubes lie beside each other their edges get a pair, once")
{
    for (const double shift : {1e-8, 1e-4, 0.1})
        for (const double depth : {1e-5, 1e-3, 0.1})
            for (const double sign : {1.0, -1.0}) {
                CAPTURE(shift);
                CAPTURE(depth);
                const TwoCubes at(shift, sign * shift, depth);
                REQUIRE(at.overlaps.size() == 1);
                const Contacts pairs = at.pairs();
                // these two corners of the shared square are corners of no cube
                int found = 0;
                for (const Contact& pair : pairs) {
                    const ContactGeometry geometry = contact_geometry(at.world, pair, 0);
                    CHECK(geometry.normal.isApprox(Vec3::UnitY()));
                    CHECK(geometry.depth == doctest::Approx(-depth).epsilon(1e-6));
                    CHECK(pair.category == ContactCategory::regular);
                    for (const double side : {1.0, -1.0}) {
                        const Vec3 corner(side > 0 ? 0.5 : shift - 0.5, 0.5,
                                          side > 0 ? sign * (shift - 0.5) : sign * 0.5);
                        found += (geometry.q - corner).norm() < 1e-12;
                    }
                }
                CHECK(found == 2);
                CHECK(at.pairs(pairs).size() == pairs.size());
            }
    CHECK(TwoCubes(0.1, 0.1, -1e-3).overlaps.empty());
}

TEST_CASE(
    "crossing edges: none where they would push into the other body, or where they pass beside each other")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto direction = [&] { return Vec3(number(random), number(random), number(random)).normalized(); };
    int all = 0;
    for (int run = 0; run < 200; ++run) {
        SurfaceMesh above = box(Vec3::Ones());
        const Mat3 turn = Eigen::AngleAxisd(number(random), direction()).toRotationMatrix();
        const Vec3 to = direction();
        for (Vec3& x : above.vertices)
            x = turn * x + to;
        const TwoCubes at(above, box(Vec3::Ones()));
        for (const Overlap& overlap : at.overlaps) {
            Contacts pairs;
            append_crossing_edges(at.world, 0, 1, overlap, pairs);
            for (const Contact& pair : pairs) {
                const ContactGeometry geometry = contact_geometry(at.world, pair, 0);
                CHECK(geometry.depth < 0);
                CHECK(geometry.normal.dot(overlap.separation_direction) > std::sqrt(0.5));
                for (const double weight : pair.weights)
                    CHECK(std::abs(weight) <= 1);
                ++all;
            }
        }
    }
    CHECK(all > 100);
}

TEST_CASE("crossing edges: beams that cross and begin in each other, with no vertex inside, separate")
{
    for (const double turn_deg : {90.0, 33.0}) {
        CAPTURE(turn_deg);
        Scene scene = chapter09::crossed_beams(0.05, turn_deg, 0.1, 0.01);
        const Solver solver = chapter09_solver(scene.contact);
        Contacts contacts;
        double fastest = 0;
        for (int step = 0; step < 150; ++step) {
            advance(scene.world, contacts, solver, scene.dt);
            fastest = std::max(fastest, scene.world.bodies[1]->mean_velocity().norm());
        }
        const double size = scene.world.bodies[1]->size();
        CHECK(fastest < 1.1 * scale_parts.max_depenetration_velocity * std::sqrt(9.81 * size));
        CHECK(scene.world.bodies[1]->centre().y() ==
              doctest::Approx(1.5 * chapter09::beam_size).epsilon(1e-4));
    }
}
