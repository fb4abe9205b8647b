// MuJoCo, as its authors compile it for browsers. The scene comes as MuJoCo's own XML (mjcf.cpp).
import { load, run, scene } from "./scene.mjs";

const { default: load_mujoco } = await load("@mujoco/mujoco");
const mujoco = await load_mujoco({ print: console.error, printErr: console.error });
const model = mujoco.MjModel.from_xml_string(scene.mjcf), data = new mujoco.MjData(model);
scene.velocities.forEach((velocity, i) => { data.qvel[i] = velocity; });

let moving = 0;
const number = scene.bodies.map(body => body.moves ? moving++ : -1);
run(() => mujoco.mj_step(model, data), i => Array.from(data.qpos.slice(7 * number[i], 7 * number[i] + 7)));
