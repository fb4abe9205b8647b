"""The course in a folder whose name has a space and an umlaut: what the build's commands make of it."""
import os
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OBJECT = "CMakeFiles/exercise_01_1.dir/exercises/01_particle_plane/1_continuous_push.cpp.o"


class FolderWithASpace(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.clone = Path(scratch.name) / "Übung 1"
        for part in ("CMakeLists.txt", "CMakePresets.json", "cmake", "chapters", "common", "exercises", "examples", "docs"):
            (shutil.copytree if (ROOT / part).is_dir() else self.copy)(ROOT / part, self.clone / part)
        self.build = self.clone / "build/release"

    @staticmethod
    def copy(source, place):
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, place)

    def said(self, *command, **options):
        done = subprocess.run(command, cwd=self.clone, capture_output=True, text=True, **options)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
        return done.stdout

    def test_an_answer_and_its_check_find_their_headers_there(self):
        environment = os.environ | {"LC_ALL": "C"}
        self.said("cmake", "--preset", "release", "-B", str(self.build), env=environment)
        words = shlex.split(self.said("ninja", "-C", str(self.build), "-t", "commands", "-s", OBJECT))
        self.assertIn(str(self.clone / "exercises/01_particle_plane"), words)
        self.assertIn(str(self.clone / "chapters/01_particle_plane"), words)
        self.assertIn(f"-I{self.clone}", words)
        for word in words:  # no path is cut at its space
            self.assertFalse(word.startswith("1/") or word.endswith("/Übung"), word)


if __name__ == "__main__":
    unittest.main()
