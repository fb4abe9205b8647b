// Chapters 2 and 3: when do they meet? A vertex and a face, or two edges, through a step; the height as a cubic, its Bernstein coefficients and its roots.
Live.add("query", (figure, chapters) => {
  figure.aspect = 0.5;
  figure.onPhone = 1.3;
  // The points of both kinds of pairs: at the start of the step, then at its end.
  const pairs = {
    face: [[0.1, 1.0, 0.1], [-1, 0, -0.8], [-0.7, 0, 0.9], [1.1, 0, 0.1], [0.1, -0.7, 0.1], [-1, 0, -0.8], [-0.7, 0, 0.9], [1.1, 0, 0.1]],
    edges: [[-0.9, 0.8, 0.3], [0.9, 1.0, -0.2], [-0.2, 0, 0.9], [0.2, 0, -0.9], [-0.9, -0.6, 0.3], [0.9, -0.4, -0.2], [-0.2, 0, 0.9], [0.2, 0, -0.9]]
  };
  figure.slider({ name: "tilt", label: "other feature's end moves by", from: -1.2, to: 1.2, value: 0, unit: "m" });
  figure.slider({ name: "tau", label: "time τ", from: 0, to: 1, value: 0 });
  figure.choice({ name: "kind", label: "pair", options: [["face", "vertex and face"], ["edges", "two edges"]] });
  const points = () => {
    const list = pairs[figure.values.kind].map(p => [...p]);
    list[figure.values.kind === "face" ? 7 : 6][1] += figure.values.tilt;
    return list;
  };
  const view = Live.turning(figure, { azimuth: 24, elevation: 16 });
  const free = () => figure.values.kind === "face" ? [0, 4] : [0, 1, 4, 5];
  for (const i of [0, 1, 4, 5])
    figure.handle(() => free().includes(i) ? view(points()[i]) : [-99, -99], (x, y) => {
      const p = pairs[figure.values.kind][i];
      [p[0], p[1], p[2]] = view.back(x, y, p).map(v => Math.max(-1.5, Math.min(1.5, v)));
    });

  figure.draw = (g, width, height, c, { tau, kind }) => {
    const all = points(), narrow = width < 500;
    const [first, stage, b0, b1, b2, b3, ...roots] = chapters.query(kind === "edges", all.flat());
    const stageBox = narrow ? [0, 0, width, height * 0.52] : [0, 0, width * 0.5, height];
    const plotBox = narrow ? [40, height * 0.56, width - 56, height * 0.33] : [width * 0.5 + 46, 22, width * 0.5 - 62, height - 66];
    const s = Math.min(stageBox[2], stageBox[3]) * 0.3, [ox, oy] = [stageBox[2] / 2, stageBox[3] * 0.52];
    view.place(stageBox, [ox, oy], s);
    const now = t => all.slice(0, 4).map((p, i) => p.map((v, k) => v + t * (all[i + 4][k] - v)));
    const draw = (p, colour, width_, fill) => {
      if (kind === "face") {
        if (fill) Live.area(g, fill, [p[1], p[2], p[3]].map(view));
        Live.line(g, colour, width_, [p[1], p[2], p[3], p[1]].map(view));
      } else
        Live.line(g, colour, width_ + 1, [p[2], p[3]].map(view));
    };
    view.draw(g, c, () => {
      draw(now(0), c.soft, 1);
      draw(now(1), c.soft, 1);
      draw(now(tau), c.ochre, 2, c.ochre + "40");
      const movers = kind === "face" ? [0] : [0, 1];
      for (const i of movers) Live.line(g, c.blue, 1.2, [view(all[i]), view(all[i + 4])], [4, 4]);
      if (kind === "edges") for (const t of [0, 1]) Live.line(g, c.blue + "90", 1.2, now(t).slice(0, 2).map(view));
      if (kind === "edges") Live.line(g, c.blue, 3, now(tau).slice(0, 2).map(view));
      for (const i of free()) Live.dot(g, c.blue, view(all[i]), 6, true);
      for (const i of movers) Live.dot(g, c.blue, view(now(tau)[i]), 5);
      if (first >= 0) for (const i of movers) Live.dot(g, c.red, view(now(first)[i]), 5, true);
      Live.label(g, c.soft, "start", view(all[0]).map((v, i) => v + (i ? -14 : 8)));
      Live.label(g, c.soft, "end", view(all[4]).map((v, i) => v + (i ? 14 : 8)));
    });

    const b = [b0, b1, b2, b3], size = Math.max(...b.map(Math.abs), 1e-6) * 1.15;
    const at = Live.axes(g, c, plotBox, { x: [0, 1], y: [-size, size], xlabel: "τ", ylabel: "height × length of the normal", yticks: 4 });
    const value = t => b0 * (1 - t) ** 3 + 3 * b1 * t * (1 - t) ** 2 + 3 * b2 * t * t * (1 - t) + b3 * t ** 3;
    Live.line(g, c.soft, 1.5, [[at.x(0), at.y(0)], [at.x(1), at.y(0)]]);
    Live.line(g, c.grey, 1, b.map((v, i) => [at.x(i / 3), at.y(v)]), [4, 4]);
    Live.line(g, c.blue, 2.2, Array.from({ length: 81 }, (_, i) => [at.x(i / 80), at.y(value(i / 80))]));
    b.forEach((v, i) => { const place = [at.x(i / 3), at.y(v)]; Live.dot(g, v >= 0 ? c.green : c.red, place, 5); Live.label(g, c.text, v >= 0 ? "+" : "−", [place[0] + (i < 3 ? 8 : -14), place[1] - 8]); });
    for (const root of roots) Live.dot(g, c.violet, [at.x(root), at.y(0)], 5, true);
    Live.line(g, c.ochre, 1.5, [[at.x(tau), plotBox[1]], [at.x(tau), plotBox[1] + plotBox[3]]]);
    if (first >= 0) Live.dot(g, c.red, [at.x(first), at.y(0)], 7, true);
    const signs = b.map(v => v >= 0 ? "+" : "−").join(" ");
    const found = first < 0 ? "no touch" : `first touch at τ = ${first.toFixed(4)}`;
    const how = ["by the signs alone", "by a search in doubles", "by a search with 106 bits"][stage];
    return `Signs ${signs}; coplanar at ${roots.length ? roots.map(r => r.toFixed(4)).join(", ") : "no time in the step"}; ${found}, settled ${how}.`;
  };
});
