// Chapter 9: the curves in which two bodies cross, the vertices of each that are inside the other, and the ways out.
Live.add("crossing", (figure, chapters) => {
  figure.aspect = 0.56;
  figure.onPhone = 0.95;
  const place = [0.8, 0.5, 0.3]; // of the moved body's middle, in metres
  const clamp = (v, most) => Math.max(-most, Math.min(most, v));
  const height = figure.slider({ name: "height", label: "height of its middle", from: -1.2, to: 1.5, value: place[1], unit: "m" });
  figure.slider({ name: "turn", label: "turn", from: -90, to: 90, value: 20, unit: "°", digits: 0 });
  figure.slider({ name: "tilt", label: "tilt", from: -90, to: 90, value: 35, unit: "°", digits: 0 });
  figure.choice({ name: "kind", label: "bodies", options: [["cube", "a cube in a block"], ["bar", "a bar through a wall"]] });
  figure.changed = name => {
    if (name === "kind") {
      [place[0], place[1], place[2]] = figure.values.kind === "bar" ? [0.1, 0.2, 0.1] : [0.8, 0.5, 0.3];
      height.set(place[1]);
    } else if (name === "height")
      place[1] = figure.values.height;
  };
  const view = Live.turning(figure, { azimuth: 24, elevation: 16 });
  figure.handle(() => view(place), (x, y) => {
    [place[0], place[1], place[2]] = view.back(x, y, place).map(v => clamp(v, 1.8));
    height.set(place[1]);
    place[1] = figure.values.height;
  });

  // One list after another, each begun by its count; `size` numbers an entry.
  const reader = numbers => {
    let at = 0;
    const count = () => numbers[at++];
    return { count, list: size => Array.from({ length: count() }, () => numbers.slice(at, at += size)) };
  };
  const points = entry => Array.from({ length: entry.length / 3 }, (_, i) => entry.slice(3 * i, 3 * i + 3));

  figure.draw = (g, width, canvasHeight, c, { kind, turn, tilt }) => {
    const read = reader(Array.from(chapters.crossing(kind === "bar", ...place, turn, tilt)));
    const edgesOfA = read.list(6), edgesOfB = read.list(6), inA = read.list(3), inB = read.list(3), ways = read.list(3);
    const curves = Array.from({ length: read.count() }, () => read.list(3));
    const s = Math.min(width, 1.7 * canvasHeight) * 0.2, ox = width / 2, oy = canvasHeight * 0.55;
    view.place([0, 0, width, canvasHeight], [ox, oy], s);
    view.draw(g, c, () => {
      for (const edge of edgesOfB) Live.line(g, c.soft, 1.2, points(edge).map(view));
      for (const edge of edgesOfA) Live.line(g, c.blue, 1.6, points(edge).map(view));
      for (const point of inB) Live.dot(g, c.violet, view(point), 3.5);
      for (const point of inA) Live.dot(g, c.ochre, view(point), 4);
      for (const curve of curves) Live.line(g, c.red, 3, [...curve, curve[0]].map(view));
      Live.dot(g, c.blue, view(place), 6, true);
      for (const way of ways) Live.arrow(g, c.green, view(place), view(place.map((v, i) => v + 0.9 * way[i])), 3.5);
    });
    const none = curves.length ? "" : inA.length || inB.length ? " One is wholly inside the other: a ray tells." : " They do not meet.";
    const out = ways.map(way => way.map(v => (v + 0).toFixed(2)).join(", ")).map(text => ` Way out (${text}).`).join("");
    return `${curves.length} curve${curves.length === 1 ? "" : "s"}; ${inA.length} vertices of the ${kind} inside, ${inB.length} of the ${kind === "bar" ? "wall" : "block"}.${none}${out}`;
  };
});
