// What the laboratory tells in words and tables: the work of a step, and the numbers of a chosen pair.
import { keyOf, pairAt, pairCount, readable, rowsOf } from "./pairs.js";
import { element } from "./parts.js";

export const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;

function workOf({ numbers: { work, thrown_away }, milliseconds }) {
  const solved = !work ? "" : work.newton_steps ? `${counted(work.rounds, "round")} with ${counted(work.newton_steps, "Newton step")}` : counted(work.responses, "response");
  return [solved, thrown_away ? `${thrown_away} halved so far` : "", milliseconds ? `${readable(Number(milliseconds.toFixed(1)))} ms a step` : ""].filter(Boolean).join(", ");
}

// The line of state: step, time, pairs and work of each lane.
export function stateOf(lanes, index) {
  const frames = lanes.map(lane => lane.frames[index]), [{ numbers: { step, time } }] = frames;
  const told = (frame, i) => (lanes.length > 1 ? `${lanes[i].title.textContent}: ` : "") + [`${frame.numbers.pairs} of ${pairCount(frame)} pairs push`, workOf(frame)].filter(Boolean).join("; ");
  return `Step ${step}, ${time.toFixed(3)} s. ${frames.map(told).join(". ")}.`;
}

function rowsOfChosen(lane, index, chosen) {
  const frame = lane.frames[index];
  for (let i = 0; frame && i < pairCount(frame); ++i) if (keyOf(pairAt(frame, i)) === chosen) return rowsOf(pairAt(frame, i), lane.scene);
  return null;
}

// The table of the chosen pair, a column a lane; a sentence where there is none.
export function pairTable(lanes, index, chosen) {
  const found = lanes.map(lane => rowsOfChosen(lane, index, chosen)), rows = found.find(Boolean);
  if (!rows) return element("p", { textContent: chosen ? "These features are no pair in this step." : "Click the mark of a pair to read its values." });
  const head = lanes.length > 1 ? [element("tr", {}, [element("th"), ...lanes.map(lane => element("th", { textContent: lane.title.textContent }))])] : [];
  const body = rows.map(([name], row) => element("tr", {}, [element("th", { textContent: name }), ...found.map(its => element("td", { textContent: its?.[row][1] ?? "no pair" }))]));
  return element("table", {}, [...head, ...body]);
}
