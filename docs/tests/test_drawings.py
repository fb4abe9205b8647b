"""The schematic drawings: each is drawn as it is kept, is shown on a page, and reads on light and on dark pages."""
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "renders/drawings"
PYTHON = "/usr/bin/python3"  # has Debian's Matplotlib


def matplotlib():
    return not subprocess.run([PYTHON, "-c", "import matplotlib"], capture_output=True).returncode


class Drawings(unittest.TestCase):
    def test_each_is_shown_on_a_page(self):
        pages = "".join(page.read_text(encoding="utf-8") for page in ROOT.glob("chapters/*/chapter.md"))
        self.assertEqual(sorted(set(re.findall(r"@figure\{drawings/(\w+)\.svg", pages))), sorted(path.stem for path in KEPT.glob("*.svg")))

    def test_none_has_a_background_or_ink_in_black(self):
        for path in KEPT.glob("*.svg"):
            svg = path.read_text(encoding="utf-8")
            self.assertIn('<g id="patch_1">\n   <path d="M', svg, path.name)
            self.assertIn('style="fill: none"', svg.split('<g id="patch_1">')[1].split("</g>")[0], path.name)
            self.assertNotIn("#000000", svg, path.name)

    @unittest.skipUnless(matplotlib(), "needs python3-matplotlib")
    def test_the_program_draws_those_that_are_kept(self):
        with tempfile.TemporaryDirectory() as held:
            subprocess.run([PYTHON, ROOT / "docs/tools/drawings.py", held], check=True)
            words = lambda folder: {path.name: re.findall(r"<!-- (.+) -->", path.read_text(encoding="utf-8")) for path in Path(folder).glob("*.svg")}
            self.assertEqual(words(held), words(KEPT))


if __name__ == "__main__":
    unittest.main()
