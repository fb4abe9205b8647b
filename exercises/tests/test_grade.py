"""Grading: where a student's file lies, and what a row says."""
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import grade  # noqa: E402
import student  # noqa: E402
from judge import Failure, Outcome  # noqa: E402

MUTANT = SimpleNamespace(name="flipped", fails=["push: out"])


def exercise():
    return SimpleNamespace(number="1.2", title="Fall", chapter="01_fall", name="2_fall", mutants=[MUTANT],
                           untouched=lambda path: path.read_text() == "stub")


class Grading(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.student = Path(held.name) / "Ada Lovelace"
        self.student.mkdir()

    def hand_in(self, folder, text):
        place = self.student / folder
        place.mkdir(parents=True)
        (place / "2_fall.cpp").write_text(text)

    def row(self, outcome=None):
        with mock.patch.object(grade, "judge", return_value=outcome):
            return grade.row_of(self.student, exercise())

    def test_nothing_handed_in(self):
        self.assertEqual(self.row(), ["Ada Lovelace", "1.2", "Fall", "missing", "", "", ""])

    def test_a_clone_and_the_bare_folder_are_found(self):
        self.hand_in("exercises/01_fall", "stub")
        self.assertEqual(self.row()[3], "not started")

    def test_the_bare_folder_of_exercises_is_found(self):
        self.hand_in("01_fall", "stub")
        self.assertEqual(self.row()[3], "not started")

    def test_a_wrong_answer_says_how_many_hold_and_which_misconception(self):
        self.hand_in("01_fall", "mine")
        wrong = Outcome("failed", cases=4, failures=[Failure("push: out", [], "expected 1 N s, got -1 N s")] * 2)
        with mock.patch.object(student, "judge_mutant", return_value=wrong):
            self.assertEqual(self.row(wrong)[3:], ["wrong", 3, 4, "flipped"])

    def test_other_numbers_are_another_mistake(self):
        self.hand_in("01_fall", "mine")
        wrong, flipped = (Outcome("failed", cases=4, failures=[Failure("push: out", [], f"got {number} N s")]) for number in (2, -1))
        with mock.patch.object(student, "judge_mutant", return_value=flipped):
            self.assertEqual(self.row(wrong)[3:], ["wrong", 3, 4, ""])

    def test_half_of_the_numbers_is_not_enough(self):
        self.hand_in("01_fall", "mine")
        same, other = Failure("push: out", [], "got -1 N s"), Failure("push: out", [], "got -2 N s")
        with mock.patch.object(student, "judge_mutant", return_value=Outcome("failed", failures=[same, other])):
            self.assertEqual(self.row(Outcome("failed", cases=4, failures=[same]))[3:], ["wrong", 3, 4, ""])

    def test_of_two_mistakes_one_is_told(self):
        self.hand_in("01_fall", "mine")
        flipped = Failure("push: out", [], "got -1 N s")
        wrong = Outcome("failed", cases=4, failures=[flipped, Failure("rest", [], "got 2 m")])
        with mock.patch.object(student, "judge_mutant", return_value=Outcome("failed", failures=[flipped])):
            self.assertEqual(self.row(wrong)[3:], ["wrong", 2, 4, "flipped"])

    def test_an_exception_is_no_misconception(self):
        self.hand_in("01_fall", "mine")
        wrong = Outcome("failed", cases=4, failures=[Failure("push: out", [], "threw an exception: bad_alloc")])
        self.assertEqual(self.row(wrong)[3:], ["wrong", 3, 4, ""])

    def test_a_right_answer(self):
        self.hand_in("01_fall", "mine")
        self.assertEqual(self.row(Outcome("passed", cases=4))[3:], ["right", 4, 4, ""])


if __name__ == "__main__":
    unittest.main()
