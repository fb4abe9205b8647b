// Chapter 7: no step is too long. The particle's heights, its energy, and the eigenvalues of its implicit step against the unit circle.
Live.add("implicit", (figure, chapters) => {
  const dt = 0.01, seconds = 2;
  figure.aspect = 0.5;
  figure.onPhone = 1.75;
  figure.slider({ name: "h", label: "stiffness h = kΔt²/m", from: 0.01, to: 10000, value: 16, digits: 2, logarithmic: true });
  figure.slider({ name: "a", label: "centre a of the weight", from: 0.3, to: 1, value: 0.5, digits: 2 });
  figure.choice({ name: "moved", label: "moved by", options: [["end", "the end's velocity"], ["mean", "the mean velocity"]] });
  figure.draw = (g, width, height, c, { h, a, moved }) => {
    const [radius, limit, re0, im0, re1, im1, ...path] = chapters.implicit(h, a, moved === "mean", Math.round(seconds / dt) + 1);
    const heights = path.filter((_, i) => i % 2 === 0), energies = path.filter((_, i) => i % 2 === 1);
    const narrow = width < 500, split = narrow ? width : width * 0.64;
    const below = narrow ? height - 0.72 * width : height, upper = 0.52 * (below - 100), lower = below - 112 - upper;
    const left = 44, wide = split - left - 18;

    const deepest = Math.min(...heights), bottom = Math.min(-0.012, Math.max(-0.45, 1.15 * deepest));
    const top = Math.max(0.11, Math.min(0.5, 1.1 * Math.max(...heights)));
    const at = Live.axes(g, c, [left, 22, wide, upper], { x: [0, seconds], y: [bottom, top], ylabel: "height [m]" });
    Live.area(g, c.grey + "30", [[at.x(0), at.y(0)], [at.x(seconds), at.y(0)], [at.x(seconds), at.y(bottom)], [at.x(0), at.y(bottom)]]);
    curve(heights, at, [left, 22, wide, upper], c.blue, 1.8);

    const most = Math.max(1.1, Math.min(3, 1.1 * Math.max(...energies)));
    const box = [left, 66 + upper, wide, lower];
    const of = Live.axes(g, c, box, { x: [0, seconds], y: [0, most], xlabel: "time [s]", ylabel: "energy above rest, over the first", yticks: 3 });
    Live.line(g, c.soft, 1, [[of.x(0), of.y(1)], [of.x(seconds), of.y(1)]], [4, 4]);
    curve(energies, of, box, c.ochre, 0);

    const room = narrow ? 0.66 * width : Math.min(below - 62, width - split - 6), half = room / 2;
    const [cx, cy] = narrow ? [width / 2, below + 16 + half] : [split + 6 + half, 22 + (below - 62) / 2], unit = half * 0.72;
    Live.line(g, c.line, 1, [[cx - half, cy], [cx + half, cy]]);
    Live.line(g, c.line, 1, [[cx, cy - half], [cx, cy + half]]);
    g.strokeStyle = c.soft; g.lineWidth = 1.5; g.beginPath(); g.arc(cx, cy, unit, 0, 2 * Math.PI); g.stroke();
    const kept = Math.abs(radius - 1) < 1e-9, colour = kept ? c.ochre : radius < 1 ? c.green : c.red;
    for (const [re, im] of [[re0, im0], [re1, im1]])
      Live.dot(g, colour, [cx + unit * Math.max(-1.35, Math.min(1.35, re)), cy - unit * im], 6);
    Live.label(g, c.soft, "eigenvalues", [cx, cy - half - 8], "center");
    Live.label(g, c.soft, "1", [cx + unit + 5, cy + 11]);
    Live.label(g, c.soft, "−1", [cx - unit - 5, cy + 11], "right");

    const verdict = kept ? "a small departure from rest neither grows nor dies out" : radius < 1 ? "a small departure from rest dies out" : "every departure from rest grows";
    const bound = moved === "mean" ? "" : isFinite(limit) ? ` The limit is h = ${limit.toPrecision(3)}.` : " There is no limit of h.";
    return `Spectral radius ${radius.toFixed(4)}: ${verdict}.${bound} After ${seconds} s, ${(100 * energies.at(-1)).toFixed(1)} % of its energy above rest are left.`;

    function curve(values, places, [x, y, w, tall], ink, dots) {
      g.save(); g.beginPath(); g.rect(x, y, w, tall); g.clip();
      const points = values.map((v, i) => [places.x(i * dt), places.y(v)]);
      Live.line(g, ink, 1.6, points);
      if (dots && w > 400) for (const point of points) Live.dot(g, ink, point, dots);
      g.restore();
    }
  };
});
