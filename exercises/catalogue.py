"""The exercises as they lie in the folders: what each asks, its source, its stub, its mutants.

One source makes the stub and the solution. The solution is solutions/NN_name/M_title.cpp, or, for a rebuild, the
chapter's own file; the stub is that file with the bodies of the missing functions taken out.
"""
import os
import re
import tomllib
from dataclasses import dataclass, field, fields
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ANSWERS = os.environ.get("ENDURING_ANSWERS", "answers")  # seen from the top; the tests of the course command have none
KINDS = {"rebuild": "rebuild the chapter's core", "extend": "go past the chapter", "predict": "write down a number, then measure it"}
CLOSE_THE_PAGE = "The chapter prints what you are about to write. Close its page, and write from the formulas."
FIRST_OF_THE_EXAM = 91  # exercises from this place on are kept for exams: neither in the book nor in a handout, while there are solutions
FEWEST_MUTANTS = {"rebuild": 5, "extend": 3, "predict": 3}
TEXTS = {"title": str, "kind": str, "minutes": int, "difficulty": int, "goal": str, "text": str, "hints": list,
         "expected": str, "missing": list}
KIND_NAMES = {str: "text", int: "whole number", list: "list of texts"}
FOR_A_REBUILD = {"source": str, "tests": list, "scene": str, "picture": str}


class CatalogueError(Exception):
    """An exercise's files do not hold what they should; the message names the file."""


@dataclass
class Mutant:
    """A plausible wrong answer: the source with one text replaced, the check's cases it must fail, what to say."""
    name: str
    replace: str
    by: str
    fails: list[str]
    diagnosis: str


@dataclass
class Exercise:
    """One exercise; paths are absolute."""
    number: str          # as in "3.2"
    chapter: str         # the chapter's folder, as in "03_penalty_impulses"
    name: str            # as in "2_title"
    title: str
    kind: str            # rebuild, extend or predict
    minutes: int
    difficulty: int      # 1 to 3
    goal: str
    text: str            # Markdown of the book
    hints: list[str]     # three steps
    expected: str        # what the check prints with a right answer
    missing: list[str]   # the functions whose bodies are taken out
    source: Path
    tests: list[str] = field(default_factory=list)  # the chapter's own cases that judge a rebuild, doctest filters
    scene: str = ""      # the experiment that a rebuild runs
    picture: str = ""    # and its picture
    mutants: list[Mutant] = field(default_factory=list)
    hidden: Path | None = None  # a check of the teacher's own, in the place of the course's

    @property
    def target(self):
        """The number as CMake writes it: "03_2"."""
        return f"{self.chapter[:2]}_{self.name.split('_')[0]}"

    @property
    def order(self):
        chapter, place = self.number.split(".")
        return int(chapter), int(place)

    @property
    def for_exams(self):
        """Whether it is kept back. In a handout, where a teacher has laid it, it is an exercise as the others."""
        return self.order[1] >= FIRST_OF_THE_EXAM and self.source.is_file()

    @property
    def stub(self):
        """What a student starts from."""
        return ROOT / "exercises" / self.chapter / f"{self.name}.cpp"

    @property
    def answer(self):
        """Where a student writes: in a folder that the course's repository leaves alone."""
        return ROOT / ANSWERS / self.chapter / f"{self.name}.cpp"

    @property
    def attempt(self):
        """What is judged: the answer, or where that is not begun the stub, if somebody has written in it."""
        begun = self.answer.is_file() and not self.untouched(self.answer)
        return self.answer if begun or self.answer.is_file() and self.untouched(self.stub) else self.stub

    @property
    def kept_stub(self):
        """In a handout, which has no solutions, what the stub was."""
        return self.stub.with_suffix(".stub")

    @property
    def check(self):
        return self.hidden or self.published_check

    @property
    def published_check(self):
        return ROOT / "exercises" / self.chapter / f"{self.name}.check.cpp"

    @property
    def second(self):
        """An independent second solution, or None."""
        path = ROOT / "solutions" / self.chapter / f"{self.name}.second.cpp"
        return path if path.is_file() else None

    @property
    def asks_first(self):
        """Whether a student should write a prediction down before they see what a right answer prints."""
        return self.kind == "predict" or "Before you run the check" in self.text

    def stub_text(self):
        """What the student starts from."""
        if self.kept_stub.is_file():
            return self.kept_stub.read_text(encoding="utf-8")
        return stub_of(self.source.read_text(encoding="utf-8"), self)

    def untouched(self, path=None):
        path = path or self.attempt
        if not path.is_file():
            raise CatalogueError(f"{shown(path)} is gone; `git checkout {shown(path)}` brings the stub back")
        return path.read_text(encoding="utf-8-sig", errors="replace") == self.stub_text()

    def holds_answer(self, path):
        """Whether a file is no stub, new or old: some body in it is written."""
        placeholder = f'not_implemented_yet("{self.number}");'
        return path.read_text(encoding="utf-8-sig", errors="replace").count(placeholder) < self.stub_text().count(placeholder)

    def missing_functions(self):
        """The definitions, with their bodies, of the functions the student writes."""
        lines = opened(self.source.read_text(encoding="utf-8"), self)
        return ["\n".join(lines[first:last + 1]) for first, _, last in definitions(lines, self)]

    def missing_lines(self):
        """How many lines the student writes: without blank lines and the outer braces."""
        lines = opened(self.source.read_text(encoding="utf-8"), self)
        return sum(1 for _, begin, end in definitions(lines, self) for line in lines[begin + 1:end] if line.strip())

    def mutated(self, mutant):
        """The source with a mutant's mistake in it."""
        text = self.source.read_text(encoding="utf-8")
        if text.count(mutant.replace) != 1:
            raise CatalogueError(f"{shown(self.source)}: mutant {mutant.name}: its text stands there "
                                 f"{text.count(mutant.replace)} times, not once")
        return text.replace(mutant.replace, mutant.by)


def shown(path):
    """A path as a reader types it."""
    return str(path.relative_to(ROOT) if path.is_relative_to(ROOT) else path)


def opened(text, exercise):
    """The lines of a source; a missing function of one line is opened: its body gets a line of its own."""
    names = "|".join(re.escape(name) for name in exercise.missing)
    return re.sub(rf"^([A-Za-z\[].*\b(?:{names})\(.*\)) \{{ (.*) \}}$", r"\1\n{\n    \2\n}", text, flags=re.M).splitlines()


def definitions(lines, exercise):
    """(first line, line of the opening brace, line of the closing brace) of each missing function, in order. A function
    begins at the margin, and its braces stand alone there, as in all our code."""
    found = []
    for name in exercise.missing:
        begins = [i for i, line in enumerate(lines) if re.match(rf"[A-Za-z\[].*\b{re.escape(name)}\(", line)]
        bodies = [span for span in (body_after(lines, i) for i in begins) if span]
        if not bodies:
            raise CatalogueError(f"{shown(exercise.source)}: no function {name} with its braces at the margin")
        found += bodies
    return sorted(found)


def body_after(lines, first):
    """From a signature's first line: its first line (a template's head, too) and the lines of its braces, or None for a
    mere declaration."""
    start = first - 1 if first and lines[first - 1].startswith("template") else first
    for i in range(first, len(lines)):
        if lines[i] == "{":
            end = next((j for j in range(i, len(lines)) if lines[j] == "}"), None)
            return None if end is None else (start, i, end)
        if lines[i].endswith((";", "}")):
            return None
    return None


def stub_of(text, exercise):
    """The source with the missing bodies and the marks of the book's listings taken out, and the include that the
    placeholder needs."""
    lines = [line for line in opened(text, exercise) if not re.fullmatch(r"//!? \[\w+\]", line)]
    for _, begin, end in reversed(definitions(lines, exercise)):
        lines[begin + 1:end] = [f'    not_implemented_yet("{exercise.number}");']
    includes = [i for i, line in enumerate(lines) if line.startswith('#include "')]
    lines.insert(includes[-1] + 1 if includes else 0, '#include "exercises/not_implemented_yet.hpp"')
    return "\n".join(lines) + "\n"


def read(path):
    """One exercise from its toml file.
    @throws CatalogueError naming the file and the key"""
    def fault(message):
        return CatalogueError(f"{shown(path)}: {message}")

    try:
        entries = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise fault(error) from None
    keys = TEXTS | (FOR_A_REBUILD if entries.get("kind") == "rebuild" else {})
    for key, kind in keys.items():
        if key not in entries or not isinstance(entries[key], kind) or not entries[key]:
            raise fault(f"needs {key}, a {KIND_NAMES[kind]}")
    if unknown := set(entries) - set(keys):
        raise fault(f"unknown: {', '.join(sorted(unknown))}")
    if entries["kind"] not in KINDS:
        raise fault(f"kind is {entries['kind']}, and should be one of {', '.join(KINDS)}")
    if not 1 <= entries["difficulty"] <= 3 or len(entries["hints"]) != 3:
        raise fault("difficulty is 1 to 3, and there are three hints")
    chapter, name = path.parent.name, path.stem
    entries["source"] = ROOT / entries.get("source", f"solutions/{chapter}/{name}.cpp")
    if not entries["source"].is_file() and not path.with_suffix(".stub").is_file():
        raise fault(f"there is no {shown(entries['source'])}")
    number = f"{int(chapter[:2])}.{int(name.split('_')[0])}"
    return Exercise(number=number, chapter=chapter, name=name, mutants=mutants_of(chapter, name), **entries)


def mutants_of(chapter, name):
    path = ROOT / "solutions" / chapter / f"{name}.toml"
    if not path.is_file():
        return []
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8")).get("mutant", [])
    except tomllib.TOMLDecodeError as error:
        raise CatalogueError(f"{shown(path)}: {error}") from None
    keys = [entry.name for entry in fields(Mutant)]
    for entries in found:
        if set(entries) != set(keys):
            raise CatalogueError(f"{shown(path)}: mutant {entries.get('name', '')}: needs just {', '.join(keys)}")
    return [Mutant(**entries) for entries in found]


def filled(text, check):
    """A text with the numbers of a check in it: {{mass}} is what the check names `const double mass = 2.5;`.
    @throws CatalogueError for a name that the check does not have"""
    def number(found):
        named = re.search(rf"\bconst double [^;]*\b{found[1]} = ([-\d.e]+)[,;]", check)
        if not named:
            raise CatalogueError(f"the text names {found[1]}, and the check has no such number")
        return named[1]
    return re.sub(r"\{\{(\w+)\}\}", number, text)


def every_exercise(root=ROOT):
    """Those of the course and those for exams, in order."""
    return sorted((read(path) for path in root.glob("exercises/[0-9][0-9]_*/[0-9]*_*.toml")), key=lambda exercise: exercise.order)


def all_exercises(root=ROOT):
    """Every exercise of the course, in its order; without those for exams."""
    return [exercise for exercise in every_exercise(root) if not exercise.for_exams]
