#include "chapters/engines/judge.hpp"

#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::engines {
namespace {

double farthest(const Frame& from, const Frame& to)
{
    double farthest = 0;
    for (std::size_t i = 0; i < from.poses.size(); ++i)
        farthest = std::max(farthest, (to.poses[i].position - from.poses[i].position).norm());
    return farthest;
}

}  // namespace

World world_at(const EngineScene& scene, const Frame& frame)
{
    World world;
    world.planes = scene.planes;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const EngineBody& body = scene.bodies[i];
        SurfaceMesh mesh{{}, body.faces};
        for (const Vec3& x : body.points)
            mesh.vertices.push_back(frame.poses[i].to_world(x));
        if (body.moves)
            world.bodies.push_back(std::make_unique<RigidBody>(body.name, mesh, mass_properties(mesh, 1000)));
        else
            world.bodies.push_back(std::make_unique<StaticBody>(
                body.name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces),
                mesh.vertices));
    }
    return world;
}

double depth_um(const EngineScene& scene, const Frame& frame)
{
    return 1e6 * chapter07::true_depth(world_at(scene, frame));
}

double drift_um_per_s(const EngineScene& scene, const Trajectory& run)
{
    const std::size_t half = run.size() / 2, steps = run.size() - 1 - half;
    return 1e6 * farthest(run[half], run.back()) / (static_cast<double>(steps) * scene.dt);
}

double moved_mm(const Trajectory& run) { return 1e3 * farthest(run.front(), run.back()); }

double thrown_m_per_s(const EngineScene& scene, const Trajectory& run)
{
    const Vec3 up = -scene.gravity.normalized();
    double fastest = 0;
    for (std::size_t step = 1; step < run.size(); ++step)
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            fastest = std::max(fastest,
                               up.dot(run[step].poses[i].position - run[step - 1].poses[i].position));
    return fastest / scene.dt;
}

double amplitude_kept(const Trajectory& run, std::size_t body)
{
    const auto angle_of = [&](const Frame& frame) {
        const Vec3& x = frame.poses[body].position;
        return std::atan2(x.x(), -x.y());
    };
    const double first = angle_of(run.front());
    double last = first, comes_back = 0;
    int passages = 0;
    for (const Frame& frame : run) {
        const double angle = angle_of(frame);
        passages += last * angle <= 0 && last != angle;
        if (passages == 2)
            comes_back = std::max(comes_back, angle / first);
        last = angle;
    }
    return comes_back;
}

double acceleration(const EngineScene& scene, const Trajectory& run, std::size_t body, const Vec3& along)
{
    const auto speed = [&](std::size_t step) {
        return along.dot(run[step].poses[body].position - run[step - 1].poses[body].position) / scene.dt;
    };
    const std::size_t from = run.size() / 3, to = run.size() - 1;
    return (speed(to) - speed(from)) / (static_cast<double>(to - from) * scene.dt);
}

bool is_finite(const Trajectory& run)
{
    return std::all_of(run.begin(), run.end(), [](const Frame& frame) {
        return std::all_of(frame.poses.begin(), frame.poses.end(), [](const Pose& pose) {
            return pose.position.norm() < 1000 && pose.orientation.coeffs().allFinite();
        });
    });
}

double ms_at_rest(const Trajectory& run)
{
    constexpr std::size_t block = 20;
    double least = INFINITY;
    for (std::size_t from = run.size() / 2; from + block <= run.size(); from += block) {
        double sum = 0;
        for (std::size_t i = from; i < from + block; ++i)
            sum += run[i].ms;
        least = std::min(least, sum / static_cast<double>(block));
    }
    return least;
}

}  // namespace enduring::engines
