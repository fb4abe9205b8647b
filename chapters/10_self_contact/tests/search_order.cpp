#include "chapters/10_self_contact/experiments/bent_bars.hpp"
#include "chapters/10_self_contact/self_search.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

using namespace enduring;

namespace {

constexpr double dt = 0.01, gap = 1e-4;

/// No two features lie alike, so each pair is one that no number has chosen.
void shake(std::vector<Vec3>& points, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> displacement(-5e-5, 5e-5);
    for (Vec3& point : points)
        point += Vec3(displacement(random), displacement(random), displacement(random));
}

/// Two legs upwards, which all but touch each other.
TetrahedralMesh hairpin()
{
    constexpr double leg = 0.1, thickness = 0.02, bend = (thickness + gap) / 2;
    TetrahedralMesh mesh = chapter10::bent_bar(
        2 * leg + std::numbers::pi * bend, thickness, 0.04, {20, 1, 2}, [&](double s) {
            const double angle = std::clamp((s - leg) / bend, 0.0, std::numbers::pi);
            const Vec3 along(std::sin(angle), -std::cos(angle), 0), left(std::cos(angle), std::sin(angle), 0);
            return chapter10::CurvePoint{(s - leg - angle * bend) * along - bend * left, left};
        });
    shake(mesh.nodes, 1);
    return mesh;
}

/// The same elements under other numbers, their own and those of their nodes.
TetrahedralMesh renumbered(const TetrahedralMesh& mesh, std::mt19937& random)
{
    std::vector<int> number(mesh.nodes.size());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    TetrahedralMesh other = mesh;
    for (std::size_t node = 0; node < number.size(); ++node)
        other.nodes[static_cast<std::size_t>(number[node])] = mesh.nodes[node];
    for (auto& element : other.elements) {
        for (int& node : element)
            node = number[static_cast<std::size_t>(node)];
        std::rotate(element.begin(), element.begin() + 1, element.begin() + 3);  // keeps its orientation
    }
    std::shuffle(other.elements.begin(), other.elements.end(), random);
    return other;
}

SurfaceMesh renumbered(const SurfaceMesh& mesh, std::mt19937& random)
{
    std::vector<int> number(mesh.vertices.size());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    SurfaceMesh other = mesh;
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex)
        other.vertices[static_cast<std::size_t>(number[vertex])] = mesh.vertices[vertex];
    for (Face& face : other.faces) {
        for (int& vertex : face)
            vertex = number[static_cast<std::size_t>(vertex)];
        std::rotate(face.begin(), face.begin() + 1, face.end());
    }
    std::shuffle(other.faces.begin(), other.faces.end(), random);
    return other;
}

/// A soft hairpin that meets itself lies on the border of an open sheet, and a soft bar on the hairpin.
/// @param seed  of the numbers that its parts have; with 0, those that they are made with
World crowd(unsigned seed)
{
    std::mt19937 random(seed);
    TetrahedralMesh pin = hairpin(), across = bar({0.05, 0.02, 0.15}, {2, 1, 6});
    SurfaceMesh sheet = plane_grid(0.2, 0.2, {7, 5});
    shake(across.nodes, 2);
    shake(sheet.vertices, 3);
    if (seed > 0) {
        pin = renumbered(pin, random);
        across = renumbered(across, random);
        sheet = renumbered(sheet, random);
    }
    const Mat3 lying = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()).toRotationMatrix();
    DeformableSettings settings;
    settings.material = {.young = 1e5, .density = 1000, .stiffness_damping = 0.001};
    settings.rotation = lying;
    settings.self_contact = true;
    settings.velocity = Vec3(0.01, -0.03, 0.02);
    std::vector<std::unique_ptr<Body>> bodies;
    bodies.push_back(std::make_unique<DeformableBody>("pin", pin, settings));
    settings.rotation = Eigen::AngleAxisd(0.1, Vec3::UnitY()).toRotationMatrix();
    settings.position = Vec3(0, 0.03 + gap, 0.05);
    bodies.push_back(std::make_unique<DeformableBody>("bar", across, settings));
    for (Vec3& x : sheet.vertices)
        x += Vec3(0.09, -0.02 - gap, 0.04);
    bodies.push_back(std::make_unique<StaticBody>(
        "sheet", SurfaceTopology(static_cast<int>(sheet.vertices.size()), sheet.faces), sheet.vertices));
    if (seed > 0)
        std::shuffle(bodies.begin(), bodies.end(), random);
    World world;
    world.bodies = std::move(bodies);
    world.skins.assign(world.bodies.size(),
                       3 * gap);  // of a run that goes on: else no two features would touch
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
    return world;
}

/// A pair by where its features' vertices lie, as those of one side and of the other.
using Side = std::set<std::array<double, 3>>;
using PlacedPair = std::pair<ContactKind, std::set<Side>>;

struct Found {
    std::set<PlacedPair> pairs;
    std::set<std::string> bodies;
};

/// The pairs at the start of the first step.
Found found_in(World world)
{
    Found all;
    SelfSearch search;
    search.begin(world, dt);
    const Contacts first = search.find(world, dt);
    const auto placed = [&](const Contact& contact) {
        Side a, b;
        for (int i = 0; i < contact.vertex_count(); ++i) {
            const bool of_a = i < contact.vertices_of_a();
            const Body& body =
                *world.bodies[static_cast<std::size_t>(of_a ? contact.body_a : contact.body_b)];
            const Vec3& x =
                body.positions_t0()[static_cast<std::size_t>(contact.vertices[static_cast<std::size_t>(i)])];
            (of_a ? a : b).insert({x.x(), x.y(), x.z()});
        }
        return PlacedPair{contact.kind, {a, b}};
    };
    for (const Contact& contact : first) {
        all.pairs.insert(placed(contact));
        std::array names{world.bodies[static_cast<std::size_t>(contact.body_a)]->name(),
                         world.bodies[static_cast<std::size_t>(contact.body_b)]->name()};
        std::sort(names.begin(), names.end());
        all.bodies.insert(names[0] + " and " + names[1]);
    }
    return all;
}

}  // namespace

TEST_CASE(
    "search: soft bodies, an open sheet and a surface that meets itself have the same pairs, whatever their numbers")
{
    const Found expected = found_in(crowd(0));
    CHECK(expected.bodies == std::set<std::string>{"bar and pin", "pin and pin", "pin and sheet"});
    CHECK(expected.pairs.size() > 100);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const Found found = found_in(crowd(seed));
        CHECK(found.bodies == expected.bodies);
        CHECK(found.pairs == expected.pairs);
    }
}
