#pragma once

#include "chapters/engines/bullet/bullet_bodies.hpp"
#include "chapters/engines/bullet/bullet_shapes.hpp"
#include "common/scenes/scene.hpp"

#include <BulletSoftBody/btDeformableLagrangianForce.h>
#include <btBulletDynamicsCommon.h>

namespace enduring::bullet {

constexpr int default_iterations = 10;  ///< of Bullet's solver

/// Bullet's world of a scene, with all that it refers to.
class BulletWorld {
public:
    /// Replaces the moving bodies of the scene by ones that Bullet moves.
    /// @throws InputError  see bullet_solver()
    explicit BulletWorld(Scene& scene, int iterations = default_iterations);
    ~BulletWorld();
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    /// One step of exactly dt; then all bodies are read back, and Bullet's points of contact.
    void step(World& world, Contacts& contacts, double dt);

private:
    btCollisionShape& shape_of(const std::string& body, std::span<const Vec3> points,
                               const SurfaceTopology& surface, bool moves);
    void add_object(std::shared_ptr<btRigidBody> object, int number);
    void add_plane(const Plane& plane);
    void add_static(const Body& body, int number);
    std::unique_ptr<Body> take_over(const RigidBody& body, int number);
    std::unique_ptr<Body> take_over(const DeformableBody& body);

    std::string scene_;
    bool soft_ = false;    ///< the scene has a deformable body
    double friction_ = 0;  ///< of one surface, so that two of them multiply to the pair's
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<TriangleShape>> triangles_;
    std::vector<std::shared_ptr<btRigidBody>> objects_;
    std::vector<std::shared_ptr<btSoftBody>> soft_bodies_;
    std::vector<std::unique_ptr<btDeformableLagrangianForce>> forces_;

    std::unique_ptr<btCollisionConfiguration> configuration_;
    std::unique_ptr<btCollisionDispatcher> dispatcher_;
    std::unique_ptr<btBroadphaseInterface> broad_phase_;
    std::unique_ptr<btSoftBodySolver> soft_solver_;
    std::unique_ptr<btConstraintSolver> constraint_solver_;
    std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

}  // namespace enduring::bullet
