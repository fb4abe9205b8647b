"""A run that is exported as glTF: Khronos' own validator finds no mistake in it, and the animation has the run's bodies and its time."""
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/tools")]
import npm  # noqa: E402

PROGRAM = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin/chapter10"
WORK = ROOT / "build/gltf_npm"
# what node runs: the report of the file that is its argument
VALIDATE = """const fs = require("fs"), validator = require("gltf-validator");
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then(report => console.log(JSON.stringify(report)));"""
SCENE = {"name": "all_kinds", "dt": 0.01, "duration": 0.2, "planes": [{"name": "ground"}], "bodies": [
    {"name": "sheet", "type": "static", "shape": {"plane_grid": {"size": [1, 1]}}, "position": [2, 0.1, 0], "motion": {"angular_velocity": [0, 9, 0]}},
    {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.1}}, "density": 500, "position": [0, 0.2, 0]},
    {"name": "door", "type": "rigid", "shape": {"box": {"size": [1, 1, 0.1]}}, "mass": 5, "position": [-2, 1, 0], "angular_velocity": [0, 3, 0],
     "locked": {"about": [0.5, 0, 0], "rotation": ["x", "z"]}},
    {"name": "jelly", "type": "deformable", "shape": {"bar": {"size": [0.2, 0.2, 0.2]}}, "density": 500, "young": 1e4, "poisson": 0.3,
     "basis": "linear", "position": [1, 0.3, 0]}]}


@unittest.skipUnless(PROGRAM.is_file(), "needs chapter 10's program")
class Gltf(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.file = Path(scratch.name) / "run.glb"
        scene = Path(scratch.name) / "all_kinds.json"
        scene.write_text(json.dumps(SCENE))
        done = subprocess.run([PROGRAM, "--scene", scene, "--out", Path(scratch.name) / "out", "--no-pictures", "--gltf", self.file], cwd=ROOT,
                              capture_output=True, text=True, check=False)
        if "TinyGLTF" in done.stderr:
            self.skipTest("the program was built without tinygltf")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_validator_finds_no_error_and_no_warning(self):
        if not (shutil.which("node") and npm.installed(ROOT / "docs/tools/npm/gltf", WORK)):
            self.skipTest("needs node and npm, and for the first time the network")
        done = subprocess.run(["node", "-e", VALIDATE, str(self.file)], env={**os.environ, "NODE_PATH": str(WORK / "node_modules")},
                              capture_output=True, text=True, check=True)
        issues = json.loads(done.stdout)["issues"]
        self.assertEqual((issues["numErrors"], issues["numWarnings"]), (0, 0), issues["messages"])

    def test_the_animation_has_all_bodies_and_the_time_of_the_run(self):
        bytes_of = self.file.read_bytes()
        document = json.loads(bytes_of[20:20 + struct.unpack("<I", bytes_of[12:16])[0]])
        names = {node.get("name") for node in document["nodes"]}
        self.assertLessEqual({body["name"] for body in SCENE["bodies"]}, names)
        ends = [document["accessors"][sampler["input"]]["max"][0] for sampler in document["animations"][0]["samplers"]]
        self.assertAlmostEqual(max(ends), SCENE["duration"], delta=1 / 30)


if __name__ == "__main__":
    unittest.main()
