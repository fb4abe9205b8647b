// What a link holds behind its #: scene=tower&solver=10&beside=xpbd&step=40&eye=1,2,3&target=0,0,0, and the text of a scene of the reader's own.
const inNumbers = v => v.map(x => Number(x.toPrecision(5))).join(",");

// Text as letters that a link may have.
function packed(text) {
  const bytes = new TextEncoder().encode(text);
  return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join("")).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

function unpacked(letters) {
  const bytes = atob(letters.replaceAll("-", "+").replaceAll("_", "/"));
  return new TextDecoder().decode(Uint8Array.from(bytes, letter => letter.charCodeAt(0)));
}

export function writeLink({ scene, text, solver, beside, step, view }) {
  return [`scene=${scene}`, `solver=${solver}`, `beside=${beside}`, `step=${step}`, `eye=${inNumbers(view.eye)}`, `target=${inNumbers(view.target)}`, ...text === null ? [] : [`text=${packed(text)}`]].join("&");
}

// Whatever cannot be read is left out.
export function readLink(hash) {
  const words = new Map(hash.split("&").map(word => word.split("=")).filter(({ length }) => length === 2)), number = name => words.has(name) ? Number(words.get(name)) : undefined;
  const solver = name => Number.isNaN(number(name)) ? words.get(name) : number(name); // a chapter, or a method's name
  const vector = name => words.get(name)?.split(",").map(Number);
  const good = v => v?.length === 3 && v.every(Number.isFinite), eye = vector("eye"), target = vector("target");
  let text = null;
  try {
    if (words.has("text")) text = unpacked(words.get("text"));
  } catch { /* a link that was cut off */ }
  return { scene: words.get("scene"), text, solver: solver("solver"), beside: solver("beside"), step: number("step"), view: good(eye) && good(target) ? { eye, target } : null };
}
