"""Formulas on the terminal: each one in the exercises becomes a line that reads aloud."""
import io
import re
import sys
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import terminal  # noqa: E402
from catalogue import all_exercises  # noqa: E402


class Formulas(unittest.TestCase):
    def test_fractions_roots_and_powers(self):
        for tex, text in ((r"\tfrac12 k\,\Delta t", "(1 / 2) k Δt"), (r"-\frac{\sigma\,|v|}{f}\, z", "-((σ |v|) / f) z"),
                          (r"w = \frac{(d \times s) \cdot n}{|n|^2} ,", "w = ((d × s) · n) / |n|²,"), (r"e^{-2\zeta} \le \sqrt{1 - x}", "e^(-2ζ) ≤ √(1 - x)"),
                          (r"\int_{\text{inside}} \delta(\tau)\; d\tau", "∫_inside δ(τ) dτ"), (r"\left(\frac{a + b}{2}\right)^2", "((a + b) / 2)²"),
                          (r"\dot z = B_{i+j}^5 \binom{5}{i}", "z' = B_(i+j)^5 binom(5, i)")):
            self.assertEqual(terminal.formula(tex), text)

    def test_an_unknown_command_is_refused(self):
        with self.assertRaisesRegex(ValueError, "nabla"):
            terminal.formula(r"\nabla f")

    def test_no_exercise_shows_tex(self):
        for exercise in all_exercises():
            text = terminal.plain("\n".join([exercise.goal, exercise.text, *exercise.hints]))
            self.assertEqual(re.findall(r"\\[a-zA-Z\[\]$]+|<<|>>|[{}]\\", text), [], exercise.number)

    def test_a_formula_of_its_own_line_stays_one(self):
        self.assertEqual(terminal.plain("Then\n$$ a = b . $$\nholds: \\ref base_step \"the step\"."), "Then\n\n    a = b.\n\nholds: the step.")

    def test_another_encoding_gets_names(self):
        for encoding, text in (("utf-8", "δ ≤ √(2)"), ("latin-1", "delta <= sqrt(2)"), ("ascii", "delta <= sqrt(2)")):
            with mock.patch("sys.stdout", io.TextIOWrapper(io.BytesIO(), encoding)):
                self.assertEqual(terminal.plain(r"$\delta \le \sqrt{2}$"), text)


if __name__ == "__main__":
    unittest.main()
