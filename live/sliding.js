// Chapter 6: a cube slides over triangles, with redefinition or without. The solver runs in the page.
Live.add("sliding", (figure, chapters) => {
  figure.aspect = 0.5;
  figure.onPhone = 0.95;
  const MARK = [c => c.grey, c => c.blue, c => c.ochre, c => c.grey];
  let state = null, history = [];
  const begin = () => {
    chapters.begin_sliding(Number(figure.values.solver), figure.values.speed);
    history = [];
    take(0);
  };
  const take = steps => {
    state = chapters.slide_on(steps);
    history.push([state[0], state[1]]);
  };
  figure.slider({ name: "speed", label: "speed at the start", from: 0.5, to: 2, value: 1.5, unit: "m/s", digits: 1 });
  figure.choice({ name: "solver", label: "solver", options: [["6", "chapter 6: pairs are redefined"], ["5", "chapter 5: pairs stay as they were found"]] });
  figure.changed = () => { begin(); };
  const place = () => [0, 1, 2, 3, 4, 5, 6, 7].reduce((sum, i) => sum + state[3 + 3 * i] / 8, 0);
  const over = () => state[0] > 3 || Math.abs(place()) > 3.4;  // or the cube comes to an end of the drawing
  let rest = 0;
  const motion = figure.animate(seconds => {
    rest += seconds;
    const steps = Math.floor(rest / 0.01);
    rest -= steps * 0.01;
    if (steps) take(steps);
    if (over()) motion.stop();
  });
  figure.button("run", () => { if (over()) begin(); motion.start(); });
  figure.button("one step", () => { motion.stop(); if (!over()) take(1); figure.redraw(); });
  figure.button("again", () => { motion.stop(); begin(); figure.redraw(); });

  const view = Live.turning(figure, { azimuth: 10, elevation: 24 });
  // The floor, the cube, and its pairs.
  const scene = (g, c) => {
    const cell = 2 / 3, x = i => -4 + cell * i, z = j => -1 + cell * j, edge = c.grey + "90";  // as begin_sliding builds the floor
    for (let i = 0; i <= 12; ++i) Live.line(g, edge, 1, [view([x(i), 0, -1]), view([x(i), 0, 1])]);
    for (let j = 0; j <= 3; ++j) Live.line(g, edge, 1, [view([-4, 0, z(j)]), view([4, 0, z(j)])]);
    for (let i = 0; i < 12; ++i)
      for (let j = 0; j < 3; ++j) Live.line(g, edge, 1, [view([x(i), 0, z(j)]), view([x(i + 1), 0, z(j + 1)])]);
    const corners = Array.from({ length: 8 }, (_, i) => [state[3 + 3 * i], state[4 + 3 * i], state[5 + 3 * i]]);
    for (let i = 0; i < 8; ++i)
      for (let j = i + 1; j < 8; ++j) {
        const gap = Math.hypot(...corners[i].map((v, k) => v - corners[j][k]));
        if (gap < 1.01) Live.line(g, c.red, 2.2, [view(corners[i]), view(corners[j])]);
      }
    for (let i = 27; i + 3 < state.length; i += 4) {
      const kind = state[i + 3];
      Live.dot(g, MARK[kind](c), view([state[i], state[i + 1], state[i + 2]]), kind === 2 ? 5.5 : 4, kind === 3);
    }
  };

  figure.draw = (g, width, height, c, values) => {
    const stage = height * 0.62, [time, speed, pairs] = state;
    view.fit([0, 0, width, stage], [-4, 4].flatMap(x => [-1, 1].flatMap(z => [[x, 0, z], [x, 1.1, z]])));
    view.draw(g, c, () => scene(g, c));
    const at = Live.axes(g, c, [48, stage + 22, width - 64, height - stage - 66], { x: [0, 3], y: [-1, 2.2], xlabel: "time [s]", ylabel: "speed [m/s]", yticks: 3 });
    Live.line(g, c.blue, 2.2, history.map(([t, v]) => [at.x(Math.min(t, 3)), at.y(Math.max(-1, Math.min(2.2, v)))]));
    return `Chapter ${values.solver}'s solver, t = ${time.toFixed(2)} s: the cube slides with ${speed.toFixed(4)} m/s on ${pairs} pairs. Blue pairs are regular, orange ones hooked, hollow ones held.`;
  };
  begin();
});
