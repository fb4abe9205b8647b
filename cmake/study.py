"""`./course study FILE`: many runs of scenes, over solvers and numbers, as a workflow for Snakemake; their results in one table.

    study.py write FILE STUDY --program SOLVERS    makes the folder STUDY: a scene for each run, and the Snakefile
    study.py run STUDY RUN                         one run, and its row: what the Snakefile calls
    study.py join STUDY                            all rows, in order, as STUDY/table.csv

FILE is a JSON object:
    "scenes"   files, as seen from FILE's folder or from the course's
    "solvers"  the chapters whose solvers run them; the last one when left out
    "vary"     {"/path/in/the/scene": [values]}, as in a change of a scene (common/scenes/scene_format.md); {} when left out
    "keep"     {"column": "last TABLE.COLUMN"}, or first, least, most: one number of each run's tables
Every scene runs with every solver and every choice of values. A run that breaks keeps its row, and `failed` in it says why.
"""
import argparse
import csv
import itertools
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CHAPTERS = len(list(ROOT.glob("chapters/[0-9][0-9]_*/solver.hpp")))
KEYS = {"scenes", "solvers", "vary", "keep"}
CHOICES = {"first": lambda column: column[0], "last": lambda column: column[-1], "least": min, "most": max}
SNAKEFILE = '''# Written by ./course study from {file}. On the cores here: snakemake --cores all; on a cluster's queue, as
# snakemake --jobs 100 --cluster 'sbatch --cpus-per-task 1'. A run that was made is not made again; each file is there whole or not at
# all (--ignore-incomplete).
RUNS = {runs}

rule all:
    input: "table.csv"

rule run:
    input: "runs/{{run}}/run.json"
    output: "runs/{{run}}/row.json"
    shell: "{python} {script} run . {{wildcards.run}}"

rule table:
    input: expand("runs/{{run}}/row.json", run=RUNS)
    output: "table.csv"
    shell: "{python} {script} join ."
'''


def wrong(message):
    print(f"course: {message}", file=sys.stderr)
    sys.exit(2)


# ------------------------------------------------------------------------------------------------------------ the study
def read_study(file):
    """The study of a file, complete; exit status 2 and the place of a mistake otherwise."""
    try:
        study = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        wrong(f"{file}: {error}")
    if not isinstance(study, dict) or set(study) - KEYS:
        others = f", not {', '.join(sorted(set(study) - KEYS))}" if isinstance(study, dict) else ""
        wrong(f"{file}: an object with the keys {', '.join(sorted(KEYS))}{others}")
    study = {"solvers": [CHAPTERS], "vary": {}} | study
    if not study.get("scenes") or not study.get("keep"):
        wrong(f"{file}: scenes and keep are needed")
    for solver in study["solvers"]:
        if solver not in range(1, CHAPTERS + 1):
            wrong(f"{file}: /solvers: a chapter from 1 to {CHAPTERS}, and not {json.dumps(solver)}")
    for path, values in study["vary"].items():
        if not path.startswith("/") or not isinstance(values, list) or not values:
            wrong(f"{file}: /vary: a path that begins with / and a list of values, and not {json.dumps({path: values})}")
    for column, what in study["keep"].items():
        if not re.fullmatch(rf"({'|'.join(CHOICES)}) \w+\.\w+", str(what)):
            wrong(f"{file}: /keep/{column}: {', '.join(CHOICES)} and TABLE.COLUMN, as in \"last energy.total_j\", and not {json.dumps(what)}")
    study["scenes"] = [str(scene_file(file, name)) for name in study["scenes"]]
    return study


def scene_file(file, name):
    for folder in (file.resolve().parent, ROOT):
        if (folder / name).is_file():
            return folder / name
    return wrong(f"{file}: /scenes: there is no file {name}")


def set_at(document, path, value):
    """Puts a value at a path into a document; in a list, a part of the path is an index or the name of an entry.
    @throws KeyError  there is no such place"""
    *parts, last = path.strip("/").split("/")
    for part in parts:
        document = document[index_of(document, part)] if isinstance(document, list) else document.setdefault(part, {})
    document[index_of(document, last) if isinstance(document, list) else last] = value


def index_of(entries, part):
    for index, entry in enumerate(entries):
        if part == str(index) or (isinstance(entry, dict) and entry.get("name") == part):
            return index
    raise KeyError(part)


def all_runs(study):
    """(name, scene, solver, {path: value}) of each run, in order."""
    count = itertools.count(1)
    for scene, solver, values in itertools.product(study["scenes"], study["solvers"], itertools.product(*study["vary"].values())):
        yield f"{next(count):05d}", Path(scene), solver, dict(zip(study["vary"], values))


def write(file, folder, program):
    """The folder of a study. What stands there and has not changed keeps its time, so that its run holds."""
    study, names = read_study(file), []
    options = ["--quick"]  # no film
    if "--no-pictures" in subprocess.run([program, "--help"], capture_output=True, text=True, check=False).stdout:
        options.append("--no-pictures")
    for name, scene, solver, values in all_runs(study):
        place = folder / "runs" / name
        place.mkdir(parents=True, exist_ok=True)
        document = json.loads(scene.read_text(encoding="utf-8"))
        try:
            for path, value in values.items():
                set_at(document, path, value)
        except (KeyError, TypeError):
            wrong(f"{file}: /vary: {scene.name} has no place {path}")
        for mesh in re.findall(r'"file": "([^"]+)"', json.dumps(document)):
            if (scene.parent / mesh).is_file() and not (place / mesh).is_file():
                shutil.copy(scene.parent / mesh, place / mesh)
        write_if_new(place / scene.name, json.dumps(document, indent=1))
        command = [str(program), "--scene", scene.name, "--solver", str(solver), "--out", "results", *options]
        write_if_new(place / "run.json", json.dumps({"scene": scene.name, "solver": solver, "vary": values, "keep": study["keep"],
                                                     "text": document, "command": command}))
        names.append(name)
    for old in (folder / "runs").iterdir():
        if old.name not in names:
            shutil.rmtree(old)
    write_if_new(folder / "Snakefile", SNAKEFILE.format(file=file.name, runs=json.dumps(names), python=quoted(sys.executable),
                                                        script=quoted(Path(__file__).resolve())))
    print(f"{len(names)} runs in {folder}")


def quoted(path):
    return "'" + str(path).replace("'", "'\\''").replace("\\", "\\\\").replace('"', '\\"').replace("{", "{{").replace("}", "}}") + "'"


def write_if_new(path, text):
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


# ------------------------------------------------------------------------------------------------------------- the runs
def run(folder, name):
    place = (folder / "runs" / name).resolve()
    told = json.loads((place / "run.json").read_text(encoding="utf-8"))
    shutil.rmtree(place / "results", ignore_errors=True)
    with (place / "log.txt").open("wb") as log:
        code = subprocess.run(told["command"], cwd=place, stdout=log, stderr=subprocess.STDOUT, check=False).returncode
    if code not in (0, 1):
        print((place / "log.txt").read_text(encoding="utf-8", errors="replace")[-2000:], file=sys.stderr)
        sys.exit(code)
    note = place / "results/failed.txt"
    failed = note.read_text(encoding="utf-8").strip() if note.is_file() else "" if code == 0 else "ended with 1"
    row = {"run": name, "scene": Path(told["scene"]).stem, "solver": told["solver"], **told["vary"],
           **{column: kept(place / "results", what) for column, what in told["keep"].items()}, "failed": failed}
    beside = place / "row.json.part"
    beside.write_text(json.dumps(row), encoding="utf-8")
    beside.replace(place / "row.json")


def kept(results, what):
    """One number of a run's tables, as text with all of its digits; nothing where there is no row.
    @throws SystemExit  there is no such table or column"""
    choice, place = what.split()
    table, column = place.split(".")
    try:
        with (results / f"{table}.csv").open(encoding="utf-8") as file:
            texts = [row[column] for row in csv.DictReader(file)]
    except (OSError, KeyError):
        raise SystemExit(f"{results}: no {place}; its tables: {', '.join(sorted(path.stem for path in results.glob('*.csv')))}") from None
    return CHOICES[choice](list(zip(map(float, texts), texts)))[1] if texts else ""


def join(folder):
    rows = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((folder / "runs").glob("*/row.json"))]
    with (folder / "table.csv.part").open("w", encoding="utf-8", newline="") as out:
        table = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    (folder / "table.csv.part").replace(folder / "table.csv")


def main():
    parser = argparse.ArgumentParser(prog="study.py")
    parser.add_argument("command", choices=["write", "run", "join"])
    parser.add_argument("words", nargs="+", type=Path)
    parser.add_argument("--program", type=Path)
    options = parser.parse_args()
    if options.command == "write":
        write(*options.words, options.program.resolve())
    elif options.command == "run":
        run(options.words[0], options.words[1].name)
    else:
        join(options.words[0])


if __name__ == "__main__":
    main()
