"""One edge of the graph that run_beside.py gives to ninja:  run_one.py PLAN NAME.

Runs what the plan says, keeps what it printed, leaves a stamp when it ends well, and says on stderr how long the rest takes.
Edges are of four kinds: `build` compiles a program, `cause` writes down what decides about a folder's results, `run` makes some of these,
and `picture` makes one that is only to look at until its `run` is there.
"""
import fcntl
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def main(plan_file, name):
    plan = json.loads(Path(plan_file).read_text(encoding="utf-8"))
    return {"build": build, "picture": picture, "cause": cause, "run": run}[plan["edges"][name]["kind"]](plan, name)


# ------------------------------------------------------------------------------------------------------------- the kinds
def build(plan, name):
    return timed(plan, name, name.replace("build ", "the program "))


def picture(plan, name):
    edge = plan["edges"][name]
    code = timed(plan, name, edge["says"])
    if code == 0:
        tell_first_picture(plan, edge, files_told(log_of(plan, name).read_text(encoding="utf-8", errors="replace"), Path(edge["out"])))
    return code


def cause(plan, name):
    """Written again only when it has changed, so that ninja leaves alone what depends on it."""
    edge = plan["edges"][name]
    file, now = Path(plan["runs"], name), cause_of(edge["folder"], Path(edge["program"])) + "\n"
    if not file.is_file() or file.read_text(encoding="utf-8") != now:
        file.write_text(now, encoding="utf-8")
    return 0


def run(plan, name):
    edge = plan["edges"][name]
    out, stamp, written = Path(edge["out"]), Path(plan["runs"], name), Path(plan["runs"], edge["cause"]).read_text(encoding="utf-8")
    (out / ".made_by").unlink(missing_ok=True)  # until all of the folder is of one program again
    stamp.unlink(missing_ok=True)
    if edge["parts"]:  # what runs of the same cause have found is kept
        keep_parts(Path(edge["parts"]), written)
    code = timed(plan, name, edge["says"])
    if code == 0:
        files = [] if edge["part"] else files_told(log_of(plan, name).read_text(encoding="utf-8", errors="replace"), out)
        write_whole(stamp, "\n".join([written.strip(), *files]) + "\n")
        tell_first_picture(plan, edge, files)
    return code


def keep_parts(parts, written):
    """A folder for what runs of this cause find; what another cause has left there is removed. One edge at a time: parts begin together, and
    between another edge's new folder and the cause in it, that folder looks like one that is left."""
    parts.parent.mkdir(parents=True, exist_ok=True)
    with parts.with_name(parts.name + ".lock").open("w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        cause_file = parts / "cause"
        if not cause_file.is_file() or cause_file.read_text(encoding="utf-8") != written:
            shutil.rmtree(parts, ignore_errors=True)
            parts.mkdir(exist_ok=True)
            cause_file.write_text(written, encoding="utf-8")


def write_whole(file, text):
    """What other edges read while this one ends: all of it or nothing."""
    beside = file.with_name(file.name + ".part")
    beside.write_text(text, encoding="utf-8")
    beside.rename(file)


def files_told(text, out):
    """The files that an experiment has written: its program names them in its last line."""
    lines = [line for line in text.splitlines() if line.strip()]
    return [word for word in (lines[-1].split() if lines else []) if (out / word).is_file()]


def cause_of(folder, program):
    """What decides about results: the program, the scenes, meshes and plots that it reads, and the programs that draw for it."""
    read = ["common/scenes", "common/meshes", "common/experiments"] + ([] if folder == "00_base" else [f"chapters/{folder}"])
    files = sorted(path for top in read for path in (ROOT / top).rglob("*") if path.is_file() and "tests" not in path.parts
                   and path.suffix not in (".md", ".toml", ".cpp", ".hpp"))
    digest = hashlib.sha256(program.read_bytes())
    for path in files:
        digest.update(f"{path.relative_to(ROOT)}\n".encode() + hashlib.sha256(path.read_bytes()).digest())
    digest.update(" ".join(drawer for drawer in ("gnuplot", "ffmpeg") if shutil.which(drawer)).encode())
    return digest.hexdigest()


# ---------------------------------------------------------------------------------------------------- run it, and tell
def log_of(plan, name):
    return Path(plan["runs"], "logs", name.replace("/", ".") + ".txt")


def timed(plan, name, says):
    """Runs an edge's command, keeps what it prints, its seconds and its failure, and tells of it."""
    edge, log, started = plan["edges"][name], log_of(plan, name), time.monotonic()
    failed = Path(plan["runs"], "failed", name.replace("/", "."))
    with log.open("wb") as out:
        code = subprocess.run(edge["command"], cwd=ROOT, stdout=out, stderr=subprocess.STDOUT, check=False).returncode
    seconds = time.monotonic() - started
    if code:
        failed.write_text(f"{says}: exit status {code}; what it printed: {shown(log)}\n", encoding="utf-8")
        said = log.read_text(encoding="utf-8", errors="replace").splitlines()[-12:]
        tell("".join(f"     | {line}\n" for line in said) + f"   {says}: FAILED after {in_words(seconds)}")
    else:
        failed.unlink(missing_ok=True)
        write_whole(Path(plan["runs"], "seconds", name.replace("/", ".")), f"{seconds:.2f}\n")
        tell(f"   {says}: {in_words(seconds)}; {the_rest(plan)}")
    return code


def tell(text):
    """To the terminal past ninja, which would keep it until a build ends."""
    os.write(int(os.environ.get("ENDURING_TOLD", "2")), (text + "\n").encode())


def tell_first_picture(plan, edge, files):
    pictures = [name for name in files if name.endswith((".png", ".svg"))]
    if pictures and not edge.get("part"):
        try:
            os.close(os.open(Path(plan["runs"], "first_picture"), os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            return
        tell(f"   A first picture is there: {shown(Path(edge['out']) / pictures[0])}")


def shown(path):
    return os.path.relpath(path, ROOT)


def in_words(seconds):
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"


# ------------------------------------------------------------------------------------------------- how long the rest takes
def the_rest(plan):
    seconds, left = estimate(plan)
    return f"{left} left, about {in_words(seconds)}" if left else "nothing is left here"


def holds(plan, name):
    """Whether what a run leaves is there, and was made by what is there now."""
    edge = plan["edges"][name]
    try:
        written, *files = Path(plan["runs"], name).read_text(encoding="utf-8").splitlines()
        cause = Path(plan["runs"], edge["cause"]).read_text(encoding="utf-8").strip()
    except FileNotFoundError:  # or a run that begins at this moment has taken it away
        return False
    return written == cause and all(Path(edge["out"], file).is_file() for file in files)


def estimate(plan):
    """(seconds until all is there, edges that are left): by the list of costs, and by how this machine has kept to it so far."""
    expected = took = beside = longest = alone = 0.0
    left = 0
    for name, edge in plan["edges"].items():
        measured = Path(plan["runs"], "seconds", name.replace("/", "."))
        if measured.is_file():
            expected += edge["seconds"]
            took += float(measured.read_text(encoding="utf-8"))
        elif edge["kind"] != "cause" and not (edge["kind"] == "run" and holds(plan, name)):
            left += 1
            if edge["alone"]:
                alone += edge["seconds"]
            else:
                beside += edge["seconds"] * (plan["jobs"] if edge["kind"] == "build" else 1)  # compilers take all cores
                longest = max(longest, edge["seconds"])
    factor = min(max((took + 30) / (expected + 30), 0.2), 10)  # half a minute of what was expected counts as measured
    return factor * (max(beside / plan["jobs"], longest) + alone) + plan["then"], left


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})  # what came while Python loaded ends it now (graph_of())
    sys.exit(main(*sys.argv[1:]))
