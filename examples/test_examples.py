"""The examples as another project meets them: what they print, and that it can use the layers in both ways that CMake has.
usage: test_examples.py BUILD   a finished build of the course (cmake --preset release)"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(sys.argv.pop(1)).resolve()
OUTSIDE = ROOT / "examples/outside"


def said(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


class Drop(unittest.TestCase):
    def test_the_ball_falls_by_the_law_of_free_fall_and_then_stays_above_the_ground_but_for_millimetres(self):
        rows = [tuple(map(float, row)) for row in re.findall(r"^(\S+) s: (\S+) m, (\d+) contacts$", said(BUILD / "bin/drop"), re.M)]
        self.assertEqual(len(rows), 200)
        for step, (time, height, contacts) in enumerate(rows, 1):
            self.assertAlmostEqual(time, 0.005 * step, 9)
            fallen = 0.75 - 9.81 * 0.005**2 * step * (step + 1) / 2  # its lowest point; it turns, and is no perfect ball
            if contacts == 0 and fallen > 0:
                self.assertAlmostEqual(height, fallen, delta=0.01)
        self.assertTrue(any(contacts for _, _, contacts in rows))
        self.assertGreater(min(height for _, height, _ in rows), -0.001)


class OneFile(unittest.TestCase):
    """examples/chapter01.cpp: no build system, no header of the course."""

    def test_a_compiler_makes_a_picture_of_it(self):
        source = ROOT / "examples/chapter01.cpp"
        self.assertLess(len(source.read_text(encoding="utf-8").splitlines()), 100)
        with tempfile.TemporaryDirectory() as folder:
            said("g++", "-O2", "-Wall", "-Wextra", "-Werror", source, "-o", f"{folder}/a.out")
            text = subprocess.run(["./a.out"], cwd=folder, capture_output=True, text=True, check=True).stdout
            kept = {name: list(map(int, re.findall(r"(\d+) %", rest))) for name, rest in re.findall(r"^(\w+) *: a bounce keeps(.*)$", text, re.M)}
            picture = Path(folder, "drop.svg").read_text(encoding="utf-8")
        self.assertEqual(picture, (ROOT / "renders/examples/chapter01.svg").read_text(encoding="utf-8"))
        svg = ElementTree.fromstring(picture)
        self.assertTrue(all(100 > more > less for more, less in zip(kept["continuous"], kept["discrete"], strict=True)), kept)
        lines = [[tuple(map(float, point.split(","))) for point in line.get("points").split()] for line in svg.iter("{http://www.w3.org/2000/svg}polyline")]
        self.assertEqual([len(line) for line in lines], [501, 501])
        for line in lines:  # free fall at first: 200 px for a metre
            for step, (_, y) in enumerate(line[:40], 1):
                self.assertAlmostEqual(y, 250 - 200 * (1 - 9.81 * 0.01**2 * step * (step + 1) / 2), delta=0.06)


class Forces(unittest.TestCase):
    def test_each_body_is_carried_by_its_weight_and_the_pairs_and_vertices_of_the_box_say_the_same(self):
        text = said(BUILD / "bin/forces")
        bodies = {name: tuple(map(float, numbers)) for name, *numbers in re.findall(r"^(\w+) of (\S+) kg: (\S+) N up$", text, re.M)}
        self.assertEqual(set(bodies), {"table", "box"})
        for mass, up in bodies.values():
            self.assertAlmostEqual(up, 9.81 * mass, delta=1e-3 * 9.81 * mass)
        up = bodies["box"][1]
        vertices = [list(map(float, numbers)) for numbers in re.findall(r"^box vertex: (\S+) (\S+) (\S+) N$", text, re.M)]
        self.assertEqual(len(vertices), 8)
        self.assertAlmostEqual(sum(y for _, y, _ in vertices), up, delta=0.01)
        pairs = re.findall(r"^(\w+) on (\w+): (\S+) N along", text, re.M)
        self.assertAlmostEqual(sum(float(force) for b, a, force in pairs if {a, b} == {"box", "table"}), up, delta=0.01)


class FromOutside(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self.scratch.name)
        self.addCleanup(self.scratch.cleanup)

    def configure(self, *options):
        said("cmake", "-G", "Ninja", "-S", OUTSIDE, "-B", self.folder / "build", *options)

    def test_an_installed_course_is_found_and_the_same_bytes_come_out(self):
        said("cmake", "--install", BUILD, "--prefix", self.folder / "prefix")
        self.configure(f"-DCMAKE_PREFIX_PATH={self.folder / 'prefix'}")
        said("cmake", "--build", self.folder / "build")
        for program in ("drop", "forces"):
            self.assertEqual(said(self.folder / "build" / program), said(BUILD / "bin" / program))
        installed = {path.name for path in (self.folder / "prefix").rglob("*") if path.is_file()}
        self.assertIn("friction_law.hpp", installed)
        self.assertFalse({"chapter_program.hpp", "main.cpp", "chapter10", "drop", "libenduring_render.a"} & installed)

    def test_a_course_that_is_added_brings_its_layers_and_nothing_of_its_own_habits(self):
        self.configure(f"-DENDURING_SOURCE={ROOT}")
        ninja = ("ninja", "-C", self.folder / "build")
        commands = said(*ninja, "-t", "commands", "drop")
        for theirs in ("-Werror", "-Wall", "-Wconversion", "-O3", "doctest", "OSMesa", "benchmark"):
            self.assertNotIn(theirs, commands)
        self.assertIn("-ffp-contract=off", commands)
        self.assertEqual(len(re.findall(r"-std=(c|gnu)\+\+20 ", commands)), commands.count(" -c "))
        targets = said(*ninja, "-t", "targets", "all")
        self.assertIn("libchapter10_layer.a:", targets)
        for ours in ("test_", "bench_", "exercise_", "render", "chapter10_experiments"):
            self.assertNotRegex(targets, rf"(?m)^(\S*/)?(lib)?{ours}\S*: (?!phony)")
        # One object of its own and one library of ours: the others compile alike, and drop is linked above.
        said(*ninja, "CMakeFiles/drop.dir" + str(ROOT / "examples/drop.cpp") + ".o", "enduring/libenduring_input.a")


if __name__ == "__main__":
    unittest.main()
