// Pictures of all views, side by side, and their name as a file.
import { element } from "./parts.js";

// With even sides, as films have them.
export function canvasOfAll(lanes) {
  const even = length => length - length % 2, pictures = lanes.map(lane => lane.view.canvas);
  return element("canvas", { width: even(pictures.reduce((sum, { width }) => sum + width, 0)), height: even(pictures[0].height) });
}

// All views as they are now.
export function paint(whole, lanes) {
  let at = 0;
  for (const { view } of lanes) {
    view.drawNow();
    whole.getContext("2d").drawImage(view.canvas, at, 0);
    at += view.canvas.width;
  }
}

export const save = (address, name) => element("a", { href: address, download: name }).click();
