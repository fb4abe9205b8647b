// Jolt, in single precision. It rounds corners by 50 mm and leaves 20 mm of depth alone by default. Fine: neither.
import { load, run, scene, triples } from "./scene.mjs";

const { default: load_jolt } = await load("jolt-physics");
const Jolt = await load_jolt(), { way } = scene;
const still = 0, moving = 1, vector = ([x, y, z]) => new Jolt.Vec3(x, y, z), place = ([x, y, z]) => new Jolt.RVec3(x, y, z);
const settings = new Jolt.JoltSettings(), pairs = new Jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(still, moving);
pairs.EnableCollision(moving, moving);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
layers.MapObjectToBroadPhaseLayer(still, new Jolt.BroadPhaseLayer(0));
layers.MapObjectToBroadPhaseLayer(moving, new Jolt.BroadPhaseLayer(1));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
settings.mMaxWorkerThreads = 0;
const world = new Jolt.JoltInterface(settings), system = world.GetPhysicsSystem();
system.SetGravity(vector(scene.gravity));
const physics = system.GetPhysicsSettings();
physics.mAllowSleeping = false;
if (way.fine) physics.mPenetrationSlop = 1e-4;  // [m]
if (way.iterations) physics.mNumVelocitySteps = way.iterations;
system.SetPhysicsSettings(physics);

const radius = way.fine ? 0 : 0.05;  // of corners [m]
const shape_of = body => {
    if (body.half_size) return new Jolt.BoxShape(vector(body.half_size), Math.min(radius, ...body.half_size));
    const mesh = body.moves ? new Jolt.ConvexHullShapeSettings() : new Jolt.MeshShapeSettings();
    if (body.moves) {
        mesh.mMaxConvexRadius = radius;
        triples(body.points).forEach(x => mesh.mPoints.push_back(vector(x)));
    } else {
        triples(body.points).forEach(x => mesh.mTriangleVertices.push_back(new Jolt.Float3(...x)));
        triples(body.faces).forEach(face => mesh.mIndexedTriangles.push_back(new Jolt.IndexedTriangle(...face, 0)));
        mesh.mActiveEdgeCosThresholdAngle = 0.996;
    }
    return mesh.Create().Get();
};
const add = (shape, body) => {
    const [w, x, y, z] = body.orientation, desc = new Jolt.BodyCreationSettings(shape, place(body.position), new Jolt.Quat(x, y, z, w),
        body.moves ? Jolt.EMotionType_Dynamic : Jolt.EMotionType_Static, body.moves ? moving : still);
    desc.mFriction = scene.friction;  // Jolt takes the geometric mean
    desc.mRestitution = desc.mLinearDamping = desc.mAngularDamping = 0;
    if (body.moves) {
        desc.mAllowSleeping = false;
        desc.mMotionQuality = Jolt.EMotionQuality_LinearCast;
        desc.mEnhancedInternalEdgeRemoval = true;
        desc.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
        desc.mMassPropertiesOverride.mMass = body.mass;
        desc.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(vector(body.inertia));
        desc.mLinearVelocity = vector(body.velocity);
        desc.mAngularVelocity = vector(body.angular_velocity);
    }
    const made = system.GetBodyInterface().CreateBody(desc);
    system.GetBodyInterface().AddBody(made.GetID(), Jolt.EActivation_Activate);
    return made;
};
for (const { point, normal } of scene.planes)
    add(new Jolt.PlaneShape(Jolt.Plane.prototype.sFromPointAndNormal(vector(point), vector(normal)), null, 1000),
        { moves: false, position: [0, 0, 0], orientation: [1, 0, 0, 0] });
const bodies = scene.bodies.map(body => add(shape_of(body), body));
run(() => world.Step(scene.dt / way.substeps, 1), i => {
    const x = bodies[i].GetPosition(), q = bodies[i].GetRotation();
    return [x.GetX(), x.GetY(), x.GetZ(), q.GetW(), q.GetX(), q.GetY(), q.GetZ()];
});
