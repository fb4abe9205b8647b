"""Compiles and links one answer: a student's file, a solution or a mutant, by the commands of the build folder."""
import json
import os
import re
import subprocess
from pathlib import Path

from catalogue import ROOT, shown

BUILD = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")).resolve()
WORK = ROOT / "build/exercises"
MOST_ERRORS = 3
MISSED = "Your file should define {}; its name, its arguments or its namespace differ."


class DoesNotCompile(Exception):
    """The answer has mistakes that the compiler finds; the message is what a student needs of them."""


class NotBuilt(Exception):
    """What stands around the answer could not be built; the message is the build's."""


def prepare(exercises, reconfigure=False):
    """Builds all that the answers to these exercises are linked with: the checks, the layers, and for a rebuild the
    chapter's own tests and its program."""
    targets = {"check_main"}
    for exercise in exercises:
        chapter = exercise.chapter[:2]
        targets |= {f"check_{exercise.target}", f"chapter{chapter}_experiments"}
        if exercise.kind == "rebuild":
            targets |= {f"test_chapter{chapter}", f"chapter{chapter}"}
    if reconfigure or not (BUILD / "build.ninja").is_file():
        run_quietly(["cmake", "--preset", "release", "-B", str(BUILD)])
    run_quietly(["cmake", "--build", str(BUILD), "--parallel", str(os.cpu_count()), "--target", *sorted(targets)])


def run_quietly(command):
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        raise NotBuilt(f"{' '.join(command)}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def last_command(target):
    """The command that makes one file of the build folder, without what CMake does after it."""
    command = run_quietly(["ninja", "-C", str(BUILD), "-t", "commands", "-s", target]).strip()
    return command.split(" && ")[1] if command.startswith(": && ") else command


def pattern_object(exercise):
    return f"CMakeFiles/exercise_{exercise.target}.dir/exercises/{exercise.chapter}/{exercise.name}.cpp.o"


def compile_answer(exercise, source, folder):
    """The object file of an answer.
    @param source  the answer's file
    @param folder  where the object goes
    @throws DoesNotCompile"""
    folder.mkdir(parents=True, exist_ok=True)
    answer = folder / "answer.o"
    pattern = pattern_object(exercise)
    command = last_command(pattern).replace(str(exercise.stub), f"'{source}'").replace(pattern, f"'{answer}'")
    done = subprocess.run(["bash", "-c", command + " -fdiagnostics-format=json"], cwd=BUILD, capture_output=True, text=True)
    if done.returncode:
        raise DoesNotCompile(readable_errors(done.stderr, source))
    if exercise.kind == "rebuild" and (names := not_defined(exercise, answer)):
        raise DoesNotCompile("\n".join(MISSED.format(name) for name in names[:MOST_ERRORS]))
    return answer


def not_defined(exercise, answer):
    """The functions of the chapter's file that an answer lacks: the linker would take the chapter's own."""
    source = exercise.source.relative_to(ROOT)
    chapters = BUILD / f"CMakeFiles/chapter{exercise.chapter[:2]}_layer.dir" / f"{source}.o"
    return sorted(symbols(chapters) - symbols(answer))


def symbols(file):
    """The functions and data that an object file defines for others."""
    lines = run_quietly(["nm", "--extern-only", "--defined-only", "--demangle", str(file)]).splitlines()
    return {line.split(" ", 2)[2] for line in lines if line.split(" ", 2)[1] in "TDBR"}


def link_check(exercise, answer, program):
    """The program that judges an answer: the exercise's check."""
    link(last_command(f"bin/exercise_{exercise.target}"), pattern_object(exercise), answer, program)


def link_instead(target, answer, program):
    """A program of the chapter with the answer's object in the place of the chapter's own."""
    command = last_command(f"bin/{target}")
    first = re.search(r"\S+\.cpp\.o", command)[0]
    link(command, first, f"{answer}' '{first}", program)


def link(command, pattern, answer, program):
    command = command.replace(pattern, f"'{answer}'", 1)
    command = re.sub(r"-o bin/\S+", lambda _: f"-o '{program}'", command, count=1)
    done = subprocess.run(["bash", "-c", command], cwd=BUILD, capture_output=True, text=True)
    if done.returncode:
        raise DoesNotCompile(link_errors(done.stderr + done.stdout))


# ------------------------------------------------------------------------------------------------ errors, made readable
def readable_errors(output, source):
    """The first errors of the compiler that lie in the student's file, each with its line, without the headers' tale."""
    try:
        found = json.loads(next(line for line in output.splitlines() if line.startswith("[{")))
    except (StopIteration, json.JSONDecodeError):
        return output[-3000:]  # another compiler, or one that fell over: all it said
    errors = [error for error in found if error["kind"].endswith("error")]
    told = [told_error(error, Path(source)) for error in errors[:MOST_ERRORS]]
    if len(errors) > MOST_ERRORS:
        told.append(f"... and {len(errors) - MOST_ERRORS} more, which often go away with the first.")
    return "\n".join(told)


def told_error(error, source):
    """file:line: message, the line and a mark below it; for an error inside a header, the place in the student's file
    that led there."""
    place = next((spot for spot in places(error) if Path(spot["file"]).name == source.name), None)
    message = re.sub(r"\s*\[with .*\]", "", error["message"])
    if place is None:
        spot = next(places(error), {"file": str(source), "line": 1, "column": 1})
        return f"{shown(Path(spot['file']))}:{spot['line']}: {message}"
    line = source.read_text(encoding="utf-8", errors="replace").splitlines()[place["line"] - 1:place["line"]]
    mark = " " * (place.get("display-column", place["column"]) - 1) + "^"
    return "\n".join([f"{shown(source)}:{place['line']}: {message}", *(f"    {text}" for text in [*line, mark])])


def places(error):
    """Where an error lies: its own place, then those that led to it."""
    for location in error.get("locations", []):
        yield location["caret"]
    for child in error.get("children", []):
        yield from places(child)


def link_errors(output):
    """What the linker missed, by name."""
    missed = sorted(set(re.findall(r"undefined reference to `([^']+)'", output)))
    twice = sorted(set(re.findall(r"multiple definition of `([^']+)'", output)))
    told = [MISSED.format(name) for name in missed]
    told += [f"Your file defines {name}, which stands elsewhere, too." for name in twice]
    return "\n".join(told[:MOST_ERRORS]) or output[-2000:]
