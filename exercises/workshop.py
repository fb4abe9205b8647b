"""Compiles and links one answer: a student's file, a solution or a mutant, by the commands of the build folder, without a shell."""
import functools
import hashlib
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import compiler_errors
import honest
import sandbox
from alone import alone
from catalogue import ROOT
from honest import DoesNotCompile

BUILD = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")).resolve()
WORK = ROOT / "build/exercises"
TOOLS = sandbox.Limits(seconds=300, memory=6 << 30, output=8 << 20)


class NotBuilt(Exception):
    """What stands around the answer could not be built; the message is the build's."""


def prepare(exercises, reconfigure=False):
    """Builds all that the answers to these exercises are linked with, and no more: the checks, their libraries, and for a rebuild the
    chapter's own tests and its program."""
    if reconfigure or not (BUILD / "build.ninja").is_file():
        run_quietly(["cmake", "--preset", "release", "-B", str(BUILD)])
    targets = {"check_main"}
    for exercise in exercises:
        chapter = exercise.chapter[:2]
        targets |= {f"check_{exercise.target}", *libraries_of(exercise)}
        if exercise.kind == "rebuild":
            targets |= {f"test_chapter{chapter}", f"chapter{chapter}"}
    build(targets)


def libraries_of(exercise):
    """The course's own libraries that an answer is linked with, as the build calls them."""
    return {word for word in last_command(f"bin/exercise_{exercise.target}") if word.endswith(".a") and not word.startswith("/")}


def build(targets):
    """Builds targets, and says how much there is to do, if there is something."""
    command = ["cmake", "--build", str(BUILD), "--parallel", str(os.cpu_count()), "--target", *sorted(targets)]
    with alone(BUILD, "building"), subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace") as running:
        lines, told = [], False
        for line in running.stdout:
            lines.append(line)
            step = re.match(r"\[\d+/(\d+)\] Building", line)
            if step and not told:
                told = True
                print(f"Building what answers are linked with: {step[1]} steps, some seconds each, and only once.", file=sys.stderr, flush=True)
    if running.returncode:
        raise NotBuilt(f"{' '.join(command)}\n{''.join(lines)[-4000:]}")


def run_quietly(command):
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, errors="replace")
    if done.returncode:
        raise NotBuilt(f"{' '.join(command)}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def run_tool(words, folder, readable=()):
    """The compiler or the linker, which see the course and write into one folder.
    @return sandbox.Finished"""
    cache = compilers_cache()
    environment = {"CCACHE_DIR": cache, "CCACHE_TEMPDIR": f"{cache}/tmp"} if cache else {}
    return sandbox.run(words, BUILD, readable=[ROOT, BUILD, *readable], writable=[folder, *environment.values()][:2], limits=TOOLS, environment=environment)


@functools.cache
def compilers_cache():
    """ccache's folder, or nothing."""
    try:
        folder = run_quietly(["ccache", "--get-config", "cache_dir"]).strip()
    except (OSError, NotBuilt):
        return ""
    Path(folder, "tmp").mkdir(parents=True, exist_ok=True)
    return folder


@functools.cache
def last_command(target):
    """The words of the command that makes one file of the build folder, without what CMake does before and after it."""
    words = shlex.split(run_quietly(["ninja", "-C", str(BUILD), "-t", "commands", "-s", target]))
    words = words[words.index("&&") + 1:] if words[0] == ":" else words
    return tuple(words[:words.index("&&")] if "&&" in words else words)


def exchanged(words, changes):
    """The words with some of them changed, of a dependency file's name its stem."""
    return [changes.get(word, f"{changes.get(word[:-2])}.d" if word.endswith(".d") and word[:-2] in changes else word) for word in words]


def pattern_object(exercise):
    return f"CMakeFiles/exercise_{exercise.target}.dir/exercises/{exercise.chapter}/{exercise.name}.cpp.o"


def compile_answer(exercise, source, folder):
    """The object file of an answer.
    @param source  the answer's file
    @param folder  where the object goes
    @throws DoesNotCompile, IncludesSolution"""
    folder.mkdir(parents=True, exist_ok=True)
    copy, answer = folder / "answer.cpp", folder / "answer.o"
    copy.write_bytes(honest.text_of(source))
    pattern = pattern_object(exercise)
    done = run_tool(exchanged(last_command(pattern), {str(exercise.stub): str(copy), pattern: str(answer)}), folder)
    honest.refuse_solution(exercise, Path(f"{answer}.d"), copy, BUILD)
    if done.stopped:
        raise DoesNotCompile(f"The compiler was stopped: it took too much {done.stopped}.")
    if done.returncode:
        raise DoesNotCompile(compiler_errors.readable(done.err, copy, source))
    honest.refuse_names(exercise, answer, BUILD)
    return answer


def link_check(exercise, answer, program):
    """The program that judges an answer: the exercise's check, or a hidden one."""
    objects = {pattern_object(exercise): answer}
    if exercise.hidden:
        objects[check_object(exercise)] = compile_hidden_check(exercise)
    link(f"exercise_{exercise.target}", objects, program)


def check_object(exercise):
    return f"CMakeFiles/check_{exercise.target}.dir/exercises/{exercise.chapter}/{exercise.name}.check.cpp.o"


def compile_hidden_check(exercise):
    """The object file of a teacher's check, compiled once for all answers.
    @throws NotBuilt"""
    folder = WORK / "hidden" / hashlib.sha256(exercise.hidden.read_bytes()).hexdigest()[:16]
    with alone(folder):
        made = folder / f"{exercise.target}.o"
        if not made.is_file():
            pattern, part = check_object(exercise), folder / f"{exercise.target}.part.o"
            words = exchanged(last_command(pattern), {str(exercise.published_check): str(exercise.hidden), pattern: str(part)})
            done = run_tool(words, folder, [exercise.hidden])
            if done.returncode:
                raise NotBuilt(f"{exercise.hidden} does not compile:\n{done.err[-2000:]}")
            part.replace(made)
    return made


def link_tests(exercise, answer, program):
    """The chapter's tests with the answer in the place of the chapter's own code, and with the main program of a check."""
    target = f"test_chapter{exercise.chapter[:2]}"
    link(target, {"of the layer": answer, "CMakeFiles/doctest_main.dir/cmake/doctest_main.cpp.o": BUILD / honest.JUDGED_MAIN}, program)


def link_instead(target, answer, program):
    """A program of the chapter with the answer's object in the place of the chapter's own."""
    link(target, {"of the layer": answer}, program)


def link(target, objects, program):
    """A program of the build with some objects changed: those of its own command change places, all others come first, so that
    the linker does not look for them in its libraries.
    @param objects  the changed objects, by the build's name for each
    @throws DoesNotCompile"""
    words = last_command(f"bin/{target}")
    first = next(place for place, word in enumerate(words) if word.endswith(".cpp.o"))
    others = [str(changed) for name, changed in objects.items() if name not in words]
    own = {name: str(changed) for name, changed in objects.items()} | {f"bin/{target}": str(program)}
    done = run_tool([*words[:first], *others, *exchanged(words[first:], own)], program.parent, objects.values())
    if done.returncode:
        raise DoesNotCompile(honest.link_errors(done.err + done.out))


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
    """Compiles one file of a copy of the sources, or several that are one for the compiler, as the build compiles its original; warnings are nobody's business there.
    @param pattern  the build's object file
    @param sources  the copy, with the same folders in it
    @param changed  the new object, which lies above the copy
    @throws DoesNotCompile"""
    own = {pattern: str(changed), f"-I{ROOT}": f"-I{sources}"}
    words = [word.replace(f"{ROOT}/", f"{sources}/", 1) if word.endswith(".cpp") else word for word in last_command(pattern)]
    together = [word for word in words if word.endswith(".cxx")]  # a file of the build that includes several sources
    if together:
        own[together[0]] = str(changed.with_suffix(".cxx"))
        Path(own[together[0]]).write_text(Path(together[0]).read_text(encoding="utf-8").replace(f"{ROOT}/", f"{sources}/"), encoding="utf-8")
    done = run_tool([*exchanged(words, own), "-w"], changed.parent)
    if done.returncode:
        raise DoesNotCompile(f"does not compile: {done.err[-2000:]}")
