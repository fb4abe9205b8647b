"""Runs experiments beside each other on all cores, by ninja: one edge for each experiment, or for each part of a large one.

    run_beside.py --results DIR --release DIR --jobs N [--full] [--again] [--book] FOLDER[/EXPERIMENT]...

Programs are compiled in the order of the folders, and an experiment begins when its program is there. What one of them fails to do
stops no other. What was finished is not run again, unless the program or what it reads has changed; with --again it is, if all of it
was finished. What measures time runs at the end, and nothing beside it. In DIR/.runs lie the graph, logs, stamps and seconds.
Exit status: 0; 1 when something failed, which is named; 2 for a name that does not exist.
"""
import argparse
import hashlib
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import experiments
import run_one
from experiments import ROOT

FIRST = "01_particle_plane"  # its pictures come first: its program is the smallest
PICTURE = "first_picture"     # a program of one of its experiments, which is compiled in a quarter of the time


def arguments():
    parser = argparse.ArgumentParser(prog="run_beside.py")
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--release", type=Path, required=True)
    parser.add_argument("--jobs", type=int, required=True)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--book", action="store_true", help="the book follows: count it in")
    parser.add_argument("names", nargs="+")
    options = parser.parse_args()
    options.release = options.release.resolve()  # edges run elsewhere
    return options


def chosen(names):
    """{folder: its experiments that are asked for}, a first picture's folder first."""
    found = {}
    for name in names:
        folder, _, experiment = name.partition("/")
        known = list(experiments.experiments_of(folder))
        if experiment and experiment not in known:
            raise SystemExit(2)
        found.setdefault(folder, []).extend([experiment] if experiment else known)
    return dict(sorted(found.items(), key=lambda item: item[0] != FIRST))


# -------------------------------------------------------------------------------------------------------------- the plan
def plan_of(options, wanted):
    """All edges, each with its command and about how long it takes."""
    runs, program_folder = options.results.resolve() / ".runs", options.release / "bin"
    costs, builds = experiments.costs()
    edges = {}
    for folder, names in wanted.items():
        program = program_folder / experiments.program_of(folder)
        if folder == FIRST and not program.is_file():
            edges[f"build {PICTURE}"] = edge_of_build(options, program_folder / PICTURE, builds)
            edges[PICTURE] = {"kind": "picture", "alone": False, "seconds": 1, "needs": [f"build {PICTURE}"], "says": "a first picture",
                              "out": str(options.results.resolve() / folder),
                              "command": [str(program_folder / PICTURE), "--out", str(options.results.resolve() / folder)]}
        edges[f"build {program.name}"] = edge_of_build(options, program, builds)
        if folder == FIRST and PICTURE in edges:
            edges[f"build {program.name}"]["needs"] = [f"build {PICTURE}"]  # a ninja of 1.12 or later begins what has most behind it
        edges[f"cause/{folder}"] = {"kind": "cause", "alone": False, "seconds": 0, "folder": folder, "program": str(program),
                                    "needs": [f"build {program.name}"]}
        for name in names:
            edges.update(edges_of_run(options, runs, folder, name, costs.get((folder, name), experiments.Cost())))
    return {"runs": str(runs), "jobs": options.jobs, "then": builds.get("book", 60) if options.book else 0, "edges": edges}


def edge_of_build(options, program, builds):
    return {"kind": "build", "alone": False, "seconds": 1 if program.is_file() else builds.get(program.name, 60) / options.jobs,
            "command": ["cmake", "--build", str(options.release), "--parallel", str(options.jobs), "--target", program.name]}


def edges_of_run(options, runs, folder, name, cost):
    """An experiment: one edge, or an edge for each part and one that joins them."""
    out = options.results.resolve() / folder
    parts = cost.parts if options.full else 1
    kept = str(runs / "parts" / folder / name) if parts > 1 else ""
    command = [str(options.release / "bin" / experiments.program_of(folder)), name, "--out", str(out)] + ([] if options.full else ["--quick"])
    common = {"kind": "run", "alone": cost.alone, "out": str(out), "cause": f"cause/{folder}", "parts": kept, "folder": folder}
    says = f"{'the base' if folder == '00_base' else 'chapter ' + folder[1:2] if folder[0] == '0' else folder}, {name}"
    shares = {f"done/{folder}/{name}.{part}of{parts}": common | {
        "part": True, "seconds": cost.seconds(options.full) / parts, "needs": [], "says": f"{says}, part {part} of {parts}",
        "command": [*command, "--parts", kept, "--part", f"{part}/{parts}"]} for part in range(1, parts + 1) if parts > 1}
    whole = common | {"part": False, "seconds": 2 if shares else cost.seconds(options.full), "needs": list(shares), "says": says,
                      "command": command + (["--parts", kept] if shares else [])}
    return shares | {f"done/{folder}/{name}": whole}


# ------------------------------------------------------------------------------------------------------------- the graph
def escaped(text):
    return text.replace("$", "$$").replace(" ", "$ ").replace(":", "$:")


def quoted(path):
    return "'" + str(path).replace("'", "'\\''").replace("$", "$$") + "'"


def graph_of(plan, edges):
    """Some edges of the plan as ninja reads them, which begins with what stands first of all that is ready. What no edge makes is there.
    An edge takes the place of its shell, for that is what ninja waits for when it is stopped; and it hears of Ctrl-C when Python has loaded,
    which swallows it at times before."""
    command = f"exec env --block-signal=INT {quoted(sys.executable)} {quoted(ROOT / 'cmake/run_one.py')}"
    lines = ["ninja_required_version = 1.11", "pool compiling", "  depth = 1", "rule edge",
             f"  command = {command} {quoted(Path(plan['runs'], 'plan.json'))} '$name'",
             "build always: phony"]
    for name in edges:
        edge = plan["edges"][name]
        needs = [escaped(need) for need in ([edge["cause"]] if edge["kind"] == "run" else ["always"]) + edge.get("needs", [])]
        lines += [f"build {escaped(name)}: edge {' '.join(needs)}", f"  name = {name}"]
        lines += {"build": ["  pool = compiling"], "cause": ["  restat = 1"], "picture": [], "run": []}[edge["kind"]]
    return "\n".join(lines) + "\n"


def edges_in_order(plan, full):
    """(those that run beside each other, those that run alone): what is compiled first, then small runs as the chapters stand, and of
    full ones the longest first."""
    order = {"build": 0, "picture": 1, "cause": 1, "run": 2}
    names = sorted(plan["edges"], key=lambda name: (order[plan["edges"][name]["kind"]], -plan["edges"][name]["seconds"] if full else 0))
    return [name for name in names if not plan["edges"][name]["alone"]], [name for name in names if plan["edges"][name]["alone"]]


# --------------------------------------------------------------------------------------------------------------- running
def prepare(plan, again):
    """The folder of the graph, without what is asked for again or does not hold."""
    runs = Path(plan["runs"])
    for name in ("logs", "failed", "seconds", "cause", "done"):
        if name in ("failed", "seconds"):
            shutil.rmtree(runs / name, ignore_errors=True)
        (runs / name).mkdir(parents=True, exist_ok=True)
    results = {name: edge for name, edge in plan["edges"].items() if edge["kind"] == "run"}
    again = again and all(run_one.holds(plan, name) for name in results)
    for name, edge in results.items():
        stamp = runs / name
        stamp.parent.mkdir(parents=True, exist_ok=True)
        if again and edge["parts"]:
            shutil.rmtree(edge["parts"], ignore_errors=True)
        if stamp.is_file() and (again or not run_one.holds(plan, name)):
            stamp.unlink()
    (runs / "first_picture").unlink(missing_ok=True)
    (runs / "plan.json").write_text(json.dumps(plan, indent=1), encoding="utf-8")


def ninja(plan, which, edges, jobs):
    """Runs some edges; what ninja says itself goes to a log, for each edge tells of itself."""
    runs = Path(plan["runs"])
    graph, log = runs / f"{which}.ninja", runs / f"{which}.txt"
    graph.write_text(graph_of(plan, edges), encoding="utf-8")
    command = ["ninja", "--quiet", "-f", graph.name, "-k", "0", "-j", str(jobs)]
    told = os.dup(2)
    with log.open("wb") as out, subprocess.Popen(command, cwd=runs, stdout=out, stderr=subprocess.STDOUT, pass_fds=[told],
                                                 env=os.environ | {"ENDURING_TOLD": str(told)}) as running:
        try:
            code = running.wait()
        except KeyboardInterrupt:
            running.wait()  # it has heard of it as well, and ends what it runs
            sys.exit(130)
    os.close(told)
    if code and not any((runs / "failed").iterdir()):
        sys.stderr.write(log.read_text(encoding="utf-8", errors="replace")[-3000:])


def stamp_folders(plan, wanted):
    """Says who made a folder's results, where all of them are of one program: the book takes no others (docs/tools/checks.py)."""
    for folder in wanted:
        cause = plan["edges"][f"cause/{folder}"]
        out, program = Path(plan["runs"]).parent / folder, Path(cause["program"])
        like = {"cause": f"cause/{folder}", "out": str(out)}
        whole = {"runs": plan["runs"], "edges": {f"done/{folder}/{name}": like for name in experiments.experiments_of(folder)}}
        if program.is_file() and out.is_dir() and all(run_one.holds(whole, name) for name in whole["edges"]):
            maker = hashlib.sha256(program.read_bytes()).hexdigest() + "\n"
            if not (out / ".made_by").is_file() or (out / ".made_by").read_text(encoding="utf-8") != maker:
                (out / ".made_by").write_text(maker, encoding="utf-8")


def written_twice(plan, folder):
    """(file, two experiments) for each file of a folder that two of them have left: they may run at the same time, and so must not."""
    writers = {}
    for name in experiments.experiments_of(folder):
        stamp = Path(plan["runs"], "done", folder, name)
        for file in stamp.read_text(encoding="utf-8").splitlines()[1:] if stamp.is_file() else []:
            if file in writers:
                yield file, f"{writers[file]} and {name}"
            writers[file] = name


def keep_costs(plan):
    """What each took, in the form of the list of costs."""
    runs, lines = Path(plan["runs"]), []
    for file in sorted((runs / "seconds").iterdir()):
        lines.append(f"{file.name.removeprefix('done.').replace('.', ' ', 1)} {float(file.read_text(encoding='utf-8')):.1f}")
    if lines:
        (runs / "seconds.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    options, started = arguments(), time.monotonic()
    wanted = chosen(options.names)
    plan = plan_of(options, wanted)
    prepare(plan, options.again)
    seconds, left = run_one.estimate(plan)
    count = sum(edge["kind"] == "run" and not edge["part"] for edge in plan["edges"].values())
    if left:
        sys.stderr.write(f"   {count} experiments on {options.jobs} cores: about {run_one.in_words(seconds)}\n")
        sys.stderr.flush()
    beside, alone = edges_in_order(plan, options.full)
    ninja(plan, "beside", beside, options.jobs + 1)  # one for the compiler, which hands its jobs on
    failed = {file.name for file in Path(plan["runs"], "failed").iterdir()}
    alone = [name for name in alone if not failed & set(plan["edges"][plan["edges"][name]["cause"]]["needs"])]  # whose program is there
    if alone:
        ninja(plan, "alone", alone, 1)
    return report(plan, wanted, started)


def report(plan, wanted, started):
    """Stamps, seconds, and a last line; the exit status."""
    stamp_folders(plan, wanted)
    keep_costs(plan)
    for file in sorted(Path(plan["runs"], "failed").iterdir()):
        sys.stderr.write(f"   failed: {file.read_text(encoding='utf-8')}")
    twice = [f"{folder}/{file} is written by {both}" for folder in wanted for file, both in written_twice(plan, folder)]
    sys.stderr.writelines(f"   failed: {fault}, which may run at the same time\n" for fault in twice)
    missing = [name for name, edge in plan["edges"].items() if edge["kind"] == "run" and not run_one.holds(plan, name)]
    if not missing:
        sys.stderr.write(f"   all is there after {run_one.in_words(time.monotonic() - started)}\n")
    return 1 if missing or twice else 0


if __name__ == "__main__":
    sys.exit(main())
