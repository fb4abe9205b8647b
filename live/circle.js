// Chapter 5: from which sides may a wedge be pushed? The classification circle, for any opening.
Live.add("circle", (figure, chapters) => {
  figure.aspect = 0.62;
  figure.slider({ name: "opening", label: "opening of the wedge", from: 10, to: 180, value: 60, unit: "°", digits: 0 });
  const leaning = figure.slider({ name: "lean", label: "the floor leans by", from: -180, to: 179, value: 70, unit: "°", digits: 0 });
  let centre = null;
  figure.draw = (g, width, height, c, { opening, lean }) => {
    const marks = chapters.circle(opening), [cx, cy] = [width / 2, height / 2], r = Math.min(width, height) * 0.46;
    centre = [cx, cy];
    const toward = degrees => { const a = degrees * Math.PI / 180; return [Math.sin(a), Math.cos(a)]; };  // a floor below has the lean 0
    const ring = (bit, inner, outer, colour) => marks.forEach((mark, i) => {
      const from = toward(i - 180.6), to = toward(i - 179.4);
      Live.area(g, mark & bit ? colour : c.line + "70", [[cx + inner * from[0], cy + inner * from[1]], [cx + outer * from[0], cy + outer * from[1]],
                                                 [cx + outer * to[0], cy + outer * to[1]], [cx + inner * to[0], cy + inner * to[1]]]);
    });
    ring(1, r * 0.62, r * 0.72, c.blue);
    ring(2, r * 0.75, r * 0.85, c.ochre);
    ring(4, r * 0.88, r * 0.98, c.green);
    const half = opening * Math.PI / 360, side = r * 0.52;
    const sides = [-1, 1].map(s => [cx + s * side * Math.sin(half), cy - side * Math.cos(half)]);
    Live.area(g, c.grey + "60", [[cx, cy], ...sides]);
    Live.line(g, c.text, 2, [sides[0], [cx, cy], sides[1]]);
    const [x, y] = toward(lean), board = [-y, x];
    Live.line(g, c.red, 3, [[cx - board[0] * r * 0.5, cy - board[1] * r * 0.5], [cx + board[0] * r * 0.5, cy + board[1] * r * 0.5]]);
    Live.arrow(g, c.red, [cx + x * r * 0.56, cy + y * r * 0.56], [cx + x * r * 0.12, cy + y * r * 0.12]);
    if (width >= 500) {
      Live.label(g, c.green, "outer: the span says regular", [8, 14]);
      Live.label(g, c.ochre, "middle: the averaged normal does", [8, 34]);
      Live.label(g, c.blue, "inner: a board can touch here", [8, 54]);
    }
    const mark = marks[(Math.round(lean) + 180 + 360) % 360], word = bit => mark & bit ? "regular" : "hooked";
    return `A wedge of ${Math.round(opening)}°, and a floor that leans by ${Math.round(lean)}°: it ${mark & 1 ? "can" : "cannot"} touch the tip without cutting in. By the averaged normal the pair is ${word(2)}, by the span ${word(4)}. ` +
      "Rings, from inside: can touch; regular by the average; regular by the span.";
  };
  figure.handle(() => {
    if (!centre) return [-99, -99];
    const a = figure.values.lean * Math.PI / 180, r = Math.min(figure.element.clientWidth, figure.canvas.clientHeight) * 0.46 * 0.56;
    return [centre[0] + r * Math.sin(a), centre[1] + r * Math.cos(a)];
  }, (x, y) => { leaning.set(Math.atan2(x - centre[0], y - centre[1]) * 180 / Math.PI); });
});
