// One solver beside another one: its engine, its frames, and its view.
import { Engine } from "./engine.js";
import { element } from "./parts.js";
import { View } from "./view.js";

const named = ({ name, bodies }) => JSON.stringify([name, bodies.map(body => body.name)]);

// Frames are kept with single precision for what is drawn; tables and curves have all digits.
export const kept = frame => ({ ...frame, exact: frame.positions, positions: new Float32Array(frame.positions) });

export class Lane {
  constructor(views, meshes) {
    this.place = element("div", { className: "lab-view" });
    this.title = element("span", { className: "lab-lane" });
    this.place.append(this.title);
    views.append(this.place);
    this.view = new View(this.place);
    this.engine = new Engine(meshes);
    this.frames = [];
  }

  // A scene of the same bodies is seen from where the last one was. `keepView`: the camera of a link.
  begin(scene, frames, { title, colour, showsPairs, replays, keepView = null }) {
    const looked = this.scene && named(this.scene) === named(scene) ? this.view.looks() : null;
    Object.assign(this, { scene, broken: null, frames });
    this.title.textContent = title;
    this.title.style.setProperty("--lane", colour);
    this.view.showsPairs = showsPairs;
    this.view.pulls = !replays;
    this.view.canvas.setAttribute("aria-label", `${scene.name}, ${title}. Drag beside bodies to turn the view${replays ? "" : ", drag a body to pull it"}.`);
    this.view.show(scene, frames[0]);
    if (keepView ?? looked) this.view.look(keepView ?? looked);
  }

  // Takes what the engine gave for the next step. A run that broke stays where it was.
  take(frame) {
    if (frame.error) this.broken = frame.error;
    const next = this.broken ? this.frames.at(-1) : kept(frame);
    delete this.frames.at(-1).exact;
    this.frames.push(next);
  }

  end() {
    this.engine.end();
    this.view.end();
    this.place.remove();
  }
}
