#!/usr/bin/env python3
"""Weaves the pages of the book: the written text, and what the run measured, into Markdown for Doxygen.

docs/writing.md lists what a page may ask for. A number, table, figure or listing that is not there is an error that
names the page's file and line; all of them are reported, and nothing is written.
"""
import argparse
import csv
import html
import itertools
import re
import shutil
import sys
from dataclasses import dataclass, field
from pathlib import Path

import api_pages
import changes
import checks
import course_map
import exercise_pages
import formulas
import lab
import measured
import sentences
import teaching
import wrong_versions  # beside the catalogue, where exercise_pages found it
from concordance import KINDS, Concordance, heading_of

# Behind the number of a figure or table whose experiment ran in its small version. Sentences have the numbers of the full run in any case.
QUICK_MARK = '<span class="quick" title="./course docs --full makes the other">small version, of a quick run</span>'

LONG_TABLE = 30  # rows; more are folded: the text says what they come to


class Mistake(Exception):
    """Something a page asks for that the build does not have."""


@dataclass
class Figure:
    number: str
    anchor: str
    source: Path
    place: str  # in the finished book
    kept: bool = False  # in the repository: no run made it


@dataclass
class Page:
    path: Path          # of the text
    folder: str         # of its chapter, "" outside the chapters
    label: str = ""
    title: str = ""
    about: str = ""     # one line for lists of pages
    lines: list = field(default_factory=list)      # of the body
    first_line: int = 2
    faults: list = field(default_factory=list)     # of its formulas
    figures: dict = field(default_factory=dict)    # by file name
    tables: dict = field(default_factory=dict)

    @property
    def number(self):
        return str(int(self.folder[:2])) if self.folder else ""


class Results:
    """What the programs left: build/results/NN_name/, and that of all solvers build/results/solvers/."""

    def __init__(self, root):
        self.root = root
        self.folders = checks.result_folders(root)
        self.facts = {folder.name: self._read_facts(folder) for folder in self.folders}

    @staticmethod
    def _read_facts(folder):
        facts = {}
        for path in sorted(folder.glob("facts_*.csv")):
            experiment = path.stem[len("facts_"):]
            with path.open(newline="", encoding="utf-8") as lines:
                facts.update({f"{experiment}.{row['name']}": row["text"] for row in csv.DictReader(lines)})
        return facts

    @staticmethod
    def _of_one_chapter(page, what, name, found_in):
        """A chapter's number before the name decides (6/bunny_bowl.png, solvers/ledger.png); then a page's own chapter comes
        first, and elsewhere a name must be the only one."""
        if "/" in name:
            found_in = [folder for folder in found_in if checks.word_of(folder) == name.split("/")[0]]
        if page.folder in found_in:
            return page.folder
        if not found_in:
            raise Mistake(f"no run left the {what} '{name}'")
        if len(found_in) > 1:
            raise Mistake(f"the {what} '{name}' is in several chapters: {', '.join(found_in)}")
        return found_in[0]

    def fact(self, page, name):
        key = without_chapter(name)
        found_in = [folder for folder, facts in self.facts.items() if key in facts]
        return self.facts[self._of_one_chapter(page, "fact", name, found_in)][key]

    def file(self, page, what, name):
        file = without_chapter(name)
        found_in = [folder.name for folder in self.folders if (folder / file).is_file()]
        chapter = self._of_one_chapter(page, what, name, found_in)
        return next(folder / file for folder in self.folders if folder.name == chapter)


def without_chapter(name):
    return name.split("/")[-1]


# ------------------------------------------------------------------------------------------------- reading the pages
def read_page(path, folder=""):
    page = Page(path, folder)
    text = path.read_text(encoding="utf-8")
    page.faults = [f"{path}:{line}: {told}" for line, told in formulas.faults(text)]
    lines = formulas.for_doxygen(text).splitlines()
    title = re.match(r"#\s+(?:Chapter\s+)?(?:\d+[.:]?\s+)?(.+?)\s*(?:\{#(\w+)\})?$", lines[0] if lines else "")
    if not title:
        raise Mistake(f"{path}:1: a page begins with its title: # Title")
    page.title = f"Chapter {page.number}: {title[1]}" if folder else title[1]
    page.label = title[2] or (f"chapter_{folder[:2]}" if folder else f"page_{path.stem}")
    about = re.match(r"@about\{(.+)\}\s*$", lines[1]) if len(lines) > 1 else None
    page.about = about[1] if about else ""
    page.first_line = 3 if about else 2
    page.lines = lines[page.first_line - 1:]
    return page


def all_pages(root):
    pages = [read_page(path, path.parent.name) for path in sorted((root / "chapters").glob("[0-9][0-9]_*/chapter.md"))]
    pages += [read_page(path) for folder in ("common/*", "docs") for path in sorted(root.glob(f"{folder}/*.md"))
              if path.name != "README.md"]
    for label, title, lines in exercise_pages.pages(root):
        pages.append(Page(root / f"exercises/{label}.md", "", label, title, lines=formulas.for_doxygen("\n".join(lines)).split("\n"), first_line=1))
    for page, other in itertools.combinations(pages, 2):
        if page.label == other.label:
            raise Mistake(f"{other.path}:1: {page.path} has the label {{#{page.label}}} already")
    return pages


def prose(page):
    """The lines outside fenced code, with their numbers."""
    fenced = False
    for number, line in enumerate(page.lines, start=page.first_line):
        if line.lstrip().startswith(("```", "~~~")):
            fenced = not fenced
        elif not fenced:
            yield number, line


FIGURE = re.compile(r"^@figure\{\s*((?:\w+/)?[\w.-]+\.(?:png|svg|webp|mp4))\s*,\s*(.+)\}\s*$")
LIVE = re.compile(r"^@live\{\s*(\w+)\s*,\s*((?:\w+/)?[\w.-]+\.(?:png|svg))\s*,\s*(.+)\}\s*$")
TABLE = re.compile(r"^@table\{\s*((?:\w+/)?[\w-]+)\s*(?:,\s*(.+))?\}\s*$")


def drawn_by_hand(picture):
    """The figures of programs that no run starts are kept, in renders/."""
    kept = Path(__file__).resolve().parents[2] / "renders" / picture
    return kept if "/" in picture and kept.is_file() else None


def number_figures(page, results):
    """Figures and captioned tables are numbered in the order of the page."""
    for line_number, line in prose(page):
        match = FIGURE.match(line) or LIVE.match(line)
        if match:
            picture = match[2] if match.re is LIVE else match[1]
            kept = drawn_by_hand(picture)
            try:
                source = kept or results.file(page, "figure", picture)
            except Mistake as mistake:
                yield f"{page.path}:{line_number}: {mistake}"
                continue
            number = ".".join(filter(None, [page.number, str(len(page.figures) + 1)]))
            page.figures[match[1]] = Figure(number, f"fig_{page.label}_{re.sub(r'[^a-zA-Z0-9]', '_', match[1])}", source,
                                            f"figures/{source.parent.name}/{source.name}", kept is not None)
        match = TABLE.match(line)
        if match and match[2]:
            page.tables[match[1]] = (".".join(filter(None, [page.number, str(len(page.tables) + 1)])),
                                     f"tab_{page.label}_{match[1].replace('/', '_')}")


# --------------------------------------------------------------------------------------------------- what is woven in
def plain_words(caption):
    """A caption for who cannot see the figure."""
    return html.escape(re.sub(r"\\f\$|[*`_]|@\w+\{.*?\}", "", caption))


def with_caption(figure, shown, caption, quick):
    mark = f" {QUICK_MARK}" if quick and not figure.kept else ""
    return f'<div class="figure">\n\\anchor {figure.anchor}\n{shown}\n<div class="caption"><b>Figure {figure.number}.</b>{mark} {caption}</div>\n</div>'


def figure_block(figure, caption, quick):
    plain = plain_words(caption)
    if figure.place.endswith(".mp4"):
        shown = f'<video src="{figure.place}" autoplay loop muted controls playsinline aria-label="{plain}"></video>'
    else:
        shown = f'<a href="{figure.place}"><img src="{figure.place}" alt="{plain}" loading="lazy"></a>'
    return with_caption(figure, f"\\htmlonly{shown}\\endhtmlonly", caption, quick)


def live_block(figure, name, caption, live, quick):
    """A picture that a script replaces where the chapters were compiled for the browser."""
    picture = f'<a href="{figure.place}"><img src="{figure.place}" alt="{plain_words(caption)}"></a>'
    scripts = "".join(f'<script src="live/{script}.js"></script>' for script in ("live", "figure", "turning", name)) if live else ""
    note = "" if live else '<p class="live-note">In the live book this figure answers to your hand: <code>./course docs --live</code></p>'
    shown = f'<div class="live" data-figure="{name}"{" data-live=" + chr(34) + name + chr(34) if live else ""}>{picture}</div>{note}{scripts}'
    return with_caption(figure, f"\\htmlonly[block]\n{shown}\n\\endhtmlonly", caption, quick and not live)


def lab_block(live):
    """The laboratory, where the layers were compiled for the browser."""
    told = lab.BLOCK.format(place="live/") if live else '<p class="live-note">The laboratory stands here in the live book: <code>./course docs --live</code>. By itself: <code>./course lab</code></p>'
    return f"\\htmlonly[block]\n{told}\n\\endhtmlonly"


def table_block(page, name, caption, results, quick):
    rows = results.file(page, "table", name + ".md").read_text(encoding="utf-8").strip()
    columns = rows.splitlines()[0].count("|") - 1
    box = '<div class="data wide widest">' if columns > 12 else '<div class="data wide">' if columns > 8 else '<div class="data">'
    if (length := len(rows.splitlines()) - 2) > LONG_TABLE:
        rows = f"{exercise_pages.opened(f'All {length} rows')}\n\n{rows}\n\n{exercise_pages.CLOSED}"
    mark = f" {QUICK_MARK}" if quick else ""
    if not caption:
        return f'{box}\n\n{rows}\n\n{mark}</div>'
    number, anchor = page.tables[name]
    return (f'{box}\n\\anchor {anchor}\n<div class="caption"><b>Table {number}.</b>{mark} {caption}</div>\n\n'
            f'{rows}\n\n</div>')


LISTING = re.compile(r"^\s*\[(\S+): (.+)\]\((\S+)\)\s*$")


def listing_block(root, page, name, region, link):
    """A listing of the compiled code, which the page links; Doxygen reads it, we make sure that there is something to read."""
    file = (page.path.parent / link).resolve()
    if not file.is_file():
        raise Mistake(f"the listing {name}: {link} is no file")
    shown = file.relative_to(root).as_posix()
    if not f"/{shown}".endswith(f"/{name}"):
        raise Mistake(f"the listing {name} leads to {shown}")
    lines = file.read_text(encoding="utf-8").splitlines()
    marks = [number for number, line in enumerate(lines) if f"[{region}]" in line]
    if len(marks) != 2:
        raise Mistake(f"the listing {name}: the mark [{region}] stands {len(marks)} times in {shown}, not twice")
    if not any(line.strip() for line in lines[marks[0] + 1:marks[1]]):
        raise Mistake(f"the listing {name}: the region [{region}] of {shown} is empty")
    return f'<div class="listing">{shown}</div>\n\\snippet {shown} {region}'


def first_sentence(page):
    """What the page asks: its first paragraph up to the first full stop or question mark."""
    paragraph = re.match(r"\s*((?:[^\n#@\\<].*\n?)+)", "\n".join(page.lines))
    sentence = re.match(r".+?[.?!](?=\s|$)", paragraph[1].replace("\n", " ")) if paragraph else None
    return sentence[0] if sentence else ""


def link_block(weaver, kind):
    chosen = {"chapters": [page for page in weaver.pages if page.folder],
              "common": [page for page in weaver.pages if page.path.parent.parent.name == "common"]}.get(kind)
    if chosen is None:
        raise Mistake(f"@pages{{{kind}}}: either chapters or common")
    return "\n".join(f"- \\subpage {page.label} <br>{weaver.inline(page, page.about or first_sentence(page))}" for page in chosen)


def reference(pages, page, kind, name):
    """@figref and @tabref: 'Figure 3.2', linked."""
    for other in [page] + pages:
        if kind == "figref" and name in other.figures:
            return f'\\ref {other.figures[name].anchor} "Figure {other.figures[name].number}"'
        if kind == "tabref" and name in other.tables:
            return f'\\ref {other.tables[name][1]} "Table {other.tables[name][0]}"'
    raise Mistake(f"@{kind}{{{name}}}: no page shows it under a number")


def test_names(root):
    """The names of all tests, as CTest shows them."""
    sources = [path for top in ("common", "chapters") for path in sorted((root / top).rglob("tests/*.cpp"))]
    return {name.replace('\\"', '"') for path in sources
            for name in re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)+)"', path.read_text(encoding="utf-8"))}


# ------------------------------------------------------------------------------------------------------------ weaving
class Weaver:
    def __init__(self, root, pages, results, live=False, quick=False):
        self.live, self.quick, self.wrong_versions = live, quick, None
        self.root, self.pages, self.results, self.tests = root, pages, results, test_names(root)
        self.chapters = [page for page in pages if page.folder]
        self.concordance, self.by_label = Concordance(root), {page.label: page for page in pages}
        self.orphans = self.concordance.check(self.tests, self.by_label)

    def test(self, name):
        """A test's name, as a row of a table shows it."""
        if name not in self.tests:
            raise Mistake(f"no test is called '{name}'")
        return '<code class="test">' + html.escape(name, quote=False).replace("|", "\\|") + "</code>"

    def tick(self, name):
        """A tick in a sentence, with the test's name behind it: docs/theme/book.css shows it to who points at the tick, or comes to it by keys."""
        return f'<span class="test" tabindex="0">✓{self.test(name)}</span>'

    def wrong(self, page, name):
        """The name of a wrong version, of the page's own chapter or else of any other layer, and of the test that fails in it."""
        if self.wrong_versions is None:
            self.wrong_versions = wrong_versions.all_versions(self.root)
        named = [version for version in self.wrong_versions if version.title == name]
        found = [version for version in named if version.layer == page.folder] or named
        if len(found) != 1:
            raise Mistake(f"{len(found)} wrong versions are called '{name}'")
        fails = found[0].fails
        self.test(fails)
        return f'<code class="test" title="fails: {html.escape(fails)}">{name}</code>'

    def numbers(self, page, text):
        """Sentences are about the full run: where a quick one made the results, the numbers that stand in the source are those."""
        return measured.woven(text, lambda name: self.results.fact(page, name), as_written=self.quick)

    def inline(self, page, text):
        """Measured numbers and references, everywhere but in `code`."""
        in_table = text.lstrip().startswith("|")

        def replaced(match):
            if match[1] == "test":
                return (self.test if in_table else self.tick)(match[2].strip())
            if match[1] == "wrong":
                return self.wrong(page, match[2].strip())
            return reference(self.pages, page, match[1], match[2].strip())
        parts = measured.CODE.split(text)
        parts[::2] = [re.sub(r"@(test|wrong|figref|tabref)\{([^}]*)\}", replaced, self.numbers(page, part)) for part in parts[::2]]
        left = next((found for part in parts[::2] for found in re.findall(r"@(?:fact|test|wrong|figref|tabref|table|figure|pages|about|concordance|exercises|live|lab|map|api|changes|minutes|goals|local)\b.*|<!--(?:(?:\w+/)?\w+\.\w+)?-->.*", part)),
                    None)
        if left:
            raise Mistake(f"cannot read {left[:60]}")
        return "".join(parts)

    def line(self, page, line):
        if match := FIGURE.match(line):
            return figure_block(page.figures[match[1]], self.inline(page, match[2]), self.quick) if match[1] in page.figures else ""
        if match := LIVE.match(line):
            caption = self.inline(page, match[3])
            return live_block(page.figures[match[1]], match[1], caption, self.live, self.quick) if match[1] in page.figures else ""
        if match := TABLE.match(line):
            return table_block(page, match[1], self.inline(page, match[2] or ""), self.results, self.quick)
        if match := re.match(r"^@pages\{(\w+)\}\s*$", line):
            return link_block(self, match[1])
        if line.startswith("@local{"):
            return ""
        if line.strip() == "@lab":
            return lab_block(self.live)
        if line.strip() == "@map":
            return course_map.map_block(self.chapters, self.by_label)
        if line.strip() == "@api":
            return api_pages.api_block(self.root, self.chapters)
        if line.strip() == "@changes":
            return changes.changes_block(self.root, self.results.root, page.folder)
        if match := re.match(r"^@(minutes|goals)\s*$", line):
            return teaching.block(self.root, match[1], self.chapters)
        if line.strip() == "@exercises":
            return exercise_pages.list_block(self.root, page.folder)
        if match := re.match(r"^@concordance\{(\w+)\}\s*$", line):
            if match[1] not in KINDS:
                raise Mistake(f"@concordance{{{match[1]}}}: one of {', '.join(KINDS)}")
            return "" if self.orphans else self.concordance.table(match[1], self.by_label, self.test)
        if anchor := self.concordance.anchors(page.label).get(heading_of(line)):
            return line if "{#" in line else f"{line} {{#{anchor}}}"
        if match := LISTING.match(line):
            return listing_block(self.root, page, *match.groups())
        return self.inline(page, line)

    def page(self, page):
        """The page's Markdown for Doxygen, and what is wrong with it."""
        woven, mistakes = dict(enumerate(page.lines, start=page.first_line)), []
        for number, line in prose(page):
            try:
                woven[number] = self.line(page, line)
            except Mistake as mistake:
                mistakes.append(f"{page.path}:{number}: {mistake}")
        body = "\n".join(woven.values())
        head = f"# {page.title} {{#{page.label}}}\n"
        contents = "" if page.label == "mainpage" or "[TOC]" in body else "\n[TOC]\n"
        return "\n".join([head + contents, body, self.neighbours(page)]), mistakes

    def neighbours(self, page):
        chapters = [other for other in self.pages if other.folder]
        if page not in chapters:
            return ""
        at = chapters.index(page)
        before = f'\\ref {chapters[at - 1].label}' if at else '\\ref index "The start"'
        after = f'\\ref {chapters[at + 1].label}' if at + 1 < len(chapters) else ""
        return f'\n<div class="neighbours"><span>{before}</span> <span>{after}</span></div>\n'


def unlisted_errata(root, tests):
    """Tests named errata: that the page of errata does not show."""
    page = root / "docs/errata.md"
    shown = page.read_text(encoding="utf-8") if page.is_file() else ""
    return [f"{page}:1: the test '{name}' is not listed" for name in sorted(tests)
            if name.startswith("errata:") and f"@test{{{name}}}" not in shown]


def what_nothing_explains(root, pages):
    """Figures that no sentence mentions; symbols and abbreviations that are in no table."""
    texts = [(page.path, "\n".join(page.lines)) for page in pages]
    own = [(path, text, set(re.findall(r"\w+", " ".join(re.findall(r"^@local\{(.*)\}", text, re.M))))) for path, text in texts]
    found = list(checks.figure_faults([(page.path, page.figures, text) for page, (_, text) in zip(pages, texts)]))
    for name, check in (("notation", checks.symbol_faults), ("glossary", checks.abbreviation_faults)):
        table = root / f"docs/{name}.md"
        if table.is_file():
            found += check(own, formulas.for_doxygen(table.read_text(encoding="utf-8")))
    return found


def written_numbers(pages, results, quick):
    """Notes, and mistakes, about the numbers that stand in the pages' sources."""
    notes, mistakes = [], []
    for page in pages:
        try:
            told, wrong = measured.compare(prose(page), lambda name, page=page: results.fact(page, name), quick)
        except Mistake:
            continue  # a number that no run left is told when it is woven
        notes += [f"{page.path}:{line}: {text}" for line, text in told]
        mistakes += [f"{page.path}:{line}: {text}" for line, text in wrong]
    return notes, mistakes


def renew(root, results_root):
    """Writes the numbers of this run into the sources of the pages."""
    results = Results(results_root)
    for page in all_pages(root):
        if page.path.is_file():
            text = page.path.read_text(encoding="utf-8")
            page.path.write_text(measured.renewed(text, lambda name, page=page: results.fact(page, name)), encoding="utf-8")


def weave(root, results_root, out, quick, live=False):
    """Writes out/pages/*.md and out/figures/NN_name/*; returns the mistakes, and writes nothing if there are any."""
    results = Results(results_root)
    pages = all_pages(root)
    mistakes = [mistake for page in pages for mistake in number_figures(page, results)]
    mistakes += [fault for page in pages for fault in page.faults]
    weaver, texts = Weaver(root, pages, results, live, quick), {}
    mistakes += unlisted_errata(root, weaver.tests)
    mistakes += weaver.orphans
    mistakes += what_nothing_explains(root, pages)
    mistakes += sentences.all_faults(root, pages)
    notes, wrong = written_numbers(pages, results, quick)
    mistakes += wrong
    print("".join(f"{note}\n" for note in notes).replace(f"{root}/", ""), end="", file=sys.stderr)
    for page in pages:
        texts[page.label], found = weaver.page(page)
        mistakes += found
    if mistakes:
        return mistakes
    for folder in ("pages", "figures"):
        shutil.rmtree(out / folder, ignore_errors=True)
        (out / folder).mkdir(parents=True)
    for label, text in texts.items():
        (out / "pages" / f"{label}.md").write_text(text, encoding="utf-8")
    for page in pages:
        for figure in page.figures.values():
            place = out / figure.place
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(figure.source, place)
    return []


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", type=Path, default=root, help="the repository")
    parser.add_argument("--results", type=Path, default=root / "build/results", help="what the run left")
    parser.add_argument("--out", type=Path, default=root / "build/docs", help="where pages/ and figures/ go")
    parser.add_argument("--quick", action="store_true", help="the run was a quick one: sentences keep the numbers written in them, and tables and figures are marked")
    parser.add_argument("--programs", type=Path, help="where the chapters' programs are: results of others are refused")
    parser.add_argument("--renew", action="store_true", help="write the measured numbers into the pages' sources, and weave nothing")
    parser.add_argument("--live", action="store_true", help="with figures that move: live/ stands beside the pages")
    options = parser.parse_args()
    try:
        mistakes = list(checks.stale_results(options.results, options.programs)) if options.programs else []
        if options.renew and not mistakes:
            renew(options.root.resolve(), options.results.resolve())
            return 0
        mistakes = mistakes or weave(options.root.resolve(), options.results.resolve(), options.out, options.quick, options.live)
    except (Mistake, teaching.TeachingError, exercise_pages.catalogue.CatalogueError) as mistake:
        mistakes = [str(mistake)]
    except FileNotFoundError as missing:
        mistakes = [f"{missing.filename} is not there: was everything run?"]
    for mistake in mistakes:
        print(mistake.replace(f"{options.root.resolve()}/", ""), file=sys.stderr)
    return 2 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
