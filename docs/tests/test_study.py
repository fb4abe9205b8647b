"""./course study: what its file may say; each run once, also after a stop; one table with all digits, in order."""
import csv
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOLVERS = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin/solvers"
STUDY = ROOT / "cmake/study.py"
GOOD = {"scenes": ["common/scenes/falling_sphere.json"], "solvers": [6, 9], "vary": {"/bodies/ball/velocity": [[0, 0, 0], [0, -2, 0]], "/duration": [0.1]},
        "keep": {"energy_j": "last energy.total_j", "deepest_m": "most penetration.depth_max_m"}}


class Studies(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="enduring study ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, study, program=SOLVERS):
        file = self.folder / "trial.json"
        file.write_text(study if isinstance(study, str) else json.dumps(study), encoding="utf-8")
        return subprocess.run([sys.executable, STUDY, "write", file, self.folder / "out", "--program", program], capture_output=True,
                              text=True, check=False)

    def test_a_mistake_ends_with_2_and_names_its_place(self):
        for change, said in (({"scenes": ["no.json"]}, "/scenes: there is no file no.json"), ({"solver": [8]}, "not solver"), ({"solvers": [99]}, "/solvers: "),
                             ({"vary": {"dt": [1]}}, "/vary: "), ({"vary": {"/dt": 1}}, "/vary: "),
                             ({"vary": {"/bodies/none/mass": [1]}}, "no place /bodies/none/mass"),
                             ({"keep": {"e": "mean energy.total_j"}}, "/keep/e: "), ({"keep": {}}, "are needed")):
            with self.subTest(said):
                done = self.write(GOOD | change, "/bin/true")
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("trial.json: ", done.stderr)
                self.assertIn(said, done.stderr)
        self.assertEqual(self.write("{").returncode, 2)

    def test_each_scene_runs_with_each_solver_and_each_choice(self):
        self.assertEqual(self.write(GOOD, "/bin/true").returncode, 0)
        runs = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((self.folder / "out/runs").glob("*/run.json"))]
        self.assertEqual([(run["solver"], run["vary"]["/bodies/ball/velocity"][1]) for run in runs], [(6, 0), (6, -2), (9, 0), (9, -2)])
        scene = json.loads((self.folder / "out/runs/00002/falling_sphere.json").read_text(encoding="utf-8"))
        self.assertEqual((scene["bodies"][0]["velocity"], scene["duration"]), ([0, -2, 0], 0.1))

    def snakemake(self):
        return subprocess.Popen(["snakemake", "--directory", self.folder / "out", "--snakefile", self.folder / "out/Snakefile", "--cores", "2",
                                 "--keep-going", "--ignore-incomplete", "--nolock", "--quiet"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                start_new_session=True, env=os.environ | {"XDG_CACHE_HOME": str(self.folder / "cache")})

    @unittest.skipUnless(shutil.which("snakemake"), "needs snakemake (./course setup study)")
    @unittest.skipUnless(SOLVERS.is_file(), "needs the program solvers")
    def test_a_study_that_was_killed_makes_only_what_is_missing_and_its_table_has_each_run(self):
        self.assertEqual(self.write(GOOD).returncode, 0)
        first = self.snakemake()
        rows = lambda: sorted((self.folder / "out/runs").glob("*/row.json"))
        for _ in range(6000):
            if rows() or first.poll() is not None:
                break
            time.sleep(0.01)
        os.killpg(first.pid, signal.SIGKILL)
        first.communicate()
        made = {path: path.stat().st_mtime_ns for path in rows()}
        self.assertTrue(0 < len(made) < 4, len(made))

        second = self.snakemake()
        said = second.communicate()[0].decode()
        self.assertEqual(second.returncode, 0, said)
        self.assertEqual({path: path.stat().st_mtime_ns for path in made}, made)
        with (self.folder / "out/table.csv").open(encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        self.assertEqual([(row["run"], row["solver"]) for row in table], [("00001", "6"), ("00002", "6"), ("00003", "9"), ("00004", "9")])
        # a ball that falls freely keeps its energy; thrown down at 2 m/s it has m v^2 / 2 more
        energies = [float(row["energy_j"]) for row in table]
        mass = 2 * (energies[1] - energies[0]) / 2 ** 2
        ball = 50 * 4 / 3 * math.pi * 0.25 ** 3  # of triangles, so a little less
        self.assertTrue(0.9 * ball < mass < ball, mass)
        self.assertAlmostEqual(energies[0], energies[2], delta=1e-9 * abs(energies[0]))
        with (self.folder / "out/runs/00001/results/energy.csv").open(encoding="utf-8") as file:
            self.assertEqual(list(csv.DictReader(file))[-1]["total_j"], table[0]["energy_j"])
        self.assertEqual([row["failed"] for row in table], [""] * 4)


if __name__ == "__main__":
    unittest.main()
