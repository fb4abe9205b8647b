"""The pages that the exercises make: for each chapter its exercises and their solutions, and all misconceptions."""
import html
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "exercises"))
import catalogue  # noqa: E402

KIND_NAMES = {"rebuild": "rebuild", "extend": "go further", "predict": "predict"}

CLOSED = "\\htmlonly[block]\n</details>\n\\endhtmlonly"


def opened(summary):
    """The head of a folded part; CLOSED ends it."""
    return f"\\htmlonly[block]\n<details><summary>{summary}</summary>\n\\endhtmlonly"


def by_chapter(root):
    """The exercises of each chapter that has some: {folder: [exercise]}."""
    chapters = {}
    for exercise in catalogue.all_exercises(root):
        chapters.setdefault(exercise.chapter, []).append(exercise)
    return chapters


def pages(root):
    """(label, title, lines) of each page, for the weaver."""
    chapters = by_chapter(root)
    for folder, exercises in chapters.items():
        number = int(folder[:2])
        yield f"exercises_{folder[:2]}", f"Exercises to chapter {number}", exercise_page(root, folder, exercises)
        yield f"solutions_{folder[:2]}", f"Solutions to chapter {number}", solution_page(root, folder, exercises)
    if chapters:
        yield "page_misconceptions", "Misconceptions", misconception_page(chapters)


def stars(exercise):
    return f'<span title="difficulty {exercise.difficulty} of 3">{"★" * exercise.difficulty}{"☆" * (3 - exercise.difficulty)}</span>'


def list_block(root, folder):
    """The table of a chapter's exercises, for the chapter's page; "" when it has none."""
    exercises = by_chapter(root).get(folder)
    if not exercises:
        return ""
    rows = [f'| \\ref exercise_{anchor(exercise)} "{exercise.number} {exercise.title}" | {KIND_NAMES[exercise.kind]} | '
            f'{exercise.minutes} | {stars(exercise)} |' for exercise in exercises]
    return "\n".join(['<div class="data">', "", "| Exercise | Kind | Minutes | Difficulty |", "|:--|:--|--:|:--|", *rows, "", "</div>", "",
                      f"Their texts: \\subpage exercises_{folder[:2]}. `./course check {int(folder[:2])}` judges them."])


def anchor(exercise):
    return exercise.number.replace(".", "_")


def exercise_page(root, folder, exercises):
    number = int(folder[:2])
    yield (f"To \\ref chapter_{folder[:2]}. Write into the file that each exercise names, then type `./course check {number}`: it says what "
           f"holds and what is next. The solutions: \\subpage solutions_{folder[:2]}.")
    for exercise in exercises:
        yield from ["", f"## {exercise.number} {exercise.title} {{#exercise_{anchor(exercise)}}}", "",
                    f'<div class="exercise">{KIND_NAMES[exercise.kind]} · {exercise.minutes} minutes · {stars(exercise)}</div>', "",
                    *exercise.goal.strip().splitlines(), "", *exercise.text.strip().splitlines(), ""]
        header = exercise.stub.with_suffix(".hpp")
        if header.is_file():
            yield from listing(root, header, header.read_text(encoding="utf-8"))
        if exercise.kind == "rebuild":
            yield from [catalogue.CLOSE_THE_PAGE, ""]
        yield from [f"Your file is `{catalogue.shown(exercise.answer)}` (`./course exercise {exercise.number}` lays it there); `./course check {exercise.number}` judges it.", ""]
        yield from expected(exercise)
        yield from hints(exercise.hints, 1)


def expected(exercise):
    """What a right answer prints; folded where the exercise asks for a prediction, which it tells."""
    printed = ["", "```", *exercise.expected.strip().splitlines(), "```", ""]
    if exercise.asks_first:
        yield from [opened("What a right answer prints: first write down your prediction"), *printed, CLOSED, ""]
    else:
        yield from ["A right answer prints:", *printed]


def hints(texts, step):
    """One hint inside the other, so that each is opened on its own."""
    if not texts:
        return
    yield from [opened(f"Hint {step}"), "", *texts[0].strip().splitlines(), ""]
    yield from hints(texts[1:], step + 1)
    yield from [CLOSED, ""]


def listing(root, path, text):
    shown = path.relative_to(root).as_posix()
    yield from [f'<div class="listing">{shown}</div>', "", "```cpp", *text.strip().splitlines(), "```", ""]


def solution_page(root, folder, exercises):
    yield f"To \\ref exercises_{folder[:2]}. Each is folded: try first."
    for exercise in exercises:
        yield from ["", f"## {exercise.number} {exercise.title} {{#solution_{anchor(exercise)}}}", "", opened("Solution"), ""]
        yield from listing(root, exercise.source, "\n\n".join(exercise.missing_functions()))
        yield from [CLOSED, ""]
        if exercise.second:
            yield from [opened("Another way"), ""]
            yield from listing(root, exercise.second, exercise.second.read_text(encoding="utf-8"))
            yield from [CLOSED, ""]


def misconception_page(chapters):
    count = sum(len(exercise.mutants) for exercises in chapters.values() for exercise in exercises)
    yield (f"{count} plausible wrong answers, and what the check tells a student whose answer fails in the same way. Each is compiled and "
           "rejected whenever the course is tested (`./course prove`).")
    for folder, exercises in chapters.items():
        yield from ["", f"## Chapter {int(folder[:2])} {{#misconceptions_{folder[:2]}}}", ""]
        for exercise in exercises:
            yield from [f'\\ref exercise_{anchor(exercise)} "{exercise.number} {exercise.title}"', ""]
            for mutant in exercise.mutants:
                name = html.escape(mutant.name.replace("_", " "))
                yield f'- **{name}.** {" ".join(mutant.diagnosis.split())}'
            yield ""
