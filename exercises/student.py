"""What a student types: check, hint and solution."""
import re
import tempfile
import textwrap
from pathlib import Path

import beside
import workshop
from catalogue import KINDS, shown
from judge import THREW, judge
from progress import Progress

MOST_FAILURES = 3


def check(exercises, named):
    """Judges the attempts among these exercises and says what is next.
    @param named  whether the student named one exercise: then it is judged even where it held before
    @return the exit status: 0 unless an attempt does not hold"""
    progress = Progress()
    touched = [exercise for exercise in exercises if not exercise.untouched()]
    to_judge = [exercise for exercise in touched if named or not progress.holds(exercise)]
    if to_judge:
        workshop.prepare(to_judge)
    wrong = None
    for exercise in to_judge:
        outcome = judge(exercise, exercise.stub, workshop.WORK / exercise.number)
        progress.note(exercise, outcome.state == "passed")
        if outcome.state != "passed":
            wrong = exercise, outcome
            break
        tell_right(exercise, outcome)
    if wrong:
        tell_wrong(*wrong)
    if not named:
        tell_list(exercises, progress, wrong)
    tell_next(exercises, progress, wrong)
    return 1 if wrong and wrong[1].state != "untouched" else 0


def tell_right(exercise, outcome):
    print(f"\n{exercise.number} {exercise.title}: right. All {outcome.cases} properties hold.")
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
    elif outcome.state in ("too_long", "crashed"):
        print(head + outcome.message)
    else:
        failed = outcome.failed_cases
        print(head + f"{outcome.cases - len(failed)} of {outcome.cases} properties hold.")
        for case in failed[:MOST_FAILURES]:
            tell_failure(next(failure for failure in outcome.failures if failure.case == case))
        if len(failed) > MOST_FAILURES:
            print(f"\n  ... and {len(failed) - MOST_FAILURES} more")
        for mutant in misconceptions(exercise, outcome):
            print("\n" + textwrap.fill("Perhaps: " + " ".join(mutant.diagnosis.split()), 100, subsequent_indent="   "))
    print(f"\nYour file: {shown(exercise.stub)}    A hint: ./course hint {exercise.number}")


def tell_failure(failure):
    print(f"\n  does not hold: {failure.case}")
    for line in failure.given:
        print(textwrap.indent(line, "    with "))
    print(textwrap.indent(failure.message, "    "))


def misconceptions(exercise, outcome):
    """The mutants that fail in just the cases in which this answer fails; none where it threw an exception. Of several, those
    that also get the same wrong numbers, if there are such."""
    if any(failure.message.startswith(THREW) for failure in outcome.failures):
        return []
    alike = [mutant for mutant in exercise.mutants if set(mutant.fails) == set(outcome.failed_cases)]
    if len(alike) < 2:
        return alike
    same_numbers = [mutant for mutant in alike if messages(judge_mutant(exercise, mutant)) == messages(outcome)]
    return same_numbers or alike[:2]


def judge_mutant(exercise, mutant):
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch) / f"{exercise.name}.cpp"
        source.write_text(exercise.mutated(mutant), encoding="utf-8")
        return judge(exercise, source, Path(scratch), chapters_tests=False)


def messages(outcome):
    return [failure.message for failure in outcome.failures]


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


def tell_next(exercises, progress, wrong):
    if wrong:
        return
    right = [exercise for exercise in exercises if progress.holds(exercise)]
    waiting = [exercise for exercise in exercises if exercise.untouched()]
    if not waiting:
        print(f"\nAll {len(right)} hold. Well done.")
        return
    exercise = waiting[0]
    print(f"\n{len(right)} of {len(exercises)} hold. Next: {exercise.number} {exercise.title} "
          f"({KINDS[exercise.kind]}; {exercise.minutes} minutes, difficulty {exercise.difficulty} of 3)")
    print(textwrap.fill(" ".join(exercise.goal.split()), 100, initial_indent="   ", subsequent_indent="   "))
    print(f"   Its text: ./course exercise {exercise.number}    Your file: {shown(exercise.stub)}\n"
          f"   When you have written something: ./course check {exercise.number}")


def show_text(exercise):
    """An exercise's text, as the terminal can show it."""
    print(f"{exercise.number} {exercise.title}\n{KINDS[exercise.kind]}; {exercise.minutes} minutes, difficulty {exercise.difficulty} of 3\n")
    print(plain(f"{exercise.goal.strip()}\n\n{exercise.text.strip()}"))
    print(f"\nA right answer prints:\n{textwrap.indent(exercise.expected.strip(), '   ')}")
    print(f"\nYour file: {shown(exercise.stub)}    Judge it: ./course check {exercise.number}    A hint: ./course hint {exercise.number}")


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


def plain(text):
    """The book's Markdown for a terminal: formulas keep their TeX between dollars, links their words."""
    text = re.sub(r"\\f[$]", "$", re.sub(r"\\f\[|\\f\]", "$$", text.strip()))
    return re.sub(r'\\ref \w+(?: "([^"]*)")?', lambda found: found[1] or "the book", text)
