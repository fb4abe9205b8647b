"""Hidden checks: which numbers change, and that a check which does not bite is not written."""
import io
import json
import re
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from dataclasses import replace
from pathlib import Path
from unittest import mock

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
sys.path.insert(0, str(HERE))
import catalogue  # noqa: E402
import variants  # noqa: E402
from test_catalogue import Folder  # noqa: E402

CHECK = """TEST_CASE("fall: half")
{
    const double mass = 0.3, k = 700, dt = 1e-3, twice = 2 * mass;
    for (const double height : {1.0, 20.0}) {
        given("mass 0.3 kg");
        expect("way", way(mass, 3), 4.5, 1e-12);
    }
    RandomInputs random(7);
    for (unsigned seed = 1; seed <= 20; ++seed)
        continue;
}
"""


class Varied(unittest.TestCase):
    def test_named_numbers_lists_and_seeds_change_and_nothing_else(self):
        before, after = CHECK.splitlines(), variants.varied(CHECK, 5).splitlines()
        self.assertEqual([i for i, (old, new) in enumerate(zip(before, after, strict=True)) if old != new], [2, 3, 7, 8])
        self.assertRegex(after[2], r"mass = 0\.[234]\d*, k = [5-8]\d\d\.\d, dt = 0\.00\d+, twice = 2 \* mass;")
        self.assertNotIn("0.3,", after[2])

    def test_a_range_of_seeds_keeps_its_length(self):
        first, last = variants.SEED.search(variants.varied(CHECK, 5), CHECK.index("unsigned")).group(2, 3)
        self.assertEqual(int(last) - int(first), 19)
        self.assertGreater(int(first), 20)

    def test_the_same_seed_makes_the_same_check_and_another_one_another(self):
        self.assertEqual(variants.varied(CHECK, 5), variants.varied(CHECK, 5))
        self.assertNotEqual(variants.varied(CHECK, 5), variants.varied(CHECK, 6))


class OfAnExercise(unittest.TestCase):
    """A course of one exercise, and a folder for hidden checks."""
    def setUp(self):
        self.course = Folder()
        self.course.write("exercises/01_fall/2_fall.check.cpp", CHECK)
        for place in (catalogue, variants):
            patch = mock.patch.object(place, "ROOT", self.course.root)
            patch.start()
            self.addCleanup(patch.stop)
        self.exercise, = catalogue.all_exercises(self.course.root)
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.hidden = Path(held.name)

    def is_solution(self, answer):
        return answer == self.exercise.source.read_text()


class Written(OfAnExercise):
    def write(self, passes):
        """@param passes  whether an answer passes a check, both by their text"""
        texts = [self.exercise.source.read_text(), *map(self.exercise.mutated, self.exercise.mutants)]
        with mock.patch.object(variants, "compiled", return_value=texts), mock.patch.object(variants.workshop, "prepare"), \
                mock.patch.object(variants, "passes", lambda exercise, answer, check: passes(answer, check)), redirect_stdout(io.StringIO()) as told:
            variants.write_variants([self.exercise], self.hidden, 5)
        self.told = told.getvalue()
        return list(self.hidden.rglob("*.cpp"))

    def test_the_check_is_written_and_used(self):
        file, = self.write(lambda answer, check: self.is_solution(answer))
        found = variants.with_hidden(self.exercise, self.hidden)
        self.assertEqual(found.check, file.resolve())
        self.assertIn(variants.varied(CHECK, 5), file.read_text())
        self.assertEqual(variants.with_hidden(self.exercise, self.hidden / "elsewhere").check, self.exercise.check)

    def test_a_number_that_the_solution_needs_stays(self):
        file, = self.write(lambda answer, check: self.is_solution(answer) and "k = 700" in check)
        self.assertIn("k = 700,", file.read_text())
        self.assertNotIn("mass = 0.3,", file.read_text())

    def test_a_check_that_lets_a_wrong_answer_pass_is_not_written(self):
        self.assertEqual(self.write(lambda answer, check: True), [])
        self.assertIn("Without one, for they name no number that can change alone: 1.2", self.told)

    def test_where_a_throw_of_the_dice_lets_a_wrong_answer_pass_another_is_tried(self):
        first = variants.varied(CHECK, 5)
        file, = self.write(lambda answer, check: self.is_solution(answer) or check == first)
        self.assertNotIn(first, file.read_text())

    def test_a_check_of_one_s_own_is_another_check(self):
        self.assertNotEqual(replace(self.exercise, hidden=self.hidden / "x.cpp").check, self.exercise.published_check)


EXAM_TEXT = "A body of {{mass}} kg falls from {{height}} m."


class ForExams(OfAnExercise):
    """The exercise of the other tests, at the place 91."""
    def setUp(self):
        super().setUp()
        root = self.course.root
        for file in [*root.glob("exercises/01_fall/2_fall*"), *root.glob("solutions/01_fall/2_fall*")]:
            file.rename(file.with_name(file.name.replace("2_fall", "91_fall")))
        self.text = root / "exercises/01_fall/91_fall.toml"
        (root / "exercises/01_fall/91_fall.hpp").write_text("// Declared.\n")
        (root / "exercises/01_fall/91_fall.check.cpp").write_text(CHECK.replace("dt = 1e-3", "height = 4.5"))
        self.text.write_text(re.sub(r'text = "[^"]*"', f"text = {json.dumps(EXAM_TEXT)}", self.text.read_text()))
        self.assertIn("{{mass}}", self.text.read_text())
        self.exercise, = catalogue.every_exercise(root)

    def write(self, passes):
        texts = [self.exercise.source.read_text(), *map(self.exercise.mutated, self.exercise.mutants)]
        with mock.patch.object(variants, "compiled", return_value=texts), mock.patch.object(variants.workshop, "prepare"), \
                mock.patch.object(variants, "passes", lambda exercise, answer, check: passes(answer, check)), redirect_stdout(io.StringIO()):
            variants.write_variants([], self.hidden, 5, [self.exercise])
        return [file for file in self.hidden.rglob("*.cpp") if "exam" not in file.relative_to(self.hidden).parts]

    def test_the_course_does_not_list_it_while_there_is_a_solution(self):
        self.assertEqual(catalogue.all_exercises(self.course.root), [])
        self.exercise.kept_stub.write_text(self.exercise.stub_text())
        self.exercise.source.unlink()
        self.assertEqual([exercise.number for exercise in catalogue.all_exercises(self.course.root)], ["1.91"])

    def test_students_get_text_and_check_with_the_same_numbers_and_the_graded_check_has_others(self):
        graded, = self.write(lambda answer, check: self.is_solution(answer))
        place = self.hidden / "exam/exercises/01_fall"
        self.assertEqual(sorted(file.name for file in place.iterdir()), [f"91_fall.{end}" for end in ("check.cpp", "cpp", "hpp", "stub", "toml")])
        shown, text = (place / "91_fall.check.cpp").read_text(), (place / "91_fall.toml").read_text()
        mass, height = (re.search(rf"{name} = ([\d.]+)", shown)[1] for name in ("mass", "height"))
        self.assertIn(f"A body of {mass} kg falls from {height} m.", text)
        self.assertNotEqual(mass, "0.3")
        self.assertNotIn(f"mass = {mass},", graded.read_text())
        self.assertNotIn("return 9.81", (place / "91_fall.cpp").read_text())

    def test_a_number_that_the_check_does_not_have_is_told(self):
        with self.assertRaisesRegex(catalogue.CatalogueError, "the text names age"):
            catalogue.filled("{{age}}", CHECK)


if __name__ == "__main__":
    unittest.main()
