"""What an answer may not be: no text, an include of the solution, a file that lacks a function or brings a name of the course's or of C's."""
import functools
import re
import subprocess

import compiler_errors
from catalogue import ROOT

LONGEST = 1 << 20  # bytes of an answer
FUNCTIONS, ANY = "TWi", "TWiDBRVuCG"  # nm's kinds of what is defined
JUDGED_MAIN = "CMakeFiles/check_main.dir/exercises/judged_main.cpp.o"
MISSED = "Your file should define {}; its name, its arguments or its namespace differ."
OF_THE_COURSE = "Your file defines {}, which is the course's or C's own; put it into a namespace without a name, or call it otherwise."


class DoesNotCompile(Exception):
    """The answer has mistakes that the compiler finds; the message is what a student needs of them."""


class IncludesSolution(Exception):
    """The answer includes what it should have written; the message names the file."""


def text_of(source):
    """The bytes of an answer.
    @throws DoesNotCompile for what is no C++ text"""
    if not source.is_file() or source.stat().st_size > LONGEST:
        raise DoesNotCompile(f"{source.name} is no file of at most {LONGEST >> 20} MB.")
    text = source.read_bytes()
    if text.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in text:
        raise DoesNotCompile(f"{source.name} is in UTF-16, or is no text. Save it as UTF-8.")
    return text


def refuse_solution(exercise, dependencies, copy, build):
    """@throws IncludesSolution when the compiler has read a solution, the chapter's own source, or another .cpp file of the course"""
    rules = dependencies.read_text(encoding="utf-8", errors="replace") if dependencies.is_file() else ""
    for word in re.findall(r"(?:\\[ #]|[^\s\\])+", rules.partition(": ")[2]):
        read = (build / re.sub(r"\\([ #])", r"\1", word).replace("$$", "$")).resolve()
        if read != copy.resolve() and (read == exercise.source or read.is_relative_to(ROOT) and read.suffix == ".cpp"):
            raise IncludesSolution(f"Your file includes {read.relative_to(ROOT)}. Write it yourself.")


def refuse_names(exercise, answer, build):
    """@throws DoesNotCompile when an answer lacks a function of the chapter's file, where the linker would take the chapter's own,
    or brings one of the course's, of the check's or of C's, where the check would be given that one"""
    mine = symbols(answer)
    if exercise.kind == "rebuild":
        source = exercise.source.relative_to(ROOT)
        own = symbols(build / f"CMakeFiles/chapter{exercise.chapter[:2]}_layer.dir" / f"{source}.o")
        tell_names(MISSED, own - mine)
        mine = mine - own
    checks = build / f"CMakeFiles/check_{exercise.target}.dir/exercises/{exercise.chapter}/{exercise.name}.check.cpp.o"
    foreign = mine & (symbols(checks, ANY) | names_around(build))
    asked = [f"{len(name)}{name}" for name in exercise.missing]
    tell_names(OF_THE_COURSE, {name for name in symbols(answer, FUNCTIONS) if not name.startswith("_Z")} |
               {name for name in foreign if not any(part in name for part in asked)})


def tell_names(sentence, names):
    if names:
        first = told(["c++filt", *sorted(names)[:compiler_errors.MOST]]).splitlines()
        raise DoesNotCompile("\n".join(sentence.format(name) for name in first))


@functools.cache
def names_around(build):
    """All that stands around every check: what the libraries of the build and the check's main program define."""
    return frozenset().union(*(symbols(file, ANY) for file in [build / JUDGED_MAIN, *build.glob("*.a")]))


def told(command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def symbols(file, kinds="TDBR"):
    """What an object file or a library defines for others, as the linker calls it: of these kinds of nm's."""
    lines = (line.split() for line in told(["nm", "--extern-only", "--defined-only", str(file)]).splitlines())
    return {words[2] for words in lines if len(words) == 3 and words[1] in kinds}


def link_errors(output):
    """What the linker missed, by name."""
    missed = sorted(set(re.findall(r"undefined reference to `([^']+)'", output)))
    twice = sorted(set(re.findall(r"multiple definition of `([^']+)'", output)))
    told = [MISSED.format(name) for name in missed]
    told += [f"Your file defines {name}, which stands elsewhere, too." for name in twice]
    return "\n".join(told[:compiler_errors.MOST]) or output[-2000:]
