// The laboratory: a page's box with scenes, solvers, steps, curves and pairs. What is computed, engine.js asks of the compiled layers;
// what is seen, view.js draws.
import { Curves, LANE_COLOURS } from "./curves.js";
import { Engine } from "./engine.js";
import { filmType, record } from "./film.js";
import { readLink, writeLink } from "./link.js";
import { keyOf, pairAt, pairCount, readable, rowsOf } from "./pairs.js";
import { button, element, labelled, select } from "./parts.js";
import { replayed } from "./replay.js";
import { Knobs } from "./knobs.js";
import { View } from "./view.js";

// Chapters by their numbers, the methods of chapter 13 by their names.
const METHODS = [["sequential", "sequential impulses"], ["soft_step", "soft step"], ["relaxation", "convex relaxation"], ["xpbd", "XPBD"], ["avbd", "AVBD"], ["barrier", "barrier"]];
const SOLVERS = [[1, "1: particle and plane"], [2, "2: collision detection"], [3, "3: penalty impulses"], [4, "4: friction"], [5, "5: categorisation"], [6, "6: redefinition"],
                  [7, "7: implicit contact"], [8, "8: contact by distance"], [9, "9: deep contacts"], [10, "10: self-contact"],
                  [11, "11: exact contact"], [12, "12: joints"], ...METHODS.map(([name, title]) => [name, `13: ${title}`])];
const titleOf = solver => METHODS.find(([name]) => name === solver)?.[1] ?? `chapter ${solver}`;
const LAST_CHAPTER = 13;
const SPEEDS = [[1, "as the clock"], [0.25, "4 times slower"], [0.0625, "16 times slower"], [0, "step by step"]];
const OWN = "own", RUN = "run", MOST_BYTES = 3e8, MOST_STEPS_A_FRAME = 20, FRAME = 1 / 60;

const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;

class Laboratory {
  constructor(box, given) {
    this.box = box;
    this.given = given;
    this.lanes = [];
    this.index = 0;
    this.begun = 0;
    this.makeControls();
    this.curves = new Curves(this.curvesBox);
    new MutationObserver(() => this.retheme()).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    new ResizeObserver(() => this.drawCurves()).observe(this.curvesBox);
    addEventListener("hashchange", () => { if (location.hash.slice(1) !== this.written) this.openLink(); });
    this.ready = this.openLink();
    this.tick = this.tick.bind(this);
    requestAnimationFrame(this.tick);
  }

  // ------------------------------------------------------------------------------------------------------ the controls
  makeControls() {
    const groups = new Map();
    for (const scene of this.given.scenes) groups.set(scene.group, [...groups.get(scene.group) ?? [], [scene.key, scene.title]]);
    this.sceneChoice = select([...groups.entries(), ["Your own", [[OWN, "the text below"], [RUN, "a run that a program wrote"]]]], () => this.start(this.chooseScene()));
    this.solverChoice = select(SOLVERS, () => this.start(this.reload()));
    this.besideChoice = select([[0, "none"], ...SOLVERS], () => this.start(this.reload()));
    this.stars = element("div", { className: "lab-stars", ariaLabel: "scenes to begin with" }, this.given.scenes.filter(({ thumbnail }) => thumbnail).map(scene => {
      const made = button("", scene.look, () => { this.sceneChoice.value = scene.key; this.start(this.chooseScene()); });
      made.dataset.scene = scene.key;
      made.append(element("img", { src: scene.thumbnail, alt: "", width: 168, height: 112 }), element("span", { textContent: scene.title }));
      return made;
    }));
    this.knobs = new Knobs(() => this.text.value, text => { this.text.value = text; this.start(this.reload()); });
    this.speedChoice = select(SPEEDS, () => this.restartClock());
    this.playButton = button("▶ play", "space bar", () => this.play(!this.playing));
    this.pairsShown = element("input", { type: "checkbox", checked: true });
    this.pairsShown.addEventListener("input", () => this.lanes.forEach(lane => lane.view.showPairs(this.pairsShown.checked)));
    const steps = element("div", { className: "lab-bar" }, [
      this.playButton, button("◀ back", "left arrow", () => this.show(this.index - 1)), button("step ▶", "right arrow", () => this.stepOnce()),
      button("↺ reset", "key R", () => this.reload()), labelled("speed", this.speedChoice), labelled("pairs and joints", this.pairsShown)]);
    this.slider = element("input", { type: "range", min: 0, max: 0, value: 0, className: "lab-time", ariaLabel: "steps that were shown" });
    this.slider.addEventListener("input", () => { this.play(false); this.show(Number(this.slider.value)); });
    this.about = element("p", { className: "lab-about" });
    this.look = element("p", { className: "lab-look" });
    this.views = element("div", { className: "lab-views" });
    this.curvesBox = element("div", { className: "lab-curves" });
    this.state = element("p", { className: "lab-state", ariaLive: "off" });
    this.pairBox = element("div", { className: "lab-pair" });
    this.text = element("textarea", { spellcheck: false, rows: 14, ariaLabel: "the scene's text" });
    this.message = element("pre", { className: "lab-message", hidden: true });
    this.message.setAttribute("role", "alert");
    const own = element("details", { className: "lab-own" }, [
      element("summary", { textContent: "The scene's text: change it" }), this.text,
      element("div", { className: "lab-bar" }, [button("run this text", "", () => { this.sceneChoice.value = OWN; this.reload(); })])]);
    const keep = element("div", { className: "lab-bar" }, [
      button("copy a link", "to this scene, its solvers, step and view", () => this.copyLink()), button("save a picture", "", () => this.savePicture()),
      this.filmButton = button("save a film", "of the steps so far, at the chosen speed", () => this.saveFilm()), button("open a run", "replay.json of a program", () => this.runFile.click()),
      button("view from the start", "key Home", () => this.resetView())]);
    this.filmButton.hidden = !filmType();
    this.runFile = element("input", { type: "file", accept: ".json", hidden: true });
    this.runFile.addEventListener("change", () => this.openFile(this.runFile.files[0]));
    const choices = element("div", { className: "lab-bar" }, [labelled("scene", this.sceneChoice), labelled("solver", this.solverChoice), labelled("beside it", this.besideChoice)]);
    this.box.replaceChildren(this.stars, steps, this.message, this.views, this.slider, this.look, choices, this.knobs.box, this.about, this.state, this.curvesBox, this.pairBox, keep, this.runFile, own);
    this.box.addEventListener("keydown", event => this.key(event));
  }

  key(event) {
    if (/^(TEXTAREA|SELECT)$/.test(event.target.tagName) || event.ctrlKey || event.metaKey || event.altKey) return;
    const does = { " ": () => this.play(!this.playing), ArrowRight: () => this.stepOnce(), ArrowLeft: () => this.show(this.index - 1), r: () => this.reload(), Home: () => this.resetView() }[event.key];
    if (!does || event.key === " " && event.target.tagName === "BUTTON" || event.target === this.slider && event.key !== " ") return;
    event.preventDefault();
    does();
  }

  // ------------------------------------------------------------------------------------------------------- the scenes
  chooseScene() {
    if (this.sceneChoice.value === RUN) return this.chooseRun();
    const scene = this.given.scenes.find(({ key }) => key === this.sceneChoice.value);
    if (scene) {
      this.text.value = scene.text;
      if (scene.solver) this.solverChoice.value = scene.solver;
      if (scene.beside !== undefined) this.besideChoice.value = scene.beside;
    }
    return this.reload();
  }

  // A scene that a reader has chosen moves at once, but for readers who want no motion.
  async start(loading) {
    await loading;
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches && !this.replays && (this.message.hidden || this.message.classList.contains("mild"))) this.play(true);
  }

  // Reads the text anew, under each of the solvers. `keepView`: the camera of a link.
  async reload(keepView = null) {
    const turn = ++this.begun, known = this.given.scenes.find(({ key }) => key === this.sceneChoice.value);
    this.play(false);
    if (this.sceneChoice.value === RUN) return this.chooseRun();
    this.offer(true);
    const solvers = [this.solverChoice.value, this.besideChoice.value].filter(solver => solver !== "0");
    while (this.lanes.length > solvers.length) this.endLane(this.lanes.pop());
    while (this.lanes.length < solvers.length) this.lanes.push(this.makeLane());
    const file = known && this.text.value === known.text ? `${known.key}.json` : "own.json";
    const loaded = await Promise.all(this.lanes.map((lane, i) => lane.engine.load(this.text.value, file, solvers[i])));
    if (turn !== this.begun) return;
    const failed = loaded.find(({ error }) => error);
    this.say(failed?.error ?? loaded[0].scene.warnings.join("\n"), !failed);
    if (failed) return;
    this.lanes.forEach((lane, i) => this.begin(lane, loaded[i].scene, [this.kept(loaded[i].frame)], { title: titleOf(solvers[i]), colour: LANE_COLOURS[i], keepView }));
    this.look.textContent = known?.look ? `Look at this: ${known.look}` : "";
    for (const star of this.stars.children) star.setAttribute("aria-pressed", String(star.dataset.scene === known?.key));
    this.knobs.show(this.text.value, Math.min(...solvers.map(solver => Number(solver) || LAST_CHAPTER)));
    this.about.textContent = [known?.note, this.lanes[0].scene.description].filter(Boolean).join(" ");
    this.choose(null);
    this.index = 0;
    this.until = this.lanes[0].scene.duration;
    this.show(0);
  }

  // A scene of the same bodies is seen from where the last one was.
  begin(lane, scene, frames, { title, colour, keepView = null }) {
    const named = ({ name, bodies }) => JSON.stringify([name, bodies.map(body => body.name)]);
    const looked = lane.scene && named(lane.scene) === named(scene) ? lane.view.looks() : null;
    Object.assign(lane, { scene, broken: null, frames });
    lane.title.textContent = title;
    lane.title.style.setProperty("--lane", colour);
    lane.view.showsPairs = this.pairsShown.checked;
    lane.view.pulls = !this.replays;
    lane.view.canvas.setAttribute("aria-label", `${scene.name}, ${title}. Drag beside bodies to turn the view${this.replays ? "" : ", drag a body to pull it"}.`);
    lane.view.show(scene, frames[0]);
    if (keepView ?? looked) lane.view.look(keepView ?? looked);
  }

  // ------------------------------------------------------------------------------------------- a run that was written
  // A run has its frames: there is nothing to choose and to compute.
  offer(yes) {
    this.replays = !yes;
    for (const choice of [this.solverChoice, this.besideChoice]) {
      choice.disabled = !yes;
      choice.closest("label").style.display = yes ? "" : "none";
    }
  }

  chooseRun() { return this.given.run ? this.openRun(this.given.run) : this.runFile.click(); }

  async openFile(file) {
    if (!file) return;
    try {
      this.given.run = JSON.parse(await file.text());
      this.openRun(this.given.run);
    } catch (error) {
      this.say(`${file.name}: ${error.message}`, false);
    }
  }

  // @throws Error  it is no run
  openRun(run) {
    const { scene, frames } = replayed(run);
    ++this.begun;
    this.play(false);
    this.offer(false);
    this.sceneChoice.value = RUN;
    while (this.lanes.length > 1) this.endLane(this.lanes.pop());
    if (!this.lanes.length) this.lanes.push(this.makeLane());
    this.begin(this.lanes[0], scene, frames, { title: scene.solver, colour: LANE_COLOURS[0] });
    this.say("", true);
    this.look.textContent = "";
    this.knobs.box.hidden = true;
    this.about.textContent = `${counted(frames.length, "frame")} of a run. ${scene.description}`;
    this.choose(null);
    this.until = Infinity;
    this.show(0);
  }

  makeLane() {
    const place = element("div", { className: "lab-view" }), title = element("span", { className: "lab-lane" });
    place.append(title);
    this.views.append(place);
    const lane = { place, title, view: new View(place), engine: new Engine(this.given.meshes), frames: [] };
    lane.view.onmove = view => this.moved(view);
    lane.view.onchoose = key => this.choose(key);
    lane.view.onpull = (view, grip) => this.pull(lane, grip);
    return lane;
  }

  endLane(lane) {
    lane.engine.end();
    lane.view.end();
    lane.place.remove();
  }

  // Frames are kept with single precision for what is drawn; tables and curves have all digits.
  kept(frame) {
    return { ...frame, exact: frame.positions, positions: new Float32Array(frame.positions) };
  }

  // --------------------------------------------------------------------------------------------------------- the steps
  get last() { return this.lanes[0] ? this.lanes[0].frames.length - 1 : 0; }
  get broken() { return this.lanes.length > 0 && this.lanes.every(lane => lane.broken); }

  async advance(steps) {
    if (this.computing || this.broken || this.replays || !this.lanes.length) return;
    const turn = this.begun;
    this.computing = true;
    const frames = await Promise.all(this.lanes.map(lane => lane.broken ? lane.frames.at(-1) : lane.engine.advance(steps)));
    this.computing = false;
    if (turn !== this.begun) return;
    this.lanes.forEach((lane, i) => {
      if (frames[i].error) lane.broken = frames[i].error;
      const frame = frames[i].error || lane.broken ? lane.frames.at(-1) : this.kept(frames[i]);
      delete lane.frames.at(-1).exact;
      lane.frames.push(frame);
    });
    const most = Math.max(200, MOST_BYTES / this.lanes.reduce((sum, { frames: [first] }) => sum + first.positions.byteLength + 4000, 0));
    while (this.last > most) for (const lane of this.lanes) lane.frames.shift();
    const broken = this.lanes.filter(lane => lane.broken).map(lane => `${lane.title.textContent} ended: ${lane.broken}`);
    if (broken.length) this.say(broken.join("\n"), false);
    if (this.broken) this.play(false);
  }

  async stepOnce() {
    this.play(false);
    if (this.index === this.last) await this.advance(1);
    this.show(this.index + 1);
  }

  show(index) {
    if (!this.lanes.length || !this.lanes[0].frames.length) return;
    this.index = Math.max(0, Math.min(index, this.last));
    this.slider.max = this.last;
    this.slider.value = this.index;
    for (const lane of this.lanes) {
      lane.view.update(lane.frames[this.index]);
      lane.view.placeSpring();
    }
    this.drawCurves();
    this.tell();
  }

  play(yes) {
    this.playing = yes && !this.broken && !this.filming;
    if (this.playing && this.replays && this.index === this.last) this.show(0);
    this.playButton.textContent = this.playing ? "❚❚ pause" : "▶ play";
    const now = this.lanes[0]?.frames[this.index]?.numbers.time ?? 0;
    if (this.playing && now >= this.until - 1e-9) this.until += this.lanes[0].scene.duration;
    this.restartClock();
  }

  restartClock() { this.clock = { at: performance.now(), time: this.lanes[0]?.frames[this.index]?.numbers.time ?? 0 }; }

  async tick(now) {
    requestAnimationFrame(this.tick);
    if (!this.playing || this.computing || !this.lanes.length) return;
    const speed = Number(this.speedChoice.value), { dt } = this.lanes[0].scene, time = this.timeOf(this.index), next = this.index < this.last ? this.timeOf(this.index + 1) : time + dt;
    const due = speed ? this.clock.time + speed * (now - this.clock.at) / 1000 : next;
    if (due < next - dt * 0.001) return;
    if (this.index === this.last && due > time + 4 * Math.max(dt, FRAME)) this.clock = { at: now, time: next }; // it cannot keep pace: what was missed is not made up for
    if (time >= this.until - 1e-9 || this.replays && this.index === this.last) { this.play(false); return; }
    const steps = Math.max(1, Math.min(MOST_STEPS_A_FRAME, Math.floor((due - time) / dt + 1e-3)));
    if (this.index === this.last) await this.advance(steps);
    this.show(speed ? this.frameAt(due, this.index + 1) : this.index + 1);
  }

  timeOf(index) { return this.lanes[0].frames[index].numbers.time; }

  // The last frame that is due, but not before `first`.
  frameAt(time, first = 0) {
    let index = first;
    while (index < this.last && this.timeOf(index + 1) <= time + 1e-9) ++index;
    return index;
  }

  pull(lane, grip) {
    if (this.replays) return;
    if (grip && this.index < this.last) this.show(this.last);
    lane.engine.hold(grip?.body ?? -1, grip?.face ?? 0, grip?.target ?? [0, 0, 0]);
    if (grip && !this.playing) this.play(true);
  }

  // ---------------------------------------------------------------------------------------------------- what it tells
  say(message, mild) {
    this.message.hidden = !message;
    this.message.textContent = message;
    this.message.classList.toggle("mild", mild);
  }

  tell() {
    const frames = this.lanes.map(lane => lane.frames[this.index]), [{ numbers: n }] = frames;
    const work = ({ numbers: m, milliseconds }) => [!m.work ? "" : m.work.newton_steps ? `${counted(m.work.rounds, "round")} with ${counted(m.work.newton_steps, "Newton step")}` : counted(m.work.responses, "response"),
      m.thrown_away ? `${m.thrown_away} halved so far` : "", milliseconds ? `${readable(Number(milliseconds.toFixed(1)))} ms a step` : ""].filter(Boolean).join(", ");
    const told = (frame, i) => (this.lanes.length > 1 ? `${this.lanes[i].title.textContent}: ` : "") + [`${frame.numbers.pairs} of ${pairCount(frame)} pairs push`, work(frame)].filter(Boolean).join("; ");
    this.state.textContent = `Step ${n.step}, ${n.time.toFixed(3)} s. ${frames.map(told).join(". ")}.`;
    this.tellPair();
  }

  choose(key) {
    this.chosen = key;
    for (const lane of this.lanes) lane.view.choose(key);
    this.tellPair();
  }

  tellPair() {
    const found = this.lanes.map(lane => {
      const frame = lane.frames[this.index];
      for (let i = 0; frame && i < pairCount(frame); ++i) if (keyOf(pairAt(frame, i)) === this.chosen) return rowsOf(pairAt(frame, i), lane.scene);
      return null;
    });
    const rows = found.find(Boolean);
    if (!rows) {
      this.pairBox.replaceChildren(element("p", { textContent: this.chosen ? "These features are no pair in this step." : "Click the mark of a pair to read its values." }));
      return;
    }
    const head = this.lanes.length > 1 ? [element("tr", {}, [element("th"), ...this.lanes.map(lane => element("th", { textContent: lane.title.textContent }))])] : [];
    const body = rows.map(([name], row) => element("tr", {}, [element("th", { textContent: name }), ...found.map(its => element("td", { textContent: its?.[row][1] ?? "no pair" }))]));
    this.pairBox.replaceChildren(element("table", {}, [...head, ...body]));
  }

  drawCurves() { if (this.curves && this.lanes[0]?.frames.length) this.curves.draw(this.lanes, this.index); }

  retheme() {
    for (const lane of this.lanes) lane.view.theme();
    this.drawCurves();
  }

  // ------------------------------------------------------------------------------------------------- view, link, picture
  moved(view) {
    if (this.moving) return;
    this.moving = true; // the other view follows
    for (const lane of this.lanes) if (lane.view !== view && lane.view.scene) lane.view.look(view.looks());
    this.moving = false;
  }

  resetView() {
    for (const { view, scene } of this.lanes) view.look(scene.camera_given ? { eye: [...scene.eye], target: [...scene.target] } : view.afar());
  }

  link() {
    return writeLink({ scene: this.sceneChoice.value, text: this.sceneChoice.value === OWN || !this.given.scenes.some(({ text }) => text === this.text.value) ? this.text.value : null, solver: this.solverChoice.value,
      beside: this.besideChoice.value, step: this.lanes[0].frames[this.index].numbers.step, view: this.lanes[0].view.looks() });
  }

  async copyLink() {
    if (this.replays) return this.say("A link cannot hold a run: give its file, replay.json.", true);
    this.written = this.link();
    history.replaceState(null, "", `#${this.written}`);
    try {
      await navigator.clipboard.writeText(location.href);
      this.say("The link is copied, and stands in the address line.", true);
    } catch {
      this.say("The link stands in the address line.", true);
    }
  }

  async openLink() {
    if (this.given.run && !location.hash) return this.openRun(this.given.run);
    const link = readLink(location.hash.slice(1)), first = this.given.scenes[0];
    const scene = this.given.scenes.find(({ key }) => key === link.scene) ?? (link.text ? null : first);
    this.sceneChoice.value = link.text || !scene ? OWN : scene.key;
    this.text.value = link.text ?? scene.text;
    this.solverChoice.value = SOLVERS.some(([solver]) => solver === link.solver) ? link.solver : link.scene ? 10 : scene?.solver ?? 10;
    this.besideChoice.value = SOLVERS.some(([solver]) => solver === link.beside) ? link.beside : link.scene ? 0 : scene?.beside ?? 0;
    await this.reload(link.view);
    if (!link.scene && !link.text) return this.start();
    for (let step = 0; step < (link.step ?? 0) && !this.broken; ++step) {
      await this.advance(1);
      if (step % 5 === 4) this.show(this.last);
    }
    this.show(this.last);
  }

  // All views side by side, as they are now.
  paint(whole) {
    let at = 0;
    for (const { view } of this.lanes) {
      view.drawNow();
      whole.getContext("2d").drawImage(view.canvas, at, 0);
      at += view.canvas.width;
    }
  }

  // With even sides, as films have them.
  canvasOfAll() {
    const even = length => length - length % 2, pictures = this.lanes.map(lane => lane.view.canvas);
    return element("canvas", { width: even(pictures.reduce((sum, { width }) => sum + width, 0)), height: even(pictures[0].height) });
  }

  save(address, ending) { element("a", { href: address, download: `${this.lanes[0].scene.name}_${this.lanes[0].frames[this.index].numbers.step}.${ending}` }).click(); }

  savePicture() {
    const whole = this.canvasOfAll();
    this.paint(whole);
    this.save(whole.toDataURL("image/png"), "png");
  }

  // The steps so far, at the chosen speed; step by step, ten of them in a second.
  async film() {
    const whole = this.canvasOfAll(), speed = Number(this.speedChoice.value), first = this.timeOf(0), last = this.last;
    this.play(false);
    this.filming = this.filmButton.disabled = true;
    try {
      return await record(whole, seconds => {
        this.show(Math.min(last, speed ? this.frameAt(first + speed * seconds) : Math.floor(10 * seconds)));
        this.paint(whole);
        return this.index < last;
      });
    } finally {
      this.filming = this.filmButton.disabled = false;
    }
  }

  async saveFilm() {
    if (!this.last) return this.say("There is no step yet to film: play first.", true);
    try {
      const film = await this.film(), address = URL.createObjectURL(film);
      this.save(address, film.type.split("/")[1]);
      setTimeout(() => URL.revokeObjectURL(address), 60_000);
    } catch (error) {
      this.say(`This browser could not film: ${error.message}`, false);
    }
  }
}

const box = document.querySelector("[data-lab]");
const failed = error => {
  box.textContent = `The laboratory needs WebAssembly and WebGL; this browser says: ${error.message}`;
  box.dataset.lab = "failed";
};
try {
  window.laboratory = new Laboratory(box, window.LABORATORY);
  window.laboratory.ready.then(() => { box.dataset.lab = "ready"; }, failed);
} catch (error) {
  failed(error);
}
