"""Hidden checks: the course's with other numbers and seeds. Numbers are changed only where the solution still passes and every known wrong
answer is still rejected.

Changed are the numbers that a check names (`const double mass = 0.3`), the lists that it goes through, and its seeds. Numbers inside of
its sentences are not: what a hidden check says is for the teacher.
"""
import os
import random
import re
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import workshop
from catalogue import ROOT, filled
from judge import properties_of, run_cases

NUMBER = r"(?<![\w.])\d+(?:\.\d*)?(?:e[+-]?\d+)?(?![\w.])"
NAMED = re.compile(rf"\bconst double [^;{{}}]*;|for \(const double \w+ : \{{([^}}]*)\}}\)")
DECLARED = re.compile(rf"= *({NUMBER}) *(?=[,;])|(?<=[{{,]) *({NUMBER}) *(?=[}},])")
SEED = re.compile(r"\bRandomInputs \w+\((\d+)\)|\bunsigned seed = (\d+); seed <= (\d+)")
THROWS = 4  # of the dice, until a check bites
HEAD = "// A hidden variant of exercises/{}: other numbers, other seeds (from {}). Its sentences still tell the published ones.\n"


def sites(text):
    """(kind, spans) of each number that may change: kind is "number" or "seed"; the two ends of a range of seeds move together."""
    found = [("number", [match.span(group)]) for named in NAMED.finditer(text)
             for match in DECLARED.finditer(text, named.start(), named.end()) for group in (1, 2) if match[group]]
    found += [("seed", [match.span(group) for group in (1, 2, 3) if match[group]]) for match in SEED.finditer(text)]
    return sorted(found, key=lambda site: site[1])


def varied(text, seed, chosen=None):
    """The text with its numbers changed, each by up to a fifth, and its seeds moved.
    @param chosen  only these of the sites"""
    dice, changes = random.Random(seed), []
    shift = dice.randrange(1000, 1000000)
    for i, (kind, spans) in enumerate(sites(text)):
        factor = 1 + dice.choice((-1, 1)) * dice.uniform(0.05, 0.2)
        changes += [(span, kind, factor) for span in spans if chosen is None or i in chosen]
    for (first, last), kind, factor in reversed(changes):
        new = str(int(text[first:last]) + shift) if kind == "seed" else repr(float(f"{float(text[first:last]) * factor:.3g}"))
        text = text[:first] + new + text[last:]
    return text


def variants(exercise, seeds):
    """For each seed (the check with other numbers, how many were changed); ("", 0) where there is none to change."""
    text = exercise.published_check.read_text(encoding="utf-8")
    if not sites(text):
        yield from (("", 0) for _ in seeds)
        return
    with tempfile.TemporaryDirectory(prefix="enduring_") as scratch:
        answers = compiled(exercise, Path(scratch))
        for seed in seeds:
            tried = ((dice, kept_sites(exercise, answers, text, dice)) for dice in (seed, *(f"{seed}.{throw}" for throw in range(1, THROWS))))
            yield next(((varied(text, dice, kept), len(kept)) for dice, kept in tried if kept), ("", 0))


def write_variant(exercise, folder, seed):
    """Writes the hidden check of an exercise, where there is a number to change.
    @return how many were changed"""
    (text, count), = variants(exercise, [seed])
    return write_hidden(exercise, folder, seed, text, count)


def write_hidden(exercise, folder, seed, text, count):
    if count:
        path = folder / exercise.chapter / exercise.check.name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(HEAD.format(exercise.check.relative_to(ROOT / "exercises"), seed) + text, encoding="utf-8")
    return count


def write_exam(exercise, folder, seed):
    """Writes the hidden check of an exercise for exams, and into folder/exam what its students get: text and check with other numbers again, and the stub.
    @return how many numbers were changed in the hidden check"""
    (hidden, count), (shown, _) = variants(exercise, [seed, f"{seed}.shown"])
    shown = shown or exercise.published_check.read_text(encoding="utf-8")
    place = folder / "exam/exercises" / exercise.chapter
    place.mkdir(parents=True, exist_ok=True)
    declared, asked = exercise.stub.with_suffix(".hpp"), exercise.stub.with_suffix(".toml")
    for name, text in ((exercise.published_check.name, shown), (exercise.stub.name, exercise.stub_text()), (exercise.kept_stub.name, exercise.stub_text()),
                       (asked.name, filled(asked.read_text(encoding="utf-8"), shown)), (declared.name, declared.read_text(encoding="utf-8"))):
        (place / name).write_text(text, encoding="utf-8")
    return write_hidden(exercise, folder, seed, hidden, count)


def kept_sites(exercise, answers, text, dice):
    """Which numbers may change with these dice: all, or those that the solution can spare one by one; none, if then the check does not bite."""
    kept = list(range(len(sites(text))))
    if bites(exercise, answers, varied(text, dice, kept)):
        return kept
    kept = [i for i in kept if passes(exercise, answers[0], varied(text, dice, {i}))]
    return kept if kept and bites(exercise, answers, varied(text, dice, kept)) else []


def compiled(exercise, folder):
    """The object files of the solution and of the known wrong answers."""
    texts = [exercise.source.read_text(encoding="utf-8"), *map(exercise.mutated, exercise.mutants)]
    for i, text in enumerate(texts):
        (folder / f"{i}.cpp").write_text(text, encoding="utf-8")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda i: workshop.compile_answer(exercise, folder / f"{i}.cpp", folder / str(i)), range(len(texts))))


def bites(exercise, answers, text):
    """Whether the solution passes this check, and no wrong answer does."""
    return passes(exercise, answers[0], text) and not any(passes(exercise, wrong, text) for wrong in answers[1:])


def passes(exercise, answer, text):
    """Whether an answer passes this check; none does where it does not compile."""
    hidden = answer.with_name(exercise.check.name)
    hidden.write_text(text, encoding="utf-8")
    judged_by_it = replace(exercise, hidden=hidden)
    try:
        workshop.link_check(judged_by_it, answer, answer.with_name("check"))
    except (workshop.DoesNotCompile, workshop.NotBuilt):
        return False
    return run_cases(answer.with_name("check"), expected=properties_of(judged_by_it)).state == "passed"


def write_variants(exercises, folder, seed, exams=()):
    """Writes the hidden checks of all exercises and says which have none; and the exercises for exams, with their hidden checks."""
    workshop.prepare([*exercises, *exams])
    without = []
    for exercise in [*exercises, *exams]:
        count = (write_exam if exercise in exams else write_variant)(exercise, folder, seed)
        print(f"  {exercise.number}: {count} numbers changed" if count else f"  {exercise.number}: none", flush=True)
        without += [] if count else [exercise.number]
    print(f"\nHidden checks: {folder}. Keep them to yourself; ./course grade FOLDER --hidden {folder}")
    if exams:
        print(f"For an exam: {', '.join(exam.number for exam in exams)}, in {folder / 'exam'}. On the day: cp -r {folder / 'exam'}/. HANDOUT")
    if without:
        print(f"Without one, for they name no number that can change alone: {', '.join(without)}. Write yours there, as NN_name/M_title.check.cpp.")


def with_hidden(exercise, folder):
    """The exercise, judged by the hidden check where there is one."""
    hidden = folder / exercise.chapter / exercise.check.name
    return replace(exercise, hidden=hidden.resolve()) if hidden.is_file() else exercise
