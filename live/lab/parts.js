// Small pieces of a page.
export function element(tag, properties = {}, children = []) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

export function button(text, hint, press) {
  const made = element("button", { type: "button", textContent: text, title: hint });
  made.addEventListener("click", press);
  return made;
}

export const labelled = (text, input) => element("label", {}, [element("span", { textContent: text }), input]);

// Options are [value, text], or [group, [[value, text], ...]].
export function select(options, choose) {
  const option = ([value, text]) => element("option", { value, textContent: text });
  const made = element("select", {}, options.map(([name, inside]) => Array.isArray(inside) ? element("optgroup", { label: name }, inside.map(option)) : option([name, inside])));
  made.addEventListener("input", choose);
  return made;
}
