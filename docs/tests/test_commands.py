"""Every command line that stands in a page, in README.md or in CONTRIBUTING.md can be typed: its words and options are known."""
import os
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin"
sys.path[:0] = [str(ROOT / "docs/tools"), str(ROOT / "exercises")]
import checks  # noqa: E402
import course_exercises  # noqa: E402
import editor  # noqa: E402
import weave  # noqa: E402

EXERCISES = course_exercises.all_exercises()
WITH_EXAMS = course_exercises.every_exercise()
FOR_TEACHERS = {"exercise", "solution", "prove", "grade"}  # commands that know the exercises for exams
COMMAND = re.compile(r"`\./course\b([^`]*)`|^ *\./course\b(.*)$", re.M)
SHAPES = {"[N]": "1"}  # what stands for a number; capitals stand for a file or a folder, and are as good as any name


def command_lines(text):
    """The words behind ./course of each command line in a text; a line may break within one."""
    for quoted, line in COMMAND.findall(text):
        yield tuple(SHAPES.get(word, word) for word in shlex.split(quoted or line, comments=True))


def in_all_pages():
    """{words: where they stand first}"""
    texts = {page.path: "\n".join(page.lines) for page in weave.all_pages(ROOT)}
    texts |= {path: path.read_text(encoding="utf-8") for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md")}
    found = {}
    for path, text in texts.items():
        for words in command_lines(text):
            found.setdefault(words, path.relative_to(ROOT).as_posix())
    return found


def program_of(word):
    return next(PROGRAMS / checks.program_of(path.name) for path in [ROOT / "chapters/00_base", *sorted((ROOT / "chapters").iterdir())]
                if checks.word_of(path.name) == word)


def refusal(words):
    """Why a command line cannot be typed; "" when it can."""
    command, rest = (words[0] if words else "help"), list(words[1:])
    if command == "compare":
        return "" if len(rest) in (1, 2) else "compare takes one or two folders"
    if command == "prove" and "--page" in rest:  # the exercises that the pages offer
        return "" if {word for word in rest if word != "--page"} <= {exercise.number for exercise in editor.offered()} else "not in a page"
    if command in ("check", "exercise", "hint", "solution", "update", "prove", "grade", "handout"):
        return refusal_of_exercises(words)
    done = subprocess.run(["./course", *words], cwd=ROOT, env=os.environ | {"ENDURING_ONLY_READ": "yes"}, capture_output=True, text=True)
    if done.returncode or command != "run" or not rest or rest[0].startswith("-"):
        return done.stderr
    program = program_of(rest[0])
    if not program.is_file():
        return ""
    passed = [word for word in rest[1:] if word != "--"]
    return subprocess.run([program, *passed, "--list"], capture_output=True, text=True).stderr if "--help" not in passed else ""


def refusal_of_exercises(words):
    with mock.patch.object(sys, "argv", ["course", *words]), mock.patch("sys.stderr"):
        try:
            options = course_exercises.arguments()
            number = getattr(options, "number", None)
            if not getattr(options, "layers", False):
                course_exercises.all_chosen(WITH_EXAMS if words[0] in FOR_TEACHERS else EXERCISES, getattr(options, "numbers", [number] if number else []))
        except SystemExit as stop:
            return f"exit status {stop.code}"
    return ""


class Commands(unittest.TestCase):
    def test_each_command_line_of_a_page_can_be_typed(self):
        found = in_all_pages()
        self.assertGreater(len(found), 100)
        for words, place in found.items():
            with self.subTest(place, command=" ".join(["./course", *words])):
                self.assertEqual(refusal(words), "")

    def test_what_is_wrong_with_one_is_found(self):
        for wrong in ("run 3 bunny_bowl --elements 10668", "run 99", "run 3 no_such", "run 3 bunny_bowl -- --elements 9", "docs --fast",
                      "check 9.9", "solution", "compare", "frobnicate", "grade"):
            with self.subTest(wrong):
                self.assertNotEqual(refusal(tuple(wrong.split())), "")

    def test_command_lines_are_found_in_code_and_over_two_lines(self):
        text = "Type `./course run 3\nslope -- --every 2`, `x`, or\n\n    ./course check 3.1  # judges it\n"
        self.assertEqual(list(command_lines(text)), [("run", "3", "slope", "--", "--every", "2"), ("check", "3.1")])


if __name__ == "__main__":
    unittest.main()
