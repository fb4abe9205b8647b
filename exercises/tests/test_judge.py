"""The judge: what came of an answer, and how a compiler's errors are told."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import compiler_errors  # noqa: E402
import honest  # noqa: E402
import judge  # noqa: E402

COMPILER = shutil.which("g++")
EIGEN = "/usr/include/eigen3"


@unittest.skipUnless(COMPILER, "needs g++")
class Judging(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.program = cls.folder / "cases"
        subprocess.run([COMPILER, "-std=c++20", "-O1", "-D_GLIBCXX_ASSERTIONS", f"-I{HERE.parents[1]}", "-isystem", EIGEN,
                        HERE / "cases.cpp", "-o", cls.program], check=True)

    def run_case(self, name, seconds=20, expected=1):
        return judge.run_cases(self.program, [f"--test-case={name}"], seconds, expected)

    def the_failure(self, name):
        outcome = self.run_case(name)
        self.assertEqual((outcome.state, outcome.cases, outcome.failed_cases), ("failed", 1, [name]))
        return outcome.failures[0]

    def test_a_right_answer_passes_and_what_it_says_is_kept(self):
        outcome = self.run_case("right")
        self.assertEqual((outcome.state, outcome.cases, outcome.said), ("passed", 1, "speed 9.81 m/s\n"))

    def test_a_wrong_number_is_told_with_its_input_and_its_unit(self):
        failure = self.the_failure("wrong number")
        self.assertEqual((failure.given, failure.message), (["t = 2 s"], "speed: expected 9.81 m/s, got -9.81 m/s"))

    def test_a_wrong_vector_is_told_in_brackets(self):
        self.assertEqual(self.the_failure("wrong vector").message, "push: expected (1, 2, 4) N s, got (1, 2, 3) N s")

    def test_the_digits_that_differ_are_told(self):
        self.assertEqual(self.the_failure("close number").message, "speed: expected 0.9 m/s, got 0.900000003 m/s")
        self.assertEqual(self.the_failure("close vector").message, "push: expected (1, 2, 3) N s, got (1, 2, 3.00000001) N s")

    def test_not_a_number_is_never_right(self):
        self.assertIn("got nan m/s", self.the_failure("not a number").message)

    def test_a_wrong_sentence_is_told(self):
        self.assertEqual(self.the_failure("wrong sentence").message, "this should hold: the sun rises")

    def test_a_plain_check_is_told_as_doctest_expands_it(self):
        self.assertEqual(self.the_failure("plain check").message, "expected 1 + 1 == 3, got 2 == 3")

    def test_an_exception_fails_and_is_told(self):
        self.assertIn("out of paper", self.the_failure("throws").message)

    def test_an_untouched_stub_is_no_failure_of_the_student(self):
        self.assertEqual(self.run_case("untouched").state, "untouched")

    def test_one_written_function_of_two_is_an_attempt(self):
        outcome = self.run_case("untouched,right", expected=2)
        self.assertEqual((outcome.state, outcome.failed_cases), ("failed", ["untouched"]))

    def test_a_loop_without_end_is_stopped(self):
        outcome = self.run_case("loop", seconds=2)
        self.assertEqual(outcome.state, "too_long")
        self.assertRegex(outcome.message, "Stopped after 2 s.*checking: loop")

    def test_a_crash_says_where(self):
        outcome = self.run_case("index")
        self.assertEqual(outcome.state, "crashed")
        self.assertRegex(outcome.message, r"past the end of a container: at stl_vector.h:\d+ this should hold: __n < this->size\(\).*checking: index")

    def test_an_endless_recursion_is_a_crash(self):
        outcome = self.run_case("recursion")
        self.assertEqual(outcome.state, "crashed")
        self.assertIn("calls itself without end", outcome.message)

    def test_a_program_that_leaves_early_is_told_so(self):
        self.assertIn("exit()", self.run_case("leaves").message)

    def test_a_report_of_its_own_is_no_verdict(self):
        self.assertEqual(self.run_case("forges").state, "crashed")
        self.assertEqual(self.run_case("forges and goes on").state, "crashed")

    def test_a_property_more_or_less_is_no_verdict(self):
        for expected in (0, 2):
            outcome = self.run_case("right", expected=expected)
            self.assertEqual(outcome.state, "crashed")
            self.assertIn(f"of the {expected} properties it reports 1", outcome.message)

    def test_a_text_among_the_inputs_stays_a_text(self):
        self.assertEqual(self.the_failure("chosen text").given, ["a plate, flat"])


@unittest.skipUnless(COMPILER, "needs g++")
class CompilersErrors(unittest.TestCase):
    def told(self, text):
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        source = folder / "mine.cpp"
        source.write_text(text)
        done = subprocess.run([COMPILER, "-std=c++20", "-c", source, "-o", "/dev/null"],
                              capture_output=True, text=True)
        return compiler_errors.readable(done.stderr, source).splitlines()

    def test_the_line_and_a_mark_below_it(self):
        first, line, mark = self.told("int main()\n{\n    return mien;\n}\n")
        self.assertRegex(first, r"mine.cpp:3: .*mien.* was not declared")
        self.assertEqual((line, mark.index("^")), ("        return mien;", line.index("mien")))

    def test_an_error_inside_a_header_is_told_where_the_student_caused_it(self):
        told = self.told("#include <map>\nstruct Key {};\nint main()\n{\n    std::map<Key, int> all;\n    all[Key{}] = 1;\n}\n")
        self.assertRegex(told[0], r"mine.cpp:6: ")
        self.assertLessEqual(len(told), 10)

    def test_a_line_that_the_file_does_not_have(self):
        self.assertIn("mine.cpp:900: ", self.told("#line 900\nint a = b;\n")[0])

    def test_only_the_first_errors_are_shown(self):
        told = self.told("".join(f"int a{i} = b{i};\n" for i in range(9)))
        self.assertEqual(len(told), 3 * compiler_errors.MOST + 1)
        self.assertIn("6 more", told[-1])

    def test_what_the_linker_missed_is_named(self):
        self.assertEqual(honest.link_errors("x.o: undefined reference to `enduring::speed(double)'\n"),
                         "Your file should define enduring::speed(double); its name, its arguments or its namespace differ.")


if __name__ == "__main__":
    unittest.main()
