"""Compiles and links one answer: a student's file, a solution or a mutant, by the commands of the build folder."""
import functools
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
    build(targets)


def build(targets):
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
    link(f"exercise_{exercise.target}", {pattern_object(exercise): answer}, program)


def link_instead(target, answer, program):
    """A program of the chapter with the answer's object in the place of the chapter's own."""
    link(target, {"of the layer": answer}, program)


def link(target, objects, program):
    """A program of the build with some objects changed: those of its own command change places, all others come first, so that
    the linker does not look for them in its libraries.
    @param objects  the changed objects, by the build's name for each
    @throws DoesNotCompile"""
    before, first, rest = re.split(r"(\S+\.cpp\.o)", last_command(f"bin/{target}"), maxsplit=1)
    own = {name for name in objects if name == first or f" {name} " in rest}
    of_libraries = " ".join(f"'{changed}'" for name, changed in objects.items() if name not in own)
    command = f"{before}{of_libraries} {first}{rest}"
    for name in own:
        command = command.replace(f" {name} ", f" '{objects[name]}' ")
    command = re.sub(r"-o bin/\S+", lambda _: f"-o '{program}'", command, count=1)
    done = subprocess.run(["bash", "-c", command], cwd=BUILD, capture_output=True, text=True)
    if done.returncode:
        raise DoesNotCompile(link_errors(done.stderr + done.stdout))


# ----------------------------------------------------------------------------------------- a copy of the sources, changed
def objects_that_read(source, targets):
    """The objects of some targets whose sources include a file, directly or not, or are that file.
    @param source  as seen from the top"""
    names = {f"    {ROOT / source}", f"    {os.path.relpath(ROOT / source, BUILD)}"}  # as a compiler, or ccache, may have told it
    found, current = [], ""
    for line in recorded_includes():
        if line in names:
            found.append(current)
        elif not line.startswith(" "):
            current = line.split(": ")[0]
    return sorted({name for name in found if name.startswith(tuple(f"CMakeFiles/{target}.dir/" for target in targets))})


@functools.cache
def recorded_includes():
    """For each object of the build, a line with its name, and its sources in indented lines."""
    return run_quietly(["ninja", "-C", str(BUILD), "-t", "deps"]).splitlines()


def compile_copy(pattern, sources, changed):
    """Compiles one file of a copy of the sources as the build compiles its original; warnings are nobody's business there.
    @param pattern  the build's object file
    @param sources  the copy, with the same folders in it
    @param changed  the new object
    @throws DoesNotCompile"""
    command = last_command(pattern).replace(pattern, f"'{changed}'").replace(f"-I{ROOT} ", f"-I'{sources}' ").replace(
        f"-c {ROOT}/", f"-c {sources}/") + " -w"
    done = subprocess.run(["bash", "-c", command], cwd=BUILD, capture_output=True, text=True)
    if done.returncode:
        raise DoesNotCompile(f"does not compile: {done.stderr[-2000:]}")


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
