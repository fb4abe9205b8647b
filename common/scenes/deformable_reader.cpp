#include "common/scenes/deformable_reader.hpp"

#include "common/fem/point_weights.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/solid_checks.hpp"
#include "common/scenes/motion_reader.hpp"
#include "common/scenes/placement.hpp"
#include "common/scenes/region_reader.hpp"
#include "common/simulation/deformable_body.hpp"

#include <array>
#include <utility>

namespace enduring {
namespace {

constexpr std::size_t max_driven = 100, max_forces = 100;

/// The keys "fixed" and "driven": nodes that stay, and nodes that move as given. No node is in two of them.
/// Nodes that stay until a time are driven nowhere.
void read_grips(const JsonValue& body, const NamedNodes& of_body, const Placement& placement,
                DeformableSettings& settings)
{
    std::vector<char> taken(of_body.nodes.size(), 0);
    if (const std::optional<JsonValue> fixed = body.find("fixed")) {
        fixed->require_keys({"min", "max", "ball", "group", "until"});
        std::vector<int> nodes = read_region(*fixed, of_body);
        for (const int node : nodes)
            taken[static_cast<std::size_t>(node)] = 1;
        if (fixed->find("until"))
            settings.driven_nodes.push_back({std::move(nodes),
                                             GivenMotion::steady(Vec3::Zero(), Vec3::Zero()),
                                             placement.position, read_until(*fixed)});
        else
            settings.fixed_nodes = std::move(nodes);
    }
    const std::optional<JsonValue> driven = body.find("driven");
    if (!driven)
        return;
    for (const JsonValue& entry : driven->items(0, max_driven)) {
        entry.require_keys({"min", "max", "ball", "group", "motion", "until"});
        const ReadMotion given = read_given_motion(entry.at("motion"), placement);
        const std::vector<int> gripped = read_region(entry, of_body);
        for (const int node : gripped)
            if (std::exchange(taken[static_cast<std::size_t>(node)], 1) != 0)
                entry.complain("a node in this region is fixed or driven already");
        settings.driven_nodes.push_back({gripped, given.motion, given.centre, read_until(entry)});
    }
}

/// What a force at a point or on a region gives to the nodes; none if it is spread over the whole body.
std::vector<NodeWeight> read_shares(const JsonValue& entry, const NamedNodes& of_body,
                                    const ElasticBody& elastic)
{
    std::vector<NodeWeight> shares;
    if (const std::optional<JsonValue> point = entry.find("point")) {
        if (gives_region(entry))
            point->complain("stands beside a region of nodes; one of the two is enough");
        shares = point_weights(elastic.mesh(), point->vector({-1e4, 1e4, true, true, "m"}));
        if (shares.empty())
            point->complain("lies outside of the body");
    } else if (gives_region(entry)) {
        const std::vector<int> nodes = read_region(entry, of_body);
        const double mass = elastic.masses()(nodes).sum();
        shares.reserve(nodes.size());
        for (const int node : nodes)
            shares.push_back({node, elastic.masses()[node] / mass});
    }
    return shares;
}

/// What a rigid body has and a soft one cannot have.
void refuse_what_is_rigid(const JsonValue& entry)
{
    const auto refuse = [&](const char* key, const char* reason) {
        if (const std::optional<JsonValue> found = entry.find(key))
            found->complain(reason);
    };
    refuse("torque", "a soft body does not turn as a whole; give forces at two of its points");
    refuse("axes", "a soft body has no axes that turn along; its forces are in the world's");
    refuse("spring", "pulls rigid bodies only");
}

void add_forces(const JsonValue& value, const NamedNodes& of_body, DeformableBody& body)
{
    const std::optional<JsonValue> list = value.find("forces");
    if (!list)
        return;
    for (const JsonValue& entry : list->items(0, max_forces)) {
        refuse_what_is_rigid(entry);
        entry.require_keys({"force", "table", "point", "min", "max", "ball", "group"});
        body.add_force(read_force(entry), read_shares(entry, of_body, body.elastic()));
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

Shape read_solid(const JsonValue& value, const SceneSurroundings& surroundings)
{
    Shape shape = read_shape(value.at("shape"), surroundings);
    if (!shape.solid)
        value.at("shape").fail("a shape made of tetrahedra, \"bar\" or a \"file\" ending in .msh");
    check_solid(*shape.solid, "the mesh");
    return shape;
}

std::unique_ptr<Body> build(const JsonValue& value, const SceneSurroundings& surroundings,
                            const SceneMaterials& materials)
{
    const Shape shape = read_solid(value, surroundings);
    const TetrahedralMesh& mesh = *shape.solid;
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

    const auto made_of = [&](const auto& of_basis) {
        const NamedNodes of_body = NamedNodes::of(of_basis, shape.groups);
        read_grips(value, of_body, placement, settings);
        auto body = std::make_unique<DeformableBody>(value.at("name").text(), of_basis, settings);
        add_forces(value, of_body, *body);
        return body;
    };
    const std::optional<JsonValue> basis = value.find("basis");
    if (!basis || basis->choice({"linear", "quadratic"}) == 1)
        return made_of(with_edge_midpoints(mesh));
    return made_of(mesh);
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
