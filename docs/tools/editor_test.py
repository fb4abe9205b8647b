#!/usr/bin/python3
"""Proves the exercises in the page: in headless Chromium, stubs, solutions, second solutions and wrong answers get the verdict, the properties, the
numbers and the diagnosis of `./course check`. Needs Debian's chromium-driver and python3-selenium, and a book built with --live.

    docs/tools/editor_test.py 1.1         one exercise
    docs/tools/editor_test.py --part 2/9  of all answers every ninth, from the second on
    docs/tools/editor_test.py --known     against what `./course prove` proves of each answer, its verdict, its properties and its diagnosis: no compiler is needed
"""
import argparse
import http.server
import sys
import threading
import time
from functools import partial
from pathlib import Path

import editor  # puts the exercises' folder on the path
import judge
import prove
import student
import workshop
from browser_test import PHONE, WebDriverWait, browser, screen
from layers import part_of

ROOT = Path(__file__).resolve().parents[2]
SECONDS = 600  # of one answer, on a machine that has much else to do
OPEN = """const [number, done] = arguments, page = new URL('live/editor/page.js', location.href);
(async () => { const button = document.querySelector(`button[data-exercise="${number}"]`), open = (await import(page)).open;
  window.editors ??= {}; window.editors[number] ??= await open(number, button); await window.editors[number].prepared; done(''); })().catch(error => done(String(error.stack)));"""
JUDGE = """const [number, text, done] = arguments, editor = window.editors[number]; editor.write(text); const begun = performance.now();
editor.check().then(found => done({ ...found, shown: editor.verdict.textContent, seconds: (performance.now() - begun) / 1000 }));"""
LINE, NAME = "return depth_t1 < 0 ? -k * dt * depth_t1 : 0.0;", "double discrete_plane_impulse("  # of exercise 1.1
BROKEN = {"no semicolon": (LINE, "return 0"), "another name": (NAME, "double discrete_push("), "leaves": (LINE, "std::exit(0);"), "stops": (LINE, "std::abort();"),
          "throws": (LINE, 'throw std::out_of_range("depth");'), "never ends": (LINE, "for (volatile bool on = true; on;) {}\n    return 0;")}


def answers_of(exercise):
    """(name, text) of what is judged."""
    yield "stub", exercise.stub_text()
    yield "solution", exercise.source.read_text(encoding="utf-8")
    if exercise.second:
        yield "second solution", exercise.second.read_text(encoding="utf-8")
    yield from ((mutant.name, exercise.mutated(mutant)) for mutant in exercise.mutants)
    if exercise.number == "1.1":
        yield from ((name, exercise.source.read_text(encoding="utf-8").replace(*change)) for name, change in BROKEN.items())


def here(exercise, name, text):
    """The native judge's outcome. That of a known mistake is kept, for diagnoses ask for it again."""
    known = next((mutant for mutant in exercise.mutants if mutant.name == name), None)
    if known:
        return student.judge_mutant(exercise, known)
    folder = prove.folder_of(exercise, f"page_{name.replace(' ', '_')}")
    source = folder / f"{exercise.name}.cpp"
    source.write_text(text, encoding="utf-8")
    return judge.judge(exercise, source, folder, chapters_tests=False)


def diagnosis_of(exercise, outcome):
    """What the terminal says about a wrong answer, in one line."""
    told = []
    student.tell_diagnosis, kept = lambda head, mutant: told.append(head + " ".join(mutant.diagnosis.split())), student.tell_diagnosis
    student.tell_misconceptions(exercise, outcome)
    student.tell_diagnosis = kept
    return "\n\n".join(told)


def differences(exercise, there, outcome):
    """Where the page's outcome is not the native one. Of what does not come to its end, compilers and crashes have other words in the page."""
    if there["state"] != outcome.state:
        yield f"the page says {there['state']} ({there.get('message')}), ./course check {outcome.state} ({outcome.message})"
        return
    if outcome.state not in ("passed", "failed", "untouched"):
        checked = [message.partition("It was checking: ")[2] for message in (there["message"], outcome.message)]
        if checked[0] != checked[1]:
            yield f"the page was checking '{checked[0]}', ./course check '{checked[1]}'"
        return
    compared = {"properties": (there["cases"], outcome.cases), "prints": (there["said"].strip(), outcome.said.strip()), "failures": (len(there["failures"]), len(outcome.failures))}
    for one, ours in zip(there["failures"], outcome.failures):
        compared["\n".join([ours.case, *ours.given, ours.message])] = ([one["name"], one["given"], one["message"]], [ours.case, ours.given, ours.message])
    if outcome.state == "failed":
        compared["diagnosis"] = (there["diagnosis"], diagnosis_of(exercise, outcome))
    yield from (f"{what}: {page} in the page, {native} in ./course check" for what, (page, native) in compared.items() if page != native)


def differences_from_known(exercise, name, there):
    """Where the page's outcome is not what the exercise's own files say of this answer: all that `./course prove` proves natively."""
    mutant = next((mutant for mutant in exercise.mutants if mutant.name == name), None)
    state = "failed" if mutant else "untouched" if name == "stub" else "passed"
    if there["state"] != state:
        yield f"the page says {there['state']} ({there.get('message')} {there.get('failures', [])[:1]}), and should say {state}"
        return
    if state == "passed" and there["said"].strip() != exercise.expected.strip():
        yield f"the page prints '{there['said'].strip()}', and the exercise promises '{exercise.expected.strip()}'"
    if mutant:
        failed = {failure["name"] for failure in there["failures"]}
        yield from (f"fails in the page alone: {case}" for case in sorted(failed - set(mutant.fails)))
        yield from (f"holds in the page alone: {case}" for case in sorted(set(mutant.fails) - failed))
        numbers_fail = set(mutant.fails) <= {failure["name"] for failure in there["failures"] if not failure["message"].startswith(judge.THREW)}
        if numbers_fail and " ".join(mutant.diagnosis.split()) not in there["diagnosis"]:
            yield f"its diagnosis is missing in '{there['diagnosis']}'"


def prove_answer(driver, exercise, name, text, known):
    there = driver.execute_async_script(JUDGE, exercise.number, text)
    faults = list(differences_from_known(exercise, name, there) if known else differences(exercise, there, here(exercise, name, text)))
    print(f"   {exercise.number} {name}: {there['state']}, {there['seconds']:.1f} s" + "".join(f"\n      {fault}" for fault in faults), flush=True)
    return [f"{exercise.number} {name}: {fault}" for fault in faults]


def open_exercise(driver, address, exercise):
    """Its editor, ready, beside those of the chapter's other exercises: they share a compiler."""
    page = f"{address}exercises_{exercise.chapter[:2]}.html"
    if driver.current_url != page:
        driver.get(page)
        WebDriverWait(driver, 60).until(lambda d: d.execute_script("return document.readyState") == "complete")
    begun = time.monotonic()
    if fault := driver.execute_async_script(OPEN, exercise.number):
        sys.exit(f"{exercise.number}: its editor does not open: {fault}")
    print(f"{exercise.number} {exercise.title}: ready after {time.monotonic() - begun:.1f} s", flush=True)
    width = driver.execute_script("return document.scrollingElement.scrollWidth")
    if width > PHONE["width"]:
        yield f"{exercise.number}: {width} px wide on a screen of {PHONE['width']} px"


def prove_page(book, exercises, part=None, known=False):
    """@return the faults of these exercises' answers, or of a part of them, and how many answers these are"""
    tasks = [(exercise, *answer) for exercise in exercises for answer in answers_of(exercise) if not (known and answer[0] in BROKEN)]
    tasks = part_of(tasks, part) if part else tasks
    if not known:
        workshop.build({"check_main"} | {target for exercise, *_ in tasks for target in (f"check_{exercise.target}", f"chapter{exercise.chapter[:2]}_experiments")})
    faults, opened = [], None
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), partial(editor.lab.Quiet, directory=str(book)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    driver = browser()
    driver.set_script_timeout(SECONDS)
    screen(driver, PHONE)
    try:
        for exercise, name, text in tasks:
            if exercise is not opened:
                faults += open_exercise(driver, f"http://127.0.0.1:{server.server_address[1]}/", exercise)
                opened = exercise
            faults += prove_answer(driver, exercise, name, text, known)
        faults += [f"console: {entry['message'][:200]}" for entry in driver.get_log("browser") if entry["level"] == "SEVERE" and "favicon" not in entry["message"]]
    finally:
        driver.quit()
        server.shutdown()
    return faults, len(tasks)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--page", action="store_true", help=argparse.SUPPRESS)  # as it is typed: ./course prove --page
    parser.add_argument("number", nargs="?", metavar="N[.M]", help="a chapter's exercises, or one")
    parser.add_argument("--part", metavar="K/N", help="of the answers the K-th of N parts")
    parser.add_argument("--known", action="store_true", help="against what ./course prove proves, without a native compiler")
    parser.add_argument("--book", type=Path, default=ROOT / "build/book")
    options = parser.parse_args()
    if not (options.book / "live/editor").is_dir():
        sys.exit(f"{options.book} has no exercises in its pages: ./course docs --live brings them, where npm gives what they need")
    exercises = [exercise for exercise in editor.offered() if options.number in (None, exercise.number, exercise.number.split(".")[0])]
    if not exercises:
        sys.exit(f"{options.number}: the pages offer {', '.join(exercise.number for exercise in editor.offered())}")
    faults, count = prove_page(options.book.resolve(), exercises, options.part, options.known)
    print(*faults, sep="\n")
    print(f"\n{len(faults)} faults in {count} answers" if faults else f"\nProven: {count} answers to {len(exercises)} exercises get in the page what ./course {'prove' if options.known else 'check'} says.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
