// The laboratory: a page's box with scenes, solvers, steps, curves and pairs. controls.js makes the box, engine.js asks the compiled layers
// for each step, view.js draws, and told.js finds the words. What they share is the state of this class.
import { Curves, LANE_COLOURS } from "./curves.js";
import { makeControls, OWN, RUN } from "./controls.js";
import { record } from "./film.js";
import { kept, Lane } from "./lane.js";
import { readLink, writeLink } from "./link.js";
import { canvasOfAll, paint, save } from "./pictures.js";
import { replayed } from "./replay.js";
import { counted, pairTable, stateOf } from "./told.js";

const MOST_BYTES = 3e8, MOST_STEPS_A_FRAME = 20, FRAME = 1 / 60, USUAL_SOLVER = 10;

class Laboratory {
  constructor(box, given) {
    this.box = box;
    this.given = given;
    this.lanes = [];
    this.index = 0;
    this.begun = 0;
    makeControls(this);
    this.curves = new Curves(this.curvesBox);
    new MutationObserver(() => this.retheme()).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    new ResizeObserver(() => this.drawCurves()).observe(this.curvesBox);
    addEventListener("hashchange", () => { if (location.hash.slice(1) !== this.written) this.openLink(); });
    this.ready = this.openLink();
    this.tick = this.tick.bind(this);
    requestAnimationFrame(this.tick);
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
    while (this.lanes.length > solvers.length) this.lanes.pop().end();
    while (this.lanes.length < solvers.length) this.lanes.push(this.makeLane());
    const file = known && this.text.value === known.text ? `${known.key}.json` : "own.json";
    const loaded = await Promise.all(this.lanes.map((lane, i) => lane.engine.load(this.text.value, file, solvers[i])));
    if (turn !== this.begun) return;
    const failed = loaded.find(({ error }) => error);
    this.say(failed?.error ?? loaded[0].scene.warnings.join("\n"), !failed);
    if (failed) return;
    this.lanes.forEach((lane, i) => lane.begin(loaded[i].scene, [kept(loaded[i].frame)],
      { title: this.titleOf(solvers[i]), colour: LANE_COLOURS[i], showsPairs: this.pairsShown.checked, replays: false, keepView }));
    this.look.textContent = known?.look ? `Look at this: ${known.look}` : "";
    for (const star of this.stars.children) star.setAttribute("aria-pressed", String(star.dataset.scene === known?.key));
    this.knobs.show(this.text.value, Math.min(...solvers.map(solver => Number(solver) || Infinity)));
    this.about.textContent = [known?.note, this.lanes[0].scene.description].filter(Boolean).join(" ");
    this.choose(null);
    this.index = 0;
    this.until = this.lanes[0].scene.duration;
    this.show(0);
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
    while (this.lanes.length > 1) this.lanes.pop().end();
    if (!this.lanes.length) this.lanes.push(this.makeLane());
    this.lanes[0].begin(scene, frames, { title: scene.solver, colour: LANE_COLOURS[0], showsPairs: this.pairsShown.checked, replays: true });
    this.say("", true);
    this.look.textContent = "";
    this.knobs.box.hidden = true;
    this.about.textContent = `${counted(frames.length, "frame")} of a run. ${scene.description}`;
    this.choose(null);
    this.until = Infinity;
    this.show(0);
  }

  makeLane() {
    const lane = new Lane(this.views, this.given.meshes);
    lane.view.onmove = view => this.moved(view);
    lane.view.onchoose = key => this.choose(key);
    lane.view.onpull = (view, grip) => this.pull(lane, grip);
    return lane;
  }

  // A chapter by its number, a method by its own title.
  titleOf(solver) { return Number(solver) ? `chapter ${solver}` : this.given.solvers.find(([key]) => key === solver)[1].replace(/^\d+: /, ""); }

  // --------------------------------------------------------------------------------------------------------- the steps
  get last() { return this.lanes[0] ? this.lanes[0].frames.length - 1 : 0; }
  get broken() { return this.lanes.length > 0 && this.lanes.every(lane => lane.broken); }

  async advance(steps) {
    if (this.computing || this.broken || this.replays || !this.lanes.length) return;
    const turn = this.begun;
    this.computing = true;
    const frames = await Promise.all(this.lanes.map(lane => lane.broken ? { error: lane.broken } : lane.engine.advance(steps)));
    this.computing = false;
    if (turn !== this.begun) return;
    this.lanes.forEach((lane, i) => lane.take(frames[i]));
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
    this.state.textContent = stateOf(this.lanes, this.index);
    this.tellPair();
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

  choose(key) {
    this.chosen = key;
    for (const lane of this.lanes) lane.view.choose(key);
    this.tellPair();
  }

  tellPair() { this.pairBox.replaceChildren(pairTable(this.lanes, this.index, this.chosen)); }

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
    const known = solver => this.given.solvers.some(([key]) => key === String(solver));
    this.solverChoice.value = known(link.solver) ? link.solver : link.scene ? USUAL_SOLVER : scene?.solver ?? USUAL_SOLVER;
    this.besideChoice.value = known(link.beside) ? link.beside : link.scene ? 0 : scene?.beside ?? 0;
    await this.reload(link.view);
    if (!link.scene && !link.text) return this.start();
    for (let step = 0; step < (link.step ?? 0) && !this.broken; ++step) {
      await this.advance(1);
      if (step % 5 === 4) this.show(this.last);
    }
    this.show(this.last);
  }

  fileName(ending) { return `${this.lanes[0].scene.name}_${this.lanes[0].frames[this.index].numbers.step}.${ending}`; }

  savePicture() {
    const whole = canvasOfAll(this.lanes);
    paint(whole, this.lanes);
    save(whole.toDataURL("image/png"), this.fileName("png"));
  }

  // The steps so far, at the chosen speed; step by step, ten of them in a second.
  async film() {
    const whole = canvasOfAll(this.lanes), speed = Number(this.speedChoice.value), first = this.timeOf(0), last = this.last;
    this.play(false);
    this.filming = this.filmButton.disabled = true;
    try {
      return await record(whole, seconds => {
        this.show(Math.min(last, speed ? this.frameAt(first + speed * seconds) : Math.floor(10 * seconds)));
        paint(whole, this.lanes);
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
      save(address, this.fileName(film.type.split("/")[1]));
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
