#include "chapters/engines/bullet/bullet_world.hpp"

#include "chapters/engines/bullet/bullet_contacts.hpp"
#include "chapters/engines/bullet/bullet_vectors.hpp"
#include "common/geometry/shortest_turn.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/static_body.hpp"

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <algorithm>
#include <cmath>

namespace enduring::bullet {
namespace {

bool is_deformable(const Body& body) { return dynamic_cast<const DeformableBody*>(&body) != nullptr; }

btDeformableMultiBodyDynamicsWorld& deformable(btDiscreteDynamicsWorld& world)
{
    return static_cast<btDeformableMultiBodyDynamicsWorld&>(world);
}

}  // namespace

BulletWorld::BulletWorld(Scene& scene, int iterations)
    : scene_(scene.name), friction_(std::sqrt(coefficients_of(scene.contact.friction).mu_s)),
      broad_phase_(std::make_unique<btDbvtBroadphase>())
{
    Solver bullet;
    bullet.name = "Bullet";
    bullet.exact = true;  // it has impulses in place of springs
    require_asked(scene, bullet);
    std::vector<std::unique_ptr<Body>>& bodies = scene.world.bodies;
    soft_ = std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return is_deformable(*body); });
    if (soft_) {
        configuration_ = std::make_unique<btSoftBodyRigidBodyCollisionConfiguration>();
        dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
        auto soft_solver = std::make_unique<btDeformableBodySolver>();
        auto solver = std::make_unique<btDeformableMultiBodyConstraintSolver>();
        solver->setDeformableSolver(soft_solver.get());
        auto world = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
            dispatcher_.get(), broad_phase_.get(), solver.get(), configuration_.get(), soft_solver.get());
        world->getWorldInfo().m_gravity = to_bullet(scene.world.gravity);
        soft_solver_ = std::move(soft_solver);
        constraint_solver_ = std::move(solver);
        world_ = std::move(world);
    } else {
        configuration_ = std::make_unique<btDefaultCollisionConfiguration>();
        dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
        constraint_solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
        world_ = std::make_unique<btDiscreteDynamicsWorld>(dispatcher_.get(), broad_phase_.get(),
                                                           constraint_solver_.get(), configuration_.get());
        btGImpactCollisionAlgorithm::registerAlgorithm(dispatcher_.get());
    }
    world_->setGravity(to_bullet(scene.world.gravity));
    world_->getSolverInfo().m_numIterations = iterations;

    for (const Plane& plane : scene.world.planes)
        add_plane(plane);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int number = static_cast<int>(i);
        if (bodies[i]->is_driven())
            throw InputError(scene_ + ": Bullet cannot take '" + bodies[i]->name() +
                             "': its motion, its forces, its gravity or what is locked is the scene's own");
        if (const auto* rigid = dynamic_cast<const RigidBody*>(bodies[i].get()))
            bodies[i] = take_over(*rigid, number);
        else if (const auto* soft = dynamic_cast<const DeformableBody*>(bodies[i].get()))
            bodies[i] = take_over(*soft);
        else if (dynamic_cast<const StaticBody*>(bodies[i].get()) != nullptr)
            add_static(*bodies[i], number);
        else
            throw InputError(scene_ + ": Bullet cannot take '" + bodies[i]->name() +
                             "': it is neither rigid, deformable nor static");
    }
}

BulletWorld::~BulletWorld()
{
    for (const auto& soft : soft_bodies_)
        deformable(*world_).removeSoftBody(soft.get());
    for (const auto& object : objects_)
        world_->removeRigidBody(object.get());
}

btCollisionShape& BulletWorld::shape_of(const std::string& body, std::span<const Vec3> points,
                                        const SurfaceTopology& surface, bool moves)
{
    const bool convex = is_convex(points, surface);
    if (convex && (moves || soft_))
        return *shapes_.emplace_back(hull_shape(points, surface.faces()));
    if (soft_)
        throw InputError(scene_ + ": Bullet cannot take '" + body +
                         "': its deformable bodies meet convex ones only, and this is not convex");
    if (moves && !surface.is_closed())
        throw InputError(scene_ + ": Bullet cannot take '" + body + "': its surface is open");
    triangles_.push_back(moves ? moving_triangles(points, surface.faces())
                               : static_triangles(points, surface.faces()));
    return *triangles_.back()->shape;
}

void BulletWorld::add_object(std::shared_ptr<btRigidBody> object, int number)
{
    object->setFriction(friction_);
    object->setActivationState(DISABLE_DEACTIVATION);
    object->setUserIndex(number);
    world_->addRigidBody(object.get());
    objects_.push_back(std::move(object));
}

void BulletWorld::add_plane(const Plane& plane)
{
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, nullptr);
    info.m_startWorldTransform.setIdentity();
    if (soft_) {
        const Quaternion turned = shortest_turn(Vec3::UnitY(), plane.normal);
        info.m_collisionShape = shapes_.emplace_back(large_box()).get();
        info.m_startWorldTransform = btTransform(
            to_bullet(turned), to_bullet(plane.point - 0.5 * large_box_size * plane.normal));
    } else {
        info.m_collisionShape = shapes_.emplace_back(half_space(plane.normal)).get();
        info.m_startWorldTransform.setOrigin(to_bullet(plane.point));
    }
    add_object(std::make_shared<btRigidBody>(info), no_body);
}

void BulletWorld::add_static(const Body& body, int number)
{
    std::vector<Vec3> points(body.positions_t0().begin(), body.positions_t0().end());
    for (Vec3& x : points)
        x -= body.centre();
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr,
                                                  &shape_of(body.name(), points, body.surface(), false));
    info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), to_bullet(body.centre()));
    auto object = std::make_shared<btRigidBody>(info);
    object->setCollisionFlags(object->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    add_object(std::move(object), number);
}

std::unique_ptr<Body> BulletWorld::take_over(const RigidBody& body, int number)
{
    std::vector<Vec3> points;
    for (const Vec3& x : body.positions_t0())
        points.push_back(body.motion().pose().to_body(x));
    auto taken = std::make_unique<BulletRigidBody>(body, shape_of(body.name(), points, body.surface(), true));
    // swept as the ball inside it, in steps that move it further than that
    const double radius = inner_radius(points, body.surface().faces());
    if (radius > 0) {
        taken->shared_body()->setCcdMotionThreshold(radius);
        taken->shared_body()->setCcdSweptSphereRadius(radius);
    }
    add_object(taken->shared_body(), number);
    return taken;
}

std::unique_ptr<Body> BulletWorld::take_over(const DeformableBody& body)
{
    btDeformableMultiBodyDynamicsWorld& world = deformable(*world_);
    auto taken = std::make_unique<BulletSoftBody>(body, world.getWorldInfo());
    btSoftBody& soft = *taken->shared_body();
    soft.m_cfg.kDF = friction_;
    soft.m_cfg.kKHR = soft.m_cfg.kCHR = 1;
    soft.m_cfg.collisions = btSoftBody::fCollision::SDF_RD | btSoftBody::fCollision::SDF_RDF |
                            btSoftBody::fCollision::VF_DD;
    soft.m_softSoftCollision = body.rest_neighbours() != nullptr;
    soft.setSelfCollision(soft.m_softSoftCollision);
    soft.setActivationState(DISABLE_DEACTIVATION);
    soft.setUserIndex(no_body);
    btSoftBodyHelpers::generateBoundaryFaces(&soft);
    world.addSoftBody(&soft);
    soft_bodies_.push_back(taken->shared_body());

    const ElasticMaterial& material = body.elastic().material();
    auto elasticity = std::make_unique<btDeformableLinearElasticityForce>();
    elasticity->setYoungsModulus(material.young);
    elasticity->setPoissonRatio(material.poisson);
    elasticity->setDamping(material.mass_damping, material.stiffness_damping);
    forces_.push_back(std::make_unique<btDeformableGravityForce>(world.getGravity()));
    forces_.push_back(std::move(elasticity));
    for (std::size_t i = forces_.size() - 2; i < forces_.size(); ++i)
        world.addForce(&soft, forces_[i].get());
    return taken;
}

void BulletWorld::step(World& world, Contacts& contacts, double dt)
{
    {
        const InnerEdges inner_edges;
        world_->stepSimulation(dt, 0);
    }
    for (const std::unique_ptr<Body>& body : world.bodies)
        if (auto* moved = dynamic_cast<BulletBody*>(body.get()))
            moved->read_back();
    contacts = contacts_of(world, *dispatcher_);
}

}  // namespace enduring::bullet
