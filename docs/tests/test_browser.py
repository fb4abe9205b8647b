"""The browser test, shown a page with every fault that it looks for, and one without."""
import subprocess
import tempfile
import unittest
from pathlib import Path

TEST = Path(__file__).resolve().parents[1] / "tools/browser_test.py"
PYTHON = "/usr/bin/python3"  # Debian's, which has Debian's selenium
GOOD = """<!DOCTYPE html><html lang="en"><head><meta name="viewport" content="width=device-width, initial-scale=1"></head>
<body style="background: #fff; color: #000"><p>%s</p></body></html>"""
FAULTS = {
    "console": ("<script>throw new Error('oops')</script>", "console: "),
    "raw": ("the depth \\(\\delta\\)", "left raw: the depth"),
    "formula": ("<script type='math/tex'>x</script>", "1 of 1 formulas are not typeset"),
    "picture": ("<img src='gone.png'>", "a picture is missing: gone.png"),
    "pale": ("<span style='color: #bbb'>pale</span>", 'contrast 1.9'),
    "wide": ("<div style='width: 900px'>wide</div>", "px wide on a phone"),
    "dead": ("<div data-live='x' data-figure='x'></div>", "the live figure x does not start"),
    "deaf": ("<div data-live='ready' data-figure='x' data-answer='a'><canvas></canvas><label>k<input type='range'></label></div>", "the live figure x does not answer to k"),
}


def possible():
    return Path(PYTHON).is_file() and not subprocess.run([PYTHON, "-c", "import selenium"], capture_output=True).returncode


@unittest.skipUnless(possible(), "needs python3-selenium")
class TheBrowserTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as book:
            (Path(book) / "good.html").write_text(GOOD % "fine")
            for name, (body, _) in FAULTS.items():
                (Path(book) / f"{name}.html").write_text(GOOD % body)
            cls.done = subprocess.run([PYTHON, TEST, "--book", book], capture_output=True, text=True)

    def test_each_fault_is_told_with_its_page(self):
        for name, (_, told) in FAULTS.items():
            with self.subTest(name):
                self.assertRegex(self.done.stdout, f"(?m)^{name}.html: .*{told}")

    def test_a_page_without_a_fault_is_not_named(self):
        self.assertNotIn("good.html: ", self.done.stdout.split("pieces of text")[0])

    def test_faults_are_an_exit_status(self):
        self.assertEqual(self.done.returncode, 1)

    def test_a_browser_that_does_not_start_is_told_at_once(self):
        with tempfile.TemporaryDirectory() as book:
            (Path(book) / "good.html").write_text(GOOD % "fine")
            done = subprocess.run([PYTHON, TEST, "--book", book], capture_output=True, text=True, env={"PATH": book})
        self.assertEqual(done.returncode, 1)
        self.assertIn("The browser does not start: ", done.stderr)


if __name__ == "__main__":
    unittest.main()
