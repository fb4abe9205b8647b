// Curves that run along with the steps: energy, depth, and the work of the solver.
import { readable } from "./pairs.js";

const CURVES = [
  { title: "energy", unit: "J", value: n => n.kinetic + n.gravitational + n.elastic + n.springs },
  { title: "deepest pair", unit: "m", value: n => n.depth, logarithmic: true, least: 1e-8 },
  { title: "solver's work", unit: "", value: n => n.newton_steps || n.rounds, from: 0 },
];
export const LANE_COLOURS = ["#3f8fd0", "#d9673f"];

export class Curves {
  constructor(place) {
    this.charts = CURVES.map(curve => {
      const box = document.createElement("figure"), canvas = document.createElement("canvas"), caption = document.createElement("figcaption");
      box.append(caption, canvas);
      place.append(box);
      return { curve, box, canvas, caption };
    });
  }

  // lanes: of each solver its frames; index: which one is shown
  draw(lanes, index) {
    for (const chart of this.charts) this.drawOne(chart, lanes, index);
  }

  drawOne({ curve, box, canvas, caption }, lanes, index) {
    box.hidden = lanes.every(lane => lane.frames.every(({ numbers }) => curve.value(numbers) === undefined)); // a run that was written does not have all
    if (box.hidden) return;
    const style = getComputedStyle(canvas), scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width) return;
    canvas.width = width * scale;
    canvas.height = height * scale;
    const ink = canvas.getContext("2d"), soft = style.getPropertyValue("--separator-color") || "#ccc";
    ink.scale(scale, scale);
    const series = lanes.map(lane => lane.frames.map(frame => [frame.numbers.time, curve.value(frame.numbers)]));
    const values = series.flat().map(([, v]) => v).filter(v => Number.isFinite(v) && (!curve.logarithmic || v > curve.least));
    const last = Math.max(1e-9, ...series.map(points => points.at(-1)?.[0] ?? 0)), first = Math.min(...series.map(points => points[0]?.[0] ?? 0));
    const read = v => curve.logarithmic ? Math.log10(Math.max(v, curve.least)) : v;
    let low = curve.from ?? read(Math.min(...values)), high = read(Math.max(...values));
    if (!values.length) [low, high] = [0, 1];
    if (high - low < 1e-9 * Math.max(1, Math.abs(high))) { low -= 0.5; high += 0.5; }
    const x = t => 4 + (width - 8) * (t - first) / (last - first || 1), y = v => height - 6 - (height - 12) * (read(v) - low) / (high - low);
    ink.strokeStyle = soft;
    ink.lineWidth = 1;
    for (const part of [0, 0.5, 1]) {
      const at = Math.round(6 + (height - 12) * part) + 0.5;
      ink.beginPath(); ink.moveTo(0, at); ink.lineTo(width, at); ink.stroke();
    }
    series.forEach((points, lane) => {
      ink.strokeStyle = LANE_COLOURS[lane];
      ink.lineWidth = 1.8;
      ink.beginPath();
      let drawn = false;
      for (const [t, v] of points) {
        if (!Number.isFinite(v) || curve.logarithmic && v <= 0) { drawn = false; continue; }
        if (drawn) ink.lineTo(x(t), y(v)); else ink.moveTo(x(t), y(v));
        drawn = true;
      }
      ink.stroke();
      const here = points[Math.min(index, points.length - 1)];
      if (here && Number.isFinite(here[1])) { ink.fillStyle = LANE_COLOURS[lane]; ink.beginPath(); ink.arc(x(here[0]), y(here[1]), 3.5, 0, 7); ink.fill(); }
    });
    const here = lanes.map(lane => lane.frames[Math.min(index, lane.frames.length - 1)]).filter(Boolean).map(frame => curve.value(frame.numbers));
    caption.textContent = `${curve.title}${curve.logarithmic ? " (log)" : ""}: ${here.map(v => readable(v, curve.unit)).join(" | ")}`;
  }
}
