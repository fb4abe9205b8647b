"""The exercises in the page: what is packed for them, and their words against those of the terminal."""
import contextlib
import dataclasses
import io
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/tools")]
import editor  # noqa: E402
import student  # noqa: E402
from judge import Failure, Outcome  # noqa: E402

NODE = shutil.which("node") or shutil.which("nodejs")
TELL = """import { told, compiler_errors, linker_errors, diagnosis } from "./judge.mjs";
import { readFileSync } from "node:fs";
const { exercise, outcome, alike, compiler, linker } = JSON.parse(readFileSync(0, "utf8"));
console.log(JSON.stringify([told(exercise, outcome), compiler_errors(compiler, exercise, "one\\n  two;\\n"), linker_errors(linker), await diagnosis(exercise, outcome, () => alike)]));"""
COMPILER = """In file included from answer.cpp:1:
/usr/headers/Eigen/Core:7:3: error: static assertion failed [-Wx]
answer.cpp:2:3: note: in instantiation of this
answer.cpp:2:7: warning: unused
answer.cpp:2:6: error: expected ';'
1 error generated."""


class Packed(unittest.TestCase):
    def test_an_archive_has_its_folders_without_a_slash_and_before_what_is_in_them(self):
        data = editor.archive({"a/b/c.hpp": b"x" * 600, "d.o": b""})
        names, at = [], 0
        while name := data[at:at + 100].rstrip(b"\0").decode():
            names.append(name)
            at += 512 + -(-int(data[at + 124:at + 135], 8) // 512) * 512
        self.assertEqual(names, ["a", "a/b", "a/b/c.hpp", "d.o"])

    def test_a_header_includes_by_paths_from_the_root(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "Eigen/src/Core/Block.h"
            path.parent.mkdir(parents=True)
            path.write_text('#  include "../plugins/Ops.h"\n#include "./Other.h"\n')
            self.assertEqual(editor.header(path, Path(folder)), b'#  include "Eigen/src/plugins/Ops.h"\n#include "./Other.h"\n')

    def test_each_exercise_of_the_course_is_offered_with_its_wrong_answers(self):
        exercises = editor.offered()
        self.assertEqual({str(exercise.published_check.relative_to(ROOT)) for exercise in exercises}, {str(path.relative_to(ROOT)) for path in ROOT.glob("exercises/*/*.check.cpp") if not path.name.startswith("9")})
        for exercise in exercises:
            entry = editor.entry_of(exercise)
            self.assertTrue((ROOT / entry["check"]).is_file())
            self.assertEqual((entry["properties"] > 0, len(entry["mutants"])), (True, len(exercise.mutants)))

    def test_no_check_takes_random_inputs_that_another_library_makes_otherwise(self):
        for exercise in editor.offered():
            self.assertNotRegex(exercise.published_check.read_text(encoding="utf-8"), r"#include <random>|std::shuffle|_distribution", exercise.number)

    def test_no_exercise_reads_a_file(self):
        for path in [*ROOT.glob("exercises/*/*.hpp"), *ROOT.glob("exercises/*/*.cpp")]:
            self.assertNotRegex(path.read_text(encoding="utf-8"), r"\b(load_scene|scene_file|ifstream)\(", path.name)

    def test_the_headers_are_those_of_the_terminals_answers(self):
        self.assertEqual([line for line in editor.precompiled().splitlines() if line.split()[1] in ('"live/charconv_of_doubles.hpp"', "<vector>", "<Eigen/Dense>")],
                         ['#include "live/charconv_of_doubles.hpp"', "#include <vector>", "#include <Eigen/Dense>"])


@unittest.skipUnless(NODE, "needs node")
class Words(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.exercise = dataclasses.replace(editor.offered()[0], mutants=editor.offered()[0].mutants[:1])
        cls.exercise.mutants[0].fails = ["a", "b"]
        failures = [Failure("a", ["depth 1 m\nk 2"], "impulse: expected 1.25 N s, got 2.75 N s"), Failure("b", [], "expected x == 1, got 2 == 1"), Failure("a", [], "more"),
                    Failure("c", [], "threw an exception: out of range"), Failure("d", [], "this should hold: it is"), Failure("e", [], "no")]
        cls.outcome = Outcome("failed", cases=9, failures=failures)
        cls.alike = Outcome("failed", cases=9, failures=failures[:2])
        with tempfile.TemporaryDirectory() as folder:
            shutil.copyfile(ROOT / "live/editor/judge.js", Path(folder) / "judge.mjs")
            (Path(folder) / "tell.mjs").write_text(TELL)
            given = {"exercise": editor.entry_of(cls.exercise), "outcome": cls.for_page(cls.outcome), "alike": cls.for_page(cls.alike), "compiler": COMPILER,
                     "linker": "wasm-ld: error: answer.o: undefined symbol: enduring::f(double)\nwasm-ld: error: check.o: undefined symbol: enduring::f(double)"}
            done = subprocess.run([NODE, Path(folder) / "tell.mjs"], input=json.dumps(given), capture_output=True, text=True, check=True)
        cls.told, cls.compiler, cls.linker, cls.diagnosis = json.loads(done.stdout)

    @staticmethod
    def for_page(outcome):
        return {"state": outcome.state, "cases": outcome.cases, "failures": [{"name": one.case, "given": one.given, "message": one.message} for one in outcome.failures]}

    def test_a_verdict_is_that_of_the_terminal(self):
        key = self.exercise.check, self.exercise.mutants[0].name
        student.JUDGED_MUTANTS[key] = self.alike
        with contextlib.redirect_stdout(io.StringIO()) as shown, mock.patch.object(student, "file_of", return_value="none"):
            student.tell_wrong(self.exercise, self.outcome)
        del student.JUDGED_MUTANTS[key]
        verdict = shown.getvalue().strip().partition("\n\nPerhaps: ")[0]
        self.assertEqual(self.told, verdict)
        self.assertEqual(self.diagnosis.split(), ["Perhaps:", *shown.getvalue().partition("Perhaps: ")[2].partition("\n\nYour file")[0].split()])

    def test_a_compilers_error_stands_at_its_line_of_the_answer(self):
        file = editor.entry_of(self.exercise)["file"]
        self.assertEqual(self.compiler, f"{file}:2: static assertion failed\n      two;\n      ^\n{file}:2: expected ';'\n      two;\n         ^")

    def test_what_the_linker_misses_is_told_once(self):
        self.assertEqual(self.linker, "Your file should define enduring::f(double); its name, its arguments or its namespace differ.")


if __name__ == "__main__":
    unittest.main()
