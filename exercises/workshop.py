"""Compiles and links one answer: a student's file, a solution or a mutant, by the commands of the build folder."""
import os
import re
import subprocess
from pathlib import Path

from catalogue import ROOT, shown

BUILD = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")).resolve()
WORK = ROOT / "build/exercises"
MOST_ERRORS = 3
MESSAGE = r"^([^\s:][^:\n]*):(\d+):(\d+): +(?:fatal )?(error|required from)(?:: )?(.*)$"
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
    done = subprocess.run(["bash", "-c", command], cwd=BUILD, capture_output=True, text=True)
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
    """The first errors of the compiler, each at its line of the student's file, without the headers' tale.
    @param output  all that the compiler wrote
    @param source  the student's file"""
    source, lines, told, cause = Path(source), Path(source).read_text(encoding="utf-8", errors="replace").splitlines(), [], None
    for file, line, column, kind, message in re.findall(MESSAGE, output, re.M):
        if kind == "required from":
            cause = (int(line), int(column)) if file == str(source) else cause  # what led into a header
        elif kind:
            place = (int(line), int(column)) if file == str(source) else cause
            message = re.sub(r"\s*\[with .*\]|\s*\[-W\S+\]", "", message)
            told.append(told_error(message, source, lines, place) if place else f"{shown(Path(file))}:{line}: {message}")
            cause = None
    if not told:
        return output[-3000:]
    if len(told) > MOST_ERRORS:
        told[MOST_ERRORS:] = [f"... and {len(told) - MOST_ERRORS} more, which often go away with the first."]
    return "\n".join(told)


def told_error(message, source, lines, place):
    """file:line: message, the line, and a mark below it."""
    line, column = place
    return f"{shown(source)}:{line}: {message}\n    {lines[line - 1]}\n    {' ' * (column - 1)}^"


def link_errors(output):
    """What the linker missed, by name."""
    missed = sorted(set(re.findall(r"undefined reference to `([^']+)'", output)))
    twice = sorted(set(re.findall(r"multiple definition of `([^']+)'", output)))
    told = [MISSED.format(name) for name in missed]
    told += [f"Your file defines {name}, which stands elsewhere, too." for name in twice]
    return "\n".join(told[:MOST_ERRORS]) or output[-2000:]
