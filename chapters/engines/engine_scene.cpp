#include "chapters/engines/engine_scene.hpp"

#include "chapters/engines/bullet/bullet_shapes.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/rigid_body.hpp"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>

namespace enduring::engines {
namespace {

using nlohmann::json;

Vec3 normal_of(std::span<const Vec3> points, const Face& face)
{
    const auto corner = [&](std::size_t i) { return points[static_cast<std::size_t>(face[i])]; };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

/// The axes of a cuboid: the normals of three of its sides; nothing for a surface that has others.
std::optional<Mat3> cuboid_axes(std::span<const Vec3> points, std::span<const Face> faces)
{
    constexpr double rounding = 1e-9;
    std::vector<Vec3> axes;
    for (const Face& face : faces) {
        const Vec3 normal = normal_of(points, face);
        const auto along = std::find_if(axes.begin(), axes.end(), [&](const Vec3& axis) {
            return std::abs(axis.dot(normal)) > rounding;
        });
        if (along == axes.end())
            axes.push_back(normal);
        else if (std::abs(along->dot(normal)) < 1 - rounding)
            return std::nullopt;
    }
    if (axes.size() != 3)
        return std::nullopt;
    Mat3 frame;
    frame << axes[0], axes[1], axes[0].cross(axes[1]);
    return frame;
}

EngineBody moving_body(const RigidBody& body)
{
    const RigidMotion& motion = body.motion();
    const auto positions = body.positions_t0();
    EngineBody taken;
    taken.name = body.name();
    taken.moves = true;
    taken.mass = body.mass();
    taken.frame = motion.pose();
    taken.convex = bullet::is_convex(positions, body.surface());
    const auto axes = taken.convex ? cuboid_axes(positions, body.surface().faces()) : std::nullopt;
    if (axes)
        taken.frame.orientation = Quaternion(*axes);
    for (const Vec3& x : positions)
        taken.points.push_back(taken.frame.to_body(x));
    if (axes) {
        taken.half_size = Vec3::Zero();
        for (const Vec3& x : taken.points)
            taken.half_size = taken.half_size->cwiseMax(x);
    }
    const Mat3 turn = taken.frame.orientation.toRotationMatrix();
    taken.inertia = (turn.transpose() * motion.inverse_inertia() * turn).diagonal().cwiseInverse();
    taken.velocity = motion.velocity();
    taken.angular_velocity = motion.angular_velocity();
    return taken;
}

json numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

EngineScene describe(const Scene& scene)
{
    Solver engine;
    engine.name = "another engine";
    engine.exact = true;
    require_asked(scene, engine);
    EngineScene taken{scene.name,          scene.dt,
                      scene.world.gravity, coefficients_of(scene.contact.friction).mu_s,
                      scene.world.planes,  {}};
    for (const auto& body : scene.world.bodies) {
        const auto* rigid = dynamic_cast<const RigidBody*>(body.get());
        if (body->is_driven() || (!rigid && !body->is_static()))
            throw InputError(scene.name + ": no other engine takes '" + body->name() +
                             "': it is deformable or driven");
        EngineBody next;
        if (rigid)
            next = moving_body(*rigid);
        else {
            next.name = body->name();
            next.points.assign(body->positions_t0().begin(), body->positions_t0().end());
            next.convex = bullet::is_convex(next.points, body->surface());
        }
        next.faces.assign(body->surface().faces().begin(), body->surface().faces().end());
        taken.bodies.push_back(std::move(next));
    }
    return taken;
}

json to_json(const EngineScene& scene)
{
    json planes = json::array(), bodies = json::array();
    for (const Plane& plane : scene.planes)
        planes.push_back({{"point", numbers(plane.point)}, {"normal", numbers(plane.normal)}});
    for (const EngineBody& body : scene.bodies) {
        json points = json::array(), faces = json::array();
        for (const Vec3& x : body.points)
            points.insert(points.end(), {x.x(), x.y(), x.z()});
        for (const auto& [a, b, c] : body.faces)
            faces.insert(faces.end(), {a, b, c});
        const Quaternion& q = body.frame.orientation;
        bodies.push_back({{"name", body.name},
                          {"moves", body.moves},
                          {"mass", body.mass},
                          {"inertia", numbers(body.inertia)},
                          {"position", numbers(body.frame.position)},
                          {"orientation", {q.w(), q.x(), q.y(), q.z()}},
                          {"velocity", numbers(body.velocity)},
                          {"angular_velocity", numbers(body.angular_velocity)},
                          {"half_size", body.half_size ? numbers(*body.half_size) : json()},
                          {"convex", body.convex},
                          {"points", std::move(points)},
                          {"faces", std::move(faces)}});
    }
    return {{"dt", scene.dt},
            {"gravity", numbers(scene.gravity)},
            {"friction", scene.friction},
            {"planes", std::move(planes)},
            {"bodies", std::move(bodies)}};
}

Pose pose_of(const EngineBody& body, std::span<const Vec3> positions)
{
    Eigen::Matrix3Xd from(3, positions.size()), to(3, positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        from.col(static_cast<Eigen::Index>(i)) = body.points[i];
        to.col(static_cast<Eigen::Index>(i)) = positions[i];
    }
    const Eigen::Matrix4d moved = Eigen::umeyama(from, to, false);
    return {moved.topRightCorner<3, 1>(), Quaternion(Mat3(moved.topLeftCorner<3, 3>()))};
}

}  // namespace enduring::engines
