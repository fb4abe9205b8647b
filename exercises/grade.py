"""Grades a class, into one CSV file that grows as it goes: a run that was stopped goes on where it was."""
import csv
import hashlib
import os
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import submissions
import workshop
from alone import alone
from honest import LONGEST
from judge import judge
from student import misconceptions

COLUMNS = ["student", "exercise", "title", "result", "properties_hold", "properties", "misconception", "message", "fingerprint"]
RESULTS = {"passed": "right", "failed": "wrong", "untouched": "not started", "does_not_compile": "does not compile",
           "includes_solution": "includes the solution", "too_long": "took too long", "too_much": "took too much", "crashed": "crashed"}
LONGEST_MESSAGE = 1000


def grade(exercises, folder, out, one=False):
    """Judges every attempt of every student.

    @param folder  as the school's system gives it (see submissions)
    @param out     the CSV file, one row for each student and exercise
    @param one     the folder is the work of one student
    @return the rows, each a dict by COLUMNS"""
    workshop.prepare(exercises)
    with tempfile.TemporaryDirectory(prefix="enduring_") as scratch, alone(workshop.WORK / "grades", "grading"):
        handed_in = submissions.collect(folder, exercises, Path(scratch), one)
        known = {(row["student"], row["exercise"]): row for row in rows_of(out)}
        rows = {(student, exercise.number): None for student in handed_in for exercise in exercises}
        pool = ThreadPoolExecutor(os.cpu_count())
        try:
            tasks = {pool.submit(row_of, student, exercise, attempts.get(exercise.number), known.get((student, exercise.number)))
                     for student, attempts in handed_in.items() for exercise in exercises}
            for count, task in enumerate(as_completed(tasks), 1):
                row = task.result()
                rows[row["student"], row["exercise"]] = row
                write([row for row in rows.values() if row], out)
                print(f"[{count}/{len(tasks)}] {row['student']} {row['exercise']}: {row['result']}", file=sys.stderr, flush=True)
        finally:
            pool.shutdown(cancel_futures=True)
    write(rows.values(), out)
    return list(rows.values())


def row_of(student, exercise, source, known=None):
    """One row; the one that is known already, when nothing has changed since."""
    if source is None:
        return row(student, exercise, "missing")
    mark = fingerprint(exercise, source)
    if known and known["fingerprint"] == mark:
        return known
    if source.stat().st_size <= LONGEST and exercise.untouched(source):
        return row(student, exercise, "not started", fingerprint=mark)
    folder = Path(tempfile.mkdtemp(dir=workshop.WORK / "grades"))
    try:
        outcome = judge(exercise, source.resolve(), folder)
    except Exception as error:  # one answer never ends a class: the row says what happened
        return row(student, exercise, "not judged", message=f"{type(error).__name__}: {error}"[:LONGEST_MESSAGE])
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    found = misconceptions(exercise, outcome) if outcome.state == "failed" else []
    properties = outcome.held_before + outcome.cases
    return row(student, exercise, RESULTS[outcome.state], properties_hold=properties - len(outcome.failed_cases) if properties else "",
               properties=properties or "", misconception="; ".join(mutant.name for mutant in found),
               message=message_of(outcome), fingerprint=mark)


def row(student, exercise, result, **rest):
    return dict.fromkeys(COLUMNS, "") | {"student": student, "exercise": exercise.number, "title": exercise.title, "result": result} | rest


def message_of(outcome):
    """What a student should read, in a few lines."""
    first = [f"does not hold: {failure.case}\n{failure.message}" for failure in outcome.failures[:1]] if outcome.state == "failed" else []
    return "\n".join([*first, outcome.message]).strip()[:LONGEST_MESSAGE]


def fingerprint(exercise, source):
    """Of all that a row rests on: the answer and its check."""
    return hashlib.sha256(source.read_bytes() + b"\0" + exercise.check.read_bytes()).hexdigest()[:16]


def rows_of(table):
    """The rows of a table of before; none where there is none, or another one."""
    if not table.is_file():
        return []
    with table.open(newline="", encoding="utf-8", errors="replace") as file:
        rows = csv.DictReader(file)
        return [row for row in rows if None not in row.values() and None not in row] if rows.fieldnames == COLUMNS else []


def write(rows, out):
    part = Path(f"{out}.part")
    with part.open("w", newline="", encoding="utf-8", errors="surrogateescape") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    part.replace(out)


def tell(rows, out):
    """How many each student has right."""
    for student in dict.fromkeys(row["student"] for row in rows):
        mine = [row["result"] for row in rows if row["student"] == student]
        print(f"  {student}: {mine.count('right')} of {len(mine)}")
    print(f"\n{len({row['student'] for row in rows})} students, {len({row['exercise'] for row in rows})} exercises: {out}")
