#include "chapters/08_contact_by_distance/experiments/forces_soft.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/driven_body.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter08::force_rows {
namespace {

void add_soft(Scene& scene, const TetrahedralMesh& mesh, bool quadratic, const ElasticMaterial& material,
              const Vec3& position)
{
    DeformableSettings settings;
    settings.material = material;
    settings.position = position;
    settings.impulse_response = ImpulseResponse::implicit;
    const std::string name = "soft " + std::to_string(scene.world.bodies.size());
    if (quadratic)
        scene.world.bodies.push_back(
            std::make_unique<DeformableBody>(name, with_edge_midpoints(mesh), settings));
    else
        scene.world.bodies.push_back(std::make_unique<DeformableBody>(name, mesh, settings));
}

}  // namespace

Rows soft_weights(const MakeSolver& make, bool full)
{
    Row row{"soft", "soft blocks at rest, alone or one on the other", "forces of what carries them", "weight",
            1e-3};
    const ElasticMaterial material{
        .young = 1e5, .poisson = 0.3, .density = 1000, .mass_damping = 5, .stiffness_damping = 0.02};
    for (const Floor floor : full ? std::vector{Floor::plane, Floor::box, Floor::cut_box}
                                  : std::vector{Floor::plane, Floor::cut_box})
        for (const int count : full ? std::vector{1, 2} : std::vector{1})
            for (const bool quadratic : full ? std::vector{false, true} : std::vector{false}) {
                Scene scene = empty_scene(0.01, 0.5);
                add_floor(scene, floor);
                constexpr double side = 0.3;
                for (int i = 0; i < count; ++i)  // one on the other, askew
                    add_soft(scene, bar(Vec3::Constant(side), {2, 2, 2}), quadratic, material,
                             Vec3(0.03 * i, side * (0.5 + i), 0.02 * i));
                Stepped run(std::move(scene), make);
                run.run_for(count == 1 ? 1.5 : 5);
                const std::vector<Vec3> forces = run.on_bodies();
                Vec3 on_floor = Vec3::Zero();
                double weight = 0;
                for (std::size_t i = floor == Floor::plane ? 0 : 1; i < forces.size(); ++i) {
                    on_floor += forces[i];
                    weight += run.weight(i);
                }
                row.add(std::to_string(count) + (quadratic ? " quadratic" : "") + " on a " + name_of(floor),
                        100 * (on_floor - Vec3(0, weight, 0)).norm() / weight);
            }
    return {row};
}

namespace {

/// The plates' inner sides are at y = 0 and at `tall`; the upper one comes down by `down` within half a
/// second.
void add_plates(Scene& scene, double tall, double down)
{
    add_static(scene, "lower plate", moved(box({1, 0.1, 1}), Vec3(0, -0.05, 0)));
    const Vec3 centre(0, tall + 0.05, 0);
    scene.world.bodies.push_back(std::make_unique<DrivenBody>(
        "upper plate", moved(box({1, 0.1, 1}), centre), centre,
        GivenMotion::through({{0, Vec3::Zero(), Vec3::Zero()}, {0.5, Vec3(0, -down, 0), Vec3::Zero()}})));
}

/// A third of the area of each face that touches a vertex, among those at the bottom [m^2].
std::vector<double> areas_below(const Body& body, double bottom)
{
    const auto positions = body.positions_t0();
    std::vector<double> areas(positions.size(), 0.0);
    for (const Face& face : body.surface().faces()) {
        const auto at = [&](std::size_t i) { return positions[static_cast<std::size_t>(face.at(i))]; };
        if (std::max({at(0).y(), at(1).y(), at(2).y()}) > bottom + 1e-9)
            continue;
        const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
        for (const int corner : face)
            areas[static_cast<std::size_t>(corner)] += area / 3;
    }
    return areas;
}

}  // namespace

Rows soft_pressure(const MakeSolver& make, bool full)
{
    Row share{"pressure", "soft block between plates, no friction", "force of each vertex on the lower plate",
              "its share of the area", 1},
        sum{"pressure_sum", "the same", "sum on each plate", "E times area and strain", 0.5};
    constexpr double side = 0.3;
    for (const int cells : full ? std::vector{2, 3, 6} : std::vector{3})
        for (const double nu : {0.0, 0.3}) {
            const ElasticMaterial material{
                .young = 1e5, .poisson = nu, .density = 1000, .stiffness_damping = 0.02};
            Scene scene = empty_scene(0.01, 0);
            scene.world.gravity.setZero();
            constexpr double strain = 0.05;
            add_plates(scene, side, strain * side);
            add_soft(scene, bar(Vec3::Constant(side), {cells, cells, cells}), false, material,
                     Vec3(0, side / 2, 0));
            const Body& block = *scene.world.bodies[2];
            const std::vector<double> areas = areas_below(block, 0);
            Stepped run(std::move(scene), make);
            run.run_for(2);
            const std::vector<Vec3> forces = run.on_vertices(2);
            const Vec3 on_lower = run.between(0, 2), on_upper = run.between(1, 2);
            double off = 0;
            for (std::size_t i = 0; i < areas.size(); ++i)
                if (areas[i] > 0) {
                    const double expected = -on_lower.y() * areas[i] / (side * side);
                    off = std::max(off, std::abs(forces[i].y() - expected) / expected);
                }
            const std::string name = std::to_string(cells) + " cells" + named(", nu", nu);
            share.add(name, 100 * off);
            const double formula = material.young * side * side * strain;
            sum.add(name, 100 * std::max(std::abs(on_lower.y() + formula), std::abs(on_upper.y() - formula)) /
                              formula);
        }
    return {share, sum};
}

namespace {

/// A cube of tetrahedra drawn into a ball.
TetrahedralMesh soft_ball(double radius, int cells)
{
    TetrahedralMesh mesh = bar({2, 2, 2}, {cells, cells, cells}, CellSplit::five);
    for (Vec3& node : mesh.nodes) {
        const Vec3 squared = node.cwiseAbs2();
        const double x = squared.x(), y = squared.y(), z = squared.z();
        node = radius * Vec3(node.x() * std::sqrt(1 - y / 2 - z / 2 + y * z / 3),
                             node.y() * std::sqrt(1 - z / 2 - x / 2 + z * x / 3),
                             node.z() * std::sqrt(1 - x / 2 - y / 2 + x * y / 3));
    }
    return mesh;
}

}  // namespace

Rows hertz(const MakeSolver& make, bool full)
{
    Row row{"hertz", "soft ball between plates", "force of the plates", "Hertz", 15};
    constexpr double radius = 0.1, nu = 0, young = 1e5;
    for (const int cells : full ? std::vector{12} : std::vector{8})
        for (const double down : full ? std::vector{0.016, 0.02} : std::vector{0.02}) {
            Scene scene = empty_scene(0.01, 0);
            scene.world.gravity.setZero();
            add_plates(scene, 2 * radius, down);
            add_soft(scene, soft_ball(radius, cells), false,
                     {.young = young, .poisson = nu, .density = 1000, .stiffness_damping = 0.02},
                     Vec3(0, radius, 0));
            Stepped run(std::move(scene), make);
            run.run_for(1);
            const double formula = 4.0 / 3 * young / (1 - nu * nu) * std::sqrt(radius) *
                                   std::pow(down / 2, 1.5);
            row.add(std::to_string(cells) + " cells" + named(", nearer by [m]", down),
                    100 * std::abs(run.between(1, 2).y() / formula - 1));
        }
    return {row};
}

}  // namespace enduring::chapter08::force_rows
