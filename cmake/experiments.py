"""The experiments of the chapters, as their main.cpp lists them: known before anything is built. And what each takes.

    python3 cmake/experiments.py FOLDER...     as in 03_penalty_impulses: a line each, as the programs write with --list
"""
import re
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COSTS = "cmake/experiments.txt"
STRING = r'"(?:[^"\\]|\\.)*"'
# {"name", "what it shows", how it runs}; a title is followed by a list instead
ENTRY = re.compile(rf'\{{\s*"([a-z]\w*)",\s*({STRING}(?:\s*{STRING})*),(?!\s*\{{)')
UNKNOWN = {"small": 3.0, "full": 60.0}  # seconds of an experiment that the list of costs does not name


@dataclass
class Cost:
    """What an experiment takes on one core [s], and how it may be run."""
    small: float = UNKNOWN["small"]
    full: float = UNKNOWN["full"]
    parts: int = 1       # into which a full run is cut
    alone: bool = False  # it measures time: nothing runs beside it

    def seconds(self, full):
        return self.full if full else self.small


def folders(root=ROOT):
    """The base, the chapters, all solvers together, and other engines; as in `course`."""
    return ["00_base", *sorted(path.parent.name for path in root.glob("chapters/[0-9][0-9]_*/main.cpp")), "solvers", "engines"]


def program_of(folder):
    return "base" if folder == "00_base" else f"chapter{folder[:2]}" if folder[:2].isdigit() else folder


def main_of(folder, root=ROOT):
    return root / ("common/experiments/verification" if folder == "00_base" else f"chapters/{folder}") / "main.cpp"


def joined(strings):
    """What C++ makes of neighbouring string literals."""
    return "".join(re.sub(r"\\(.)", r"\1", text[1:-1]) for text in re.findall(STRING, strings))


def experiments_of(folder, root=ROOT):
    """{name: summary}, in the order of the program."""
    return {name: joined(summary) for name, summary in ENTRY.findall(main_of(folder, root).read_text(encoding="utf-8"))}


def listed(folder, root=ROOT):
    """The text that the program writes with --list."""
    found = experiments_of(folder, root)
    width = max(map(len, found), default=0)
    return "".join(f"  {name:<{width}}  {summary}\n" for name, summary in found.items())


def costs(root=ROOT):
    """({(folder, experiment): Cost}, {program: seconds that its compilation takes on one core}) of the list of costs.
    @throws SystemExit  a line that cannot be read"""
    of_runs, of_builds = {}, {}
    for number, line in enumerate((root / COSTS).read_text(encoding="utf-8").splitlines(), 1):
        words = line.split("#")[0].split()
        try:
            if words and words[0] == "build":
                of_builds[words[1]] = float(words[2])
            elif words:
                of_runs[words[0], words[1]] = Cost(float(words[2]), float(words[3]), int(words[4]), "alone" in words[5:])
        except (IndexError, ValueError):
            sys.exit(f"{COSTS}:{number}: FOLDER EXPERIMENT SMALL FULL PARTS [alone], or build PROGRAM SECONDS, and not: {line}")
    return of_runs, of_builds


if __name__ == "__main__":
    sys.stdout.writelines(listed(folder) for folder in sys.argv[1:])
