// Runs inside a page of the book, for docs/tools/browser_test.py: what a reader would see, as numbers and as complaints.
const done = arguments[arguments.length - 1];

// ------------------------------------------------------------------------------------------------------------- contrast
function rgba(colour) {
  const numbers = colour.match(/[\d.]+/g)?.map(Number) ?? [0, 0, 0, 0];
  return numbers.length < 4 ? [...numbers.slice(0, 3), 1] : numbers;
}

const over = (top, below) => [0, 1, 2].map(i => top[i] * top[3] + below[i] * (1 - top[3])).concat(1);

function background(element) {
  const layers = [];
  for (let at = element; at; at = at.parentElement) {
    const layer = rgba(getComputedStyle(at).backgroundColor);
    if (layer[3] > 0) layers.push(layer);
    if (layer[3] === 1) break;
  }
  const page = document.documentElement.classList.contains("dark-mode") ? [0, 0, 0, 1] : [255, 255, 255, 1];
  return layers.reverse().reduce((below, top) => over(top, below), page);
}

function luminance(colour) {
  const [r, g, b] = colour.map(v => v / 255).map(v => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(element) {
  const behind = background(element), colour = rgba(getComputedStyle(element).color);
  let opacity = colour[3];
  for (let at = element; at; at = at.parentElement) opacity *= Number(getComputedStyle(at).opacity);
  const [light, dark] = [luminance(over([...colour.slice(0, 3), opacity], behind)), luminance(behind)].sort((a, b) => b - a);
  return (light + 0.05) / (dark + 0.05);
}

// Every element that shows text of its own.
function* texts() {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (!walker.currentNode.data.trim() || element.closest("script, style, noscript, svg, [aria-hidden=true], .MathJax_Preview")) continue;
    if (element.checkVisibility && !element.checkVisibility({ checkOpacity: true, checkVisibilityCSS: true })) continue;
    if (element.getClientRects().length) yield [element, walker.currentNode.data.trim()];
  }
}

function readContrast(report, theme) {
  const known = new Set();
  for (const [element, text] of texts()) {
    report.texts += 1;
    const style = getComputedStyle(element), size = parseFloat(style.fontSize);
    const key = `${style.color} ${size} ${element.className} ${element.tagName} ${element.parentElement.className}`;
    if (known.has(key)) continue;
    known.add(key);
    const ratio = contrast(element), needed = size >= 24 || size >= 18.66 && Number(style.fontWeight) >= 700 ? 3 : 4.5;
    report.lowest = Math.min(report.lowest, ratio);
    if (ratio < needed) report.faults.push(`contrast ${ratio.toFixed(2)} in the ${theme} theme: "${text.slice(0, 40)}" (${element.tagName.toLowerCase()}.${element.className})`);
  }
}

// -------------------------------------------------------------------------------------------------- formulas and pictures
function readFormulas(report) {
  report.formulas = document.querySelectorAll("script[type^='math/tex']").length;
  const set = document.querySelectorAll(".MathJax_SVG svg").length;
  if (set < report.formulas) report.faults.push(`${report.formulas - set} of ${report.formulas} formulas are not typeset`);
  for (const fault of document.querySelectorAll(".MathJax_Error, .MathJax_SVG_Error, merror, g[data-mml-node=merror]"))
    report.faults.push(`a formula is wrong: ${fault.textContent.slice(0, 60)}`);
  for (const [element, text] of texts())
    if (!element.closest("code, pre, .fragment, .line") && /\\f[$[{]|\\\(|\\\[|@\w+\{/.test(text)) report.faults.push(`left raw: ${text.slice(0, 60)}`);
}

async function readPictures(report) {
  const images = [...document.images].filter(image => image.getAttribute("src"));
  for (const image of images) image.loading = "eager";
  await Promise.all(images.map(image => image.decode().catch(() => {})));
  report.pictures = images.length;
  for (const image of images) if (!image.naturalWidth) report.faults.push(`a picture is missing: ${image.getAttribute("src")}`);
  for (const video of document.querySelectorAll("video")) {
    report.pictures += 1;
    if (video.readyState < 1) await new Promise(go => { video.onloadedmetadata = video.onerror = go; setTimeout(go, 4000); });
    if (!video.videoWidth) report.faults.push(`a clip does not play: ${video.getAttribute("src")}`);
  }
}

// ------------------------------------------------------------------------------------------------------------ live figures
async function readLive(report) {
  for (const figure of document.querySelectorAll("[data-live]")) {
    report.live += 1;
    const name = figure.dataset.figure;
    for (let i = 0; i < 100 && figure.dataset.live !== "ready"; ++i) await new Promise(go => setTimeout(go, 100));
    if (figure.dataset.live !== "ready") { report.faults.push(`the live figure ${name} does not start`); continue; }
    for (const input of figure.querySelectorAll("input[type=range], select")) {
      const before = figure.dataset.answer + figure.querySelector("canvas").toDataURL();
      if (input.tagName === "SELECT") input.selectedIndex = 1; else input.value = Number(input.value) > 500 ? 250 : 750;
      input.dispatchEvent(new Event("input", { bubbles: true }));
      await new Promise(go => requestAnimationFrame(() => requestAnimationFrame(go)));
      report.inputs += 1;
      if (figure.dataset.answer + figure.querySelector("canvas").toDataURL() === before)
        report.faults.push(`the live figure ${name} does not answer to ${input.closest("label").textContent.trim()}`);
    }
  }
}

(async () => {
  const report = { faults: [], formulas: 0, pictures: 0, texts: 0, lowest: 21, live: 0, inputs: 0, width: 0 };
  if (window.MathJax?.Hub) await new Promise(go => MathJax.Hub.Queue(go));
  await readPictures(report);
  readFormulas(report);
  for (const theme of ["light", "dark"]) {
    document.documentElement.classList.toggle("dark-mode", theme === "dark");
    document.documentElement.classList.toggle("light-mode", theme === "light");
    readContrast(report, theme);
  }
  await readLive(report);
  report.width = document.scrollingElement.scrollWidth;
  if (report.width > window.innerWidth) {
    const wide = [...document.querySelectorAll("body *")].filter(e => e.getBoundingClientRect().right > window.innerWidth + 1).slice(-1)[0];
    report.faults.push(`${report.width} px wide on a phone of ${window.innerWidth} px (${wide?.tagName.toLowerCase()}.${wide?.className})`);
  }
  done(report);
})().catch(error => done({ faults: [`the probe failed: ${error}`], formulas: 0, pictures: 0, texts: 0, lowest: 21, live: 0, inputs: 0, width: 0 }));
