// Chapter 11: a block on a spring that remembers its force. Each pass brings the impulse nearer to the exact one, however soft the spring.
Live.add("passes", (figure, chapters) => {
  const MOST = 8, X = [-2.6, 2.6], Y = [-0.6, 2.6];
  figure.aspect = 0.42;
  figure.onPhone = 1.42;
  figure.slider({ name: "h", label: "stiffness h = kΔt²/m", from: 0.1, to: 1e5, value: 1.5, digits: 1, logarithmic: true });
  figure.slider({ name: "count", label: "passes", from: 1, to: MOST, value: 2, digits: 0 });
  figure.slider({ name: "mu", label: "friction μ", from: 0, to: 1.2, value: 0.5 });
  let wanted = [2, -1.6], cone = null; // the impulse that would stop the block: along the normal, along the surface
  figure.handle(() => cone ? [cone.x(wanted[1]), cone.y(wanted[0])] : [-99, -99], (x, y) => {
    const fit = (v, [from, to]) => Math.max(from, Math.min(to, v));
    const normal = fit(cone.normal(y), [-0.5, 2.5]), along = fit(cone.along(x), [-2.5, 2.5]);
    if (Math.hypot(normal, along) > 0.05) wanted = [normal, along]; // at rest there is nothing to solve
  });

  figure.draw = (g, width, height, c, { h, count, mu }) => {
    const numbers = [...chapters.passes(h, MOST, mu, -wanted[0], -wanted[1])], exact = numbers.slice(0, 2);
    const after = Array.from({ length: MOST }, (_, i) => numbers.slice(2 + 7 * i, 9 + 7 * i)).map(([rn, rt, un, ut, mn, mt, error]) => ({ r: [rn, rt], u: [un, ut], map: [mn, mt], error }));
    const narrow = width < 500, last = after[count - 1];
    const high = (width - 44) * (Y[1] - Y[0]) / (X[1] - X[0]);
    drawCone(g, c, narrow ? [30, 22, width - 44, high] : [30, 22, width * 0.56 - 30, height - 66], after.slice(0, count), exact, mu);
    drawErrors(g, c, narrow ? [36, high + 92, width - 50, height - high - 136] : [width * 0.56 + 60, 22, width * 0.44 - 76, height - 66], after, count, h);
    const does = exact[0] === 0 ? "flies, and gets no impulse" : Math.hypot(exact[0] - wanted[0], exact[1] - wanted[1]) < 1e-6 ? "holds" : "slides";
    const speed = v => Math.abs(v) < 1e-12 ? "0" : Math.abs(v) < 1e-3 ? power(v) : v.toPrecision(3).replace("-", "−");
    return `The exact block ${does}. After ${count} ${count === 1 ? "pass" : "passes"} with h = ${h} ours is pushed with ${last.r[0].toFixed(4)} N s of ${exact[0].toFixed(4)} N s along the normal, ` +
      `moves with ${speed(last.u[0])} m/s along it and with ${speed(last.u[1])} m/s along the surface. The natural map is ${last.error < 1e-15 ? "zero, but for rounding" : power(last.error)}.`;
  };

  const power = v => {
    const [digits, exponent] = v.toExponential(1).split("e");
    return `${digits.replace("-", "−")}·10${[...String(Number(exponent))].map(sign => "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"["0123456789-".indexOf(sign)]).join("")}`;
  };

  // The cone, and the impulses of the passes in it; the same unit along both axes.
  function drawCone(g, c, [left, top, w, tall], after, exact, mu) {
    const unit = Math.min(w / (X[1] - X[0]), tall / (Y[1] - Y[0])), half = w / unit / 2, low = Y[1] - tall / unit;
    const box = [left, top, w, tall], at = Live.axes(g, c, box, { x: [-half, half], y: [low, Y[1]], xlabel: "impulse along the surface [N s]", ylabel: "along the normal [N s]", xticks: 6, yticks: 4 });
    cone = { x: at.x, y: at.y, along: x => (x - left) / unit - half, normal: y => Y[1] - (y - top) / unit };
    const put = ([normal, along]) => [at.x(along), at.y(normal)], last = after.at(-1);
    g.save(); g.beginPath(); g.rect(...box); g.clip();
    const side = Math.min(Y[1], half / Math.max(mu, 1e-9));
    Live.area(g, c.grey + "30", [put([0, 0]), put([side, mu * side]), ...(side < Y[1] ? [put([Y[1], half]), put([Y[1], -half])] : []), put([side, -mu * side])]);
    for (const sign of [-1, 1]) Live.line(g, c.grey, 1.2, [put([0, 0]), put([Y[1], sign * mu * Y[1]])], [5, 4]);
    Live.label(g, c.soft, "cone of friction", put([Y[1] - 0.13, 0]), "center");
    Live.arrow(g, c.green, put(wanted), put(last.r), 2.2);
    Live.line(g, c.blue, 1.2, [[0, 0], ...after.map(({ r }) => r)].map(put));
    for (const { r } of after.slice(0, -1)) Live.dot(g, c.blue, put(r), 3);
    Live.arrow(g, c.red, put(last.r), put(last.r.map((v, i) => v - last.map[i])), 2);
    Live.dot(g, c.text, put(exact), 8, true);
    Live.dot(g, c.blue, put(last.r), 5);
    Live.dot(g, c.ochre, put(wanted), 7);
    const [x, y] = put(wanted);
    Live.label(g, c.ochre, "would stop it", [Math.max(left + 46, Math.min(left + w - 46, x)), y - (y < top + 24 ? -17 : 17)], "center");
    g.restore();
  }

  // The natural map over the passes.
  function drawErrors(g, c, box, after, count, h) {
    const floor = -16, at = Live.axes(g, c, box, { x: [0.5, MOST + 0.5], y: [floor, 0.5], xlabel: "pass", ylabel: "log₁₀ of the natural map over |q|", xticks: 8, yticks: 4 });
    Live.line(g, c.green, 1.2, [[at.x(0.5), at.y(-8)], [at.x(MOST + 0.5), at.y(-8)]], [5, 4]);
    Live.label(g, c.green, "solved", [at.x(MOST + 0.4), at.y(-8) + 10], "right");
    const places = after.map(({ error }, i) => [at.x(i + 1), at.y(Math.max(floor, Math.log10(Math.max(error, 1e-16))))]);
    Live.line(g, c.red, 1.2, places);
    places.forEach((place, i) => Live.dot(g, c.red, place, i === count - 1 ? 6 : 3.5, i >= count));
    Live.label(g, c.soft, `1 / (1 + h) = ${(1 / (1 + h)).toPrecision(2)}`, [at.x(MOST + 0.4), at.y(-0.6)], "right");
  }
});
