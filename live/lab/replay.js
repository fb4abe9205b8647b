// A run that a program wrote (common/experiments/own_scene/replay.hpp), as the scene and the frames that an engine would give.
const floats = text => new Float32Array(Uint8Array.from(atob(text), letter => letter.charCodeAt(0)).buffer);
const NUMBERS_OF_A_POSE = 7;

// @throws Error  it is another file
export function replayed(file) {
  if (file?.replay !== 1) throw new Error("this is no run: a program writes replay.json beside the tables of --scene");
  const bodies = file.scene.bodies.map(body => {
    const points = floats(body.points);
    return { ...body, points };
  });
  const frames = file.frames.map(({ numbers, motion, pairs, joints = "" }) =>
    ({ numbers, pairs: Float64Array.from(floats(pairs)), joints: Float64Array.from(floats(joints)), positions: positionsOf(bodies, floats(motion)) }));
  if (!frames.length) throw new Error("this run has no frames");
  return { scene: { ...file.scene, bodies }, frames };
}

function positionsOf(bodies, motion) {
  const all = new Float32Array(bodies.reduce((sum, { points }) => sum + points.length, 0));
  let to = 0, from = 0;
  for (const { kind, points } of bodies) {
    if (kind === "rests") all.set(points, to);
    else if (kind === "rigid") all.set(placed(points, motion.subarray(from, from += NUMBERS_OF_A_POSE)), to);
    else all.set(motion.subarray(from, from += points.length), to);
    to += points.length;
  }
  return all;
}

// Points of a body's own coordinates, turned by the quaternion (x, y, z, w) and then shifted.
function placed(points, [px, py, pz, x, y, z, w]) {
  const there = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    const [a, b, c] = points.subarray(i, i + 3), u = 2 * (y * c - z * b), v = 2 * (z * a - x * c), t = 2 * (x * b - y * a);
    there[i] = px + a + w * u + y * t - z * v;
    there[i + 1] = py + b + w * v + z * u - x * t;
    there[i + 2] = pz + c + w * t + x * v - y * u;
  }
  return there;
}
