"""The live figures: what the compiled chapters answer in JavaScript, against formulas and against each other."""
import json
import math
import shutil
import subprocess
import unittest
from pathlib import Path

MODULE = Path(__file__).resolve().parents[2] / "build/live/live.js"
NODE = shutil.which("node") or shutil.which("nodejs")
CALLS = """
require(MODULE)().then(m => {
  const list = a => Array.from(a);
  const face = [0.2, 1, 0.2, 0, 0, 0, 0, 0, 1, 1, 0, 0];
  const fall = [...face, ...face.map((v, i) => i === 1 ? -1 : v)];
  const slide = solver => { m.begin_sliding(solver, 1.5); const s = []; for (let i = 0; i < 20; ++i) s.push(list(m.slide_on(10))); return s; };
  console.log(JSON.stringify({
    cpf: list(m.stability(true, 0.1, 100, 3)), dpf: list(m.stability(false, 0.1, 100, 3)),
    fall: list(m.query(false, fall)), away: list(m.query(false, [...face, ...face.map((v, i) => i === 1 ? 2 : v)])),
    inside: list(m.integral(-1, -1, -1, -1)), outside: list(m.integral(1, 1, 1, 1)), line: list(m.integral(1, 1 / 3, -1 / 3, -1)),
    loose: list(m.slope(false, 10, 0.3, 0.3, 0, 1)), firm: list(m.slope(false, 10, 0.4, 0.4, 0, 1)), mass_splitting: list(m.slope(true, 10, 0.18, 0.18, 0, 1)),
    flat: list(m.circle(180)), right: list(m.circle(90)), six: slide(6), five: slide(5),
    fastest: list(m.implicit(16, 0.5, false, 200)), kept: list(m.implicit(16, 0.5, true, 200)), back: list(m.implicit(21, 0.3, false, 2)),
    corner: list(m.crossing(false, 1.25, 0.65, 1.25, 0, 0)), bar: list(m.crossing(true, 0, 0.1, 0.1, 7, 3)), apart: list(m.crossing(false, 0, 1.5, 0, 0, 0)),
    holds: list(m.passes(3, 8, 0.6, -1, 0.3)), slides: list(m.passes(3, 8, 0.25, -1, 0.3)), flies: list(m.passes(3, 2, 0.5, 1, 0.3)),
    titles: list(m.method_titles()), methods: list(m.methods(0.5, 1, 8)), smooth: list(m.methods(0, 1, 4)) }));
});
"""


@unittest.skipUnless(NODE and MODULE.is_file(), "needs node and the compiled figures (./course docs --live)")
class LiveFigures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = subprocess.run([NODE, "-e", CALLS.replace("MODULE", json.dumps(str(MODULE)))], capture_output=True, text=True, check=True)
        cls.said = json.loads(done.stdout)

    def crossing(self, name):
        """The lists of a crossing: edges of both, vertices inside of both, ways out, curves."""
        numbers, at, lists = self.said[name], 0, []
        for size in (6, 6, 3, 3, 3):
            count = int(numbers[at])
            lists.append([numbers[at + 1 + size * i:at + 1 + size * (i + 1)] for i in range(count)])
            at += 1 + size * count
        curves, at = int(numbers[at]), at + 1
        for _ in range(curves):
            at += 1 + 3 * int(numbers[at])
        self.assertEqual(at, len(numbers))
        return *lists, curves

    def test_a_cubes_corner_in_a_blocks_corner_leaves_along_the_areas_that_it_covers(self):
        # They share 0.25 m by 0.25 m by 0.25 m, so all three areas are the same.
        edges, _, inside, _, ways, curves = self.crossing("corner")
        self.assertEqual((curves, len(ways)), (1, 1))
        self.assertEqual(len(edges), 3 * 12)
        self.assertTrue(all(abs(x - 3 ** -0.5) < 1e-9 for x in ways[0]))
        self.assertEqual([[round(x, 9) for x in vertex] for vertex in inside], [[0.75, 0.15, 0.75]])

    def test_a_bar_through_a_wall_has_two_curves_and_what_is_apart_none(self):
        self.assertEqual(self.crossing("bar")[5], 2)
        _, _, in_a, in_b, ways, curves = self.crossing("apart")
        self.assertEqual((in_a, in_b, ways, curves), ([], [], [], 0))

    def test_stability_limits_are_the_chapters_formulas(self):
        self.assertAlmostEqual(self.said["cpf"][1], (2 / 100) ** 0.5, 15)
        self.assertAlmostEqual(self.said["dpf"][1], (4 / 300) ** 0.5, 15)
        self.assertAlmostEqual(self.said["cpf"][0], 0.5 ** 0.5, 15)  # the root of 1 - h/2 at h = 1

    def test_a_vertex_that_falls_through_a_face_touches_at_half_of_the_step(self):
        self.assertAlmostEqual(self.said["fall"][0], 0.5, 9)
        self.assertGreater(self.said["fall"][2] * -self.said["fall"][5], 0)

    def test_one_that_moves_away_is_settled_by_signs(self):
        self.assertEqual(self.said["away"][:2], [-1, 0])

    def test_the_integral_is_the_area_inside(self):
        self.assertEqual(self.said["inside"], [1, 1, 0, 1])
        self.assertEqual(self.said["outside"], [0, 0])
        self.assertAlmostEqual(self.said["line"][0], 0.25, 12)
        self.assertAlmostEqual(self.said["line"][2], 0.5, 12)

    def test_an_undamped_anchor_needs_twice_the_tangent_and_the_mass_splitting_one_does_not(self):
        self.assertEqual([self.said[name][0] for name in ("loose", "firm", "mass_splitting")], [0, 1, 1])

    def test_on_a_flat_vertex_average_and_span_agree_and_on_an_edge_they_do_not(self):
        self.assertTrue(all((mark & 2 > 0) == (mark & 4 > 0) for mark in self.said["flat"]))
        self.assertEqual(sum(mark & 2 > 0 for mark in self.said["right"]) in (90, 91), True)
        self.assertEqual(sum(mark & 4 > 0 for mark in self.said["right"]) in (180, 181), True)

    def test_the_implicit_step_is_fastest_at_16_costs_nothing_by_the_mean_and_has_a_limit_where_it_looks_back(self):
        self.assertAlmostEqual(self.said["fastest"][0], 1 / 3, 6)
        self.assertAlmostEqual(self.said["kept"][0], 1, 12)
        self.assertTrue(all(abs(energy - 1) < 1e-9 for energy in self.said["kept"][7::2]))
        self.assertTrue(all(after <= before + 1e-12 for before, after in zip(self.said["fastest"][7::2], self.said["fastest"][9::2])))
        self.assertAlmostEqual(self.said["back"][1], 4 / (1 - 2 * 0.3), 12)
        self.assertGreater(self.said["back"][0], 1)

    def test_each_pass_leaves_a_quarter_of_the_error_at_a_stiffness_of_3(self):
        for name, exact in (("holds", (1, -0.3)), ("slides", (1, -0.25)), ("flies", (0, 0))):
            normal, along, *passes = self.said[name]
            self.assertAlmostEqual(normal, exact[0], 8)
            self.assertAlmostEqual(along, exact[1], 8)
            for i in range(len(passes) // 7):
                r_n, r_t, u_n, u_t, _, _, error = passes[7 * i:7 * i + 7]
                self.assertAlmostEqual(r_n, (1 - 4 ** -(i + 1)) * exact[0], 11)
                self.assertAlmostEqual(r_t, (1 - 4 ** -(i + 1)) * exact[1], 11)
                self.assertAlmostEqual(u_n, (1 if name == "flies" else -1) + r_n, 14)
                self.assertAlmostEqual(u_t, 0.3 + r_t, 14)
                self.assertLessEqual(error, 4 ** -(i + 1) + 1e-14)

    def errors(self, name, counts):
        """Of each method by its title: how much farther and how much higher its cube is, for each number of iterations [m]."""
        off = self.said[name][1:]
        self.assertEqual(len(off), 2 * counts * len(self.said["titles"]))
        return {title: list(zip(off[2 * counts * i:2 * counts * (i + 1):2], off[2 * counts * i + 1:2 * counts * (i + 1):2])) for i, title in enumerate(self.said["titles"])}

    def test_a_sliding_cube_is_braked_by_coulombs_law_and_with_more_sweeps_impulses_come_to_it(self):
        t, dt = 0.1, 0.01
        self.assertAlmostEqual(self.said["methods"][0], t - 0.5 * 9.81 * 0.5 * t * (t + dt), 6)
        errors = self.errors("methods", 8)
        self.assertEqual(list(errors), ["sequential impulses", "soft step", "convex relaxation", "XPBD", "AVBD", "barrier"])
        size = {title: [math.hypot(*pair) for pair in off] for title, off in errors.items()}
        self.assertLess(size["sequential impulses"][7], 1e-6)
        self.assertLess(size["AVBD"][7], size["AVBD"][3])
        self.assertAlmostEqual(size["convex relaxation"][5], size["convex relaxation"][7], 9)  # converged, and elsewhere

    def test_without_friction_no_method_brakes_the_cube(self):
        self.assertAlmostEqual(self.said["smooth"][0], 0.1, 12)
        for title, off in self.errors("smooth", 4).items():
            self.assertTrue(all(abs(along) < 1e-6 for along, _ in off), title)

    def test_the_cube_keeps_its_speed_with_chapter_6_and_stops_with_chapter_5(self):
        self.assertAlmostEqual(self.said["six"][-1][1], 1.5, 2)
        self.assertLess(self.said["five"][-1][1], 0.5)


if __name__ == "__main__":
    unittest.main()
