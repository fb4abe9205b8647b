// The solvers of the course, in JavaScript: a scene as the course's scene format has it, stepped under any chapter's solver or a method of chapter 13.
import factory from "./solver.cjs";

const NUMBERS_A_PAIR = 24;

const unpacked = list => Array.from({ length: list.length / NUMBERS_A_PAIR }, (_, i) => {
  const n = list.subarray(NUMBERS_A_PAIR * i, NUMBERS_A_PAIR * (i + 1)), vector = at => [n[at], n[at + 1], n[at + 2]];
  return { kind: ["vertex-plane", "vertex-face", "edge-edge"][n[0]], bodyA: n[1], bodyB: n[2], featureA: n[3], featureB: n[4], point: vector(5), normal: vector(8), depth: n[11],
           impulse: vector(12), friction: vector(15), stiffness: n[18], pushes: n[22] === 1 };
});

export class Simulation {
  #module;
  #frame;

  /** Reads a scene. @throws {Error} with the message and the place that the program would print */
  static async create(scene, { chapter = 10, solver = chapter, meshes = {} } = {}) {
    const made = new Simulation(), text = typeof scene === "string" ? scene : JSON.stringify(scene);
    made.#module = await factory();
    for (const [name, mesh] of Object.entries(meshes)) made.#module.add_mesh(name, mesh);
    made.scene = made.#checked(made.#module.load(text, "scene.json", String(solver)));
    made.#frame = made.#module.frame();
    return made;
  }

  #checked(result) {
    if (result.error) throw new Error(result.error);
    return result;
  }

  /** Takes some steps. @throws {Error} the run broke; the last good step stays */
  step(steps = 1) {
    if (!Number.isInteger(steps) || steps < 1) throw new RangeError(`steps: expected a whole number from 1 on, found ${steps}`);
    this.#frame = this.#checked(this.#module.advance(steps));
    return this;
  }

  get time() { return this.#frame.numbers.time; }
  get numbers() { return this.#frame.numbers; }
  get positions() { return this.#frame.positions; }
  get pairs() { return unpacked(this.#frame.pairs); }
}
