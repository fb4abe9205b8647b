// Curves that run along with the steps: energy, depth, and the work of the solver.
import { axisOf } from "./axis.js";
import { readable } from "./pairs.js";

const CURVES = [
  { title: "energy", unit: "J", value: n => n.kinetic + n.gravitational + n.elastic + n.springs },
  { title: "deepest pair", unit: "m", value: n => n.depth, logarithmic: true },
  { title: "Newton steps, or responses before chapter 7", unit: "", value: ({ work }) => work && (work.newton_steps || work.responses), from: 0 },
  { title: "attempts at a step", unit: "", value: ({ work }) => work?.attempts, from: 0 },
];
export const LANE_COLOURS = ["#3f8fd0", "#d9673f"];
const EDGE = { left: 62, right: 6, top: 8, bottom: 20 }; // [px] around the curves, for what is written there

// As it stands beside an axis: a power of ten alone.
const short = value => readable(value).replace("1.00·", "");

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
    const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width) return;
    canvas.width = width * scale;
    canvas.height = height * scale;
    const ink = canvas.getContext("2d");
    ink.scale(scale, scale);
    const times = lanes.flatMap(({ frames }) => [frames[0], frames.at(-1)]).filter(Boolean).map(({ numbers }) => numbers.time), first = Math.min(...times), last = Math.max(...times);
    const axis = axisOf(lanes.map(({ frames }) => frames.map(({ numbers }) => curve.value(numbers))), curve);
    const place = {
      x: time => EDGE.left + (width - EDGE.left - EDGE.right) * (last > first ? (time - first) / (last - first) : 0),
      y: part => height - EDGE.bottom - (height - EDGE.top - EDGE.bottom) * part,
    };
    frameOf(ink, getComputedStyle(canvas), width, place, axis, [first, last]);
    lanes.forEach(({ frames }, lane) => curveOf(ink, lane, place, frames.map(({ numbers }) => [numbers.time, axis.of(curve.value(numbers))]), index));
    const here = lanes.map(({ frames }) => frames[Math.min(index, frames.length - 1)]).filter(Boolean).map(({ numbers }) => curve.value(numbers));
    caption.textContent = `${curve.title}${curve.logarithmic ? " (log)" : ""}: ${here.map(v => readable(v, curve.unit)).join(" | ")}`;
  }
}

// Three lines, and what they stand for.
function frameOf(ink, style, width, { x, y }, { ends }, times) {
  ink.strokeStyle = style.getPropertyValue("--separator-color") || "#ccc";
  ink.fillStyle = style.getPropertyValue("--page-secondary-foreground-color") || "#666";
  ink.font = `11px ${style.fontFamily}`;
  ink.lineWidth = 1;
  for (const part of [0, 0.5, 1]) {
    const at = Math.round(y(part)) + 0.5;
    ink.beginPath(); ink.moveTo(x(times[0]), at); ink.lineTo(width, at); ink.stroke();
  }
  ink.textAlign = "right";
  ink.textBaseline = "middle";
  ends.forEach((value, part) => ink.fillText(short(value), EDGE.left - 6, y(part)));
  ink.textBaseline = "top";
  ink.fillText(`${short(times[1])} s`, width, y(0) + 6);
  ink.textAlign = "left";
  ink.fillText(`${short(times[0])} s`, EDGE.left, y(0) + 6);
}

// The second solver's curve has gaps, through which the first one's is seen where both are the same.
function curveOf(ink, lane, { x, y }, points, index) {
  ink.strokeStyle = ink.fillStyle = LANE_COLOURS[lane];
  ink.lineWidth = 1.8;
  ink.setLineDash(lane ? [7, 4] : []);
  ink.beginPath();
  let drawn = false;
  for (const [time, part] of points) {
    if (part !== null) drawn ? ink.lineTo(x(time), y(part)) : ink.moveTo(x(time), y(part));
    drawn = part !== null;
  }
  ink.stroke();
  const [time, part] = points[Math.min(index, points.length - 1)] ?? [0, null];
  if (part === null) return;
  ink.beginPath(); ink.arc(x(time), y(part), 3.5, 0, 7); ink.fill();
}
