// Chapter 1: how long may a step be? The particle's heights, and the eigenvalues of its step against the unit circle.
Live.add("stability", (figure, chapters) => {
  figure.aspect = 0.46;
  figure.slider({ name: "dt", label: "step Δt", from: 0.01, to: 0.2, value: 0.1, unit: "s", digits: 3 });
  figure.slider({ name: "k", label: "stiffness k", from: 20, to: 1000, value: 100, unit: "N/m", digits: 0, logarithmic: true });
  figure.choice({ name: "method", label: "penalty", options: [["cpf", "continuous (CPF)"], ["dpf", "discrete (DPF)"]] });
  figure.draw = (g, width, height, c, { dt, k, method }) => {
    const steps = Math.min(400, Math.ceil(6 / dt));
    const [radius, critical, re0, im0, re1, im1, ...heights] = chapters.stability(method === "cpf", dt, k, steps);
    const tall = height - 62, circle = Math.min(tall, width * 0.34), split = width - circle - 34;
    const top = Math.max(0.12, Math.min(0.5, Math.max(...heights) * 1.1)), bottom = Math.min(-0.06, Math.max(-0.6, Math.min(...heights) * 1.15));
    const at = Live.axes(g, c, [44, 22, split - 62, tall], { x: [0, 6], y: [bottom, top], xlabel: "time [s]", ylabel: "height [m]" });
    Live.area(g, c.grey + "30", [[at.x(0), at.y(0)], [at.x(6), at.y(0)], [at.x(6), at.y(bottom)], [at.x(0), at.y(bottom)]]);
    g.save(); g.beginPath(); g.rect(44, 22, split - 62, tall); g.clip();
    const places = heights.map((h, i) => [at.x(i * dt), at.y(h)]);
    Live.line(g, c.blue, 1.6, places);
    for (const place of places) Live.dot(g, c.blue, place, 2.2);
    g.restore();
    const half = circle / 2, [cx, cy] = [split + 10 + half, 22 + tall / 2], unit = half * 0.62;
    Live.line(g, c.line, 1, [[cx - half, cy], [cx + half, cy]]);
    Live.line(g, c.line, 1, [[cx, cy - half], [cx, cy + half]]);
    g.strokeStyle = c.soft; g.lineWidth = 1.5; g.beginPath(); g.arc(cx, cy, unit, 0, 2 * Math.PI); g.stroke();
    const colour = radius < 1 ? c.green : c.red;
    for (const [re, im] of [[re0, im0], [re1, im1]])
      Live.dot(g, colour, [cx + unit * Math.max(-1.55, Math.min(1.55, re)), cy - unit * im], 6);
    Live.label(g, c.soft, "eigenvalues", [cx, 12], "center");
    Live.label(g, c.soft, "1", [cx + unit + 5, cy + 10]);
    Live.label(g, c.soft, "−1", [cx - unit - 5, cy + 10], "right");
    const verdict = radius < 1 ? "a small departure from rest dies out" : "every departure from rest grows";
    return `Spectral radius ${radius.toFixed(4)}: ${verdict}. The limit is Δt = ${critical.toFixed(4)} s, and Δt/limit = ${(dt / critical).toFixed(3)}.`;
  };
});
