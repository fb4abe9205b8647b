// Chapter 4: what a slope asks of friction, and what two laws give. A block of one pair, set down with a slack anchor.
Live.add("slope", (figure, chapters) => {
  figure.aspect = 0.46;
  figure.onPhone = 1.25;
  figure.slider({ name: "angle", label: "slope", from: 0, to: 40, value: 15, unit: "°", digits: 1 });
  figure.slider({ name: "mu_s", label: "μs", from: 0, to: 1, value: 0.4 });
  figure.slider({ name: "mu_d", label: "μd", from: 0, to: 1, value: 0.2 });
  figure.slider({ name: "damping", label: "damping ratio ζ", from: 0, to: 1, value: 0.1 });
  figure.choice({ name: "law", label: "law", options: [["thesis", "the thesis' spring and damper"], ["mass_splitting", "mass splitting"]] });
  figure.draw = (g, width, height, c, { angle, mu_s, mu_d, damping, law }) => {
    const [held, largest, ...places] = chapters.slope(law === "mass_splitting", angle, mu_s, mu_d, damping, 2);
    const narrow = width < 500, picture = narrow ? [0, 0, width, height * 0.5] : [0, 0, width * 0.46, height];
    const plot = narrow ? [52, height * 0.57, width - 68, height * 0.32] : [width * 0.46 + 56, 22, width * 0.54 - 72, height - 66];
    const a = angle * Math.PI / 180, [ox, oy] = [picture[2] / 2, picture[3] * 0.62], length = picture[2] * 0.45, size = picture[3] * 0.13;
    const along = [-Math.cos(a), Math.sin(a)], out = [Math.sin(a) * -1, -Math.cos(a)];
    const put = (s, n) => [ox + s * along[0] + n * out[0], oy + s * along[1] + n * out[1]];
    Live.area(g, c.grey + "30", [put(-length, 0), put(length, 0), [put(length, 0)[0], picture[3] - 8], [put(-length, 0)[0], picture[3] - 8]]);
    Live.line(g, c.soft, 2, [put(-length, 0), put(length, 0)]);
    const unit = picture[3] * 0.42, normal = unit * Math.cos(a);
    Live.area(g, c.green + "28", [put(0, 0), put(-mu_s * normal, normal), put(mu_s * normal, normal)]);
    for (const side of [-1, 1]) Live.line(g, c.green, 1.2, [put(0, 0), put(side * mu_s * normal, normal)], [5, 4]);
    Live.area(g, c.ochre + "80", [put(-size, 0), put(size, 0), put(size, size), put(-size, size)]);
    Live.arrow(g, c.text, put(0, size / 2), [ox + out[0] * size / 2, oy + out[1] * size / 2 + unit * 0.75]);
    Live.arrow(g, c.blue, put(0, 0), put(0, normal));
    Live.arrow(g, c.red, put(0, 0), put(-Math.tan(a) * normal, normal));
    Live.label(g, c.red, "what the slope asks", [put(-Math.tan(a) * normal, normal)[0] + 4, put(-Math.tan(a) * normal, normal)[1] - 10]);
    Live.label(g, c.green, "friction cone", [put(mu_s * normal, normal)[0], put(mu_s * normal, normal)[1] - 10], "center");
    const farthest = Math.max(0.02, ...places) * 1000;
    const at = Live.axes(g, c, plot, { x: [0, 2], y: [0, farthest * 1.1], xlabel: "time [s]", ylabel: "way down the slope [mm]", yticks: 4 });
    Live.line(g, held ? c.green : c.red, 2.2, places.map((p, i) => [at.x(i / 100), at.y(1000 * p)]));
    const tangent = Math.tan(a), coulomb = mu_s >= tangent ? "holds" : "slides";
    return `tan α = ${tangent.toFixed(3)}, so by Coulomb's law it ${coulomb}. Friction asked for up to ${largest.toFixed(3)} of the normal force, and the pair ${held ? "never let go" : "let go"}; ` +
      `after 2 s it lies ${places.at(-1) > 0.1 ? `${places.at(-1).toFixed(2)} m` : `${(1000 * places.at(-1)).toFixed(2)} mm`} down.`;
  };
});
