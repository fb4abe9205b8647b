"""Chapter 7, "Two cubes by hand": the page's numbers are those of its formulas."""
import re
import unittest
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "chapters/07_implicit_contact/chapter.md"
STEP, GRAVITY, GAP, H = 0.01, 10.0, 0.9e-3, 100.0
MASSES = (1.0, 0.5)  # of the pairs: lower cube on the floor, cube on cube
STIFFNESS = [H * mass / STEP**2 for mass in MASSES]
FREE = (-GRAVITY * STEP, -GRAVITY * STEP)


def pairs(v):
    """Depths, impulses and contact Hessians of both pairs at these velocities."""
    depths = (STEP * v[0], GAP + STEP * (v[1] - v[0]))
    impulses = [-k * STEP * min(0.0, depth) for k, depth in zip(STIFFNESS, depths)]
    return depths, impulses, [k * STEP**2 * (depth < 0) for k, depth in zip(STIFFNESS, depths)]


def gradient(v):
    _, (floor, upper), _ = pairs(v)
    return (v[0] - FREE[0] - floor + upper, v[1] - FREE[1] - upper)


def newton(v):
    """The direction, solved with the Hessian ((1 + s0 + s1, -s1), (-s1, 1 + s1))."""
    (a, b), (_, _, (s0, s1)) = gradient(v), pairs(v)
    det = (1 + s0 + s1) * (1 + s1) - s1 * s1
    return (-((1 + s1) * a + s1 * b) / det, -(s1 * a + (1 + s0 + s1) * b) / det)


def moved(v, d):
    return (v[0] + d[0], v[1] + d[1])


class TwoCubes(unittest.TestCase):
    def setUp(self):
        text = PAGE.read_text(encoding="utf-8")
        self.text = re.search(r"### Two cubes by hand\n(.*?)\n### ", text, re.S)[1]

    def shows(self, value, digits):
        """The page has this number, rounded to so many decimals."""
        self.assertRegex(self.text, rf"(?<![\d.-]){re.escape(f'{value:.{digits}f}')}(?!\d)")

    def test_the_first_step_and_its_line_search(self):
        direction = newton(FREE)
        after = moved(FREE, direction)
        self.shows(direction[0], 5)
        self.shows(after[0], 5)
        for v in (FREE, after):
            self.shows(sum(d * g for d, g in zip(direction, gradient(v))), 4)
        self.assertLess(abs(sum(d * g for d, g in zip(direction, gradient(after)))), 0.1 * abs(direction[0] * gradient(FREE)[0]))

    def test_the_second_step_and_the_result(self):
        first = moved(FREE, newton(FREE))
        depths, impulses, _ = pairs(first)
        self.shows(1000 * depths[0], 5)
        self.shows(1000 * depths[1], 4)
        for impulse in impulses:
            self.shows(impulse, 4)
        direction = newton(first)
        self.shows(direction[0], 7)
        self.shows(direction[1], 5)
        v = moved(first, direction)
        self.assertLess(max(map(abs, gradient(v))), 1e-12)
        depths, impulses, _ = pairs(v)
        for value in (*v, *impulses, *(1000 * depth for depth in depths), v[0] - FREE[0]):
            self.shows(value, 5)

    def test_the_lower_cube_holds_by_friction(self):
        v = moved(FREE, newton(FREE))
        floor = pairs(moved(v, newton(v)))[1][0]
        held = 0.05 / (1 + H)
        self.shows(0.5 * floor, 5)
        self.shows(held, 6)
        self.shows(H * held, 4)
        self.assertLess(H * held, 0.5 * floor)


if __name__ == "__main__":
    unittest.main()
