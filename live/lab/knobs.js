// Sliders for three numbers of a scene's text: friction, the length of a step and, where a solver takes it from the scene, the stiffness of pairs.
import { element, labelled } from "./parts.js";

const LAST_WITH_STIFFNESS = 6; // from chapter 7 on the solver finds it
const ROUNDED = 3;             // digits of what a slider writes
const KNOBS = [
  { name: "µ", unit: "", from: 0, to: 1.5, steps: 150, read: scene => scene.contact?.friction?.mu_s,
    write: (scene, mu) => { const { friction } = scene.contact, share = friction.mu_s > 0 ? (friction.mu_d ?? friction.mu_s) / friction.mu_s : 1; friction.mu_s = mu; friction.mu_d = Number((mu * share).toPrecision(ROUNDED)); } },
  { name: "dt", unit: "s", from: 1e-3, to: 0.05, steps: 100, logarithmic: true, read: scene => scene.dt, write: (scene, dt) => { scene.dt = dt; } },
  { name: "k", unit: "N/m", from: 10, to: 1e6, steps: 100, logarithmic: true, until: LAST_WITH_STIFFNESS, read: scene => scene.contact?.stiffness ?? 1000,
    write: (scene, k) => { (scene.contact ??= {}).stiffness = k; } },
];

const valueAt = ({ from, to, steps, logarithmic }, at) => Number((logarithmic ? from * (to / from) ** (at / steps) : from + (to - from) * at / steps).toPrecision(ROUNDED));
const placeOf = ({ from, to, steps, logarithmic }, value) => Math.round(steps * (logarithmic ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from)));

// The text with one number changed, or null where it is no scene that has it.
export function changed(text, knob, value) {
  try {
    const scene = JSON.parse(text);
    if (knob.read(scene) === undefined) return null;
    knob.write(scene, value);
    return `${JSON.stringify(scene, null, 1)}\n`;
  } catch {
    return null;
  }
}

export class Knobs {
  // `read` gives the scene's text; `write` is given a new one, when a slider is let go.
  constructor(read, write) {
    this.rows = KNOBS.map(knob => {
      const input = element("input", { type: "range", min: 0, max: knob.steps, ariaLabel: knob.name }), told = element("output");
      const tell = value => { told.textContent = `${value} ${knob.unit}`.trim(); };
      input.addEventListener("input", () => tell(valueAt(knob, Number(input.value))));
      input.addEventListener("change", () => {
        const text = changed(read(), knob, valueAt(knob, Number(input.value)));
        if (text) write(text);
      });
      const row = labelled(knob.name, input);
      row.append(told);
      return { knob, row, input, tell };
    });
    this.box = element("div", { className: "lab-bar lab-knobs" }, this.rows.map(({ row }) => row));
  }

  // What the text says; a number that the least of the solvers does not read has no slider.
  show(text, least) {
    let scene = null;
    try { scene = JSON.parse(text); } catch { /* the page tells the mistake */ }
    this.box.hidden = !scene;
    for (const { knob, row, input, tell } of this.rows) {
      const value = scene ? knob.read(scene) : undefined;
      row.hidden = value === undefined || least > (knob.until ?? Infinity);
      if (row.hidden) continue;
      input.value = placeOf(knob, value);
      tell(value);
    }
  }
}
