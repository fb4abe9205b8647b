"""Proves the exercises: each stub fails by its own "not implemented yet", each solution passes, each mutant is rejected."""
import collections
import json
import os
import shutil
from concurrent.futures import ThreadPoolExecutor

import beside
import layers
import update
import workshop
from catalogue import FEWEST_MUTANTS, shown
from judge import judge

FEWEST_LINES, MOST_LINES = 15, 40


def prove(exercises, renew, part=None):
    """Proves these exercises and prints what does not hold.
    @param renew  first write the stubs anew from their sources
    @param part   of the mutants only the K-th of N parts, as in "2/4"
    @return the exit status"""
    made = [exercise for exercise in exercises if renew and write_stub(exercise)]
    workshop.prepare(exercises, reconfigure=bool(made))
    mutants = [(exercise, mutant_task(mutant)) for exercise in exercises for mutant in exercise.mutants]
    tasks = [(exercise, task) for exercise in exercises for task in tasks_of(exercise)]
    tasks += layers.part_of(mutants, part) if part else mutants
    faults = [fault for found in run_side_by_side(run_task, tasks) for fault in found]
    faults += [fault for exercise in exercises for fault in shape_faults(exercise)]
    for fault in faults:
        print(fault)
    return tell(exercises, faults, part)


def run_side_by_side(work, tasks):
    """What came of each task, in their order, as soon as it is known."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        yield from pool.map(work, tasks)


def prove_layers(versions, renew):
    """Proves that the layers' tests notice these wrong versions, and says of each which test did.
    @param renew  write down the names of the tests that noticed
    @return the exit status"""
    layers.prepare(versions)
    faults = 0
    for said, is_fault in run_side_by_side(lambda version: layers.prove(version, renew), versions):
        print(said, flush=True)
        faults += is_fault
    return tell_layers(versions, faults)


def write_stub(exercise):
    """Whether the stub was written for the first time: then the build has to be configured again."""
    first = not exercise.stub.is_file()
    if first or not exercise.untouched(exercise.stub):
        if not first and exercise.holds_answer(exercise.stub):
            print(update.keep_answer(exercise))
        exercise.stub.write_text(exercise.stub_text(), encoding="utf-8")
        print(f"written: {shown(exercise.stub)}")
    return first


def shape_faults(exercise):
    """What can be said without running anything."""
    if not exercise.untouched(exercise.stub):
        yield f"{exercise.number}: {shown(exercise.stub)} " + (
            f"holds an answer (./course update keeps it as {shown(exercise.answer)})" if exercise.holds_answer(exercise.stub)
            else f"is not what its source makes (./course prove {exercise.number} --renew)")
    lines = exercise.missing_lines()
    if not FEWEST_LINES <= lines <= MOST_LINES:
        yield f"{exercise.number}: {lines} lines are missing, and should be {FEWEST_LINES} to {MOST_LINES}"
    if len(exercise.mutants) < FEWEST_MUTANTS[exercise.kind]:
        yield f"{exercise.number}: {len(exercise.mutants)} mutants, and a {exercise.kind} needs {FEWEST_MUTANTS[exercise.kind]}"


def tasks_of(exercise):
    yield prove_stub
    yield prove_solution
    if exercise.second:
        yield prove_second


def mutant_task(mutant):
    return lambda exercise: prove_mutant(exercise, mutant)


def run_task(task):
    exercise, proof = task
    return [f"{exercise.number}: {fault}" for fault in proof(exercise)]


def folder_of(exercise, name):
    folder = workshop.WORK / "proof" / exercise.number / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def prove_stub(exercise):
    folder = folder_of(exercise, "stub")
    stub = folder / f"{exercise.name}.cpp"
    stub.write_text(exercise.stub_text(), encoding="utf-8")
    outcome = judge(exercise, stub, folder)
    if outcome.state != "untouched":
        others = [failure.message for failure in outcome.failures if not failure.message.startswith("not implemented")]
        passing = outcome.cases - len(outcome.failed_cases)
        yield f"the stub should fail each case by 'not implemented yet'; it is {outcome.state}, {passing} cases pass. {outcome.message} {others[:1]}"
    elif any(not failure.message.endswith(f": {exercise.number}") for failure in outcome.failures):
        yield "the stub names another exercise"


def prove_solution(exercise):
    folder = folder_of(exercise, "solution")
    yield from passes(exercise, exercise.source, folder, "the solution")
    if exercise.kind == "rebuild":
        result = beside.lay_beside(exercise, folder)
        if isinstance(result, str) or not result[1]:
            yield f"the solution's scene: {beside.told(result) if isinstance(result, str) else 'its picture is not the reference picture'}"


def prove_second(exercise):
    yield from passes(exercise, exercise.second, folder_of(exercise, "second"), "the second solution")


def passes(exercise, source, folder, who):
    outcome = judge(exercise, source, folder)
    if outcome.state != "passed":
        yield f"{who} is {outcome.state}: {outcome.message} {outcome.failures[:2]}"
    elif outcome.said.strip() != exercise.expected.strip():
        yield f"{who} prints, where the exercise promises something else:\n{outcome.said}"


def prove_mutant(exercise, mutant):
    folder = folder_of(exercise, mutant.name)
    source = folder / f"{exercise.name}.cpp"
    source.write_text(exercise.mutated(mutant), encoding="utf-8")
    outcome = judge(exercise, source, folder, chapters_tests=False)
    if outcome.state != "failed":
        yield f"mutant {mutant.name} should be rejected by the check, and is {outcome.state}: {outcome.message}"
    elif set(outcome.failed_cases) != set(mutant.fails):
        yield f"mutant {mutant.name} fails in {outcome.failed_cases}, and its entry says {mutant.fails}"


def tell(exercises, faults, part=None):
    """The counts, for the terminal and for the book."""
    counts = {"exercises": len(exercises), "stubs": len(exercises), "solutions": len(exercises),
              "second_solutions": sum(1 for exercise in exercises if exercise.second),
              "mutants": sum(len(exercise.mutants) for exercise in exercises), "faults": len(faults)}
    workshop.WORK.mkdir(parents=True, exist_ok=True)
    (workshop.WORK / "proof.json").write_text(json.dumps(counts, indent=1) + "\n", encoding="utf-8")
    if faults:
        print(f"\n{len(faults)} faults in {counts['exercises']} exercises")
        return 1
    print(f"\nProven: {counts['exercises']} exercises, their stubs fail by 'not implemented yet' and their solutions pass, "
          f"{counts['second_solutions']} of them a second time; {f'part {part} of the ' if part else ''}{counts['mutants']} mutants {'is' if part else 'are'} rejected.")
    return 0


def tell_layers(versions, faults):
    """The counts by layer."""
    counts = collections.Counter(version.layer for version in versions)
    print("\n" + ", ".join(f"{count} of {layer}" for layer, count in counts.items()))
    if faults:
        print(f"{faults} faults in {len(versions)} wrong versions")
        return 1
    print(f"Proven: {len(versions)} wrong versions of {len(counts)} layers, each noticed by a test.")
    return 0
