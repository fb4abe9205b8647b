#!/usr/bin/env python3
"""Compares the tables of two runs, and names each that differs and by how much.

A difference is told relative to the largest number of its column, since noise around zero has no scale of its own; in
tables of facts, whose column holds all sorts of things, relative to the fact. What a clock measured is not compared.
Exit code 1 if anything differs.
"""
import argparse
import csv
import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# A clock takes part in these, and the ratios of what it measured; the same program writes them anew each time.
CLOCK = re.compile(r"\[[mn]s\]|_[mn]s$|real.time.factor|by_clock$|bullet_over_tree| / DPF's$")
CLOCK_TABLES = re.compile(r"^times\.csv$|^\w+_passes\.csv$|^(facts|pair)_cost\.csv$|^speed_\w+\.csv$")


def number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def cells(path):
    """A table as {(row, column): text}, columns by name; a fact is a row by its name."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if path.name.startswith("facts_"):
        return {(row["name"], "is"): row["value"] or row["text"] for row in rows if not CLOCK.search(row["name"])}
    return {(i + 1, column): text for i, row in enumerate(rows) for column, text in row.items() if not CLOCK.search(column)}


def scales(table, facts):
    """Each cell's scale: the largest number of its column, or the fact itself."""
    largest = {}
    for (row, column), text in table.items():
        place = row if facts else column
        value = abs(number(text))
        if math.isfinite(value):
            largest[place] = max(largest.get(place, 0.0), value)
    return {(row, column): largest.get(row if facts else column, 0.0) for row, column in table}


def differences(before, after):
    """(relative difference, row, column, text before, text after) of each cell that differs; infinite between words."""
    old, new = cells(before), cells(after)
    scale = scales(old, before.name.startswith("facts_"))
    for place in dict.fromkeys([*old, *new]):
        a, b = old.get(place, "nothing"), new.get(place, "nothing")
        if a != b:
            by = abs(number(a) - number(b))
            yield (math.inf if math.isnan(by) else by / (scale[place] or 1.0)), *place, a, b


def compare(before, after, tolerance):
    """A sentence for each table that differs by more than the tolerance."""
    names = sorted({path.relative_to(folder) for folder in (before, after) for path in folder.rglob("*.csv")})
    for name in (name for name in names if not CLOCK_TABLES.search(name.name)):
        sides = [(before / name).is_file(), (after / name).is_file()]
        if not all(sides):
            yield f"{name}: only in {before if sides[0] else after}"
            continue
        found = [one for one in differences(before / name, after / name) if one[0] > tolerance]
        if found:
            by, row, column, a, b = max(found, key=lambda one: one[0])
            most = "" if math.isinf(by) else f", most by {by:.1e} of its scale"
            yield f"{name}: {len(found)} of {len(cells(before / name))} cells differ{most} (row {row}, {column}: {a}, then {b})"


def main():
    parser = argparse.ArgumentParser(prog="./course compare", description=__doc__.splitlines()[0])
    parser.add_argument("before", type=Path, help="results of one run, as a copy of build/results")
    parser.add_argument("after", type=Path, nargs="?", default=ROOT / "build/results", help="of another (build/results)")
    parser.add_argument("--tolerance", type=float, default=0.0, help="a relative difference that is let pass (0)")
    options = parser.parse_args()
    for folder in (options.before, options.after):
        if not any(folder.rglob("*.csv")):
            parser.error(f"{folder} holds no tables")
    faults = list(compare(options.before, options.after, options.tolerance))
    for fault in faults:
        print(fault)
    tables = sum(not CLOCK_TABLES.search(path.name) for path in options.before.rglob("*.csv"))
    print(f"{tables} tables compared: {len(faults)} differ" if faults else f"{tables} tables compared: all the same")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
