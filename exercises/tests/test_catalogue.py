"""The catalogue: what it reads, what the stub keeps and drops, and what it refuses."""
import atexit
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import catalogue  # noqa: E402

SOURCE = """#include "fall.hpp"

namespace enduring {

// [speed]
double speed(double t)
{
    // Galileo's law.
    return 9.81 * t;
}
// [speed]

template <class Number>
Number height(Number t,
              Number g)
{
    if (t < 0) {
        return 0;
    }
    return g * t * t / 2;
}

double kept() { return 1; }

}  // namespace enduring
"""

ENTRY = """
title = "Fall"
kind = "extend"
minutes = 10
difficulty = 1
goal = "Fall."
text = "Write it."
hints = ["a", "b", "c"]
expected = "4.9 m"
missing = ["speed", "height"]
"""

MUTANT = """
[[mutant]]
name = "no_half"
replace = "/ 2"
by = ""
fails = ["fall: half"]
diagnosis = "The half is missing."
"""


class Folder:
    """A course with one exercise, in the place of the real one."""

    def __init__(self, entry=ENTRY, mutants=MUTANT, source=SOURCE):
        self.root = Path(tempfile.mkdtemp())
        atexit.register(shutil.rmtree, self.root)
        self.write("exercises/01_fall/2_fall.toml", entry)
        self.write("solutions/01_fall/2_fall.toml", mutants)
        self.write("solutions/01_fall/2_fall.cpp", source)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def read(self):
        with mock.patch.object(catalogue, "ROOT", self.root):
            return catalogue.all_exercises(self.root)

    def stub(self):
        exercise = self.read()[0]
        return exercise.stub_text()


class TheCatalogue(unittest.TestCase):
    def test_an_exercise_has_its_number_from_its_place(self):
        exercise, = Folder().read()
        self.assertEqual((exercise.number, exercise.target, exercise.mutants[0].name), ("1.2", "01_2", "no_half"))

    def test_the_stub_keeps_all_but_the_missing_bodies(self):
        stub = Folder().stub()
        self.assertEqual(stub.count('not_implemented_yet("1.2");'), 2)
        self.assertIn("double kept() { return 1; }", stub)
        self.assertIn("template <class Number>\nNumber height(Number t,\n              Number g)\n{\n    not_implemented", stub)
        for gone in ("9.81", "Galileo", "g * t", "[speed]"):
            self.assertNotIn(gone, stub)

    def test_lines_are_counted_without_the_braces_at_the_margin(self):
        self.assertEqual(Folder().read()[0].missing_lines(), 6)

    def test_the_solution_shown_is_the_missing_functions(self):
        first, second = Folder().read()[0].missing_functions()
        self.assertTrue(first.startswith("double speed") and second.startswith("template"))

    def test_a_mutant_is_the_source_with_one_text_replaced(self):
        exercise, = Folder().read()
        self.assertIn("return g * t * t ;", exercise.mutated(exercise.mutants[0]))

    def refused(self, message, **parts):
        with self.assertRaisesRegex(catalogue.CatalogueError, message):
            exercise, = Folder(**parts).read()
            exercise.stub_text()
            exercise.mutated(exercise.mutants[0])

    def test_what_is_wrong_is_named_with_its_file(self):
        self.refused("2_fall.toml: needs goal", entry=ENTRY.replace('goal = "Fall."', ""))
        self.refused("2_fall.toml: needs minutes, a whole number", entry=ENTRY.replace("10", '"ten"'))
        self.refused("2_fall.toml: unknown: minuets", entry=ENTRY + "minuets = 3\n")
        self.refused("three hints", entry=ENTRY.replace(', "c"', ""))
        self.refused("kind is extended", entry=ENTRY.replace('"extend"', '"extended"'))
        self.refused("needs source", entry=ENTRY.replace('"extend"', '"rebuild"'))
        self.refused("2_fall.cpp: no function fly", entry=ENTRY.replace('"speed"', '"fly"'))
        self.refused("2_fall.cpp: mutant no_half: its text stands there 0 times", source=SOURCE.replace("/ 2", "* 0.5"))
        self.refused("2_fall.toml: mutant no_half: needs just .*diagnosis", mutants=MUTANT.replace("diagnosis", "diagnose"))


if __name__ == "__main__":
    unittest.main()
