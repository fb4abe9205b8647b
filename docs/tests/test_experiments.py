"""The list of experiments, which is read without a build, is what the programs say; each is in the list of costs; the graph for ninja."""
import argparse
import multiprocessing
import os
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin"
sys.path.insert(0, str(ROOT / "cmake"))
import experiments  # noqa: E402
import run_beside  # noqa: E402
import run_one  # noqa: E402


def options(full, jobs=2, results="/nowhere/results"):
    return argparse.Namespace(full=full, jobs=jobs, book=False, results=Path(results), release=Path("/nowhere/release"))


class Experiments(unittest.TestCase):
    def test_the_list_without_a_build_is_that_of_the_programs(self):
        compared = 0
        for folder in experiments.folders():
            program = PROGRAMS / experiments.program_of(folder)
            if program.is_file():
                compared += 1
                said = subprocess.run([program, "--list"], capture_output=True, text=True, encoding="utf-8", check=True).stdout
                self.assertEqual(experiments.listed(folder), said)
        if not compared:
            self.skipTest("no program is built")

    def test_the_list_of_costs_names_each_experiment_and_no_other(self):
        known = {(folder, name) for folder in experiments.folders() for name in experiments.experiments_of(folder)}
        of_runs, of_builds = experiments.costs()
        self.assertEqual(set(of_runs), known)
        self.assertEqual(set(of_builds), {experiments.program_of(folder) for folder in experiments.folders()} | {run_beside.PICTURE, "book"})

    def test_strings_are_joined_as_a_compiler_joins_them(self):
        self.assertEqual(experiments.joined('"with \\"and\\" "\n   "and more"'), 'with "and" and more')

    def test_a_line_of_the_list_of_costs_that_is_wrong_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "cmake").mkdir()
            for line in ("01_particle_plane drop 1 two 1", "01_particle_plane drop", "build chapter01"):
                (Path(folder) / experiments.COSTS).write_text("# a comment\n" + line + "\n", encoding="utf-8")
                with self.assertRaisesRegex(SystemExit, "experiments.txt:2: "):
                    experiments.costs(Path(folder))


class Graph(unittest.TestCase):
    def plan(self, full, folders=("08_contact_by_distance", "solvers"), jobs=2):
        return run_beside.plan_of(options(full, jobs), run_beside.chosen(folders))

    def test_a_large_experiment_comes_in_parts_that_are_joined_and_a_small_one_whole(self):
        parts = experiments.costs()[0]["08_contact_by_distance", "creep"].parts
        self.assertGreater(parts, 1)
        edges = {name: edge for name, edge in self.plan(True)["edges"].items() if "/creep" in name}
        self.assertEqual(len(edges), parts + 1)
        self.assertEqual(sorted(edges["done/08_contact_by_distance/creep"]["needs"]), sorted(name for name in edges if ".1" in name or "of" in name))
        self.assertEqual([name for name in self.plan(False)["edges"] if "/creep" in name], ["done/08_contact_by_distance/creep"])

    def test_the_commands_are_the_same_for_any_number_of_cores(self):
        of_runs = [[edge["command"] for edge in self.plan(True, jobs=jobs)["edges"].values() if edge["kind"] == "run"] for jobs in (1, 8)]
        self.assertEqual(*of_runs)

    def test_what_measures_time_runs_alone_and_the_longest_of_the_others_begins_first(self):
        plan = self.plan(True)
        beside, alone = run_beside.edges_in_order(plan, True)
        self.assertEqual(alone, ["done/solvers/sizes", "done/solvers/worst", "done/solvers/soft_speed", "done/solvers/speed"])
        runs = [plan["edges"][name]["seconds"] for name in beside if plan["edges"][name]["kind"] == "run"]
        self.assertEqual(runs, sorted(runs, reverse=True))

    def test_a_first_picture_is_compiled_first_and_small_runs_begin_in_the_order_of_the_chapters(self):
        plan = run_beside.plan_of(options(False), run_beside.chosen(experiments.folders()))
        beside, _ = run_beside.edges_in_order(plan, False)
        self.assertEqual(beside[:2], ["build first_picture", "build chapter01"])
        self.assertEqual(plan["edges"]["build chapter01"]["needs"], ["build first_picture"])
        self.assertEqual(next(name for name in beside if name.startswith("done/")), "done/01_particle_plane/two_looks")

    def test_two_experiments_that_write_one_file_are_told(self):
        with tempfile.TemporaryDirectory() as runs:
            done = Path(runs) / "done/01_particle_plane"
            done.mkdir(parents=True)
            (done / "drop").write_text("cause\ndrop.csv\nboth.csv\n", encoding="utf-8")
            (done / "ground").write_text("cause\nground.csv\nboth.csv\n", encoding="utf-8")
            self.assertEqual(list(run_beside.written_twice({"runs": runs}, "01_particle_plane")), [("both.csv", "drop and ground")])

    def test_the_rest_takes_as_long_as_its_longest_edge_or_as_all_on_all_cores(self):
        with tempfile.TemporaryDirectory() as runs:
            def plan(*seconds, jobs=2):
                edges = {f"done/x/{i}": {"kind": "run", "alone": False, "seconds": s, "cause": "cause/x", "out": runs} for i, s in enumerate(seconds)}
                return {"runs": runs, "jobs": jobs, "then": 5, "edges": edges}
            self.assertEqual(run_one.estimate(plan(10, 20, 30)), (30 + 5, 3))
            self.assertEqual(run_one.estimate(plan(10, 20, 60)), (60 + 5, 3))
            self.assertEqual(run_one.estimate(plan(40, 40, 40)), (60 + 5, 3))
            # a machine that is twice as slow as the list is believed the more the longer it has been so
            (Path(runs) / "seconds").mkdir()
            (Path(runs) / "seconds/done.x.0").write_text("600", encoding="utf-8")
            seconds, left = run_one.estimate(plan(300, 300))
            self.assertEqual(left, 1)
            self.assertGreater(seconds, 500)
            self.assertLess(seconds, 605)


def run_part(plan, name, begin):
    """One edge, in a process of its own, as ninja runs it: all of them begin together."""
    begin.wait()
    sys.exit(run_one.run(plan, name))


class Parts(unittest.TestCase):
    PARTS, ROUNDS = 20, 6  # without the lock the first or the second round fails

    def plan(self, folder, number):
        """An experiment in parts, each of which leaves one file."""
        runs, kept = Path(folder), Path(folder, "parts", str(number))
        for name in ("logs", "failed", "seconds", "done", "cause"):
            (runs / name).mkdir(exist_ok=True)
        (runs / "cause/chapter").write_text("a cause\n", encoding="utf-8")
        if number % 2:
            kept.mkdir(parents=True)
            (kept / "cause").write_text("another cause\n", encoding="utf-8")
            (kept / "left").touch()
        edge = {"kind": "run", "alone": False, "seconds": 1, "out": str(runs / "out"), "cause": "cause/chapter", "parts": str(kept), "part": True}
        names = [f"done/{number}.{part}of{self.PARTS}" for part in range(self.PARTS)]
        return {"runs": str(runs), "jobs": self.PARTS, "then": 0, "edges": {
            name: edge | {"says": name, "command": ["touch", str(kept / Path(name).name)]} for name in names}}

    def test_parts_that_begin_together_keep_what_each_other_finds_and_nothing_of_another_cause(self):
        processes = multiprocessing.get_context("fork")
        with tempfile.TemporaryDirectory() as folder, open(os.devnull, "w", encoding="utf-8") as nowhere:
            with unittest.mock.patch.dict(os.environ, {"ENDURING_TOLD": str(nowhere.fileno())}):
                for number in range(self.ROUNDS):
                    plan, begin = self.plan(folder, number), processes.Barrier(self.PARTS)
                    running = [processes.Process(target=run_part, args=(plan, name, begin)) for name in plan["edges"]]
                    for process in running:
                        process.start()
                    for process in running:
                        process.join()
                    self.assertEqual([process.exitcode for process in running], [0] * self.PARTS)
                    found = {path.name for path in Path(folder, "parts", str(number)).iterdir()}
                    self.assertEqual(found, {"cause"} | {Path(name).name for name in plan["edges"]})

    def test_what_another_run_takes_away_at_this_moment_does_not_hold(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(Path, "is_file", return_value=True):
            plan = self.plan(folder, 0)
            self.assertFalse(run_one.holds(plan, next(iter(plan["edges"]))))


if __name__ == "__main__":
    unittest.main()
