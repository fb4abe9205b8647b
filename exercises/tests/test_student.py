"""What a student meets: the exit status of check, where the answer lies, and commands that run at once."""
import io
import sys
import tempfile
import threading
import time
import unittest
from contextlib import redirect_stdout
from dataclasses import replace
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import alone  # noqa: E402
import catalogue  # noqa: E402
import progress  # noqa: E402
import student  # noqa: E402
from judge import Failure, Outcome  # noqa: E402
sys.path.insert(0, str(Path(__file__).resolve().parent))
from test_catalogue import ENTRY, SOURCE, Folder  # noqa: E402

RIGHT, WRONG = Outcome("passed", cases=4), Outcome("failed", cases=4, failures=[Failure("fall: down", [], "expected 1 m, got 2 m")])
STUB = Outcome("untouched", cases=1, failures=[Failure("fall: down", [], "not implemented yet: 1.2")])


class AStudent(unittest.TestCase):
    """Two exercises, 1.2 and 1.3."""

    def setUp(self):
        self.course = Folder()
        self.course.write("exercises/01_fall/3_fall.toml", ENTRY)
        self.course.write("solutions/01_fall/3_fall.cpp", SOURCE)
        root = self.course.root
        for place, name, value in ((catalogue, "ROOT", root), (progress, "ROOT", root), (progress, "PLACE", root / "progress.json"),
                                   (student.workshop, "WORK", root / "work"), (student.workshop, "prepare", mock.Mock())):
            patch = mock.patch.object(place, name, value)
            patch.start()
            self.addCleanup(patch.stop)
        self.exercises = [replace(exercise, mutants=[]) for exercise in catalogue.all_exercises(root)]
        for exercise in self.exercises:
            exercise.stub.write_text(exercise.stub_text(), encoding="utf-8")
            exercise.check.write_text("check", encoding="utf-8")
        self.first = self.exercises[0]
        patch = mock.patch.object(student, "all_exercises", return_value=self.exercises)
        patch.start()
        self.addCleanup(patch.stop)

    def answer(self, exercise, text="mine"):
        exercise.answer.parent.mkdir(parents=True, exist_ok=True)
        exercise.answer.write_text(text, encoding="utf-8")

    def check(self, exercises, *outcomes, named=False):
        """(exit status, what was printed)"""
        with mock.patch.object(student, "judge", side_effect=outcomes) as self.judge, redirect_stdout(io.StringIO()) as told:
            status = student.check(exercises, named)
        return status, told.getvalue()

    def test_the_next_is_one_of_the_same_chapter(self):
        other = replace(self.first, number="2.1", chapter="02_rise", name="1_rise")
        for path in (other.stub, other.check):
            path.parent.mkdir(exist_ok=True)
            path.write_text("check", encoding="utf-8")
        for first in ([other, *self.exercises], [*self.exercises, other]):
            with mock.patch.object(student, "all_exercises", return_value=first), mock.patch.object(catalogue.Exercise, "untouched", lambda one, path=None: one.number != "1.3"):
                self.answer(self.exercises[1])
                self.assertIn("Next: 1.2", self.check([self.exercises[1]], RIGHT, named=True)[1])

    def test_what_a_prediction_should_be_is_not_shown_before_it(self):
        for exercise in (replace(self.first, kind="predict"), replace(self.first, text="Before you run the check: how deep?")):
            for text, shown in ((exercise.stub_text(), False), ("mine", True)):
                self.answer(exercise, text)
                with redirect_stdout(io.StringIO()) as told:
                    student.show_text(exercise)
                self.assertEqual("4.9 m" in told.getvalue(), shown, exercise.kind)

    def test_a_diagnosis_is_hedged_where_many_mistakes_get_the_same(self):
        mutant = mock.Mock(diagnosis="the sign", fails=["fall: down"])
        heads = {}
        for message in ("expected 1 m, got 0.1234 m", "expected 1 m, got 0 m", "it comes to rest"):
            outcome = Outcome("failed", cases=4, failures=[Failure("fall: down", [], message)])
            with mock.patch.object(student, "misconceptions", return_value=[mutant]), redirect_stdout(io.StringIO()) as told:
                student.tell_misconceptions(mock.Mock(mutants=[mutant]), outcome)
            heads[message] = told.getvalue().strip()
        self.assertEqual(list(heads.values()), ["Perhaps: the sign", *2 * ["This has many possible reasons. One of them: the sign"]])

    def test_a_stub_is_not_right(self):
        self.assertEqual(self.check(self.exercises)[0], 1)
        self.assertEqual(self.check([self.first], named=True)[0], 1)
        self.answer(self.first, "// mine\n" + self.first.stub_text())
        self.assertEqual(self.check([self.first], STUB, named=True)[0], 1)

    def test_a_wrong_answer_is_not_right_and_one_right_answer_is_not_all(self):
        self.answer(self.first)
        self.assertEqual(self.check([self.first], WRONG, named=True)[0], 1)
        self.assertEqual(self.check(self.exercises, RIGHT)[0], 1)
        self.assertEqual(self.check([self.first], RIGHT, named=True)[0], 0)
        self.assertEqual(self.check([self.first])[0], 0)
        self.answer(self.exercises[1])
        self.assertEqual(self.check(self.exercises, RIGHT)[0], 0)

    def test_the_stub_is_laid_where_git_does_not_look(self):
        _, told = self.check(self.exercises)
        self.assertIn("Your file: answers/01_fall/2_fall.cpp", told)
        self.assertEqual(self.first.answer.read_text(), self.first.stub_text())
        self.assertTrue(self.first.untouched())

    def test_an_answer_is_never_written_over(self):
        self.answer(self.first)
        for show in (lambda: student.show_text(self.first), lambda: self.check([self.first], WRONG, named=True)):
            with redirect_stdout(io.StringIO()):
                show()
            self.assertEqual(self.first.answer.read_text(), "mine")

    def test_who_writes_into_the_stub_is_judged_too(self):
        self.first.stub.write_text("mine", encoding="utf-8")
        self.assertEqual(self.first.attempt, self.first.stub)
        self.assertIn("Your file: exercises/01_fall/2_fall.cpp", self.check([self.first], WRONG, named=True)[1])
        self.answer(self.first, self.first.stub_text())
        self.assertEqual(self.first.attempt, self.first.stub)
        self.answer(self.first, "mine, too")
        self.assertEqual(self.first.attempt, self.first.answer)

    def test_two_lists_of_progress_do_not_forget_each_other(self):
        self.answer(self.first)
        self.answer(self.exercises[1])
        one, other = progress.Progress(), progress.Progress()
        one.note(self.first, True)
        other.note(self.exercises[1], True)
        self.assertTrue(all(progress.Progress().holds(exercise) for exercise in self.exercises))


class AtOnce(unittest.TestCase):
    def test_the_second_waits_for_the_first_and_says_so(self):
        order = []
        with tempfile.TemporaryDirectory() as folder, mock.patch("sys.stderr", io.StringIO()) as told:
            def second():
                with alone.alone(Path(folder), "judging 1.2"):
                    order.append("second")

            with alone.alone(Path(folder)):
                thread = threading.Thread(target=second)
                thread.start()
                time.sleep(0.2)
                order.append("first")
            thread.join()
        self.assertEqual(order, ["first", "second"])
        self.assertIn("Another command is judging 1.2", told.getvalue())


if __name__ == "__main__":
    unittest.main()
