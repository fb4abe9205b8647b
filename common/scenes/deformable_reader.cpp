#include "common/scenes/deformable_reader.hpp"

#include "common/geometry/quadratic.hpp"
#include "common/geometry/solid_checks.hpp"
#include "common/scenes/motion_reader.hpp"
#include "common/scenes/placement.hpp"
#include "common/simulation/deformable_body.hpp"

#include <array>
#include <limits>
#include <utility>

namespace enduring {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t max_driven = 100;

/// A box and a ball in the shape's coordinates: the nodes in both.
struct Region {
    Vec3 low, high, centre = Vec3::Zero();
    double radius = infinity;
    bool contains(const Vec3& point) const
    {
        return (point.array() >= low.array()).all() && (point.array() <= high.array()).all() &&
               !((point - centre).norm() > radius);
    }
};

Region read_region(const JsonValue& value)
{
    const NumberRange coordinate{-1e6, 1e6, true, true, "m"};
    Region region{value.vector_or("min", coordinate, Vec3::Constant(-infinity)),
                  value.vector_or("max", coordinate, Vec3::Constant(infinity))};
    if (const std::optional<JsonValue> ball = value.find("ball")) {
        ball->require_keys({"centre", "radius"});
        region.centre = ball->at("centre").vector(coordinate);
        region.radius = ball->at("radius").number({0, 1e6, true, true, "m"});
    }
    return region;
}

std::vector<int> nodes_in(const JsonValue& value, const std::vector<Vec3>& nodes)
{
    const Region region = read_region(value);
    std::vector<int> inside;
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (region.contains(nodes[node]))
            inside.push_back(static_cast<int>(node));
    if (inside.empty())
        value.complain("no node of the shape lies in this region");
    return inside;
}

/// The keys "fixed" and "driven": nodes that stay, and nodes that move as given. No node is in two of them.
void read_grips(const JsonValue& body, const std::vector<Vec3>& nodes, const Placement& placement,
                DeformableSettings& settings)
{
    std::vector<char> taken(nodes.size(), 0);
    if (const std::optional<JsonValue> fixed = body.find("fixed")) {
        fixed->require_keys({"min", "max", "ball"});
        settings.fixed_nodes = nodes_in(*fixed, nodes);
        for (const int node : settings.fixed_nodes)
            taken[static_cast<std::size_t>(node)] = 1;
    }
    const std::optional<JsonValue> driven = body.find("driven");
    if (!driven)
        return;
    for (const JsonValue& entry : driven->items(0, max_driven)) {
        entry.require_keys({"min", "max", "ball", "motion"});
        const ReadMotion given = read_given_motion(entry.at("motion"), placement);
        const std::vector<int> gripped = nodes_in(entry, nodes);
        for (const int node : gripped)
            if (std::exchange(taken[static_cast<std::size_t>(node)], 1) != 0)
                entry.complain("a node in this region is fixed or driven already");
        settings.driven_nodes.push_back({gripped, given.motion, given.centre});
    }
}

ElasticMaterial read_material(const JsonValue& body, const TetrahedralMesh& mesh,
                              const SceneMaterials& materials)
{
    ElasticMaterial material;
    const double volume = ElasticMesh(mesh).volume();
    material.density = read_mass(body, volume, materials) / volume;
    material.young = body.at("young").number({1e-3, 1e13, true, true, "Pa"});
    material.poisson = body.at("poisson").number({-0.99, 0.4999});
    if (const std::optional<JsonValue> law = body.find("elasticity"))
        material.law = std::array{
            ElasticLaw::corotated, ElasticLaw::corotated_at_points,
            ElasticLaw::neo_hookean}[law->choice({"corotated", "corotated_at_points", "neo_hookean"})];
    if (const std::optional<JsonValue> damping = body.find("rayleigh")) {
        damping->require_keys({"mass", "stiffness"});
        material.mass_damping = damping->number_or("mass", {0, 1e6, true, true, "1/s"},
                                                   material.mass_damping);
        material.stiffness_damping = damping->number_or("stiffness", {0, 1e3, true, true, "s"},
                                                        material.stiffness_damping);
    }
    return material;
}

TetrahedralMesh read_solid(const JsonValue& value, const SceneSurroundings& surroundings)
{
    Shape shape = read_shape(value.at("shape"), surroundings);
    if (!shape.solid)
        value.at("shape").fail("a shape made of tetrahedra, \"bar\" or a \"file\" ending in .msh");
    check_solid(*shape.solid, "the mesh");
    return *std::move(shape.solid);
}

std::unique_ptr<Body> build(const JsonValue& value, const SceneSurroundings& surroundings,
                            const SceneMaterials& materials)
{
    const TetrahedralMesh mesh = read_solid(value, surroundings);
    const Placement placement = read_placement(value);
    const InitialMotion motion = read_motion(value);
    DeformableSettings settings;
    settings.material = read_material(value, mesh, materials);
    settings.rotation = placement.rotation.toRotationMatrix();
    settings.position = placement.position;
    settings.velocity = motion.velocity;
    settings.angular_velocity = motion.angular_velocity;
    if (const std::optional<JsonValue> response = value.find("impulse_response"))
        settings.impulse_response = response->choice({"lumped", "implicit"}) == 1 ? ImpulseResponse::implicit
                                                                                  : ImpulseResponse::lumped;

    settings.self_contact = value.flag_or("self_contact", false);
    settings.options.solver_tolerance = value.number_or("solver_tolerance", {1e-14, 1e-2},
                                                        settings.options.solver_tolerance);
    if (const std::optional<JsonValue> solver = value.find("linear_solver"))
        settings.options.linear_solver = solver->choice({"simplicial", "supernodal"}) == 0
                                             ? LinearSolverKind::simplicial
                                             : LinearSolverKind::supernodal;

    const std::vector<TimedVector> forces = read_spread_forces(value);
    const auto driven = [&](std::unique_ptr<DeformableBody> body) {
        for (const TimedVector& force : forces)
            body->add_force(force);
        return body;
    };
    const std::optional<JsonValue> basis = value.find("basis");
    if (!basis || basis->choice({"linear", "quadratic"}) == 1) {
        const QuadraticTetrahedralMesh quadratic = with_edge_midpoints(mesh);
        read_grips(value, quadratic.nodes, placement, settings);
        return driven(std::make_unique<DeformableBody>(value.at("name").text(), quadratic, settings));
    }
    read_grips(value, mesh.nodes, placement, settings);
    return driven(std::make_unique<DeformableBody>(value.at("name").text(), mesh, settings));
}

}  // namespace

std::unique_ptr<Body> read_deformable(const JsonValue& value, const SceneSurroundings& surroundings,
                                      const SceneMaterials& materials)
{
    value.require_keys({"name",
                        "type",
                        "shape",
                        "density",
                        "mass",
                        "young",
                        "poisson",
                        "elasticity",
                        "rayleigh",
                        "basis",
                        "fixed",
                        "driven",
                        "impulse_response",
                        "self_contact",
                        "solver_tolerance",
                        "linear_solver",
                        "position",
                        "rotation",
                        "velocity",
                        "angular_velocity",
                        "look",
                        "material",
                        "gravity",
                        "forces"});
    try {
        return build(value, surroundings, materials);
    } catch (const InputError& error) {
        value.pass_on(error);
    }
}

}  // namespace enduring
