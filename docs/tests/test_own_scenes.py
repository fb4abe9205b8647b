"""The page "Scenes of your own": its listings are lines of the files in examples/scenes, each of which runs; each key stands where it is new."""
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "examples/scenes"
PROGRAM = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin/chapter10"
PAGE = (ROOT / "docs/own_scenes.md").read_text(encoding="utf-8")
STEPS = re.findall(r"^```\n(.*?)^```\n\n.*?--scene examples/scenes/(\w+)\.json", PAGE, re.M | re.S)
TABLE = {name: re.findall(r"`(\w+)`", keys) for name, keys in re.findall(r"^\| `(\w+)` \| (.*) \|$", PAGE, re.M)}


def keys_of(value):
    if isinstance(value, dict):
        return set(value) | set().union(*map(keys_of, value.values()))
    return set().union(*map(keys_of, value)) if isinstance(value, list) else set()


def keys_of_readers():
    readers = "".join(file.read_text(encoding="utf-8") for file in (ROOT / "common/scenes").glob("*.cpp"))
    return {key for call in re.findall(r"require_keys\(\s*\{(.*?)\}\s*\)", readers, re.S) for key in re.findall(r'"(\w+)"', call)}


class OwnScenes(unittest.TestCase):
    def test_each_scene_has_its_step_and_each_listing_stands_in_its_file(self):
        self.assertEqual({name for _, name in STEPS}, {file.stem for file in SCENES.glob("*.json")})
        for listing, name in STEPS:
            with self.subTest(name):
                self.assertIn(listing.rstrip(), (SCENES / f"{name}.json").read_text(encoding="utf-8"))
        self.assertEqual(STEPS[0][0], (SCENES / "ball.json").read_text(encoding="utf-8"))

    def test_the_table_has_each_key_once_at_the_scene_that_shows_it_first(self):
        self.assertEqual(list(TABLE), [name for _, name in STEPS])
        known = set()
        for name, keys in TABLE.items():
            used = keys_of(json.loads((SCENES / f"{name}.json").read_text(encoding="utf-8")))
            with self.subTest(name):
                self.assertEqual(sorted(keys), sorted(used - known))
            known |= used

    def test_every_key_that_a_reader_takes_stands_once_in_the_tables_of_this_page(self):
        others = PAGE.split("| In | Keys |")[1]
        named = [key for keys in TABLE.values() for key in keys]
        named += [key for keys in re.findall(r"^\| [^|]* \| (`.*) \|$", others, re.M) for key in re.findall(r"`(\w+)`", keys)]
        self.assertEqual(sorted(named), sorted(keys_of_readers()))

    def test_every_key_that_a_reader_takes_stands_on_the_page_of_the_format(self):
        page = (ROOT / "common/scenes/scene_format.md").read_text(encoding="utf-8")
        keys = keys_of_readers()
        self.assertGreater(len(keys), 80)
        self.assertEqual([key for key in sorted(keys) if not re.search(rf'[`"]{key}[`"]', page)], [])

    @unittest.skipUnless(PROGRAM.is_file(), "needs chapter 10's program")
    def test_each_scene_runs_to_its_end_without_a_warning(self):
        with tempfile.TemporaryDirectory() as folder:
            for _, name in STEPS:
                with self.subTest(name):
                    done = subprocess.run([PROGRAM, "--scene", SCENES / f"{name}.json", "--out", folder, "--quick", "--no-pictures"],
                                          cwd=ROOT, capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertIn("200 steps of 0.01 s", done.stdout)
                    self.assertNotRegex(done.stderr, "warning: (?!empty y range)")


if __name__ == "__main__":
    unittest.main()
