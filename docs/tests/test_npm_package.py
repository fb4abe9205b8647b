"""The package for npm: installed from its file into an empty project, it steps a scene, and tells a mistake with its place."""
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/tools")]
import npm_package  # noqa: E402

MODULE = ROOT / "build/live/lab.js"
PROGRAM = """import { Simulation } from "enduring-contacts";
const cube = { name: "cube", type: "rigid", shape: { box: { size: [1, 1, 1] } }, mass: 2, position: [0, 1.5, 0] };
const scene = { name: "drop", dt: 0.01, duration: 1, planes: [{ name: "ground" }], bodies: [cube] };
const simulation = await Simulation.create(scene);
simulation.step(20);
const falls = Math.min(...simulation.positions.filter((_, i) => i % 3 === 1));
while (simulation.time < 2) simulation.step();
const rests = Math.min(...simulation.positions.filter((_, i) => i % 3 === 1)), carried = simulation.pairs.reduce((sum, pair) => sum + pair.impulse[1], 0);
const mistake = await Simulation.create({ ...scene, dt: 0 }).catch(error => error.message), steps = (() => { try { simulation.step(0); } catch (error) { return error.message; } })();
console.log(JSON.stringify({ time: simulation.time, falls, rests, carried, mistake, steps, vertices: simulation.scene.bodies[0].vertices }));
"""


class Package(unittest.TestCase):
    def test_its_version_has_three_numbers(self):
        self.assertRegex(npm_package.version(), r"^\d+\.\d+\.\d+$")

    def test_what_it_says_to_hold_is_there(self):
        files = json.loads((ROOT / "live/npm/package.json").read_text(encoding="utf-8"))["files"]
        self.assertEqual([name for name in files if name != "solver.cjs" and not (ROOT / "live/npm" / name).is_file()], [])

    @unittest.skipUnless(MODULE.is_file() and shutil.which("npm") and shutil.which("node"), "needs npm and the compiled laboratory (./course docs --live)")
    def test_installed_from_its_file_it_steps_a_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            made = npm_package.pack(MODULE, Path(folder) / "work")
            project = Path(folder) / "project"
            project.mkdir()
            (project / "package.json").write_text('{"name": "project", "version": "1.0.0", "type": "module"}')
            subprocess.run(["npm", "install", "--offline", "--no-audit", "--no-fund", "--silent", str(made)], cwd=project, check=True)
            (project / "main.js").write_text(PROGRAM)
            told = json.loads(subprocess.run(["node", "main.js"], cwd=project, capture_output=True, text=True, check=True).stdout)
        self.assertAlmostEqual(told["falls"], 1 - 9.81 * 0.01**2 * 20 * 21 / 2, 6)  # free fall, step by step
        self.assertAlmostEqual(told["rests"], 0, delta=1e-3)
        self.assertAlmostEqual(told["carried"], 2 * 9.81 * 0.01, delta=1e-4)        # its weight, times a step
        self.assertIn("scene.json: /dt: expected a number from 1e-06 to 3600 [s], found 0", told["mistake"])
        self.assertIn("from 1 on, found 0", told["steps"])


if __name__ == "__main__":
    unittest.main()
