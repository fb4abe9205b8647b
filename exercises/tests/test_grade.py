"""Grading: what a row says, and how the table grows."""
import io
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


def exercise(check, number="1.2", name="2_fall"):
    check.write_text("check", encoding="utf-8")
    return SimpleNamespace(number=number, title="Fall", chapter="01_fall", name=name, mutants=[MUTANT], check=check,
                           untouched=lambda path: path.read_text(encoding="utf-8", errors="replace") == "stub")


class Grading(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.work = Path(held.name)
        (self.work / "grades").mkdir()
        patch = mock.patch.object(grade.workshop, "WORK", self.work)
        patch.start()
        self.addCleanup(patch.stop)
        self.source = None
        self.exercise = exercise(self.work / "check.cpp")

    def hand_in(self, text):
        self.source = self.work / "2_fall.cpp"
        self.source.write_text(text, encoding="utf-8")

    def row(self, outcome=None, known=None):
        with mock.patch.object(grade, "judge", side_effect=outcome if isinstance(outcome, Exception) else [outcome]) as self.judge:
            found = grade.row_of("Ada Lovelace", self.exercise, self.source, known)
        self.mark = found["fingerprint"]
        return [found[column] for column in grade.COLUMNS[:7]]

    def test_nothing_handed_in(self):
        self.assertEqual(self.row(), ["Ada Lovelace", "1.2", "Fall", "missing", "", "", ""])

    def test_a_stub_is_not_started(self):
        self.hand_in("stub")
        self.assertEqual(self.row()[3], "not started")

    def test_what_is_known_is_not_judged_again_until_the_answer_changes(self):
        self.hand_in("mine")
        self.row(Outcome("passed", cases=4))
        known = {"student": "Ada", "result": "right", "fingerprint": self.mark} | dict.fromkeys(set(grade.COLUMNS) - {"student", "result", "fingerprint"}, "")
        self.row(None, known)
        self.judge.assert_not_called()
        self.hand_in("mine, mended")
        self.assertEqual(self.row(Outcome("crashed"), known)[3], "crashed")

    def test_what_breaks_the_judge_is_a_row_and_no_end(self):
        self.hand_in("mine")
        self.assertEqual(self.row(OSError("no space left"))[3], "not judged")

    def test_a_wrong_answer_says_how_many_hold_and_which_misconception(self):
        self.hand_in("mine")
        wrong = Outcome("failed", cases=4, failures=[Failure("push: out", [], "expected 1 N s, got -1 N s")] * 2)
        with mock.patch.object(student, "judge_mutant", return_value=wrong):
            self.assertEqual(self.row(wrong)[3:], ["wrong", 3, 4, "flipped"])

    def test_other_numbers_are_another_mistake(self):
        self.hand_in("mine")
        wrong, flipped = (Outcome("failed", cases=4, failures=[Failure("push: out", [], f"got {number} N s")]) for number in (2, -1))
        with mock.patch.object(student, "judge_mutant", return_value=flipped):
            self.assertEqual(self.row(wrong)[3:], ["wrong", 3, 4, ""])

    def test_half_of_the_numbers_is_not_enough(self):
        self.hand_in("mine")
        same, other = Failure("push: out", [], "got -1 N s"), Failure("push: out", [], "got -2 N s")
        with mock.patch.object(student, "judge_mutant", return_value=Outcome("failed", failures=[same, other])):
            self.assertEqual(self.row(Outcome("failed", cases=4, failures=[same]))[3:], ["wrong", 3, 4, ""])

    def test_of_two_mistakes_one_is_told(self):
        self.hand_in("mine")
        flipped = Failure("push: out", [], "got -1 N s")
        wrong = Outcome("failed", cases=4, failures=[flipped, Failure("rest", [], "got 2 m")])
        with mock.patch.object(student, "judge_mutant", return_value=Outcome("failed", failures=[flipped])):
            self.assertEqual(self.row(wrong)[3:], ["wrong", 2, 4, "flipped"])

    def test_an_exception_is_no_misconception(self):
        self.hand_in("mine")
        wrong = Outcome("failed", cases=4, failures=[Failure("push: out", [], "threw an exception: bad_alloc")])
        self.assertEqual(self.row(wrong)[3:], ["wrong", 3, 4, ""])

    def test_a_right_answer(self):
        self.hand_in("mine")
        self.assertEqual(self.row(Outcome("passed", cases=4))[3:], ["right", 4, 4, ""])


class TheTable(unittest.TestCase):
    """A whole class; the judge is a false one."""

    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.root = Path(held.name)
        self.folder, self.out = self.root / "class", self.root / "grades.csv"
        self.exercises = [exercise(self.root / "check.cpp"), exercise(self.root / "check.cpp", "1.3", "3_rise")]
        for student in ("Ada", "O'Brien", "=Jörg"):
            (self.folder / student).mkdir(parents=True)
            (self.folder / student / "2_fall.cpp").write_text(f"by {student}", encoding="utf-8")
        for name, value in (("prepare", None), ("WORK", self.root / "work")):
            patch = mock.patch.object(grade.workshop, name, value) if value else mock.patch.object(grade.workshop, name)
            patch.start()
            self.addCleanup(patch.stop)

    def grade(self, judge):
        with mock.patch.object(grade, "judge", side_effect=judge) as self.judge, mock.patch("sys.stderr", io.StringIO()) as self.told, \
                mock.patch.object(grade.os, "cpu_count", return_value=1):
            return grade.grade(self.exercises, self.folder, self.out)

    def test_a_row_for_each_student_and_exercise(self):
        rows = self.grade(lambda *_: Outcome("passed", cases=4))
        self.assertEqual([(row["student"], row["exercise"], row["result"]) for row in rows],
                         [(student, number, result) for student in ("=Jörg", "Ada", "O'Brien") for number, result in (("1.2", "right"), ("1.3", "missing"))])
        self.assertEqual([row["student"] for row in grade.rows_of(self.out)], [row["student"] for row in rows])
        self.assertIn("[6/6] ", self.told.getvalue())

    def test_the_table_grows_and_a_stopped_run_goes_on_where_it_was(self):
        with self.assertRaises(KeyboardInterrupt):
            self.grade([Outcome("passed", cases=4), KeyboardInterrupt()])
        self.assertEqual([row["result"] for row in grade.rows_of(self.out)].count("right"), 1)
        rows = self.grade(lambda *_: Outcome("passed", cases=4))
        self.assertEqual(self.judge.call_count, 2)
        self.assertEqual([row["result"] for row in rows].count("right"), 3)

    def test_a_table_of_something_else_is_not_taken_over(self):
        self.out.write_text("student,result\nAda,right\n", encoding="utf-8")
        self.assertEqual(grade.rows_of(self.out), [])


if __name__ == "__main__":
    unittest.main()
