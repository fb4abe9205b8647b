"""The course goes on and answers stay: a pull over solved exercises, and what is handed out to students."""
import io
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from pathlib import Path
from unittest import mock

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
sys.path.insert(0, str(HERE))
import catalogue  # noqa: E402
import handout  # noqa: E402
import prove  # noqa: E402
import update  # noqa: E402
from test_catalogue import ENTRY, MUTANT, SOURCE, Folder  # noqa: E402

ANSWER = "double speed(double t) { return 9.81 * t; }  // mine\n"
SCHOOLS = HERE.parent / "for_schools"


@unittest.skipUnless(shutil.which("git"), "needs git")
class TwoRepositories(unittest.TestCase):
    """The course's repository with two exercises, 1.2 and 1.3, and a student's clone of it."""

    def setUp(self):
        self.course = Folder()
        for place, text in (("exercises/01_fall/3_fall.toml", ENTRY), ("solutions/01_fall/3_fall.toml", MUTANT), ("solutions/01_fall/3_fall.cpp", SOURCE),
                            (".gitignore", "/build/\n/answers/\n"), (".ci/run", ""), (".github/workflows/ours.yml", "")):
            self.course.write(place, text)
        self.at(self.course.root)
        shutil.copytree(SCHOOLS, self.course.root / "exercises/for_schools")
        self.write_stubs(self.course.root)
        self.git(self.course.root, "init", "--quiet")
        self.commit(self.course.root)
        self.clone = Path(tempfile.mkdtemp(prefix="a student's "), "clone").resolve()
        self.addCleanup(shutil.rmtree, self.clone.parent)
        self.git(self.clone.parent, "clone", "--quiet", self.course.root, self.clone)
        self.first, self.second = self.at(self.clone)

    def git(self, folder, *words):
        return subprocess.run(["git", "-c", "user.name=T", "-c", "user.email=t@example.org", *words], cwd=folder, check=True, capture_output=True,
                              text=True).stdout

    def commit(self, folder):
        self.git(folder, "add", ".")
        self.git(folder, "commit", "--quiet", "-m", "The course")

    def at(self, root):
        """The exercises, as one sees them who works at this root."""
        for place in (catalogue, update, handout):
            patch = mock.patch.object(place, "ROOT", root)
            patch.start()
            self.addCleanup(patch.stop)
        return catalogue.all_exercises(root)

    def write_stubs(self, root):
        for exercise in catalogue.all_exercises(root):
            exercise.stub.write_text(exercise.stub_text(), encoding="utf-8")

    def course_goes_on(self):
        """The course changes a solution's text, and with it the stub."""
        exercises = self.at(self.course.root)
        for exercise in exercises:
            exercise.source.write_text(SOURCE.replace("#include", "// New.\n#include", 1), encoding="utf-8")
            exercise.stub.write_text(exercise.stub_text(), encoding="utf-8")
        self.commit(self.course.root)
        self.at(self.clone)

    def update(self, origin=None):
        with redirect_stdout(io.StringIO()) as told:
            self.assertEqual(update.update(catalogue.all_exercises(self.clone), origin), 0)
        return told.getvalue()


class AnUpdate(TwoRepositories):
    def test_a_pull_over_solved_exercises(self):
        self.first.answer.parent.mkdir(parents=True)
        self.first.answer.write_text(ANSWER, encoding="utf-8")       # as it should be
        self.second.stub.write_text(ANSWER, encoding="utf-8")        # as it is done all the same: this alone would be a conflict
        self.course_goes_on()
        with self.assertRaises(subprocess.CalledProcessError):
            self.git(self.clone, "pull", "--ff-only")
        told = self.update()
        self.assertIn("exercises/01_fall/3_fall.cpp: what you wrote there is now answers/01_fall/3_fall.cpp", told)
        for exercise in (self.first, self.second):
            self.assertEqual(exercise.attempt.read_text(encoding="utf-8"), ANSWER)
            self.assertTrue(exercise.stub.read_text(encoding="utf-8").startswith("// New."))
        self.assertEqual(self.git(self.clone, "status", "--short"), "")

    def test_a_pull_over_answers_that_were_committed(self):
        self.git(self.clone, "config", "user.name", "T")
        self.git(self.clone, "config", "user.email", "t@example.org")
        self.first.stub.write_text(ANSWER, encoding="utf-8")
        self.commit(self.clone)
        self.course_goes_on()
        self.update()
        self.assertEqual(self.first.answer.read_text(encoding="utf-8"), ANSWER)
        self.assertTrue(self.first.stub.read_text(encoding="utf-8").startswith("// New."))
        self.assertEqual(self.git(self.clone, "status", "--short"), "")

    def test_a_file_that_was_not_begun_gets_the_new_stub(self):
        self.first.answer.parent.mkdir(parents=True)
        shutil.copyfile(self.first.stub, self.first.answer)
        self.course_goes_on()
        self.update()
        self.assertFalse(self.first.answer.exists())

    def test_nothing_is_ever_written_over(self):
        self.first.answer.parent.mkdir(parents=True)
        self.first.answer.write_text("one", encoding="utf-8")
        self.first.stub.write_text("two", encoding="utf-8")
        self.course_goes_on()
        self.update()
        self.assertEqual(self.first.answer.read_text(encoding="utf-8"), "one")
        self.assertEqual(self.first.answer.with_name("2_fall.2.txt").read_text(encoding="utf-8"), "two")

    def test_what_git_refuses_is_told(self):
        (self.clone / "solutions/01_fall/2_fall.cpp").write_text(SOURCE + "// changed\n", encoding="utf-8")
        self.course_goes_on()
        with self.assertRaisesRegex(update.CannotUpdate, "(?s)git merge: .*solutions/01_fall/2_fall.cpp"):
            self.update()

    def test_prove_keeps_an_answer_and_does_not_suggest_to_lose_it(self):
        self.first.stub.write_text(ANSWER, encoding="utf-8")
        fault = next(prove.shape_faults(self.first))
        self.assertIn("./course update keeps it", fault)
        self.assertNotIn("--renew", fault)
        with redirect_stdout(io.StringIO()):
            prove.write_stub(self.first)
        self.assertEqual(self.first.answer.read_text(encoding="utf-8"), ANSWER)
        self.assertTrue(self.first.untouched(self.first.stub))

    def test_an_old_stub_is_written_anew(self):
        self.first.stub.write_text("// Old.\n" + self.first.stub_text(), encoding="utf-8")
        self.assertIn("--renew", next(prove.shape_faults(self.first)))


class AHandout(TwoRepositories):
    def setUp(self):
        super().setUp()
        self.students = self.clone.parent / "students"
        self.exercises = self.at(self.course.root)
        with redirect_stdout(io.StringIO()):
            handout.handout(self.exercises, self.students)

    def test_no_solution_is_in_it(self):
        files = {str(file.relative_to(self.students)) for file in self.students.rglob("*") if file.is_file()}
        self.assertFalse([name for name in files if name.startswith(("solutions", ".ci", ".git/")) or name.endswith("ours.yml")])
        self.assertNotIn("return 9.81", "".join((self.students / name).read_text() for name in files if name.endswith((".cpp", ".stub", ".toml"))))
        self.assertEqual((self.students / ".gitignore").read_text(), "/build/\n")

    def test_its_exercises_are_those_of_the_course(self):
        first, _ = self.at(self.students)
        self.assertEqual(first.stub_text(), self.exercises[0].stub_text())
        self.assertTrue(first.untouched())
        first.stub.write_text(ANSWER, encoding="utf-8")
        self.assertFalse(first.untouched())

    def test_a_new_handout_comes_over_an_old_one_and_answers_stay(self):
        self.git(self.students, "init", "--quiet")
        self.commit(self.students)
        self.clone, first = self.students, self.at(self.students)[0]
        first.answer.parent.mkdir(parents=True)
        first.answer.write_text(ANSWER, encoding="utf-8")
        self.commit(self.students)
        self.course_goes_on()
        new = self.students.with_name("new")
        with redirect_stdout(io.StringIO()):
            handout.handout(self.at(self.course.root), new)
        self.git(new, "init", "--quiet")
        self.commit(new)
        self.at(self.students)
        self.update(str(new))
        self.assertTrue(first.stub.read_text(encoding="utf-8").startswith("// New."))
        self.assertEqual(first.attempt.read_text(encoding="utf-8"), ANSWER)

    def test_an_exercise_for_exams_is_not_in_it(self):
        first, exam = self.exercises
        without = self.students.with_name("without")
        with redirect_stdout(io.StringIO()):
            handout.handout([first], without, [exam])
        files = [file.name for file in without.rglob("*")]
        self.assertIn(first.stub.name, files)
        self.assertFalse([name for name in files if name.startswith(f"{exam.name}.")])

    def test_a_folder_with_something_in_it_is_refused(self):
        with self.assertRaises(handout.CannotHandOut):
            handout.handout(self.exercises, self.students)


class TheWorkflow(unittest.TestCase):
    """docs.github.com, workflow syntax: what a workflow, a job and a step may and must have."""
    JOB = {"name", "runs-on", "container", "timeout-minutes", "env", "steps", "permissions", "needs", "if", "strategy"}
    STEP = {"id", "if", "name", "uses", "run", "with", "env", "working-directory", "shell", "timeout-minutes", "continue-on-error"}

    def setUp(self):
        try:
            import yaml
        except ImportError:
            if os.environ.get("CI") == "true":
                raise
            self.skipTest("needs python3-yaml (./course setup style)")
        self.flow = yaml.load((SCHOOLS / "check.yml").read_text(encoding="utf-8"), yaml.BaseLoader)

    def test_it_is_as_specified(self):
        self.assertLessEqual({"on", "jobs"}, set(self.flow))
        self.assertLessEqual(set(self.flow), {"name", "on", "permissions", "jobs", "env", "concurrency", "defaults", "run-name"})
        for job in self.flow["jobs"].values():
            self.assertLessEqual({"runs-on", "steps"}, set(job))
            self.assertLessEqual(set(job), self.JOB)
            for step in job["steps"]:
                self.assertLessEqual(set(step), self.STEP)
                self.assertEqual(("uses" in step) + ("run" in step), 1)

    def test_its_commands_are_the_course_s(self):
        import course_exercises
        for step in self.flow["jobs"]["check"]["steps"]:
            if "run" in step:
                words = step["run"].replace("$EXERCISES", "1.1 1.2").replace("--no-install", "").replace('"', "").split()
                self.assertEqual(words[0], "./course")
                with mock.patch.object(sys, "argv", words):
                    self.assertEqual(course_exercises.arguments().numbers, ["1.1", "1.2"])

    def test_gradescope_s_script_writes_where_it_reads(self):
        import course_exercises
        script = (SCHOOLS / "run_autograder").read_text(encoding="utf-8")
        words = script.splitlines()[-1].replace('"${exercises[@]}"', "1.1").replace("--no-install", "").split()
        with mock.patch.object(sys, "argv", words[1:]):
            options = course_exercises.arguments()
        self.assertEqual((str(options.folder), str(options.gradescope)), ("/autograder/submission", "/autograder/results/results.json"))


if __name__ == "__main__":
    unittest.main()
