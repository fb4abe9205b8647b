// DART as a process of its own: dart_beside SCENE.json; a frame is a line of JSON on stdout, as of the
// engines that node runs. In the program `engines` it cannot be: it brings Bullet in single precision, whose
// functions have the names of ours. The detector is that of Bullet: FCL's, the default, knows no planes, and
// takes a mesh of a box without height in their place.
#include "common/experiments/run/processor_clock.hpp"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <dart/collision/bullet/BulletCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/MeshShape.hpp>
#include <dart/dynamics/MultiSphereConvexHullShape.hpp>
#include <dart/dynamics/PlaneShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using nlohmann::json;
using namespace dart::dynamics;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d vector(const json& n) { return {n[0].get<double>(), n[1].get<double>(), n[2].get<double>()}; }

Isometry3d frame_of(const json& body)
{
    const json& q = body["orientation"];
    return Eigen::Translation3d(vector(body["position"])) *
           Eigen::Quaterniond(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(), q[3].get<double>());
}

/// A mesh comes to DART by way of the library Assimp, whose numbers are single.
ShapePtr mesh_of(const json& body)
{
    std::ostringstream obj;
    obj.precision(9);
    for (std::size_t i = 0; i < body["points"].size(); ++i)
        obj << (i % 3 == 0 ? "\nv " : " ") << body["points"][i].get<double>();
    for (std::size_t i = 0; i < body["faces"].size(); ++i)
        obj << (i % 3 == 0 ? "\nf " : " ") << body["faces"][i].get<int>() + 1;
    const std::string text = obj.str() + '\n';
    return std::make_shared<MeshShape>(Vector3d::Ones(),
                                       aiImportFileFromMemory(text.data(), static_cast<unsigned>(text.size()),
                                                              aiProcess_JoinIdenticalVertices, "obj"));
}

/// A body that moves, other than a cuboid: the hull of small balls. Bullet's detector finds no contact of two
/// meshes, nor of a mesh and a plane.
ShapePtr hull_of(const json& body)
{
    constexpr double radius = 1e-4;  // [m]
    const json& x = body["points"];
    MultiSphereConvexHullShape::Spheres balls;
    for (std::size_t i = 0; i < x.size(); i += 3)
        balls.emplace_back(radius, Vector3d(x[i], x[i + 1], x[i + 2]));
    return std::make_shared<MultiSphereConvexHullShape>(balls);
}

ShapePtr shape_of(const json& body)
{
    if (!body["half_size"].is_null())
        return std::make_shared<BoxShape>(2 * vector(body["half_size"]));
    return body["moves"] ? hull_of(body) : mesh_of(body);
}

void show(BodyNode* node, const ShapePtr& shape, double friction)
{
    auto* const shown = node->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
    shown->getDynamicsAspect()->setFrictionCoeff(friction);  // DART takes the smaller one of a pair
}

BodyNode* add_fixed(dart::simulation::World& world, const std::string& name, const Isometry3d& frame)
{
    const SkeletonPtr skeleton = Skeleton::create(name);
    const auto [joint, node] = skeleton->createJointAndBodyNodePair<WeldJoint>();
    joint->setTransformFromParentBodyNode(frame);
    skeleton->setMobile(false);
    world.addSkeleton(skeleton);
    return node;
}

BodyNode* add_moving(dart::simulation::World& world, const json& body)
{
    const SkeletonPtr skeleton = Skeleton::create(body["name"].get<std::string>());
    const auto [joint, node] = skeleton->createJointAndBodyNodePair<FreeJoint>();
    node->setInertia({body["mass"].get<double>(), Vector3d::Zero(), vector(body["inertia"]).asDiagonal()});
    joint->setTransform(frame_of(body));
    joint->setLinearVelocity(vector(body["velocity"]));
    joint->setAngularVelocity(vector(body["angular_velocity"]));
    world.addSkeleton(skeleton);
    return node;
}

void print(double ms, const std::vector<BodyNode*>& bodies)
{
    json poses = json::array();
    for (const BodyNode* const node : bodies) {
        const Vector3d x = node->getWorldTransform().translation();
        const Eigen::Quaterniond q(node->getWorldTransform().linear());
        poses.push_back(json::array({x.x(), x.y(), x.z(), q.w(), q.x(), q.y(), q.z()}));
    }
    std::cout << json({{"ms", ms}, {"poses", poses}}) << '\n';
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    std::ifstream file(argv[1]);
    const json scene = json::parse(file), &way = scene["way"];
    const auto world = dart::simulation::World::create();
    const int substeps = way["substeps"];
    world->setGravity(vector(scene["gravity"]));
    world->setTimeStep(scene["dt"].get<double>() / substeps);
    world->getConstraintSolver()->setCollisionDetector(dart::collision::BulletCollisionDetector::create());
    int planes = 0;
    for (const json& plane : scene["planes"])
        show(add_fixed(*world, "plane " + std::to_string(++planes), Isometry3d::Identity()),
             std::make_shared<PlaneShape>(vector(plane["normal"]), vector(plane["point"])),
             scene["friction"]);
    std::vector<BodyNode*> bodies;
    for (const json& body : scene["bodies"]) {
        bodies.push_back(body["moves"] ? add_moving(*world, body)
                                       : add_fixed(*world, body["name"], frame_of(body)));
        show(bodies.back(), shape_of(body), scene["friction"]);
    }
    print(0, bodies);
    for (int frame = 0; frame < scene["steps"]; ++frame) {
        const double start = enduring::processor_seconds();
        for (int i = 0; i < substeps; ++i)
            world->step();
        print(1000 * (enduring::processor_seconds() - start), bodies);
    }
}
