// A view of things in space that turns: by dragging beside the points, by the arrow keys, and back by a button or the key Home.
// No perspective: parallel lines stay parallel, and equal lengths that are parallel look equal. x to the right, y up, z to the viewer.
"use strict";

Live.turning = (figure, { azimuth, elevation }) => {
  const STEEPEST = 85, A_PIXEL = 0.5, A_KEY = 5; // degrees
  const start = [azimuth, elevation], now = [...start], radians = degrees => degrees * Math.PI / 180;
  let box = [0, 0, 0, 0], centre = [0, 0], scale = 1;

  // The directions of the picture in space: to its right, up, and out of it to the viewer.
  const frame = () => {
    const [a, e] = now.map(radians);
    return [[Math.cos(a), 0, Math.sin(a)], [Math.sin(a) * Math.sin(e), Math.cos(e), -Math.cos(a) * Math.sin(e)],
            [-Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)]];
  };
  const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
  const view = point => {
    const [right, up] = frame();
    return [centre[0] + scale * dot(right, point), centre[1] - scale * dot(up, point)];
  };

  // Where a point goes that is dragged to a place: in that coordinate plane through it which faces the viewer most.
  view.back = (x, y, point) => {
    const [right, up, out] = frame(), fixed = out.map(Math.abs).indexOf(Math.max(...out.map(Math.abs)));
    const [i, j] = [0, 1, 2].filter(k => k !== fixed), [px, py] = view(point), u = (x - px) / scale, v = (py - y) / scale;
    const determinant = right[i] * up[j] - right[j] * up[i], moved = [...point];
    moved[i] += (u * up[j] - v * right[j]) / determinant;
    moved[j] += (v * right[i] - u * up[i]) / determinant;
    return moved;
  };

  const turnTo = (a, e) => {
    [now[0], now[1]] = [(a + 540) % 360 - 180, Math.max(-STEEPEST, Math.min(STEEPEST, e))];
    back.disabled = now.every((v, i) => v === start[i]);
    figure.element.dataset.view = now.join(" ");
    figure.redraw();
  };
  const within = (x, y) => x >= box[0] && x <= box[0] + box[2] && y >= box[1] && y <= box[1] + box[3];
  figure.surface(within, (dx, dy) => turnTo(now[0] + A_PIXEL * dx, now[1] + A_PIXEL * dy));
  const back = figure.button("turn back", () => turnTo(...start));
  const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  figure.canvas.tabIndex = 0;
  figure.canvas.setAttribute("aria-label", `${figure.canvas.getAttribute("aria-label")} Arrow keys turn the view, Home turns it back.`);
  figure.canvas.addEventListener("keydown", event => {
    const by = keys[event.key];
    if (by) turnTo(now[0] + A_KEY * by[0], now[1] + A_KEY * by[1]);
    else if (event.key === "Home") turnTo(...start);
    else return;
    event.preventDefault(); // the page does not scroll, and a slide stays
    event.stopPropagation();
  });

  turnTo(...start);

  // Where on the canvas it is: the box that takes the dragging, the place of the origin, and the pixels of a metre.
  view.place = (stage, origin, pixels) => { [box, centre, scale] = [stage, origin, pixels]; };
  // The same, as large as lets all the points be seen.
  view.fit = (stage, points) => {
    const [right, up] = frame(), ends = values => [Math.min(...values), Math.max(...values)];
    const [left, most] = ends(points.map(p => dot(right, p))), [bottom, top] = ends(points.map(p => dot(up, p)));
    const pixels = 0.94 * Math.min(stage[2] / (most - left), stage[3] / (top - bottom));
    view.place(stage, [stage[0] + stage[2] / 2 - pixels * (left + most) / 2, stage[1] + stage[3] / 2 + pixels * (bottom + top) / 2], pixels);
  };
  // Draws within the box, and in its corner which way x, y and z go; and, until it has been turned, that it can be.
  view.draw = (g, c, paint) => {
    g.save(); g.beginPath(); g.rect(...box); g.clip();
    compass(g, c);
    paint();
    g.restore();
  };
  const compass = (g, c) => {
    const at = [box[0] + 28, box[1] + 32], out = frame()[2];
    ["x", "y", "z"].forEach((name, k) => {
      const axis = [0, 1, 2].map(i => i === k ? 18 / scale : 0), end = view(axis).map((v, i) => v - centre[i] + at[i]);
      Live.line(g, c.soft, out[k] < -0.5 ? 1 : 1.6, [at, end]);
      Live.label(g, c.soft, name, end.map((v, i) => v + 0.4 * (v - at[i])), "center");
    });
    if (back.disabled) Live.label(g, c.soft, "drag to turn", [at[0] + 32, at[1] - 2]);
  };
  return view;
};
