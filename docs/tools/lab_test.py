#!/usr/bin/python3
"""Runs the laboratory in headless Chromium, and compares its numbers with those of the program `laboratory`.

Eighteen scenes under the solvers of chapters 2 to 11 and three methods of chapter 13, 100 steps each; what the page shows, and that nothing is told on the console. Needs Debian's chromium-driver and python3-selenium.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import lab
from browser_test import DESKTOP, PHONE, ActionChains, By, WebDriverException, WebDriverWait, browser, drag, open_page, screen

ROOT = Path(__file__).resolve().parents[2]
STEPS = 100
LARGE = {"width": 1440, "height": 900, "deviceScaleFactor": 1, "mobile": False}
# The page and the program differ in the last bits of sine and cosine, by which rotations are placed and turned: 1e-16 of a body's size. A contact that opens multiplies
# a difference by the stiffness of its pair, k dt^2 / m; in a hundred steps of these scenes it stays below this part of the scene's size: 4e-9 where a body begins inside another one, 1e-12 elsewhere. A wrong sign,
# a pair less or another order of sums is far above. (The tower under chapter 7 is not among them: its cubes meet exactly edge on edge, so in its eighth step the last bit decides which of them
# are pairs, and the program and the page are 2e-5 m apart.)
TOLERANCE = 1e-7
CASES = [("tower", 10), ("slope", 4), ("block_on_slope", 7), ("block_on_triangles", 6), ("hooked", 6), ("hooked", 10), ("deep", 8), ("initial_overlap", 9), ("falling_sphere", 3), ("thin", 7),
         ("through_the_side", 6), ("fast_plate", 2), ("bar_on_cube", 3), ("folded", 10), ("block_on_slope", 11),
         ("tower", "soft_step"), ("slope", "relaxation"), ("block_on_slope", "avbd")]
RUN = """const [text, solver, steps, done] = arguments, lab = window.laboratory, Engine = lab.lanes[0].engine.constructor, engine = new Engine(lab.given.meshes);
engine.load(text, 'test.json', solver).then(async loaded => {
  const begun = performance.now();
  let frame = loaded, worst = 0;
  for (let i = 0; i < steps && !frame.error; ++i) { frame = await engine.advance(1); worst = Math.max(worst, frame.milliseconds); }
  engine.end();
  done(frame.error ? { error: frame.error } : { positions: [...frame.positions], energy: frame.numbers.kinetic + frame.numbers.gravitational + frame.numbers.elastic,
         mean: (performance.now() - begun) / steps, worst });
});"""
PLAY = """const [steps, done] = arguments, lab = window.laboratory; (async () => { for (let i = 0; i < steps; ++i) await lab.stepOnce(); done(lab.state.textContent); })();"""
# Where a point of space is on the canvas, from its middle [px].
ON_SCREEN = """const { camera, canvas } = window.laboratory.lanes[0].view, at = new camera.position.constructor(...eval(arguments[0])).project(camera);
return [Math.round(at.x * canvas.clientWidth / 2), Math.round(-at.y * canvas.clientHeight / 2)];"""
FILM = """const done = arguments[0]; window.laboratory.film().then(async film => done({ type: film.type, size: film.size,
  head: [...new Uint8Array(await film.slice(0, 4).arrayBuffer())] }), error => done({ error: String(error) }));"""
OPEN_A_RUN = """const [run, step] = arguments, lab = window.laboratory; lab.given.run = run; lab.openRun(run);
const { frames } = lab.lanes[0]; lab.show(frames.findIndex(({ numbers }) => numbers.step === step));
return { count: frames.length, positions: [...frames[lab.index].positions], state: lab.state.textContent, pairs: frames[lab.index].pairs.length };"""
PLAY_A_RUN = """const done = arguments[0], lab = window.laboratory; lab.show(0); lab.play(true); setTimeout(() => { lab.play(false); done(lab.index); }, 1500);"""
WEBM = [0x1A, 0x45, 0xDF, 0xA3]  # as such a file begins
SPINS = '{"/bodies/ball/angular_velocity": [3, -5, 7]}'  # so that a rigid body of the scene `tumble` turns about all axes
LAST = 11  # the chapter whose solver a scene of one's own gets
FLOAT = 1e-6  # of the scene's size: what a float of 32 bits rounds away of a position and a turn
KNOWN_NOISE = ("GPU stall", "software WebGL", "swiftshader")


def simplicial(text):
    """Soft bodies with the solver that the browser has."""
    scene = json.loads(text)
    for body in scene["bodies"]:
        if body["type"] == "deformable":
            body["linear_solver"] = "simplicial"
    return json.dumps(scene)


def native(program, text, solver):
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        done = subprocess.run([program, file.name, "--solver", str(solver), "--steps", str(STEPS)], capture_output=True, text=True)
    return json.loads(done.stdout) if done.returncode == 0 else {"error": done.stderr}


def difference(page, program):
    """The largest distance of a coordinate, as a part of the scene's size."""
    size = max(map(abs, program["positions"]))
    return max(abs(a - b) for a, b in zip(page["positions"], program["positions"])) / size


def number_faults(driver, program, cases=CASES):
    for name, solver in cases:
        text = simplicial(lab.text_of(name))
        page, there = driver.execute_async_script(RUN, text, solver, STEPS), native(program, text, solver)
        if "error" in page or "error" in there:
            yield f"{name} under {solver}: the page says {page.get('error', 'nothing')}, the program {there.get('error', 'nothing')}"
            continue
        apart = difference(page, there)
        print(f"   {name} under {solver}: {apart:.1e} of its size apart after {STEPS} steps")
        if len(page["positions"]) != len(there["positions"]) or not apart <= TOLERANCE:
            yield f"{name} under {solver}: after {STEPS} steps the page and the program are {apart:.1e} of the scene's size apart; at most {TOLERANCE:.0e}"


def ready(driver, page):
    open_page(driver, page)
    WebDriverWait(driver, 60).until(lambda d: d.execute_script("return document.querySelector('[data-lab]').dataset.lab") != "loading")
    return driver.execute_script("return document.querySelector('[data-lab]').dataset.lab") == "ready"


def start_faults(driver, size):
    """On the first screen there is a button that plays; the first scene moves by itself; a slider changes the scene."""
    run = driver.execute_script
    screen(driver, size)
    if not run("const box = window.laboratory.playButton.getBoundingClientRect(); scrollTo(0, 0); return box.bottom < innerHeight && box.top > 0"):
        yield f"the button that plays is not on the first screen of {size['width']} x {size['height']}"
    try:
        WebDriverWait(driver, 30).until(lambda d: d.execute_script("return window.laboratory.index") > 2)
    except WebDriverException:
        yield "the first scene does not start by itself"
    driver.execute_async_script("const [done] = arguments, lab = window.laboratory; lab.play(false); lab.reload().then(done)")
    run("const { input } = window.laboratory.knobs.rows[1]; input.value = 0; input.dispatchEvent(new Event('change'))")
    if run("return JSON.parse(window.laboratory.text.value).dt") != 0.001:
        yield "the slider of dt does not write it into the text"
    driver.execute_async_script("const [done] = arguments, lab = window.laboratory; lab.chooseScene().then(() => { lab.play(false); done(); })")


def use_faults(driver):
    """What a reader does: steps, goes back, chooses a pair, writes a mistake, and copies a link."""
    run = driver.execute_script
    told = driver.execute_async_script(PLAY, 3)
    if "Step 3," not in told:
        yield f"three steps end with '{told}'"
    run("window.laboratory.show(1)")
    if "Step 1," not in run("return window.laboratory.state.textContent"):
        yield "it does not go back"
    run("const lab = window.laboratory; lab.sceneChoice.value = 'tower'; lab.chooseScene()")
    WebDriverWait(driver, 30).until(lambda d: d.execute_script("return window.laboratory.lanes[0].scene.name") == "tower")
    driver.execute_async_script(PLAY, 12)
    run("const lab = window.laboratory, [a, b, c, d, e] = lab.lanes[0].frames[lab.index].pairs; lab.choose([a, b, d, c, e].join(' '))")
    if "since step" not in run("return window.laboratory.pairBox.textContent"):
        yield "a chosen pair has no table"
    link = run("return window.laboratory.link()")
    if "scene=tower" not in link or "step=12" not in link:
        yield f"a link to the twelfth step of the tower is {link}"
    run("const lab = window.laboratory; lab.text.value = '{\"name\": \"x\", \"dt\": -9}'; lab.sceneChoice.value = 'own'; lab.reload()")
    message = "return window.laboratory.message.textContent"
    WebDriverWait(driver, 30).until(lambda d: "own.json" in d.execute_script(message))
    if "own.json: /dt: expected a number from 1e-06 to 3600 [s], found -9" not in run(message):
        yield f"a mistake in the text is told as {run(message)}"


def hand_faults(driver):
    """A hand that holds the uppermost cube of the tower lifts it."""
    lifted = driver.execute_async_script("""const done = arguments[0], lab = window.laboratory; (async () => {
      lab.sceneChoice.value = 'tower'; await lab.chooseScene(); const lane = lab.lanes[0];
      lane.engine.hold(5, 0, [0, 6, 0]);
      for (let i = 0; i < 80; ++i) await lab.stepOnce();
      const frame = lane.frames.at(-1).positions; done(frame[frame.length - 2]); })();""")
    if not lifted > 4:
        yield f"a pulled cube is at {lifted} m"


def pointer_faults(driver):
    """A click on a mark tells the pair, a drag beside the bodies turns the view, and a drag of a body pulls it."""
    run = driver.execute_script
    tower = "const done = arguments[0], lab = window.laboratory; lab.sceneChoice.value = 'tower'; lab.chooseScene().then(async () => { for (let i = 0; i < 12; ++i) await lab.stepOnce(); done(); })"
    driver.execute_async_script(tower)
    view = driver.find_element(By.CSS_SELECTOR, ".lab-view canvas")
    run("arguments[0].scrollIntoView({block: 'center'})", view)
    place = run(ON_SCREEN, "window.laboratory.lanes[0].frames[window.laboratory.index].pairs.subarray(5, 8)")
    ActionChains(driver).move_to_element_with_offset(view, *place).click().perform()
    if "since step" not in run("return window.laboratory.pairBox.textContent"):
        yield "a click on a mark tells no pair"
    before = run("return window.laboratory.lanes[0].view.looks().eye")
    drag(driver, view, (20, 60), (80, 10))
    if run("return window.laboratory.lanes[0].view.looks().eye") == before:
        yield "the view does not turn when it is dragged"
    place = run(ON_SCREEN, "window.laboratory.lanes[0].frames[window.laboratory.index].positions.slice(-24).reduce((sum, x, i) => { sum[i % 3] += x / 8; return sum; }, [0, 0, 0])")
    run("window.laboratory.pairsShown.click()")
    ActionChains(driver).move_to_element_with_offset(view, *place).click_and_hold().move_by_offset(40, -60).pause(1).perform()
    if run("return window.laboratory.lanes[0].view.grip?.body") != 5 or not run("return window.laboratory.playing"):
        yield "a drag of the uppermost cube does not pull it"
    ActionChains(driver).release().perform()
    if run("return window.laboratory.lanes[0].view.grip"):
        yield "the hand does not let go"
    run("window.laboratory.pairsShown.click(); window.laboratory.play(false)")


def film_faults(driver):
    """A film of some steps is one that a player opens."""
    driver.execute_async_script(PLAY, 8)
    film = driver.execute_async_script(FILM)
    if film.get("type") != "video/webm" or film["head"] != WEBM or film["size"] < 1000:
        yield f"eight steps make the film {film}"


def run_faults(driver, program):
    """A run that a program wrote, of soft, rigid and resting bodies, is shown as it was."""
    run, text = driver.execute_script, lab.text_of("tumble", SPINS)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.json").write_text(text, encoding="utf-8")
        subprocess.run([program.parent / "solvers", "--scene", Path(folder) / "scene.json", "--quick", "--out", folder], check=True, capture_output=True)
        page = run(OPEN_A_RUN, json.loads((Path(folder) / "replay.json").read_text(encoding="utf-8")), STEPS)
    apart = difference(page, native(program, text, LAST))
    print(f"   a run of tumble: {page['count']} frames, {apart:.1e} of its size apart after {STEPS} steps")
    if not apart <= FLOAT:
        yield f"a run of tumble is {apart:.1e} of its size apart from the program; at most {FLOAT:.0e}"
    if f"Step {STEPS}," not in page["state"] or not page["pairs"]:
        yield f"step {STEPS} of a run is told as '{page['state']}', with {page['pairs']} numbers of pairs"
    if not driver.execute_async_script(PLAY_A_RUN) > 3:
        yield "a run does not play"
    if not run("return window.laboratory.solverChoice.disabled"):
        yield "a run offers solvers"
    driver.execute_async_script("const done = arguments[0], lab = window.laboratory; lab.sceneChoice.value = 'tower'; lab.chooseScene().then(done)")
    if run("return window.laboratory.solverChoice.disabled") or "Step 3," not in driver.execute_async_script(PLAY, 3):
        yield "after a run no scene steps"


def faults(page, program):
    """All that is wrong with the laboratory of a page."""
    if program is None or not Path(program).is_file():
        yield f"there is no program {program} to compare with"
        return
    size = lab.compressed_size(page.parent if (page.parent / "lab.js").is_file() else page.parent / "live")
    if size > lab.LARGEST:
        yield f"{size} bytes compressed; at most {lab.LARGEST}"
    driver = browser()
    try:
        for looks in (PHONE, DESKTOP):
            screen(driver, looks)
            if not ready(driver, page):
                yield f"does not start: {driver.execute_script('return document.querySelector(`[data-lab]`).textContent')}"
                return
            width = driver.execute_script("return document.scrollingElement.scrollWidth")
            if width > looks["width"]:
                yield f"{width} px wide on a screen of {looks['width']} px"
            yield from start_faults(driver, looks if looks is PHONE else LARGE)
        yield from use_faults(driver)
        yield from hand_faults(driver)
        yield from pointer_faults(driver)
        yield from film_faults(driver)
        yield from run_faults(driver, program)
        yield from number_faults(driver, program)
        yield from (f"console: {entry['message'][:160]}" for entry in driver.get_log("browser") if entry["level"] == "SEVERE" or
                    entry["level"] == "WARNING" and not any(noise in entry["message"] for noise in KNOWN_NOISE))
    finally:
        driver.quit()
    print(f"   {size / 1e6:.2f} MB compressed")


def speed(page):
    """How long steps take in the browser: the ledger's scenes and the bunny."""
    driver = browser()
    ready(driver, page)
    print("scene, solver: mean ms a step, worst, dt in ms")
    for scene in lab.all_scenes():
        if scene["group"] != "Scenes of the course":
            taken = driver.execute_async_script(RUN, scene["text"], scene["solver"], STEPS)
            print(f"{scene['key']}, {scene['solver']}: " + (taken["error"] if "error" in taken else f"{taken['mean']:.2f}, {taken['worst']:.1f}, {1000 * json.loads(scene['text'])['dt']:g}"), flush=True)
    driver.quit()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--page", type=Path, default=lab.WORK / "index.html")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/laboratory", help="what it is compared with")
    parser.add_argument("--speed", action="store_true", help="measures how long steps take")
    options = parser.parse_args()
    if options.speed:
        speed(options.page.resolve())
        return 0
    found = [f"{options.page.name}: {fault}" for fault in faults(options.page.resolve(), options.program)]
    print("\n".join(found) or "The laboratory is as the program is")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
