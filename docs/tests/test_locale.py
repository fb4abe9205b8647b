"""Readers' languages: the scripts name the encoding of each text that they open, and ranges and decimal points do not change with the language."""
import ast
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("docs", "exercises", "examples", "common", "chapters", "live", "cmake", ".ci")
BINARY = {"rb", "wb", "ab", "r+b", "rb+"}


def calls_without_encoding(text):
    """(line, name) of each call that opens a text with the encoding of the reader's language."""
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, ast.Call) or any(word.arg == "encoding" for word in node.keywords):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        owner = getattr(getattr(node.func, "value", None), "id", "")
        constants = {word.value for word in node.args if isinstance(word, ast.Constant)}
        if name in ("read_text", "write_text") or name == "open" and owner not in ("os", "webbrowser", "zipfile", "tarfile", "held", "archive") and not constants & BINARY:
            yield node.lineno, name


class Encodings(unittest.TestCase):
    def test_each_text_is_opened_with_its_encoding(self):
        paths = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py") if "tests" not in path.parts]
        self.assertGreater(len(paths), 30)
        faults = [f"{path.relative_to(ROOT)}:{line}: {name}" for path in paths for line, name in calls_without_encoding(path.read_text(encoding="utf-8"))]
        self.assertEqual(faults, [])

    def test_one_without_is_found(self):
        self.assertEqual(list(calls_without_encoding("p.read_text()\nopen(a, 'rb')\nopen(a, 'w')\np.open(encoding='utf-8')\n")), [(1, "read_text"), (3, "open")])


class TheCommand(unittest.TestCase):
    def groups_told(self, **variables):
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("LC_", "LANG"))}
        done = subprocess.run(["./course", "setup", "x"], cwd=ROOT, env=kept | variables, capture_output=True)
        return done.stderr.decode("utf-8", "replace").splitlines()[0]

    def test_programs_of_it_see_the_readers_letters_and_our_ranges_and_points(self):
        with tempfile.TemporaryDirectory() as folder:
            compiler = Path(folder) / "c++"
            compiler.write_text('#!/bin/bash\ncat >/dev/null\necho "all=${LC_ALL-unset} letters=$LC_CTYPE ranges=$LC_COLLATE numbers=$LC_NUMERIC"\n', encoding="utf-8")
            compiler.chmod(0o755)
            variables = {"PATH": f"{folder}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8", "CXX": "c++"}
            done = subprocess.run(["./course", "doctor"], cwd=ROOT, env=os.environ | variables, stdin=subprocess.DEVNULL, capture_output=True)
        self.assertIn("compiler: all=unset letters=C.UTF-8 ranges=C numbers=C", done.stdout.decode("utf-8", "replace"))

    @unittest.skipUnless(shutil.which("localedef") and Path("/usr/share/i18n/locales/tr_TR").is_file(), "needs Debian's package locales")
    def test_no_group_of_packages_is_lost_in_turkish_or_german(self):
        expected = self.groups_told(LC_ALL="C")
        self.assertIn(" pictures ", expected)
        with tempfile.TemporaryDirectory() as place:
            for name, charmap in (("tr_TR", "UTF-8"), ("de_DE", "UTF-8"), ("de_DE", "ISO-8859-1")):
                with self.subTest(f"{name}.{charmap}"):
                    subprocess.run(["localedef", "-i", name, "-f", charmap, f"{place}/{name}.{charmap}"], check=True, capture_output=True)
                    self.assertEqual(self.groups_told(LC_ALL=f"{name}.{charmap}", LOCPATH=place), expected)


if __name__ == "__main__":
    unittest.main()
