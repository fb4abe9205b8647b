"""The wheel, installed into a fresh virtual environment, runs a scene outside of the repository. Run by ./course python."""
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PYTHON = Path(__file__).resolve().parent
SCRIPT = """import enduring
scene = enduring.Scene(dt=0.005)
scene.add_plane("ground")
vertices, faces = enduring.sphere(0.25)
ball = scene.add_rigid("ball", vertices + [0, 1, 0], faces)
scene.step(50)
print(enduring.__file__)
print(ball.pose[0][1] - 1 + 9.81 * 0.005**2 * 50 * 51 / 2)
"""


@unittest.skipUnless(importlib.util.find_spec("build") and importlib.util.find_spec("ensurepip"), "needs python3-build and python3-venv")
class Wheel(unittest.TestCase):
    def run_in(self, folder, *words):
        without = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        done = subprocess.run([str(word) for word in words], cwd=folder, env=without, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_it_is_installed_with_its_types_and_runs(self):
        with tempfile.TemporaryDirectory() as held:
            folder = Path(held)
            self.run_in(folder, sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, PYTHON)
            wheel, = folder.glob("enduring_contacts-*.whl")
            self.run_in(folder, sys.executable, "-m", "venv", "--system-site-packages", "venv")  # NumPy is the system's
            own = folder / "venv/bin/python"
            self.run_in(folder, own, "-m", "pip", "install", "--no-index", "--no-deps", wheel)
            (folder / "script.py").write_text(SCRIPT, encoding="utf-8")
            place, error = self.run_in(folder, own, "script.py").split()
            self.assertTrue(Path(place).resolve().is_relative_to(folder.resolve()), place)
            self.assertAlmostEqual(float(error), 0, 12)
            self.assertTrue(Path(place).with_name("enduring-stubs").joinpath("__init__.pyi").is_file())


if __name__ == "__main__":
    unittest.main()
