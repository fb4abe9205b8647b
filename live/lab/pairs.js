// A pair's numbers, as common/scenes/shown_scene.hpp has them, one pair behind the other.
export const NUMBERS_A_PAIR = 24;
const KINDS = ["vertex on plane", "vertex on face", "edge on edge"];
const FEATURES = [["vertex", "plane"], ["vertex", "face"], ["edge", "edge"]];

export const pairCount = frame => frame.pairs.length / NUMBERS_A_PAIR;

export function pairAt(frame, index) {
  const n = frame.pairs.subarray(NUMBERS_A_PAIR * index, NUMBERS_A_PAIR * (index + 1));
  const vector = at => [n[at], n[at + 1], n[at + 2]];
  return { kind: n[0], bodyA: n[1], bodyB: n[2], featureA: n[3], featureB: n[4], point: vector(5), normal: vector(8), depth: n[11], impulse: vector(12),
           friction: vector(15), stiffness: n[18], restOffset: n[19], load: n[20], slip: n[21], pushes: n[22] === 1, since: n[23] };
}

// What stays the same from step to step while the pair lives.
export const keyOf = pair => [pair.kind, pair.bodyA, pair.featureA, pair.bodyB, pair.featureB].join(" ");

export const size = v => Math.hypot(...v);

function scientific(value) {
  const [digits, exponent] = value.toExponential(2).split("e");
  return `${digits}·10${exponent.replace("+", "").replace("-", "⁻").replace(/\d/g, digit => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit])}`;
}

export function readable(value, unit = "") {
  const large = Math.abs(value);
  const text = value === 0 ? "0" : large >= 1e-3 && large < 1e5 ? String(Number(value.toPrecision(4))) : scientific(value);
  return (unit ? `${text} ${unit}` : text).replace("-", "−");
}

const triple = v => v.map(x => readable(Math.abs(x) < 1e-12 ? 0 : x)).join(", ");

// Rows of the pair's table: what it is called, and its value.
export function rowsOf(pair, scene) {
  const [a, b] = FEATURES[pair.kind];
  const nameB = pair.kind === 0 ? scene.planes[pair.bodyB]?.name : scene.bodies[pair.bodyB]?.name;
  return [
    ["kind", KINDS[pair.kind]],
    ["A", `${a} ${pair.featureA} of ${scene.bodies[pair.bodyA]?.name}`],
    ["B", pair.kind === 0 ? `plane ${nameB}` : `${b} ${pair.featureB} of ${nameB}`],
    ["point of A [m]", triple(pair.point)],
    ["normal", triple(pair.normal)],
    ["depth", readable(-pair.depth, "m")],
    ["impulse", readable(size(pair.impulse), "N s")],
    ["friction impulse", readable(size(pair.friction), "N s")],
    ["stiffness", pair.stiffness ? readable(pair.stiffness, "N/m") : "the scene's"],
    ["rest offset", readable(pair.restOffset, "m")],
    ["load", readable(pair.load, "N")],
    ["slips at", readable(pair.slip, "m/s")],
    ["pushes", pair.pushes ? "yes" : "no"],
    ...pair.since < 0 ? [] : [["since step", String(pair.since)]],
  ];
}
