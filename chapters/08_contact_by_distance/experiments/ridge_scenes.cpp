#include "chapters/08_contact_by_distance/experiments/ridge_scenes.hpp"

#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <numbers>
#include <sstream>

namespace enduring::chapter08 {
namespace {

constexpr double drop = 0.01;  ///< [m]

Eigen::AngleAxisd turn_by(double degrees, const Vec3& axis)
{
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
}

/// A roof 0.2 m high; its ridge lies on the z-axis.
SurfaceMesh roof() { return moved(chapter07::prism({{0, 0.2}, {-0.15, 0}, {0.15, 0}}, 0.6), {0, -0.2, 0}); }
/// The edge of a cube of 0.4 m on the z-axis, the cube below.
SurfaceMesh cube_edge_up()
{
    return placed(box(Vec3::Constant(0.4)), turn_by(45, Vec3::UnitZ()).toRotationMatrix(),
                  {0, -0.2 * std::numbers::sqrt2, 0});
}
/// A tetrahedron with its corner up in the origin.
SurfaceMesh corner_up()
{
    const SurfaceMesh mesh = tetrahedron(0.4);
    double top = 0;
    for (const Vec3& vertex : mesh.vertices)
        top = std::max(top, vertex.y());
    return moved(mesh, {0, -top, 0});
}

/// Upside down, and above by what it falls.
SurfaceMesh turned_over(const SurfaceMesh& mesh, double turn_deg, double aside)
{
    return placed(mesh, (turn_by(turn_deg, Vec3::UnitY()) * turn_by(180, Vec3::UnitZ())).toRotationMatrix(),
                  {aside, drop, 0});
}

SurfaceMesh held_of(const RidgePlan& plan)
{
    switch (plan.kind) {
        case RidgePlan::Kind::ridges: return roof();
        case RidgePlan::Kind::box_edges: return cube_edge_up();
        case RidgePlan::Kind::tetrahedron:
            if (plan.which == 0)
                return moved(box({0.6, 0.2, 0.6}), {0, -0.1, 0});
            return plan.which == 1 ? roof() : corner_up();
        default: return plane_grid(1, 1, {1, 1});
    }
}

SurfaceMesh falling_of(const RidgePlan& plan)
{
    switch (plan.kind) {
        case RidgePlan::Kind::ridges: return turned_over(roof(), plan.which, plan.aside);
        case RidgePlan::Kind::box_edges: return turned_over(cube_edge_up(), plan.which, plan.aside);
        case RidgePlan::Kind::tetrahedron: return turned_over(corner_up(), 10, plan.aside);
        default:
            return placed(box({0.3, 0.2, 0.25}), turn_by(7, Vec3::UnitY()).toRotationMatrix(),
                          {0.5 + plan.aside, 0.1 + drop, 0.05});
    }
}

}  // namespace

std::vector<RidgePlan> ridge_plans()
{
    using Kind = RidgePlan::Kind;
    std::vector<RidgePlan> plans;
    for (const double angle : {0.0, 0.01, 0.1, 1.0, 5.0, 45.0})
        for (const double aside : {0.0, 0.001}) {
            std::ostringstream name;
            name << "ridge on ridge, " << angle << "°" << (aside > 0 ? ", 1 mm beside" : "");
            plans.push_back({name.str(), Kind::ridges, angle, aside});
        }
    plans.push_back({"box edge on box edge", Kind::box_edges});
    plans.push_back({"box edge on box edge, 1 mm beside", Kind::box_edges, 0, 0.001});
    plans.push_back({"box edge on box edge, 1 cm beside", Kind::box_edges, 0, 0.01});
    plans.push_back({"tetrahedron on a side", Kind::tetrahedron, 0});
    plans.push_back({"tetrahedron on a ridge", Kind::tetrahedron, 1});
    plans.push_back({"tetrahedron on a corner", Kind::tetrahedron, 2});
    plans.push_back({"tetrahedron on a corner, 1 mm beside", Kind::tetrahedron, 2, 0.001});
    for (const double beyond : {-0.05, -0.01, 0.01, 0.05}) {
        std::ostringstream name;
        name << "box over a border, " << 100 * std::abs(beyond) << " cm "
             << (beyond < 0 ? "before" : "beyond") << " it";
        plans.push_back({name.str(), Kind::border, 0, beyond});
    }
    return plans;
}

Scene ridge_scene(const RidgePlan& plan, double dt)
{
    Scene scene = chapter07::scene_of({}, dt, 0, 0.5, 0.5);
    scene.world.planes.clear();
    const SurfaceMesh held = held_of(plan), falling = falling_of(plan);
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "held", SurfaceTopology(static_cast<int>(held.vertices.size()), held.faces), held.vertices));
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("body", falling, with_mass(mass_properties(falling, 1000), 10)));
    return scene;
}

bool is_held(const Scene& scene)
{
    const Body &held = *scene.world.bodies[0], &body = *scene.world.bodies[1];
    return body.centre().y() > held.centre().y() - 0.5 * body.size();
}

}  // namespace enduring::chapter08
