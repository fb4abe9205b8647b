#!/usr/bin/env python3
"""Slides from the pages of the book: a deck for each chapter, and those of the instructors' plans (docs/tools/slide_plans.toml).

Of each section a deck takes its heading with the questions that it asks, then one slide for each formula that stands on its own, with
the sentence before it, and one for each figure, live ones among them. What a figure or formula says is nowhere written twice.
Shown by reveal.js, a library from npm.
"""
import argparse
import re
import shutil
import sys
import tomllib
from pathlib import Path

import npm
from pdf import KEPT_OF_THE_HEAD, content

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ["reveal.js", "reveal.css", "reset.css"]
SHORT, MOST_QUESTIONS, ON_ONE_SLIDE = 5, 4, 2  # words of a question; questions and formulas on a slide
NOT_SHOWN = {"Try it", "What changed", "Exercises", "Further reading"}
PIECE = re.compile(r'<div class="figure">(?P<figure>.*?)<div class="caption">(?P<caption>.*?)</div>\s*</div>'
                   r'|<p class="formulaDsp">(?P<formula>.*?)</p>|<p\s*>(?P<text>.*?)</p>|<ul>(?P<list>.*?)</ul>', re.S)


class NoSection(Exception):
    """A plan names a section that its chapter does not have."""


def sections(html):
    """(heading, HTML) of each section of a page, what stands before the first under the page's title."""
    title, text = content(html)
    text = re.sub(r"<details>.*?</details>|<dl class=.*?</dl>", "", text, flags=re.S)
    parts = re.split(r"<h1\b[^>]*>(.*?)</h1>", text, flags=re.S)
    found = list(zip([title, *map(plain, parts[1::2])], parts[::2]))
    return [(heading, part) for heading, part in found if heading not in NOT_SHOWN]


def plain(html):
    return " ".join(re.sub(r"<[^>]+>", " ", html).split())


def sentences(html):
    """Those of a paragraph; a formula in the line, or code, is never cut."""
    found = re.findall(r"(?:\\\(.*?\\\)|<code>.*?</code>|[^.?]|[.?](?!\s|$))+(?:[.?]|$)", re.sub(r"</?a\b[^>]*>", "", html.strip()), re.S)
    return [sentence.strip() for sentence in found]


def questions(told):
    """Those among some sentences; a short one with the sentence that it asks about."""
    return [f"{before} {sentence}" if before and len(plain(sentence).split()) < SHORT else sentence
            for before, sentence in zip(["", *told], told) if sentence.endswith("?")]


def slides_of(heading, html):
    """HTML of a section's slides, one below the other."""
    asked, shown, before, formulas = [], [], "", 0
    for piece in PIECE.finditer(html):
        if piece["text"]:
            told = sentences(piece["text"])
            asked += questions(told)
            before = told[-1] if told else ""
        elif piece["formula"]:
            formulas += 1
            if formulas % ON_ONE_SLIDE != 1:
                shown[-1] += f"<p>{before}</p><p>{piece['formula']}</p>"
            else:
                shown.append(f"<p>{before}</p><p>{piece['formula']}</p>")
            before = ""
        elif piece["figure"]:
            formulas = 0
            shown.append(f'{piece["figure"]}<p class="caption">{piece["caption"]}</p>')
        elif heading == "What still fails":
            shown.append(f"<ul>{piece['list']}</ul>")
    first = f"<h2>{heading}</h2>" + "".join(f"<p>{question}</p>" for question in asked[:MOST_QUESTIONS])
    below = "".join(f'<section><p class="running">{heading}</p>{slide}</section>' for slide in shown)
    return f"<section><section>{first}</section>{below}</section>"


def from_below(html):
    """Links to the book's files, from the folder slides."""
    return re.sub(r'\b(src|href)="(?!\w+:|#)', r'\1="../', html)


def deck(head, title, chosen, live):
    """A whole deck. @param chosen  (heading, HTML) of its sections"""
    body = "\n".join(slides_of(heading, html) for heading, html in chosen)
    if live:
        body = re.sub(r'<div class="live" data-figure="(\w+)"', r'<div class="live" data-figure="\1" data-live="\1"', body)
    names = list(dict.fromkeys(re.findall(r'data-live="(\w+)"', body)))
    scripts = "".join(f'<script src="live/{name}.js"></script>' for name in (["live", "figure", "turning", *names] if names else []))
    library = "".join(f'<link rel="stylesheet" href="{name}">' for name in ("reset.css", "reveal.css", "slides.css"))
    formulas = "".join(part for part in re.findall(KEPT_OF_THE_HEAD, head, re.S) if not part.startswith("<link"))
    return (f'<!DOCTYPE html><html lang="en" class="light-mode"><head><meta charset="utf-8"><title>{title}</title>{library}{from_below(formulas)}'
            '</head><body><div class="reveal"><div class="slides">'
            f'<section><h1>{title}</h1><p>Enduring Contacts</p></section>\n{from_below(body)}</div></div>{from_below(scripts)}'
            '<script src="reveal.js"></script><script>\n'
            'Reveal.initialize({ hash: true, slideNumber: true, width: 1280, height: 720, margin: 0.04, center: false, transition: "none" });\n'
            'MathJax.Hub.Queue(() => Reveal.layout());\n</script></body></html>')


def planned(plan, pages):
    """The sections of a plan. @throws NoSection"""
    for label, headings in plan.items():
        for heading in headings if label != "title" else []:
            found = [section for section in pages.get(label, []) if section[0] == heading]
            if not found:
                raise NoSection(f"docs/tools/slide_plans.toml: {label} has no section '{heading}'")
            yield found[0]


def bring_library(place):
    """reveal.js, of the version and with the digest that docs/tools/npm/slides/package-lock.json says."""
    work = ROOT / "build/slides"
    if not shutil.which("npm"):
        sys.exit("The slides need npm. On Debian: apt-get install npm   (or: ./course docs --slides, which does)")
    if not npm.installed(ROOT / "docs/tools/npm/slides", work):
        sys.exit("npm could not fetch what shows the slides")
    for name in LIBRARY:
        shutil.copyfile(work / "node_modules/reveal.js/dist" / name, place / name)
    shutil.copyfile(ROOT / "docs/theme/slides.css", place / "slides.css")


def write_decks(book, place):
    """Writes NN.html for each chapter, and NAME.html for each plan; gives their names."""
    head = (book / "index.html").read_text(encoding="utf-8").split("</head>")[0]
    pages = {path.stem: sections(path.read_text(encoding="utf-8")) for path in sorted(book.glob("chapter_[0-9][0-9].html"))}
    decks = {label.split("_")[1]: (found[0][0], found) for label, found in pages.items()}
    plans = tomllib.loads((ROOT / "docs/tools/slide_plans.toml").read_text(encoding="utf-8"))
    decks |= {name: (plan["title"], list(planned(plan, pages))) for name, plan in plans.items()}
    for name, (title, chosen) in decks.items():
        (place / f"{name}.html").write_text(deck(head, title, chosen, (book / "live").is_dir()), encoding="utf-8")
    return list(decks)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--book", type=Path, default=ROOT / "build/book", help="the book, which gets the slides, too")
    book = parser.parse_args().book
    place = book / "slides"
    place.mkdir(exist_ok=True)
    try:
        bring_library(place)
        names = write_decks(book, place)
    except NoSection as missing:
        sys.exit(str(missing))
    print(f"Slides: {', '.join(f'{place / name}.html' for name in names)}")


if __name__ == "__main__":
    main()
