#!/usr/bin/env python3
"""The commands of ./course about exercises: check, exercise, hint, solution, update, prove, grade and handout."""
import argparse
import random
import sys
import zipfile
from pathlib import Path

import exports
import grade
import handout
import layers
import prove
import student
import update
import variants
import workshop
import wrong_versions
from catalogue import ROOT, CatalogueError, all_exercises, every_exercise


def chosen(exercises, word):
    """The exercises that a word names: all for none, a chapter's for "3", one for "3.2".
    @throws SystemExit with status 2 when there is none"""
    if word is None:
        return exercises
    found = [exercise for exercise in exercises if word in (exercise.number, exercise.number.split(".")[0])]
    if not found:
        numbers = ", ".join(exercise.number for exercise in exercises)
        stop(f"there is no exercise {word}. There are: {numbers}")
    return found


def all_chosen(exercises, words):
    """The exercises that some words name; all for none."""
    found = {exercise.number: exercise for word in words or [None] for exercise in chosen(exercises, word)}
    return sorted(found.values(), key=lambda exercise: exercise.order)


def one(exercises, word):
    found = chosen(exercises, word)
    if len(found) != 1:
        stop(f"name one exercise, as in {found[0].number}")
    return found[0]


def stop(message):
    print(f"course: {message}", file=sys.stderr)
    sys.exit(2)


def prove_layers(options):
    """Of all layers, or of a chapter's (0 is the base)."""
    everything = wrong_versions.all_versions()
    versions = [version for version in everything if options.number in (None, str(version.number))]
    if not versions:
        stop(f"there is no layer {options.number}. There are: {', '.join(sorted({str(version.number) for version in everything}))}")
    lacks = list(layers.too_few(versions))
    for fault in lacks:
        print(fault)
    return prove.prove_layers(layers.part_of(versions, options.part) if options.part else versions, options.renew) or bool(lacks)


def grade_class(exercises, options):
    """One table, and what else was asked for."""
    if not options.folder.is_dir() and not zipfile.is_zipfile(options.folder):
        stop(f"{options.folder} is not a folder, and no zip file")
    out = options.csv or (options.folder / "grades.csv" if options.folder.is_dir() else options.folder.with_suffix(".csv"))
    chosen_ones = [variants.with_hidden(exercise, options.hidden) if options.hidden else exercise for exercise in all_chosen(exercises, options.numbers)]
    rows = grade.grade(chosen_ones, options.folder, out, options.one or options.gradescope is not None)
    grade.tell(rows, out)
    if options.gradescope:
        options.gradescope.write_text(exports.gradescope(rows), encoding="utf-8")
    if options.junit:
        options.junit.write_text(exports.junit(rows), encoding="utf-8", errors="replace")
    if options.summary:
        with options.summary.open("a", encoding="utf-8", errors="replace") as page:
            page.write(exports.summary(rows))
    if options.moodle:
        text, without = exports.moodle(rows)
        options.moodle.write_text(text, encoding="utf-8", errors="replace", newline="")
        if without:
            print(f"Not in {options.moodle}, for their folders are not named as Moodle's download names them: {', '.join(without)}")
    return 0


def arguments():
    parser = argparse.ArgumentParser(prog="./course", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("check", help="judge the attempts").add_argument("numbers", nargs="*", metavar="N[.M]")
    for name, what in (("exercise", "an exercise's text"), ("hint", "one hint more"), ("solution", "the solution")):
        commands.add_parser(name, help=what).add_argument("number", metavar="N.M")
    commands.choices["solution"].add_argument("--second", action="store_true", help="the other solution, where there is one")
    proof = commands.add_parser("prove", help="prove stubs, solutions and mutants")
    proof.add_argument("number", nargs="?", metavar="N[.M]")
    proof.add_argument("--renew", action="store_true", help="first write the stubs anew; attempts in them are lost")
    proof.add_argument("--layers", action="store_true", help="prove the layers instead: wrong versions that their tests have to notice")
    proof.add_argument("--part", metavar="K/N", help="of the mutants, or of the layers' wrong versions, the K-th of N parts")
    grades = commands.add_parser("grade", help="grade a class")
    grades.add_argument("folder", type=Path, help="holds a folder, a zip file or files NAME_2_title.cpp for each student; may be a zip file")
    grades.add_argument("numbers", nargs="*", metavar="N[.M]", help="which exercises (default: all)")
    grades.add_argument("--one", action="store_true", help="FOLDER is the work of one student, not of a class")
    grades.add_argument("--csv", type=Path, metavar="FILE", help="where the table goes (default: FOLDER/grades.csv); rows in it that still hold stay")
    grades.add_argument("--gradescope", type=Path, metavar="FILE", help="Gradescope's results.json; FOLDER is the work of one student")
    grades.add_argument("--junit", type=Path, metavar="FILE", help="JUnit XML: a suite for each student")
    grades.add_argument("--moodle", type=Path, metavar="FILE", help="Moodle's offline grading worksheet (CSV)")
    grades.add_argument("--summary", type=Path, metavar="FILE", help="a table in Markdown, behind what is in FILE")
    grades.add_argument("--hidden", type=Path, metavar="DIR", help="checks of your own, in the place of the course's: NN_name/M_title.check.cpp")
    for_students = commands.add_parser("handout", help="a student repository without solutions")
    for_students.add_argument("folder", type=Path, metavar="DIR")
    for_students.add_argument("--hidden", type=Path, metavar="DIR", help="write hidden checks there, and the exercises for an exam: other numbers, other seeds")
    for_students.add_argument("--seed", type=int, default=None, help="of the hidden checks (default: by chance)")
    commands.add_parser("update", help="the new course; answers stay").add_argument("origin", nargs="?", metavar="URL", help="a new handout (default: git pull)")
    return parser.parse_args()


def main():
    options = arguments()
    everything = every_exercise()
    exercises, exams = all_exercises(), [exercise for exercise in everything if exercise.for_exams]
    if options.command == "check":
        return student.check(all_chosen(exercises, options.numbers), named=any("." in number for number in options.numbers))
    if options.command == "exercise":
        return student.show_text(one(everything, options.number))
    if options.command == "hint":
        return student.hint(one(exercises, options.number))
    if options.command == "handout":
        handout.handout(exercises, options.folder, exams)
        if options.hidden:
            variants.write_variants(exercises, options.hidden, random.randrange(10**6) if options.seed is None else options.seed, exams)
        return 0
    if options.command == "update":
        return update.update(exercises, options.origin)
    if options.command in ("solution", "prove") and not (ROOT / "solutions").is_dir():
        stop("the solutions are with your teacher")
    if options.command == "solution":
        return student.solution(one(everything, options.number), options.second)
    if options.command == "prove" and options.layers:
        return prove_layers(options)
    if options.command == "prove":
        return prove.prove(chosen(everything, options.number), options.renew, options.part)
    return grade_class(everything if options.numbers else exercises, options)


if __name__ == "__main__":
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="replace")  # a terminal with another encoding shows "?" and goes on
    try:
        sys.exit(main())
    except (CatalogueError, workshop.NotBuilt, handout.CannotHandOut, update.CannotUpdate) as error:
        stop(error)
    except KeyboardInterrupt:
        sys.exit(130)
