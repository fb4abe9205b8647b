// A scene under a solver, computed beside the page: each engine is a worker of its own, so two solvers run on two cores, and the page stays smooth.
// The worker is made from the module's own text, for a page that is opened from a file may not load another one.

/* global enduring_lab */

function inTheWorker(factory) {
  let module = null;
  const answer = (id, result, transfer = []) => postMessage({ id, result }, transfer);
  const calls = {
    async begin({ meshes }) {
      module = await factory();
      for (const [name, text] of Object.entries(meshes)) module.add_mesh(name, text);
      return {};
    },
    load({ text, file, solver }) {
      const scene = module.load(text, file, String(solver));
      return scene.error ? scene : { scene, frame: module.frame() };
    },
    advance({ steps }) {
      const begun = performance.now(), frame = module.advance(steps);
      if (!frame.error) frame.milliseconds = (performance.now() - begun) / steps;
      return frame;
    },
    hold({ body, face, target }) {
      module.hold(body, face, ...target);
      return {};
    },
  };
  onmessage = async ({ data: { id, call, given } }) => {
    try {
      const result = await calls[call](given), frame = result.frame ?? result;
      answer(id, result, frame.positions ? [frame.positions.buffer, frame.pairs.buffer, frame.joints.buffer] : []);
    } catch (error) {
      answer(id, { error: `the program ended: ${error.message ?? error}` });
    }
  };
}

export class Engine {
  constructor(meshes) {
    const source = `var _scriptDir = "";\n(${inTheWorker})(${enduring_lab});`;
    this.place = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.worker = new Worker(this.place);
    this.waiting = new Map();
    this.last = 0;
    this.worker.onmessage = ({ data: { id, result } }) => {
      this.waiting.get(id)?.(result);
      this.waiting.delete(id);
    };
    this.worker.onerror = error => {
      for (const go of this.waiting.values()) go({ error: error.message });
      this.waiting.clear();
    };
    this.begun = this.call("begin", { meshes });
  }

  call(call, given) {
    const id = ++this.last;
    return new Promise(go => {
      this.waiting.set(id, go);
      this.worker.postMessage({ id, call, given });
    });
  }

  async load(text, file, solver) {
    await this.begun;
    return this.call("load", { text, file, solver });
  }

  advance(steps) { return this.call("advance", { steps }); }

  hold(body, face, target) { return this.call("hold", { body, face, target }); }

  end() {
    this.worker.terminate();
    URL.revokeObjectURL(this.place);
  }
}
