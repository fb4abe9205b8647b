#include "chapters/engines/engine.hpp"

#ifdef ENDURING_ODE
#include <ode/ode.h>

#include <array>
#endif

namespace enduring::engines {

#ifdef ENDURING_ODE
namespace {

constexpr std::size_t most_points = 64;  ///< of two bodies; ODE gives at most 8 of two boxes

/// The joints of two bodies that are near. mu is a coefficient only with dContactApprox1: else ODE takes it
/// for a force. Its cone is a pyramid along two axes of its own.
struct Touching {
    dWorldID world;
    dJointGroupID joints;
    double friction;

    static void meet(void* data, dGeomID a, dGeomID b)
    {
        const auto& self = *static_cast<Touching*>(data);
        std::array<dContact, most_points> points{};
        const int found = dCollide(a, b, most_points, &points[0].geom, sizeof(dContact));
        for (int i = 0; i < found; ++i) {
            dContact& point = points[static_cast<std::size_t>(i)];
            point.surface.mode = dContactApprox1;
            point.surface.mu = self.friction;
            dJointAttach(dJointCreateContact(self.world, self.joints, &point), dGeomGetBody(a),
                         dGeomGetBody(b));
        }
    }
};

class OdeWorld final : public EngineWorld {
public:
    OdeWorld(const EngineScene& scene, const Way& way) : direct_(way.fine), scene_(scene)
    {
        dInitODE();
        touching_ = {dWorldCreate(), dJointGroupCreate(0), scene.friction};
        space_ = dHashSpaceCreate(nullptr);
        const Vec3& g = scene.gravity;
        dWorldSetGravity(touching_.world, g.x(), g.y(), g.z());
        dWorldSetAutoDisableFlag(touching_.world, 0);
        if (way.iterations > 0)
            dWorldSetQuickStepNumIterations(touching_.world, way.iterations);
        for (const Plane& plane : scene.planes)
            dCreatePlane(space_, plane.normal.x(), plane.normal.y(), plane.normal.z(),
                         plane.normal.dot(plane.point));
        for (const EngineBody& body : scene.bodies)
            add(body);
    }
    ~OdeWorld() override
    {
        dJointGroupDestroy(touching_.joints);
        dSpaceDestroy(space_);
        dWorldDestroy(touching_.world);
        for (const dTriMeshDataID mesh : meshes_)
            dGeomTriMeshDataDestroy(mesh);
        dCloseODE();
    }
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    void step(double dt) override
    {
        dSpaceCollide(space_, &touching_, &Touching::meet);
        if (direct_)
            dWorldStep(touching_.world, dt);
        else
            dWorldQuickStep(touching_.world, dt);
        dJointGroupEmpty(touching_.joints);
    }
    Pose pose(std::size_t body) const override
    {
        const dReal *x = dBodyGetPosition(bodies_[body]), *q = dBodyGetQuaternion(bodies_[body]);
        return {Vec3(x[0], x[1], x[2]), Quaternion(q[0], q[1], q[2], q[3])};
    }

private:
    dGeomID shape_of(const EngineBody& body)
    {
        if (body.half_size)
            return dCreateBox(space_, 2 * body.half_size->x(), 2 * body.half_size->y(),
                              2 * body.half_size->z());
        const dTriMeshDataID mesh = meshes_.emplace_back(dGeomTriMeshDataCreate());
        dGeomTriMeshDataBuildDouble(mesh, body.points.data(), sizeof(Vec3),
                                    static_cast<int>(body.points.size()), body.faces.data(),
                                    static_cast<int>(3 * body.faces.size()), sizeof(Face));
        return dCreateTriMesh(space_, mesh, nullptr, nullptr, nullptr);
    }
    void add(const EngineBody& body)
    {
        const dGeomID shape = shape_of(body);
        bodies_.push_back(body.moves ? dBodyCreate(touching_.world) : nullptr);
        if (!body.moves)
            return;
        const dBodyID taken = bodies_.back();
        dMass mass;
        const Vec3 &inertia = body.inertia, &x = body.frame.position, &v = body.velocity,
                   &w = body.angular_velocity;
        dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia.x(), inertia.y(), inertia.z(), 0, 0, 0);
        dBodySetMass(taken, &mass);
        const Quaternion& q = body.frame.orientation;
        const dQuaternion turn = {q.w(), q.x(), q.y(), q.z()};
        dBodySetPosition(taken, x.x(), x.y(), x.z());
        dBodySetQuaternion(taken, turn);
        dBodySetLinearVel(taken, v.x(), v.y(), v.z());
        dBodySetAngularVel(taken, w.x(), w.y(), w.z());
        dGeomSetBody(shape, taken);
    }

    bool direct_;
    const EngineScene& scene_;  // whose points and faces ODE refers to
    Touching touching_{};
    dSpaceID space_ = nullptr;
    std::vector<dBodyID> bodies_;
    std::vector<dTriMeshDataID> meshes_;
};

}  // namespace
#endif

/// Default: dWorldQuickStep with 20 iterations. Best, by its manual's list of step functions: dWorldStep, a
/// direct solver.
Engine ode_engine()
{
    Engine engine{"ODE",       "",
                  "",          "http://ode.org/wiki/index.php/Manual#Stepping_Functions",
                  {"default"}, {"best", 1, 0, true},
                  {}};
#ifdef ENDURING_ODE
    engine.version = ENDURING_ODE;
    engine.run = [](const Scene& scene, const Way& way, int steps) {
        const EngineScene described = describe(scene);
        OdeWorld world(described, way);
        return follow(described, world, substeps_of(way, described, described.dt), steps);
    };
#else
    engine.missing = "libode-dev is not installed";
#endif
    return engine;
}

}  // namespace enduring::engines
