"""Hidden checks: which numbers change, and that a check which does not bite is not written."""
import io
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


class Written(unittest.TestCase):
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

    def write(self, passes):
        """@param passes  whether an answer passes a check, both by their text"""
        texts = [self.exercise.source.read_text(), *map(self.exercise.mutated, self.exercise.mutants)]
        with mock.patch.object(variants, "compiled", return_value=texts), mock.patch.object(variants.workshop, "prepare"), \
                mock.patch.object(variants, "passes", lambda exercise, answer, check: passes(answer, check)), redirect_stdout(io.StringIO()) as told:
            variants.write_variants([self.exercise], self.hidden, 5)
        self.told = told.getvalue()
        return list(self.hidden.rglob("*.cpp"))

    def is_solution(self, answer):
        return answer == self.exercise.source.read_text()

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


if __name__ == "__main__":
    unittest.main()
