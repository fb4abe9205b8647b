"""The concordance: every number of the thesis bound to a function, a test and a paragraph of the book.

docs/tools/concordance.json says which: "numbers" lists all that there are, and each entry binds one or several of them. A part
that an entry does not have stands in its "why_not", with the reason.
"""
import json
import re
from collections import Counter
from dataclasses import dataclass

KINDS = ("equation", "algorithm", "figure", "experiment", "section")
PARTS = ("function", "test", "paragraph")


@dataclass
class Entry:
    kind: str
    numbers: list
    says: str
    function: str   # FILE NAME
    tests: list
    paragraph: str  # LABEL: HEADING
    why_not: dict   # by part
    line: int       # in the manifest

    @property
    def name(self):
        return f"{self.kind} {', '.join(self.numbers)}"


def spread(numbers):
    """["3.1-3.3", "4.1"] -> ["3.1", "3.2", "3.3", "4.1"]"""
    spread_out = []
    for number in numbers:
        match = re.fullmatch(r"(\d+)\.(\d+)-(\d+)\.(\d+)", number)
        if match and match[1] == match[3]:
            spread_out += [f"{match[1]}.{i}" for i in range(int(match[2]), int(match[4]) + 1)]
        else:
            spread_out.append(number)
    return spread_out


def key_of(number):
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", number)]


class Concordance:
    """The manifest, and what is wrong with it."""

    def __init__(self, root):
        self.root, self.path = root, root / "docs/tools/concordance.json"
        self.numbers, self.entries, self.mistakes = {}, [], []
        if not self.path.is_file():
            return
        text = self.path.read_text(encoding="utf-8")
        try:
            manifest = json.loads(text)
            self.numbers = {kind: spread(manifest["numbers"].get(kind, [])) for kind in KINDS}
            lines = [i for i, line in enumerate(text.splitlines(), start=1) if re.match(r'\s*\{"of"', line)]
            for place, raw in enumerate(manifest["entries"]):
                self.entries.append(self._entry(raw, lines[place] if place < len(lines) else 1))
        except (json.JSONDecodeError, KeyError, TypeError) as mistake:
            self.mistakes.append(f"{self.path}:{getattr(mistake, 'lineno', 1)}: cannot be read: {mistake!r}")

    @staticmethod
    def _entry(raw, line):
        kind, numbers = raw["of"].split(" ", 1)
        tests = raw.get("test", [])
        return Entry(kind, spread([number.strip() for number in numbers.split(";")]), raw["says"], raw.get("function", ""),
                     [tests] if isinstance(tests, str) else tests, raw.get("paragraph", ""), raw.get("why_not", {}), line)

    def check(self, tests, pages):
        """All mistakes: orphans, names of nothing, numbers without an entry.
        @param tests  names of all tests
        @param pages  by label, anything with `lines` of Markdown"""
        mistakes = list(self.mistakes)
        for entry in self.entries:
            found = self._of_entry(entry, tests, pages)
            mistakes += [f"{self.path}:{entry.line}: {entry.name}: {mistake}" for mistake in found]
        return mistakes + [f"{self.path}:1: {mistake}" for mistake in self._of_numbers()]

    def _of_entry(self, entry, tests, pages):
        if entry.kind not in KINDS:
            yield f"'{entry.kind}' is none of {', '.join(KINDS)}"
        for part, value in zip(PARTS, (entry.function, entry.tests, entry.paragraph)):
            if bool(value) == bool(entry.why_not.get(part)):
                yield f"no {part}, and no reason why not" if not value else f"a {part}, and a reason why not"
        yield from (f"no test is called '{name}'" for name in entry.tests if name not in tests)
        if entry.function:
            yield from self._of_function(entry.function)
        if entry.paragraph:
            yield from self._of_paragraph(entry.paragraph, pages)

    def _of_function(self, function):
        file, _, name = function.partition(" ")
        if not (self.root / file).is_file():
            yield f"there is no file {file}"
        elif not name or not all(re.search(rf"\b{re.escape(word)}\b", code_of(self.root / file)) for word in name.split("::")):
            yield f"{file} has no '{name}'"

    @staticmethod
    def _of_paragraph(paragraph, pages):
        label, heading = split_paragraph(paragraph)
        if label not in pages:
            yield f"no page has the label '{label}'"
        elif heading and not any(heading_of(line) == heading for line in pages[label].lines):
            yield f"the page {label} has no heading '{heading}'"

    def _of_numbers(self):
        for kind in KINDS:
            bound = Counter(number for entry in self.entries if entry.kind == kind for number in entry.numbers)
            listed = self.numbers.get(kind, [])
            yield from (f"{kind} {number} is bound to nothing" for number in listed if number not in bound)
            yield from (f"{kind} {number} is bound, and not in the list of numbers" for number in bound if number not in listed)
            yield from (f"{kind} {number} is bound {times} times" for number, times in bound.items() if times > 1)

    def anchors(self, label):
        """Headings of a page that the concordance leads to, and their anchors."""
        targets = [split_paragraph(entry.paragraph) for entry in self.entries if entry.paragraph]
        return {heading: anchor_of(label, heading) for page, heading in targets if page == label and heading}

    def table(self, kind, pages, test_cell):
        """The entries of one kind as a Markdown table.
        @param test_cell  makes the name of a test what a page shows"""
        rows = ["| | What it says, and where to read it | In the code, and shown by |", "|:--|:--|:--|"]
        for entry in sorted((entry for entry in self.entries if entry.kind == kind), key=lambda entry: key_of(entry.numbers[0])):
            numbers = ", ".join(f"({number})" if kind == "equation" else number for number in entry.numbers)
            cells = [numbers, f"{entry.says} <br>{paragraph_cell(entry, pages)}",
                     f"{self._function_cell(entry)} <br>{self._test_cell(entry, test_cell)}"]
            rows.append("| " + " | ".join(cells) + " |")
        return '<div class="data">\n\n' + "\n".join(rows) + "\n\n</div>"

    @staticmethod
    def _function_cell(entry):
        if not entry.function:
            return entry.why_not["function"]
        file, _, name = entry.function.partition(" ")
        return f'`{name}` <span class="path">in {file}</span>'

    @staticmethod
    def _test_cell(entry, test_cell):
        return " <br>".join(map(test_cell, entry.tests)) if entry.tests else entry.why_not["test"]


def split_paragraph(paragraph):
    label, _, heading = paragraph.partition(":")
    return label.strip(), heading.strip()


def heading_of(line):
    """The words of a heading without its anchor, "" for other lines."""
    match = re.match(r"#{2,6}\s+(.+?)\s*(?:\{#\w+\})?\s*$", line)
    return match[1] if match else ""


def anchor_of(label, heading):
    return f"at_{label}_" + re.sub(r"[^a-z0-9]+", "_", heading.lower()).strip("_")


def paragraph_cell(entry, pages):
    if not entry.paragraph:
        return entry.why_not["paragraph"]
    label, heading = split_paragraph(entry.paragraph)
    if not heading:
        return f"\\ref {label}"
    own = next((re.search(r"\{#(\w+)\}\s*$", line) for line in pages[label].lines if heading_of(line) == heading), None)
    shown = re.sub(r'"([^"]*)"', r"“\1”", f"{pages[label].title}: {heading}")  # straight quotes would end the link's text
    return f'\\ref {own[1] if own else anchor_of(label, heading)} "{shown}"'


def code_of(path):
    """A source without its comments."""
    text = path.read_text(encoding="utf-8")
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
