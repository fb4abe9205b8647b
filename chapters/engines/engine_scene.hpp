#pragma once

#include "common/geometry/meshes.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/scenes/scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace enduring::engines {

/// A rigid body as every engine can take it. Lengths in metres, masses in kilograms, times in seconds; y
/// points up.
struct EngineBody {
    std::string name;
    bool moves = false;
    double mass = 0;              ///< [kg]; 0 for what stands still
    Vec3 inertia = Vec3::Zero();  ///< about the centre of mass, along the frame's axes [kg m^2]
    Pose frame;  ///< of a body that moves: its centre of mass, and axes along which its inertia is diagonal
    Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();  ///< in world axes [m/s, rad/s]
    std::optional<Vec3> half_size;  ///< of a cuboid, along the frame's axes [m]
    bool convex = false;            ///< and closed
    std::vector<Vec3> points;       ///< of the surface, in the frame [m]
    std::vector<Face> faces;        ///< counter-clockwise seen from outside
};

/// A scene as every engine can take it: what they have in common, and nothing of ours.
struct EngineScene {
    std::string name;
    double dt = 0;        ///< from one frame to the next [s]
    Vec3 gravity;         ///< [m/s^2]
    double friction = 0;  ///< of every pair: the static coefficient, for nobody else has two
    std::vector<Plane> planes;
    std::vector<EngineBody> bodies;  ///< in the order of World::bodies
};

/// @throws InputError  a body that is deformable or driven; names it
EngineScene describe(const Scene& scene);

/// What node's engines read: bodies with flat lists of points and faces, orientations as w, x, y, z.
nlohmann::json to_json(const EngineScene& scene);

/// Where a body is, found from where its points are: the turn and shift that fit best.
Pose pose_of(const EngineBody& body, std::span<const Vec3> positions);

}  // namespace enduring::engines
