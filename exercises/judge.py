"""Runs one answer against its check and tells what came of it."""
import functools
import re
import secrets
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import honest
import sandbox
import workshop
from catalogue import ROOT

SECONDS = 20                              # a check takes well under two
SEEN = ("chapters", "common", "renders")  # what the chapters' tests read
TOO_MUCH = {"time": "Stopped after {} s: a loop does not end, or takes far too many rounds.",
            "memory": "Stopped: it takes far too much memory.", "output": "Stopped: it prints far too much.",
            "processes": "Stopped: it starts far too many processes."}
NO_VERDICT = "No verdict: of the {1} properties it reports {0}, or its report is not the judge's. Does it add tests, or meddle with the check?"
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
    """What came of an answer: passed, failed, untouched, does_not_compile, includes_solution, too_long, too_much
    or crashed."""
    state: str
    message: str = ""
    cases: int = 0                              # properties that were tried
    failures: list = field(default_factory=list)
    said: str = ""                              # what it printed
    held_before: int = 0                        # properties of a rebuild's check, when `cases` are the chapter's tests

    @property
    def failed_cases(self):
        return list(dict.fromkeys(failure.case for failure in self.failures))


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
        outcome = run_cases(program, expected=properties_of(exercise))
        if outcome.state == "passed" and exercise.kind == "rebuild" and chapters_tests:
            outcome = with_chapters_tests(exercise, answer, folder, outcome)
        return outcome
    except honest.DoesNotCompile as error:
        return Outcome("does_not_compile", str(error))
    except honest.IncludesSolution as error:
        return Outcome("includes_solution", str(error))


def properties_of(exercise):
    """How many properties its check has."""
    return len(re.findall(r"^TEST_CASE\(", exercise.check.read_text(encoding="utf-8"), re.M))


def with_chapters_tests(exercise, answer, folder, outcome):
    program = folder / "tests"
    workshop.link_tests(exercise, answer, program)
    chosen = "--test-case=" + ",".join(exercise.tests)
    own = run_cases(program, [chosen], expected=tests_of(exercise.chapter[:2], chosen))
    if own.state == "passed" and not own.cases:
        return Outcome("failed", f"no test of the chapter is called {' or '.join(exercise.tests)}")
    own.held_before = outcome.cases
    own.said = outcome.said
    return own


@functools.cache
def tests_of(chapter, chosen):
    """How many of a chapter's tests are chosen, as its own program says."""
    told = workshop.run_quietly([str(workshop.BUILD / f"bin/test_chapter{chapter}"), chosen, "--count"])
    return int(re.search(r"filters: (\d+)", told)[1])


def run_cases(program, options=(), seconds=SECONDS, expected=None):
    """Runs a program of doctest cases.
    @param expected  how many cases it has, when it is an answer's: it then runs in the sandbox and has to sign its report; without
                     it, it is the course's own
    @return an Outcome"""
    secret = secrets.token_hex(16) if expected is not None else ""
    command = [program, "--reporters=xml", "--out={report}", "--no-breaks", *options]
    done = sandbox.run(command, ROOT, readable=[program, *(ROOT / name for name in SEEN)], limits=sandbox.Limits(seconds=seconds),
                       said=secret.encode(), environment={"ENDURING_JUDGED": "1"} if secret else {}, trusted=not secret)
    signed = done.report.endswith(secret)
    cases = cases_in(done.report.removesuffix(secret))
    checking = f" It was checking: {cases[-1].get('name')}" if cases else ""
    if done.stopped:
        return Outcome("too_long" if done.stopped == "time" else "too_much", TOO_MUCH[done.stopped].format(seconds) + checking)
    if cases is None:
        return Outcome("crashed", crash_of(done), said=done.out)
    failures = [failure for case in cases for failure in failures_of(case)]
    crash = crash_of(done) + checking if done.returncode < 0 else ""
    if not crash and (not signed or expected not in (None, len(cases))):
        return Outcome("crashed", NO_VERDICT.format(len(cases), expected), said=done.out)
    return Outcome(state_of(done, cases, failures), crash, len(cases), failures, done.out)


def cases_in(report):
    """The cases that a report holds, without those that were not asked for; None where it was never finished."""
    try:
        cases = ElementTree.fromstring(report).findall(".//TestCase")
    except ElementTree.ParseError:
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
    found = re.search(r"([^/\s]+:\d+): .*Assertion [`'](.*)' failed", done.err)
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
