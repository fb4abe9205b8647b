// Chapter 3: the impulse is the area under the depth. Four Bernstein coefficients to drag.
Live.add("integral", (figure, chapters) => {
  figure.aspect = 0.48;
  const d = [0.6, 0.2, -1.4, 0.5];
  const sliders = d.map((v, i) => figure.slider({ name: `d${i}`, label: `δ${"₀₁₂₃"[i]}`, from: -1.5, to: 1.5, value: v, unit: "mm" }));
  const coefficients = () => [0, 1, 2, 3].map(i => figure.values[`d${i}`]);
  let at = null;
  for (const i of [0, 1, 2, 3])
    figure.handle(() => at ? [at.x(i / 3), at.y(coefficients()[i])] : [-99, -99],
                  (x, y) => sliders[i].set(Math.max(-1.5, Math.min(1.5, 1.6 - 3.2 * (y - at.top) / at.height))));
  figure.draw = (g, width, height, c) => {
    const b = coefficients(), [cpf, dpf, ...ends] = chapters.integral(...b), box = [44, 22, width - 62, height - 66];
    at = Live.axes(g, c, box, { x: [0, 1], y: [-1.6, 1.6], xlabel: "τ", ylabel: "depth δ [mm], negative inside", yticks: 4 });
    Object.assign(at, { top: box[1], height: box[3] });
    const value = t => b[0] * (1 - t) ** 3 + 3 * b[1] * t * (1 - t) ** 2 + 3 * b[2] * t * t * (1 - t) + b[3] * t ** 3;
    if (b[3] < 0) Live.area(g, c.red + "30", [[at.x(0), at.y(0)], [at.x(0), at.y(b[3])], [at.x(1), at.y(b[3])], [at.x(1), at.y(0)]]);
    for (let i = 0; i < ends.length; i += 2) {
      const [from, to] = [ends[i], ends[i + 1]];
      const curve = Array.from({ length: 41 }, (_, k) => from + (to - from) * k / 40).map(t => [at.x(t), at.y(value(t))]);
      Live.area(g, c.blue + "60", [[at.x(from), at.y(0)], ...curve, [at.x(to), at.y(0)]]);
    }
    Live.line(g, c.soft, 1.5, [[at.x(0), at.y(0)], [at.x(1), at.y(0)]]);
    Live.line(g, c.grey, 1, b.map((v, i) => [at.x(i / 3), at.y(v)]), [4, 4]);
    Live.line(g, c.blue, 2.2, Array.from({ length: 101 }, (_, i) => [at.x(i / 100), at.y(value(i / 100))]));
    b.forEach((v, i) => Live.dot(g, c.ochre, [at.x(i / 3), at.y(v)], 7));
    const parts = ends.length ? Array.from({ length: ends.length / 2 }, (_, i) => `[${ends[2 * i].toFixed(3)}, ${ends[2 * i + 1].toFixed(3)}]`).join(" and ") : "never";
    return `Inside: ${parts}. CPF's impulse (blue area): ${cpf.toFixed(3)} k Δt mm; DPF's (red rectangle): ${dpf.toFixed(3)} k Δt mm.`;
  };
});
