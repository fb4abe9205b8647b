#include "chapters/07_implicit_contact/plausible_depth.hpp"
#include "chapters/05_categorisation/category.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/false_hooks.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// A cube, turned by 60 degrees, one corner of which goes by a millimetre through the side x = 0.5 of a fixed one.
/// The side would push it along itself: the corner faces the upper side, which is `below_top` away.
struct HookedCorner {
    World world;
    int corner = -1;

    explicit HookedCorner(double below_top)
    {
        const SurfaceMesh block = box(Vec3::Ones());
        SurfaceMesh cube = box(Vec3::Constant(0.8));
        for (std::size_t i = 0; i < cube.vertices.size(); ++i)
            if (cube.vertices[i].isApprox(Vec3(-0.4, -0.4, 0.4)))
                corner = static_cast<int>(i);
        const Mat3 turn = Eigen::AngleAxisd(std::numbers::pi / 3, Vec3::UnitZ()).toRotationMatrix();
        const Vec3 to = Vec3(0.5, 0.5 - below_top, 0.4) - turn * Vec3(-0.4, -0.4, 0.4);
        for (Vec3& x : cube.vertices)
            x = turn * x + to;
        world.bodies.push_back(std::make_unique<StaticBody>(
            "block", SurfaceTopology(static_cast<int>(block.vertices.size()), block.faces), block.vertices));
        world.bodies.push_back(
            std::make_unique<RigidBody>("cube", cube, with_mass(mass_properties(cube, 1000), 10)));
        world.bodies[1]->predict(Vec3(-1e-3, 0, 0) / 1e-4, 0.01);
    }

    /// With the face of the block that has this normal and the corner's foot.
    Contact pair(const Vec3& normal) const
    {
        Contact pair{ContactKind::vertex_face, 1, 0, corner, -1};
        const PairSurfaces surfaces(world, pair, 1);
        const SurfaceTopology& block = world.bodies[0]->surface();
        for (int face = 0; face < static_cast<int>(block.faces().size()); ++face) {
            const auto foot = foot_on_face(surfaces.a, corner, surfaces.b, face);
            if (surfaces.b.face_normal(face).normalized().dot(normal) > 0.99 && overshoot(foot->weights) == 0)
                put_on_face(pair, block, face, foot->weights);
        }
        pair.vertices[0] = corner;
        pair.weights[0] = 1;
        pair.category = categorise(world, pair, 1);
        return pair;
    }
};

const Vec3 side = Vec3::UnitX(), top = Vec3::UnitY();

}  // namespace

TEST_CASE("plausible depth: ten times as deep as a pair that pushes one of the bodies, and a step's way")
{
    const HookedCorner at(0.3);
    const Contact entry = at.pair(side);
    CHECK(plausible_depth(at.world, {}, entry) == doctest::Approx(1e-3));
    Contacts others{at.pair(top)};
    CHECK(plausible_depth(at.world, others, entry) == doctest::Approx(3.001));
    for (const auto silence : {+[](Contact& c) { c.hold(true); }, +[](Contact& c) { c.resolved = true; },
                               +[](Contact& c) { c.category = ContactCategory::hooked; }}) {
        Contacts silent = others;
        silence(silent[0]);
        CHECK(plausible_depth(at.world, silent, entry) == doctest::Approx(1e-3));
    }
}

TEST_CASE(
    "plausible depth: a corner that comes in far below the face that suits it is pushed back where it came in")
{
    for (const double below_top : {1e-6, 0.9e-3, 1.1e-3, 0.3}) {
        CAPTURE(below_top);
        const HookedCorner at(below_top);
        REQUIRE(at.pair(side).category == ContactCategory::hooked);
        REQUIRE(at.pair(top).category == ContactCategory::regular);
        const bool far = below_top > 1e-3;

        Contacts entering{at.pair(side)};
        admit_falsely_hooked(at.world, entering);
        CHECK((entering[0].category == ContactCategory::regular) == far);

        Contacts beside_a_deep_one{at.pair(side), at.pair(top)};
        admit_falsely_hooked(at.world, beside_a_deep_one);
        CHECK(beside_a_deep_one[0].category == ContactCategory::hooked);

        Contacts made{at.pair(side), at.pair(top)};
        drop_implausible(at.world, made, 1, 1);
        CHECK(made.size() == (far ? 1 : 2));
    }
}

TEST_CASE("plausible depth: in a heap no pair is made across a cube")
{
    Scene scene = scene_of(loose_cubes(40, 3, 12), 0.02);
    CHECK(watch(scene, 4.5).deepest_ever_mm < 100);  // a heap is chaotic; it was 280 mm
}
