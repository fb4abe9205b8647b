"""Grades a class: a folder with one folder for each student, into one CSV file."""
import csv
import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import workshop
from judge import judge
from student import misconceptions

COLUMNS = ["student", "exercise", "title", "result", "properties_hold", "properties", "misconception"]


def grade(exercises, folder, out):
    """Judges every attempt of every student.

    @param folder  holds one folder for each student: a clone of the course, or only its exercises/ or what is in it
    @param out     the CSV file, one row for each student and exercise
    @return the exit status, 0"""
    students = sorted(path for path in folder.iterdir() if path.is_dir() and not path.name.startswith("."))
    workshop.prepare(exercises)
    pairs = [(student, exercise) for student in students for exercise in exercises]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        rows = list(pool.map(lambda pair: row_of(*pair), pairs))
    write(rows, out)
    for student in students:
        right = sum(1 for row in rows if row[0] == student.name and row[3] == "right")
        print(f"  {student.name}: {right} of {len(exercises)}")
    print(f"\n{len(students)} students, {len(exercises)} exercises: {out}")
    return 0


def row_of(student, exercise):
    source = attempt(student, exercise)
    if source is None:
        return row(student, exercise, "missing")
    if exercise.untouched(source):
        return row(student, exercise, "not started")
    folder = workshop.WORK / "grades" / student.name / exercise.number
    shutil.rmtree(folder, ignore_errors=True)
    outcome = judge(exercise, source.resolve(), folder)
    results = {"passed": "right", "failed": "wrong", "untouched": "not started", "does_not_compile": "does not compile",
               "includes_solution": "includes the solution", "too_long": "took too long", "too_much": "took too much", "crashed": "crashed"}
    found = misconceptions(exercise, outcome) if outcome.state == "failed" else []
    properties = outcome.held_before + outcome.cases
    hold = properties - len(outcome.failed_cases) if properties else ""
    return row(student, exercise, results[outcome.state], hold, properties or "", "; ".join(mutant.name for mutant in found))


def row(student, exercise, result, *rest):
    return [student.name, exercise.number, exercise.title, result, *rest, *[""] * (3 - len(rest))]


def attempt(student, exercise):
    """The student's file, or None."""
    places = (student / "exercises" / exercise.chapter, student / exercise.chapter)
    return next((file for file in (place / f"{exercise.name}.cpp" for place in places) if file.is_file()), None)


def write(rows, out):
    part = Path(f"{out}.part")
    with part.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        table.writerows(rows)
    part.replace(out)
