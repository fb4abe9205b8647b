"""The stubs of `enduring` say what the module has: mypy's stubtest. Run by ./course python; the module's folder is on PYTHONPATH."""
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PYTHON = Path(__file__).resolve().parent
# pybind11's classes have a metaclass of their own, and a constructor also where nothing can be constructed.
ALLOWED = "enduring\\.(Body|Pairs|Scene)\nenduring\\.(Body|Pairs)\\.__init__\n"
RIGHT = """import enduring
scene = enduring.Scene(dt=0.01, chapter=7)
body: enduring.Body = scene.add_rigid("box", *enduring.box([1, 1, 1]))
height: float = float(body.positions[:, 1].min())
"""


@unittest.skipUnless(importlib.util.find_spec("mypy"), "needs mypy")
class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        held = tempfile.TemporaryDirectory()
        cls.addClassCleanup(held.cleanup)
        cls.folder = Path(held.name)  # with mypy's cache, too

    def mypy(self, *words):
        done = subprocess.run([sys.executable, "-m", *words], cwd=self.folder, env=os.environ | {"MYPYPATH": str(PYTHON)}, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def test_every_name_of_the_module_has_a_type_that_fits_and_no_other_has(self):
        (self.folder / "allowed").write_text(ALLOWED, encoding="utf-8")
        code, said = self.mypy("mypy.stubtest", "enduring", "--allowlist", "allowed", "--ignore-unused-allowlist")
        self.assertEqual(code, 0, said)

    def test_a_mistake_is_found_before_the_script_runs(self):
        for text, code in ((RIGHT, 0), (RIGHT.replace("add_rigid", "add_rigd"), 1), (RIGHT.replace("dt=0.01", "dt='fast'"), 1)):
            (self.folder / "script.py").write_text(text, encoding="utf-8")
            got, said = self.mypy("mypy", "--strict", "script.py")
            self.assertEqual(got, code, said)


if __name__ == "__main__":
    unittest.main()
