"""The laboratory's menu, its links, and what it reads of the course."""
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/tools")]
import lab  # noqa: E402

MODULE = ROOT / "build/live/lab.js"
NODE = shutil.which("node") or shutil.which("nodejs")
STEP_ALL = """
const given = JSON.parse(require('fs').readFileSync(0, 'utf8'));
require(MODULE)().then(lab => {
  for (const [name, text] of Object.entries(given.meshes)) lab.add_mesh(name, text);
  const told = given.scenes.map(({ key, text, solver }) => [key, lab.load(text, `${key}.json`, String(solver)).error ?? lab.advance(1).error ?? 'steps']);
  told.push(['broken', lab.load('{"name": "x", "dt": -9, "duration": 1, "bodies": []}', 'own.json', '10').error]);
  for (const [solver] of given.solvers)
    told.push([solver, lab.load(given.scenes.find(({ key }) => key === 'tower').text, 'tower.json', solver).error ?? lab.advance(1).error ?? 'steps']);
  console.log(JSON.stringify(told));
});"""
LINKS = """import { readLink, writeLink } from LINK;
const view = { eye: [1.25, -2, 3e-7], target: [0, 0.5, 0] };
const own = { scene: 'own', solver: 7, beside: 'xpbd', step: 40, view, text: '{"name": "Würfel ÷ &=#"}' };
console.log(JSON.stringify([readLink(writeLink(own)), readLink('scene=tower&eye=1,2&text=%%%'), writeLink(own)]));"""
TOLD = """import { stateOf } from TOLD;
const lane = (title, numbers, pairs) => ({ title: { textContent: title }, frames: [{ numbers: { step: 3, time: 0.03, ...numbers }, pairs: new Float64Array(24 * pairs) }] });
const springs = lane('chapter 10', { pairs: 4, thrown_away: 2, work: { rounds: 1, newton_steps: 5 } }, 6), sweeps = lane('XPBD', { pairs: 0, work: { responses: 1 } }, 0);
console.log(JSON.stringify([stateOf([springs], 0), stateOf([springs, sweeps], 0)]));"""
AXES = """import { axisOf } from AXIS;
const log = (...series) => { const axis = axisOf(series, { logarithmic: true }); return [axis.ends, series.map(values => axis.of(values.at(-1)))]; };
console.log(JSON.stringify([log([0, 1e-15, 5e-3, 2e-4]), log([2e-10, 3e-12, 1e-13], [2e-5, 2e-6, 2e-6]), log([0, 0]), axisOf([[0, 3]], { from: 0 }).ends, axisOf([[7], [9, undefined]]).ends,
  axisOf([[0, 0]], { from: 0 }).ends, axisOf([[4e-6, 100]]).ends, axisOf([[5, 5]]).ends]));"""


class Menu(unittest.TestCase):
    def test_it_has_every_row_of_the_failure_ledger(self):
        rows = re.findall(r"Bound::at_(?:most|least)", (ROOT / "chapters/motivating_scenes/motivating_scenes.cpp").read_text(encoding="utf-8"))
        self.assertEqual(len(list(lab.ledger_scenes())), len(rows))

    def test_a_row_begins_with_the_first_solver_that_passes_and_the_last_one_that_fails(self):
        rows = {row["key"]: row for row in lab.ledger_scenes()}
        self.assertEqual([(rows[f"ledger_{name}"]["solver"], rows[f"ledger_{name}"]["beside"]) for name in ("ground", "hooked", "deep", "folded", "double_pendulum")],
                         [(1, 0), (6, 5), (7, 6), (10, 9), (12, 0)])

    def test_it_offers_every_chapter_that_has_one_solver_and_every_method_by_the_name_that_programs_take(self):
        offered = dict(lab.solvers())
        last = re.search(r"last_chapter = (\d+)", (ROOT / "chapters/solvers/chapter_solver.hpp").read_text(encoding="utf-8"))[1]
        methods = re.findall(r'`"(\w+)"`', (ROOT / "live/npm/README.md").read_text(encoding="utf-8"))
        self.assertEqual(list(offered), [str(number) for number in range(1, int(last) + 1)] + methods)
        self.assertEqual((offered["8"], offered["xpbd"]), ("8: Contact by distance", "13: XPBD"))

    def test_no_two_scenes_share_a_key_and_each_mesh_is_there(self):
        scenes = list(lab.all_scenes())
        self.assertEqual(len({scene["key"] for scene in scenes}), len(scenes))
        self.assertEqual({name for scene in scenes for name in re.findall(r'"file": "([^"]+)"', scene["text"])}, set(lab.meshes()))

    def test_ten_scenes_stand_first_each_with_a_picture_and_what_to_look_at(self):
        first = lab.data()["scenes"][:10]
        self.assertEqual({scene["group"] for scene in first}, {"To begin with"})
        for scene in first:
            self.assertTrue(scene["look"].endswith((".", "?")), scene["key"])
            self.assertTrue(scene["thumbnail"].startswith("data:image/webp;base64,UklGR"), scene["key"])
            self.assertTrue(json.loads(scene["text"]).get("planes") or scene["key"] == "cradle", scene["key"])

    def test_a_change_leads_into_lists_by_name_merges_objects_and_removes_by_null(self):
        scene = {"bodies": [{"name": "a", "shape": {"file": "x", "scale": 2}}], "dt": 1, "old": 2}
        self.assertEqual(lab.changed(scene, {"/bodies/a/shape": {"file": "y"}, "dt": 3, "old": None}), {"bodies": [{"name": "a", "shape": {"file": "y", "scale": 2}}], "dt": 3})

    def test_a_scene_of_ones_own_brings_the_meshes_beside_it(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "my.json").write_text('{"shape": {"file": "part.obj"}, "other": {"file": "bunny_363.msh"}}')
            (Path(folder) / "part.obj").write_text("v 0 0 0\n")
            scene, meshes = lab.own_scene(Path(folder) / "my.json")
        self.assertEqual((scene["title"], meshes), ("my.json", {"part.obj": "v 0 0 0\n"}))

    def test_a_run_is_told_from_a_scene_and_from_what_is_broken(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "some.json"
            for text, is_run in (('{"replay": 1, "frames": []}', True), ('{"name": "scene"}', False), ("{", False), ("[1]", False)):
                path.write_text(text)
                self.assertEqual("run" in lab.data(path), is_run, text)


def said(calls, word, script):
    """What a few lines say that import one of the laboratory's scripts."""
    with tempfile.TemporaryDirectory() as folder:
        for path in (ROOT / "live/lab").glob("*.js"):
            shutil.copy(path, folder)
        (Path(folder) / "package.json").write_text('{"type": "module"}')
        program = Path(folder) / "test.mjs"
        program.write_text(calls.replace(word, json.dumps((Path(folder) / f"{script}.js").as_uri())))
        return json.loads(subprocess.run([NODE, program], capture_output=True, text=True, check=True).stdout)


@unittest.skipUnless(NODE, "needs node")
class Scripts(unittest.TestCase):
    def test_a_link_holds_what_was_written_and_leaves_out_what_cannot_be_read(self):
        read, cut, written = said(LINKS, "LINK", "link")
        self.assertEqual(read, {"scene": "own", "solver": 7, "beside": "xpbd", "step": 40, "text": '{"name": "Würfel ÷ &=#"}', "view": {"eye": [1.25, -2, 3e-7], "target": [0, 0.5, 0]}})
        self.assertEqual((cut["scene"], cut["view"], cut["text"]), ("tower", None, None))
        self.assertRegex(written, r"^[\w.,=&-]+$")

    def test_the_line_of_state_has_pairs_and_work_of_each_solver_in_counted_words(self):
        alone, both = said(TOLD, "TOLD", "told")
        springs = "4 of 6 pairs push; 1 round with 5 Newton steps, 2 halved so far"
        self.assertEqual(alone, f"Step 3, 0.030 s. {springs}.")
        self.assertEqual(both, f"Step 3, 0.030 s. chapter 10: {springs}. XPBD: 0 of 0 pairs push; 1 response.")

    def test_an_axis_of_depths_begins_at_ten_nanometres_or_below_the_curve_of_exact_contact(self):
        springs, exact, nothing, steps, energy, *ends = said(AXES, "AXIS", "axis")
        for (low, high), wanted in ((springs[0], (1e-8, 1e-2)), (exact[0], (1e-13, 1e-4)), (nothing[0], (1e-8, 1e-3))):
            self.assertAlmostEqual(low / wanted[0], 1)
            self.assertAlmostEqual(high / wanted[1], 1)
        self.assertTrue(all(0 <= part <= 1 for part in springs[1] + exact[1]), (springs, exact))
        self.assertEqual((nothing[1], steps, energy, ends), ([None], [0, 3], [7, 9], [[0, 1], [0, 100], [4.5, 5.5]]))


@unittest.skipUnless(NODE and MODULE.is_file(), "needs node and the compiled laboratory (./course docs --live)")
class Module(unittest.TestCase):
    def test_every_scene_of_the_menu_steps_under_its_solver_and_a_mistake_is_told_with_its_place(self):
        done = subprocess.run([NODE, "-e", STEP_ALL.replace("MODULE", json.dumps(str(MODULE)))], input=json.dumps(lab.data()), capture_output=True, text=True, check=True)
        told = dict(json.loads(done.stdout))
        self.assertIn("own.json: /dt: expected a number from 1e-06 to 3600 [s], found -9", told.pop("broken"))
        self.assertIn("barrier", told)
        self.assertIn("12", told)
        self.assertEqual(set(told.values()), {"steps"}, told)


if __name__ == "__main__":
    unittest.main()
