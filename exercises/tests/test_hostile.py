"""Answers that mean harm, or are careless: each is judged to its end, none passes, none writes anything."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import honest  # noqa: E402
import judge  # noqa: E402
import sandbox  # noqa: E402
import workshop  # noqa: E402

COMPILER = shutil.which("g++")
CHECK = """#include <doctest/doctest.h>
double speed(double t);
TEST_CASE("speed: doubles") { CHECK(speed(2) == 2 * speed(1)); }
TEST_CASE("speed: of the earth") { CHECK(speed(1) == 9.81); }
"""
RIGHT = "double speed(double t) { return 9.81 * t; }\n"
PATTERN = "CMakeFiles/exercise_01_2.dir/exercises/01_fall/2_fall.cpp.o"
CHECKS = "CMakeFiles/check_01_2.dir/exercises/01_fall/2_fall.check.cpp.o"
FORGED = '''#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>
struct Forger {
    Forger()
    {
        std::ifstream file("/proc/self/cmdline");
        std::string line((std::istreambuf_iterator<char>(file)), {}), secret;
        std::ifstream("/dev/stdin") >> secret;
        std::ofstream report(line.substr(line.find("--out=") + 6).c_str());
        report << "<doctest><TestCase name=\\"a\\"/><TestCase name=\\"b\\"/></doctest>" << secret << std::flush;
        _exit(0);
    }
} forger __attribute__((init_priority(101)));
double speed(double) { return 0; }
'''


def commands(root):
    """What ninja would say: the words that make the answer's object, and the check's program."""
    return {PATTERN: (COMPILER, "-std=c++20", f"-I{root}", "-MD", "-MT", PATTERN, "-MF", f"{PATTERN}.d", "-o", PATTERN, "-c", f"{root}/exercises/01_fall/2_fall.cpp"),
            CHECKS: (COMPILER, "-std=c++20", "-o", CHECKS, "-c", f"{root}/exercises/01_fall/2_fall.check.cpp"),
            "bin/exercise_01_2": (COMPILER, CHECKS, honest.JUDGED_MAIN, PATTERN, "-o", "bin/exercise_01_2")}


@unittest.skipUnless(COMPILER, "needs g++")
class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = Path(tempfile.mkdtemp(prefix="a course's root ")).resolve()
        cls.addClassCleanup(shutil.rmtree, cls.root)
        for name, text in (("exercises/01_fall/2_fall.check.cpp", CHECK), ("solutions/01_fall/2_fall.cpp", RIGHT)):
            (cls.root / name).parent.mkdir(parents=True)
            (cls.root / name).write_text(text, encoding="utf-8")
        cls.build = cls.root / "build"
        for source, out in ((cls.root / "exercises/01_fall/2_fall.check.cpp", CHECKS), (HERE.parent / "judged_main.cpp", honest.JUDGED_MAIN)):
            (cls.build / out).parent.mkdir(parents=True)
            subprocess.run([COMPILER, "-std=c++20", "-c", source, "-o", cls.build / out], check=True)
        for place, name, value in ((workshop, "ROOT", cls.root), (honest, "ROOT", cls.root), (judge, "ROOT", cls.root), (workshop, "BUILD", cls.build),
                                   (workshop, "last_command", commands(cls.root).get)):
            patch = mock.patch.object(place, name, value)
            patch.start()
            cls.addClassCleanup(patch.stop)
        honest.names_around.cache_clear()
        cls.addClassCleanup(honest.names_around.cache_clear)
        cls.exercise = SimpleNamespace(number="1.2", target="01_2", chapter="01_fall", name="2_fall", kind="extend", tests=[], missing=["speed"], hidden=None,
                                       stub=cls.root / "exercises/01_fall/2_fall.cpp", check=cls.root / "exercises/01_fall/2_fall.check.cpp",
                                       source=cls.root / "solutions/01_fall/2_fall.cpp")

    def judged(self, text, student="Ada"):
        """@return the outcome of a text, in the folder of a student"""
        folder = Path(tempfile.mkdtemp(dir=self.root)) / student
        folder.mkdir()
        source = folder / "2_fall.cpp"
        source.write_bytes(text if isinstance(text, bytes) else text.encode())
        before = Path.cwd()
        os.chdir(folder)
        self.addCleanup(os.chdir, before)
        outcome = judge.judge(self.exercise, source, Path(tempfile.mkdtemp(dir=self.root)))
        self.assertEqual([file.name for file in folder.iterdir()], ["2_fall.cpp"])
        return outcome

    def refused(self, text, state, words):
        outcome = self.judged(text)
        self.assertEqual(outcome.state, state, outcome.message)
        self.assertIn(words, outcome.message)

    def test_folders_may_have_any_name(self):
        for student in ("x';touch pwned;echo '", "O'Brien", "Jörg Müller", '$(touch pwned) "quoted" & more', "-o", "a\nb"):
            with self.subTest(student):
                outcome = self.judged(RIGHT, student)
                self.assertEqual((outcome.state, outcome.cases), ("passed", 2), outcome.message)

    def test_latin_1_is_judged_and_its_errors_are_told(self):
        self.assertEqual(self.judged(RIGHT.encode() + "// Größe\n".encode("latin-1")).state, "passed")
        self.refused("double speed(double) { return größe; }".encode("latin-1"), "does_not_compile", "2_fall.cpp:1: ")

    def test_utf_16_and_what_is_no_text_are_told(self):
        self.refused(RIGHT.encode("utf-16"), "does_not_compile", "UTF-8")
        self.refused(b"\x7fELF\0\0\0", "does_not_compile", "no text")
        self.refused(b"/" * (honest.LONGEST + 1), "does_not_compile", "at most 1 MB")

    def test_a_byte_order_mark_is_no_mistake(self):
        self.assertEqual(self.judged(b"\xef\xbb\xbf" + RIGHT.encode()).state, "passed")

    def test_including_the_solution_is_found(self):
        for name in (f"{self.root}/solutions/01_fall/2_fall.cpp", "solutions/01_fall/2_fall.cpp"):
            self.refused(f'#include "{name}"\n', "includes_solution", "solutions/01_fall/2_fall.cpp")

    def test_including_the_check_is_found(self):
        self.refused(f'#include "exercises/01_fall/2_fall.check.cpp"\n{RIGHT}', "includes_solution", "2_fall.check.cpp")

    def test_a_hidden_check_judges_in_the_place_of_the_published_one(self):
        hidden = Path(tempfile.mkdtemp()) / "2_fall.check.cpp"
        self.addCleanup(shutil.rmtree, hidden.parent)
        hidden.write_text(CHECK.replace("9.81", "1.62"), encoding="utf-8")
        exercise = SimpleNamespace(**vars(self.exercise) | {"hidden": hidden, "check": hidden, "published_check": self.exercise.check})
        with mock.patch.object(self, "exercise", exercise), mock.patch.object(workshop, "WORK", hidden.parent / "work"):
            outcome = self.judged(RIGHT)
            self.assertEqual(outcome.failed_cases, ["speed: of the earth"], outcome)
            self.assertEqual(self.judged(RIGHT.replace("9.81", "1.62")).state, "passed")

    def test_a_report_of_its_own_does_not_pass(self):
        self.refused(FORGED, "crashed", "No verdict")

    def test_leaving_early_does_not_pass(self):
        self.refused("#include <cstdlib>\ndouble speed(double) { std::exit(0); }\n", "crashed", "exit()")

    def test_properties_of_its_own_do_not_count(self):
        self.refused(f'#include <doctest/doctest.h>\nTEST_CASE("mine") {{}}\n{RIGHT}', "crashed", "of the 2 properties it reports 3")

    def test_a_name_of_c_or_of_the_check_is_refused(self):
        self.refused(RIGHT + 'extern "C" double sqrt(double) { return 0; }\n', "does_not_compile", "defines sqrt")
        self.refused(RIGHT + "namespace doctest { bool is_running_in_test; }\n", "does_not_compile", "defines doctest::is_running_in_test")

    def test_a_compiler_without_end_is_stopped(self):
        with mock.patch.object(workshop, "TOOLS", sandbox.Limits(seconds=1)), mock.patch.object(sandbox, "GRACE", 0.5):
            self.refused('#include "/dev/zero"\n', "does_not_compile", "")

    @unittest.skipUnless(sandbox.sandbox_works(), "bubblewrap cannot run here")
    def test_a_program_writes_nothing_beside_itself(self):
        target = self.root / "pwned"
        self.judged(f'#include <cstdlib>\ndouble speed(double) {{ return std::system("touch \'{target}\'"); }}\n')
        self.assertFalse(target.exists())


if __name__ == "__main__":
    unittest.main()
