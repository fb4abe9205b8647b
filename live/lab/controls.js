// What a reader presses, chooses and writes: the elements of the page's box, and the keys.
import { filmType } from "./film.js";
import { Knobs } from "./knobs.js";
import { button, element, labelled, select } from "./parts.js";

export const OWN = "own", RUN = "run"; // of the menu of scenes: the reader's text, a run that a program wrote
const SPEEDS = [[1, "as the clock"], [0.25, "4 times slower"], [0.0625, "16 times slower"], [0, "step by step"]];

function menuOfScenes(lab) {
  const groups = new Map();
  for (const scene of lab.given.scenes) groups.set(scene.group, [...groups.get(scene.group) ?? [], [scene.key, scene.title]]);
  return select([...groups.entries(), ["Your own", [[OWN, "the text below"], [RUN, "a run that a program wrote"]]]], () => lab.start(lab.chooseScene()));
}

function starOf(lab, scene) {
  const made = button("", scene.look, () => { lab.sceneChoice.value = scene.key; lab.start(lab.chooseScene()); });
  made.dataset.scene = scene.key;
  made.append(element("img", { src: scene.thumbnail, alt: "", width: 168, height: 112 }), element("span", { textContent: scene.title }));
  return made;
}

function barOfSteps(lab) {
  lab.speedChoice = select(SPEEDS, () => lab.restartClock());
  lab.playButton = button("▶ play", "space bar", () => lab.play(!lab.playing));
  lab.pairsShown = element("input", { type: "checkbox", checked: true });
  lab.pairsShown.addEventListener("input", () => lab.lanes.forEach(lane => lane.view.showPairs(lab.pairsShown.checked)));
  return element("div", { className: "lab-bar" }, [
    lab.playButton, button("◀ back", "left arrow", () => lab.show(lab.index - 1)), button("step ▶", "right arrow", () => lab.stepOnce()),
    button("↺ reset", "key R", () => lab.reload()), labelled("speed", lab.speedChoice), labelled("pairs and joints", lab.pairsShown)]);
}

function barOfChoices(lab) {
  lab.sceneChoice = menuOfScenes(lab);
  lab.solverChoice = select(lab.given.solvers, () => lab.start(lab.reload()));
  lab.besideChoice = select([[0, "none"], ...lab.given.solvers], () => lab.start(lab.reload()));
  return element("div", { className: "lab-bar" }, [labelled("scene", lab.sceneChoice), labelled("solver", lab.solverChoice), labelled("beside it", lab.besideChoice)]);
}

// Links, pictures, films and runs.
function barOfFiles(lab) {
  lab.runFile = element("input", { type: "file", accept: ".json", hidden: true });
  lab.runFile.addEventListener("change", () => lab.openFile(lab.runFile.files[0]));
  lab.filmButton = button("save a film", "of the steps so far, at the chosen speed", () => lab.saveFilm());
  lab.filmButton.hidden = !filmType();
  return element("div", { className: "lab-bar" }, [
    button("copy a link", "to this scene, its solvers, step and view", () => lab.copyLink()), button("save a picture", "", () => lab.savePicture()),
    lab.filmButton, button("open a run", "replay.json of a program", () => lab.runFile.click()), button("view from the start", "key Home", () => lab.resetView()), lab.runFile]);
}

function ownScene(lab) {
  lab.text = element("textarea", { spellcheck: false, rows: 14, ariaLabel: "the scene's text" });
  return element("details", { className: "lab-own" }, [
    element("summary", { textContent: "The scene's text: change it" }), lab.text,
    element("div", { className: "lab-bar" }, [button("run this text", "", () => { lab.sceneChoice.value = OWN; lab.reload(); })])]);
}

function onKey(lab, event) {
  if (/^(TEXTAREA|SELECT)$/.test(event.target.tagName) || event.ctrlKey || event.metaKey || event.altKey) return;
  const does = { " ": () => lab.play(!lab.playing), ArrowRight: () => lab.stepOnce(), ArrowLeft: () => lab.show(lab.index - 1), r: () => lab.reload(), Home: () => lab.resetView() }[event.key];
  if (!does || event.key === " " && event.target.tagName === "BUTTON" || event.target === lab.slider && event.key !== " ") return;
  event.preventDefault();
  does();
}

// Fills the laboratory's box. Each element that it reads or writes later is a field of the laboratory.
export function makeControls(lab) {
  lab.stars = element("div", { className: "lab-stars", ariaLabel: "scenes to begin with" }, lab.given.scenes.filter(({ thumbnail }) => thumbnail).map(scene => starOf(lab, scene)));
  lab.slider = element("input", { type: "range", min: 0, max: 0, value: 0, className: "lab-time", ariaLabel: "steps that were shown" });
  lab.slider.addEventListener("input", () => { lab.play(false); lab.show(Number(lab.slider.value)); });
  lab.knobs = new Knobs(() => lab.text.value, text => { lab.text.value = text; lab.start(lab.reload()); });
  lab.about = element("p", { className: "lab-about" });
  lab.look = element("p", { className: "lab-look" });
  lab.views = element("div", { className: "lab-views" });
  lab.curvesBox = element("div", { className: "lab-curves" });
  lab.state = element("p", { className: "lab-state", ariaLive: "off" });
  lab.pairBox = element("div", { className: "lab-pair" });
  lab.message = element("pre", { className: "lab-message", hidden: true });
  lab.message.setAttribute("role", "alert");
  lab.box.replaceChildren(lab.stars, barOfSteps(lab), lab.message, lab.views, lab.slider, lab.look, barOfChoices(lab), lab.knobs.box, lab.about, lab.state, lab.curvesBox, lab.pairBox,
    barOfFiles(lab), ownScene(lab));
  lab.box.addEventListener("keydown", event => onKey(lab, event));
}
