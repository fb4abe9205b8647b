"""What a student types: check, hint and solution."""
import os
import re
import shutil
import tempfile
import textwrap
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import beside
import workshop
from alone import alone
from catalogue import CLOSE_THE_PAGE, KINDS, all_exercises, filled, shown
from judge import NOT_IMPLEMENTED, THREW, judge
from progress import Progress
from terminal import plain

MOST_FAILURES = 3
MUTANT_JUDGES = ThreadPoolExecutor(os.cpu_count())  # one for all answers: a class is graded by as many threads again
JUDGED_MUTANTS = {}  # outcomes by the check and the mutant's name


def check(exercises, named):
    """Judges the attempts among these exercises and says what is next.
    @param named  whether the student named single exercises: then they are judged even where they held before
    @return the exit status: 0 when all of these exercises are right"""
    progress = Progress()
    touched = [exercise for exercise in exercises if not exercise.untouched()]
    to_judge = [exercise for exercise in touched if named or not progress.holds(exercise)]
    if to_judge:
        workshop.prepare(to_judge)
    wrong = next((found for exercise in to_judge if (found := judge_attempt(exercise, progress))), None)
    if wrong:
        tell_wrong(*wrong)
    if not named:
        tell_list(exercises, progress, wrong)
    if not wrong:
        tell_next(exercises, progress, named)
    return 0 if all(progress.holds(exercise) for exercise in exercises) else 1


def judge_attempt(exercise, progress):
    """Judges one attempt, and tells of a right one.
    @return (exercise, Outcome) of a wrong one, else nothing"""
    folder = workshop.WORK / exercise.number
    with alone(folder, f"judging {exercise.number}"):
        outcome = judge(exercise, exercise.attempt, folder)
        progress.note(exercise, outcome.state == "passed")
        if outcome.state != "passed":
            return exercise, outcome
        tell_right(exercise, outcome)
    return None


def file_of(exercise):
    """The student's file, as it is typed; the stub is laid there when there is none yet."""
    if not exercise.answer.is_file() and exercise.untouched(exercise.stub):
        exercise.answer.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(exercise.stub, exercise.answer)
    return shown(exercise.attempt)


def tell_right(exercise, outcome):
    own, chapters = (outcome.held_before, outcome.cases) if outcome.held_before else (outcome.cases, 0)
    print(f"\n{exercise.number} {exercise.title}: right. All {own} properties hold" + (f", and {chapters} tests of the chapter." if chapters else "."))
    print(textwrap.indent(outcome.said.rstrip(), "   "))
    if exercise.kind == "rebuild":
        print(beside.told(beside.lay_beside(exercise, workshop.WORK / exercise.number)))


def tell_wrong(exercise, outcome):
    """What fails, on which input, expected and got; and a misconception that fails in the same way."""
    head = f"\n{exercise.number} {exercise.title}: "
    if outcome.state == "untouched":
        print(head + "not implemented yet.")
    elif outcome.state == "does_not_compile":
        print(head + f"does not compile yet.\n\n{outcome.message}")
    elif outcome.state != "failed":
        print(head + outcome.message)
    else:
        failed = outcome.failed_cases
        if outcome.held_before:
            print(head + f"its {outcome.held_before} properties hold, and of the chapter's {outcome.cases} tests {outcome.cases - len(failed)}.")
        else:
            print(head + f"{outcome.cases - len(failed)} of {outcome.cases} properties hold.")
        for case in failed[:MOST_FAILURES]:
            tell_failure(next(failure for failure in outcome.failures if failure.case == case))
        if len(failed) > MOST_FAILURES:
            print("\n  nor do these hold:", *failed[MOST_FAILURES:], sep="\n    ")
        tell_misconceptions(exercise, outcome)
    print(f"\nYour file: {file_of(exercise)}    A hint: ./course hint {exercise.number}")


def tell_failure(failure):
    print(f"\n  does not hold: {failure.case}")
    for line in failure.given:
        print(textwrap.indent(line, "    with "))
    print(textwrap.indent(failure.message, "    "))


def tell_misconceptions(exercise, outcome):
    """Those with the same wrong numbers."""
    found = misconceptions(exercise, outcome)
    for mutant in found:
        tell_diagnosis("Perhaps: " if tells_apart(outcome) else "This has many possible reasons. One of them: ", mutant)


def tells_apart(outcome):
    """Whether what the answer got holds a number that few mistakes share; yes, no, and small whole numbers are got by many."""
    return any(re.search(r"\d\.\d{2}|\d{3}|\de[-+]\d", failure.message.partition(", got ")[2]) for failure in outcome.failures)


def tell_diagnosis(head, mutant):
    print("\n" + textwrap.fill(head + " ".join(mutant.diagnosis.split()), 100, subsequent_indent="   "))


def misconceptions(exercise, outcome):
    """The mutants most of whose wrong numbers are this answer's too; of these, those that explain the most. Where two mistakes
    meet, one of them is still told."""
    cases, mine = cases_to_explain(outcome), told(outcome)
    possible = [mutant for mutant in exercise.mutants if set(mutant.fails) <= cases]
    theirs = [told(its) for its in MUTANT_JUDGES.map(lambda mutant: judge_mutant(exercise, mutant), possible)]
    found = [(len(its & mine), mutant) for mutant, its in zip(possible, theirs) if 2 * len(its & mine) > len(its)]
    most = max((same for same, _ in found), default=0)
    return [mutant for same, mutant in found if same == most]


def cases_to_explain(outcome):
    """The cases with a wrong number: not those that are unwritten, or threw an exception."""
    return {failure.case for failure in outcome.failures if not failure.message.startswith((THREW, NOT_IMPLEMENTED))}


def told(outcome):
    return {(failure.case, failure.message) for failure in outcome.failures}


def judge_mutant(exercise, mutant):
    """The same for every answer, so a class's wrong answers ask for each mutant once."""
    key = exercise.check, mutant.name
    if key not in JUDGED_MUTANTS:
        with tempfile.TemporaryDirectory() as scratch:
            source = Path(scratch) / f"{exercise.name}.cpp"
            source.write_text(exercise.mutated(mutant), encoding="utf-8")
            JUDGED_MUTANTS[key] = judge(exercise, source, Path(scratch), chapters_tests=False)
    return JUDGED_MUTANTS[key]


def tell_list(exercises, progress, wrong):
    """The progress list."""
    print()
    for exercise in exercises:
        if wrong and exercise is wrong[0]:
            state = "at work"
        elif exercise.untouched():
            state = "waits"
        else:
            state = "right" if progress.holds(exercise) else "not judged"
        print(f"  {exercise.number:5} {state:10}  {exercise.title}")


def tell_next(exercises, progress, named):
    """Where to go on; after a single exercise, among all: in its chapter, behind it, then before it; then in the next chapters."""
    done = exercises[-1] if named and not exercises[0].untouched() else None
    if done:
        exercises = all_exercises()
    right = [exercise for exercise in exercises if progress.holds(exercise)]
    waiting = [exercise for exercise in exercises if exercise.untouched()]
    if not waiting:
        print(f"\nAll {len(right)} hold. Well done.")
        return
    exercise = min(waiting, key=lambda one: (one.chapter != done.chapter, one.order < done.order, one.order)) if done else waiting[0]
    count = "" if named and len(exercises) == 1 else f"{len(right)} of {len(exercises)} hold. "
    print(f"\n{count}Next: {exercise.number} {exercise.title} "
          f"({KINDS[exercise.kind]}; {exercise.minutes} minutes, difficulty {exercise.difficulty} of 3)")
    print(textwrap.fill(" ".join(exercise.goal.split()), 100, initial_indent="   ", subsequent_indent="   "))
    print(f"   Its text: ./course exercise {exercise.number}    Your file: {file_of(exercise)}\n"
          f"   When you have written something: ./course check {exercise.number}")


def show_text(exercise):
    """An exercise's text, as the terminal can show it."""
    print(f"{exercise.number} {exercise.title}\n{KINDS[exercise.kind]}; {exercise.minutes} minutes, difficulty {exercise.difficulty} of 3\n")
    print(plain(f"{exercise.goal.strip()}\n\n{filled(exercise.text.strip(), exercise.check.read_text(encoding='utf-8'))}"))
    if exercise.kind == "rebuild":
        print(f"\n{CLOSE_THE_PAGE}")
    if exercise.asks_first and exercise.untouched():
        print("\nWhat a right answer prints is shown here once you have begun: first your prediction.")
    else:
        print(f"\nA right answer prints:\n{textwrap.indent(exercise.expected.strip(), '   ')}")
    print(f"\nYour file: {file_of(exercise)}    Judge it: ./course check {exercise.number}    A hint: ./course hint {exercise.number}")


def hint(exercise):
    """One hint more than the last time."""
    shown_now = Progress().show_hint(exercise)
    for step, text in enumerate(exercise.hints[:shown_now], 1):
        print(f"Hint {step} of {len(exercise.hints)}\n{textwrap.indent(plain(text), '   ')}\n")
    if shown_now < len(exercise.hints):
        print(f"One more: ./course hint {exercise.number}")


def solution(exercise, second):
    """The lines that were missing; the whole file is named."""
    path = exercise.second if second else exercise.source
    if path is None:
        print(f"{exercise.number} has one solution only.")
        return 1
    print(path.read_text(encoding="utf-8") if second else "\n\n".join(exercise.missing_functions()))
    other = "" if second or not exercise.second else f"    Another one: ./course solution {exercise.number} --second"
    print(f"\nThe file: {shown(path)}{other}")
    return 0

