"""Runs one answer against its check and tells what came of it."""
import re
import resource
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import workshop
from catalogue import ROOT

SECONDS = 20          # a check takes well under two
MEMORY = 4 << 30      # bytes
NOT_IMPLEMENTED = "not implemented yet: "
THREW = "threw an exception"


@dataclass
class Failure:
    """One expectation that does not hold."""
    case: str       # the property
    given: list     # the input that was told last
    message: str    # expected and got


@dataclass
class Outcome:
    """What came of an answer: passed, failed, untouched, does_not_compile, too_long or crashed."""
    state: str
    message: str = ""
    cases: int = 0                              # properties that were tried
    failures: list = field(default_factory=list)
    said: str = ""                              # what it printed
    held_before: int = 0                        # properties of a rebuild's check, when `cases` are the chapter's tests

    @property
    def failed_cases(self):
        return list(dict.fromkeys(failure.case for failure in self.failures))

    @property
    def unwritten_cases(self):
        return [failure.case for failure in self.failures if failure.message.startswith(NOT_IMPLEMENTED)]


def judge(exercise, source, folder, chapters_tests=True):
    """Judges a file as an answer to an exercise.

    @param source          the file
    @param folder          where its object and program go
    @param chapters_tests  for a rebuild, also run the chapter's own tests with the answer in the place of the chapter's code
    @return an Outcome; "failed" by the check, or else by the chapter's tests"""
    program = folder / "check"
    try:
        answer = workshop.compile_answer(exercise, source, folder)
        workshop.link_check(exercise, answer, program)
        outcome = run_cases(program, folder / "check.xml")
        if outcome.state == "passed" and exercise.kind == "rebuild" and chapters_tests:
            outcome = with_chapters_tests(exercise, answer, folder, outcome)
        return outcome
    except workshop.DoesNotCompile as error:
        return Outcome("does_not_compile", str(error))


def with_chapters_tests(exercise, answer, folder, outcome):
    program = folder / "tests"
    workshop.link_instead(f"test_chapter{exercise.chapter[:2]}", answer, program)
    own = run_cases(program, folder / "tests.xml", ["--test-case=" + ",".join(exercise.tests)])
    if own.state == "passed" and not own.cases:
        return Outcome("failed", f"no test of the chapter is called {' or '.join(exercise.tests)}")
    own.held_before = outcome.cases
    own.said = outcome.said
    return own


def run_cases(program, report, options=(), seconds=None):
    """Runs a program of doctest cases, with a limit of time and memory.
    @param seconds  the limit of time; without it, that of a check"""
    seconds = seconds or SECONDS
    report.unlink(missing_ok=True)
    command = [str(program), "--reporters=xml", f"--out={report}", "--no-breaks", *options]
    done, in_time = run_limited(command, seconds)
    cases = cases_in(report)
    checking = f" It was checking: {cases[-1].get('name')}" if cases else ""
    if not in_time:
        return Outcome("too_long", f"Stopped after {seconds} s: a loop does not end, or takes far too many rounds.{checking}")
    if cases is None:
        return Outcome("crashed", crash_of(done), said=done.stdout)
    failures = [failure for case in cases for failure in failures_of(case)]
    crash = crash_of(done) + checking if done.returncode < 0 else ""
    return Outcome(state_of(done, cases, failures), crash, len(cases), failures, done.stdout)


def run_limited(command, limit):
    """(CompletedProcess, whether it ended in time). Who does not is asked to end first, so that its report names the case."""
    program = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace",
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
    in_time = True
    for seconds, end in ((limit, program.terminate), (5, program.kill), (None, None)):
        try:
            out, err = program.communicate(timeout=seconds)
            return subprocess.CompletedProcess(command, program.returncode, out, err), in_time
        except subprocess.TimeoutExpired:
            in_time = False
            end()


def cases_in(report):
    """The cases that a report holds, without those that were not asked for; None where it was never finished."""
    try:
        cases = ElementTree.parse(report).getroot().findall(".//TestCase")
    except (ElementTree.ParseError, FileNotFoundError):
        return None
    return [case for case in cases if case.get("skipped") != "true"]


def state_of(done, cases, failures):
    if done.returncode < 0:
        return "crashed"
    if failures and all(failure.message.startswith(NOT_IMPLEMENTED) for failure in failures) \
            and len({failure.case for failure in failures}) == len(cases):
        return "untouched"
    return "failed" if failures or done.returncode else "passed"


def crash_of(done):
    """Why a program fell over, as its assertion says it."""
    if done.returncode >= 0:
        return "The program ended before its check did. Does it call exit()?"
    found = re.search(r"([^/\s]+:\d+): .*Assertion [`'](.*)' failed", done.stderr)
    if not found:
        return "The program crashed: often an index or a pointer out of range, or a function that calls itself without end."
    past_the_end = "an index is past the end of a container: " if "size()" in found[2] else ""
    return f"The program crashed: {past_the_end}at {found[1]} this should hold: {found[2]}."


def failures_of(case):
    """A case's expectations that do not hold, and its exceptions."""
    for found in case.iter("Expression"):
        if found.get("success") == "false":
            infos = [text_of(info) for info in found.findall("Info")]
            if text_of(found.find("Original")) == "right":  # from expect: its message is the last of the infos
                yield Failure(case.get("name"), infos[-2:-1], infos[-1])
            else:
                thrown = found.find("Exception")
                got = f"threw {text_of(thrown)}" if thrown is not None else f"got {text_of(found.find('Expanded'))}"
                yield Failure(case.get("name"), infos[-1:], f"expected {text_of(found.find('Original'))}, {got}")
    for found in case.findall(".//Message"):
        if found.get("type") in ("ERROR", "FATAL ERROR"):
            yield Failure(case.get("name"), [], text_of(found.find("Text")))
    for found in [*case.findall("Exception"), *case.findall("SubCase/Exception")]:
        text = text_of(found).strip('"')
        yield Failure(case.get("name"), [], text if text.startswith(NOT_IMPLEMENTED) else f"{THREW}: {text}")


def text_of(element):
    return (element.text or "").strip() if element is not None else ""
