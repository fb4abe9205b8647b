// Rapier, in single precision. It takes a plane as a box of 100 m. Fine: errors of 0.1 mm are corrected, which are 5 mm by default; at rest
// neither shows.
import { load, run, scene } from "./scene.mjs";

const { default: RAPIER } = await load("@dimforge/rapier3d-compat");
await RAPIER.init();
const vector = ([x, y, z]) => ({ x, y, z }), turn = ([w, x, y, z]) => ({ x, y, z, w });
const world = new RAPIER.World(vector(scene.gravity)), settings = world.integrationParameters;
settings.dt = scene.dt / scene.way.substeps;
if (scene.way.iterations) settings.numSolverIterations = scene.way.iterations;
if (scene.way.fine) settings.normalizedAllowedLinearError = 1e-4;

const Shape = RAPIER.ColliderDesc, Body = RAPIER.RigidBodyDesc, Rule = RAPIER.CoefficientCombineRule;
const shape_of = body => {
    if (body.half_size) return Shape.cuboid(...body.half_size);
    const points = new Float32Array(body.points);
    return body.moves ? Shape.convexHull(points)
        : Shape.trimesh(points, new Uint32Array(body.faces), RAPIER.TriMeshFlags.FIX_INTERNAL_EDGES);
};
const add = (body, desc, shape) => {
    const made = world.createRigidBody(desc);
    world.createCollider(shape.setFriction(scene.friction).setFrictionCombineRule(Rule.Max), made);
    return made;
};
for (const { point, normal } of scene.planes) {
    const half = 50, [x, y, z] = normal, turned = 1 + y > 1e-9 ? [1 + y, z, 0, -x] : [0, 1, 0, 0], long = Math.hypot(...turned);
    const middle = point.map((coordinate, i) => coordinate - half * normal[i]);
    add(null, Body.fixed().setTranslation(...middle).setRotation(turn(turned.map(n => n / long))), Shape.cuboid(half, half, half));
}
const bodies = scene.bodies.map(body => add(body,
    (body.moves ? Body.dynamic().setCanSleep(false).setLinvel(...body.velocity).setAngvel(vector(body.angular_velocity)).setCcdEnabled(true)
        : Body.fixed()).setTranslation(...body.position).setRotation(turn(body.orientation)),
    body.moves ? shape_of(body).setMassProperties(body.mass, vector([0, 0, 0]), vector(body.inertia), turn([1, 0, 0, 0])) : shape_of(body)));
run(() => world.step(), i => {
    const x = bodies[i].translation(), q = bodies[i].rotation();
    return [x.x, x.y, x.z, q.w, q.x, q.y, q.z];
});
