#include "chapters/08_contact_by_distance/near_pairs.hpp"
#include "chapters/08_contact_by_distance/tests/small_world.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::distance_tests;

namespace {

/// The pairs of all features that are nearer than a distance, where everything stands.
Contacts near_pairs(World& world, double distance)
{
    for (const auto& body : world.bodies)
        body->stand_still();
    const Nearness nearness{
        [&](int, int) { return distance; }, [&](int, int) { return distance; }, [](int) { return 0.0; }, {}};
    DistanceSearch search;
    search.find_candidates(world, std::vector<double>(world.bodies.size(), distance));
    Contacts found;
    Grounds grounds;
    append_near_pairs(world, search, nearness, found, grounds);
    return found;
}

double distance_of(const World& world, const Contact& pair)
{
    const ContactGeometry geometry = contact_geometry(world, pair, 0);
    return (geometry.p - geometry.q).norm();
}

/// Of two surfaces, by the points of fine grids on all faces.
double searched_distance(const World& world)
{
    double least = INFINITY;
    const Body &a = *world.bodies[0], &b = *world.bodies[1];
    const auto points = [](const Body& body) {
        std::vector<Vec3> all;
        constexpr int n = 8;
        for (const Face& f : body.surface().faces())
            for (int i = 0; i <= n; ++i)
                for (int j = 0; i + j <= n; ++j)
                    all.push_back(((n - i - j) * body.position(f[0], 0) + i * body.position(f[1], 0) +
                                   j * body.position(f[2], 0)) /
                                  n);
        return all;
    };
    const std::vector<Vec3> of_b = points(b);
    for (const Vec3& p : points(a))
        for (const Vec3& q : of_b)
            least = std::min(least, (p - q).norm());
    return least;
}

}  // namespace

TEST_CASE("near pairs: the nearest of all pairs is as far as two surfaces are from each other")
{
    for (int i = 0; i < 20; ++i) {
        World world;
        const Vec3 axis(std::sin(i), std::cos(3 * i), 0.3);
        add_rigid(world, placed(box({1, 1, 1}), Quaternion(Eigen::AngleAxisd(0.7 * i, axis.normalized())),
                                {0, 0, 0}));
        add_rigid(world, placed(sphere(0.3, 1), Quaternion(Eigen::AngleAxisd(i, Vec3::UnitY())),
                                {0.5 + 0.5 * std::cos(i), 0.9 * std::sin(2 * i), 0.9}));
        if (any_inside(world))
            continue;
        const Contacts pairs = near_pairs(world, 1);
        double least = INFINITY;
        for (const Contact& pair : pairs) {
            const ContactGeometry geometry = contact_geometry(world, pair, 0);
            least = std::min(least, distance_of(world, pair));
            CHECK((geometry.normal - (geometry.p - geometry.q).normalized()).norm() < 1e-9);
        }
        CAPTURE(i);
        const double searched = searched_distance(world);
        CHECK(least <= searched + 1e-12);
        CHECK(least >= searched - 0.08);
    }
}

TEST_CASE("near pairs: what is flat is flat: no vertex and no edge inside a flat side has a pair of its own")
{
    for (const double shift : {0.0, 0.013}) {
        World world;
        add_static(world, box({2, 1, 2}, {4, 1, 4}));
        add_rigid(world,
                  placed(sphere(0.3, 2), Quaternion(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())),
                         {shift, 0.805, shift}));
        const Contacts pairs = near_pairs(world, 0.05);
        CHECK(!pairs.empty());
        for (const Contact& pair : pairs) {
            CHECK(pair.kind == ContactKind::vertex_face);
            CHECK(pair.body_a == 1);  // of the ball
            CHECK((pair.normal_t0 - Vec3::UnitY()).norm() < 1e-9);
        }
    }
}

TEST_CASE("near pairs: a cube over a cube has its four corners, and nothing that is further away")
{
    World world;
    add_static(world, box({2, 1, 2}, {2, 1, 2}));
    add_rigid(world, moved(box({1, 1, 1}), {0.1, 1.001, 0.05}));
    CHECK(near_pairs(world, 0.0011).size() == 4);
    CHECK(near_pairs(world, 0.0009).empty());
}
