// Chapter 13: the same sliding cube under each method, with more and more work a step: what each leaves unsolved.
Live.add("methods", (figure, chapters) => {
  const COUNTS = 8, FLOOR = 1e-6, titles = [...chapters.method_titles()]; // FLOOR: in mm, a nanometre
  const COLOURS = ["blue", "violet", "green", "red", "ochre", "grey"];
  figure.aspect = 0.46;
  figure.onPhone = 1.8;
  figure.slider({ name: "k", label: "k, where n = 2ᵏ", from: 0, to: COUNTS - 1, value: 3, digits: 0 });
  figure.slider({ name: "mu", label: "friction μ", from: 0, to: 1, value: 0.5, digits: 2 });
  figure.slider({ name: "speed", label: "speed at first", from: 0, to: 3, value: 1, unit: "m/s", digits: 2 });

  let known = "", exact = 0, rows = []; // of each method: its errors [mm] along the ground, in height and in all, for each n
  function solve(mu, speed) {
    if (known === `${mu} ${speed}`) return;
    known = `${mu} ${speed}`;
    const [way, ...off] = [...chapters.methods(mu, speed, COUNTS)].map(metres => 1000 * metres);
    exact = way;
    rows = titles.map((title, m) => ({ title, after: Array.from({ length: COUNTS }, (_, i) => {
      const at = 2 * (m * COUNTS + i), [along, high] = [off[at], off[at + 1]];
      return { along, high, error: Math.max(FLOOR, Math.hypot(along, high)) };
    }) }));
  }

  const length = mm => Math.abs(mm) < FLOOR ? "0" : Math.abs(mm) < 1e-3 ? `${Math.round(1e6 * Math.abs(mm))} nm` : Math.abs(mm) < 1 ? `${(1000 * Math.abs(mm)).toPrecision(3)} µm` : `${Math.abs(mm).toPrecision(3)} mm`;
  const told = (mm, more, less) => Math.abs(mm) < FLOOR ? "" : `${length(mm)} ${mm > 0 ? more : less}`;
  const off = ({ along, high }) => [told(along, "too far", "too short"), told(high, "too high", "too deep")].filter(Boolean).join(", ") || "exact";

  figure.draw = (g, width, height, c, { k, mu, speed }) => {
    solve(mu, speed);
    const narrow = width < 560, row = 46, table = 30 + titles.length * row;
    const box = narrow ? [44, 24, width - 60, height - table - 84] : [44, 24, 0.56 * width - 60, height - 72];
    const ends = [Math.log10(FLOOR), 3], at = Live.axes(g, c, box, { x: [-0.3, COUNTS - 0.7], y: ends, xlabel: "k", ylabel: "log₁₀ of the distance to the exact place [mm]", xticks: COUNTS, yticks: 5 });
    Live.line(g, c.soft, 1.2, [[at.x(k), box[1]], [at.x(k), box[1] + box[3]]], [4, 4]);
    g.save(); g.beginPath(); g.rect(...box); g.clip();
    rows.forEach(({ after }, m) => {
      const places = after.map(({ error }, i) => [at.x(i), at.y(Math.min(ends[1], Math.log10(error)))]);
      Live.line(g, c[COLOURS[m]], 1.6, places);
      places.forEach((place, i) => Live.dot(g, c[COLOURS[m]], place, i === k ? 6 : 3));
    });
    g.restore();

    const left = narrow ? 16 : 0.56 * width + 18, top = narrow ? height - table - 6 : 24;
    Live.label(g, c.soft, `n = ${2 ** k}, after 0.1 s:`, [left, top + 8]);
    rows.forEach(({ title, after }, m) => {
      const y = top + 36 + m * row;
      Live.dot(g, c[COLOURS[m]], [left + 5, y], 5);
      Live.label(g, c.text, title, [left + 18, y]);
      Live.label(g, c.soft, off(after[k]), [left + 18, y + 18]);
    });
    const order = [...rows].sort((a, b) => a.after[k].error - b.after[k].error), [best, worst] = [order[0], order.at(-1)];
    return `By chapter 11 the cube comes ${exact.toFixed(2)} mm far in 0.1 s. With n = ${2 ** k}, ${best.title} ends nearest to that place (${off(best.after[k])}), and ${worst.title} farthest from it (${off(worst.after[k])}).`;
  };
});
