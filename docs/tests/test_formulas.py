"""Formulas: what a page writes for GitHub arrives as Doxygen reads it, and what GitHub would show otherwise is told."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import formulas  # noqa: E402


def told(text):
    return list(formulas.faults(text))


class Translated(unittest.TestCase):
    def becomes(self, written, read):
        self.assertEqual(formulas.for_doxygen(written), read)
        self.assertEqual(told(written), [])

    def test_a_formula_in_a_line(self):
        self.becomes("Let $p$ and $|n|^2$ be.", r"Let \f$p\f$ and \f$|n|^2\f$ be.")

    def test_one_in_backquotes_keeps_its_signs(self):
        self.becomes(r"The push $`k\,\delta`$.", r"The push \f$k\,\delta\f$.")

    def test_one_on_its_own(self):
        self.becomes("so\n\n$$ a =\n  b $$\n", "so\n\n\\f[ a =\n  b \\f]\n")

    def test_a_fenced_one_keeps_its_lines_and_its_place_in_a_list(self):
        self.becomes("- so\n  ```math\n  a \\\\ b\n  ```\n- c", "- so\n  \\f[\n  a \\\\ b\n  \\f]\n- c")

    def test_code_is_left_as_it_is(self):
        for code in ("`$x$`", "``a ` $x$``", "```\n$x$\n```", "~~~ sh\necho $HOME\n~~~"):
            self.becomes(code, code)

    def test_code_and_formulas_in_one_line(self):
        self.becomes("`$x` is $y$ and `z$`", r"`$x` is \f$y\f$ and `z$`")


class ToldWithTheirLine(unittest.TestCase):
    def test_signs_that_markdown_would_eat(self):
        for formula in (r"k\,\delta", r"\{1\}", r"\bar{x}_{i}", "a * b", "a<b", "[a](b)"):
            with self.subTest(formula):
                self.assertEqual([line for line, _ in told(f"Why?\n\nBecause ${formula}$.")], [3])
                self.assertEqual([line for line, _ in told(f"Why?\n\n$$ {formula} $$")], [3])

    def test_one_that_is_not_closed(self):
        self.assertEqual(told("```\n$\n```\nLet $x be"), [(4, "a formula that is not closed")])

    def test_a_formula_over_two_lines(self):
        self.assertEqual([line for line, _ in told("Let $a +\nb$ be")], [1, 2])

    def test_the_marks_of_doxygen(self):
        self.assertEqual(told("Let\n\\f$x\\f$")[0], (2, "write formulas as $x$ and $$x$$"))

    def test_a_letter_behind_it(self):
        self.assertIn("a letter right behind", told("the $n$th")[0][1])


if __name__ == "__main__":
    unittest.main()
