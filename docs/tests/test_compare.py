"""The comparison of two runs, on small tables."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[1] / "tools/compare_results.py"


class CompareResults(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.before, self.after = (Path(scratch.name) / side for side in ("before", "after"))
        for side in (self.before, self.after):
            self.write(side, "fall.csv", "time_s,x\n0,100\n1,-1e-9\n")
            self.write(side, "facts_fall.csv", "name,value,text\ndepth,0.002,2 mm\nway,,down\nreal_time_factor,3,3\n")

    def write(self, side, name, text):
        (side / "01_a").mkdir(parents=True, exist_ok=True)
        (side / "01_a" / name).write_text(text)

    def compare(self, *words):
        done = subprocess.run([sys.executable, SCRIPT, self.before, self.after, *words], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def test_the_same_tables_are_the_same(self):
        self.assertEqual(self.compare(), (0, "2 tables compared: all the same\n"))

    def test_a_number_is_measured_by_its_column(self):
        self.write(self.after, "fall.csv", "time_s,x\n0,101\n1,-2e-9\n")
        code, said = self.compare()
        self.assertEqual(code, 1)
        self.assertIn("01_a/fall.csv: 2 of 4 cells differ, most by 1.0e-02 of its scale (row 1, x: 100, then 101)", said)
        self.assertIn("01_a/fall.csv: 1 of 4", self.compare("--tolerance", "1e-10")[1])
        self.assertEqual(self.compare("--tolerance", "0.02")[0], 0)

    def test_a_fact_is_measured_by_itself_and_a_word_by_nothing(self):
        self.write(self.after, "facts_fall.csv", "name,value,text\ndepth,0.003,3 mm\nway,,down\nreal_time_factor,3,3\n")
        self.assertIn("most by 5.0e-01 of its scale (row depth, is: 0.002, then 0.003)", self.compare()[1])
        self.write(self.after, "facts_fall.csv", "name,value,text\ndepth,0.002,2 mm\nway,,up\nreal_time_factor,3,3\n")
        self.assertIn("1 of 2 cells differ (row way, is: down, then up)", self.compare("--tolerance", "9")[1])

    def test_what_a_clock_measured_is_not_compared(self):
        self.write(self.after, "facts_fall.csv", "name,value,text\ndepth,0.002,2 mm\nway,,down\nreal_time_factor,9,9\n")
        for side, milliseconds in ((self.before, 1), (self.after, 2)):
            self.write(side, "cost.csv", f"pairs,step [ms]\n7,{milliseconds}\n")
            self.write(side, "bunny_passes.csv", f"pass,share\ndetect,{milliseconds}\n")
        self.assertEqual(self.compare()[0], 0)

    def test_a_row_or_a_table_that_is_missing_is_a_difference(self):
        self.write(self.after, "fall.csv", "time_s,x\n0,100\n")
        self.assertIn("2 of 4 cells differ (row 2, time_s: 1, then nothing)", self.compare()[1])
        (self.after / "01_a/fall.csv").unlink()
        code, said = self.compare()
        self.assertEqual(code, 1)
        self.assertIn(f"01_a/fall.csv: only in {self.before}", said)

    def test_an_empty_folder_is_an_error(self):
        self.after = self.after / "none"
        self.assertEqual(self.compare()[0], 2)


if __name__ == "__main__":
    unittest.main()
