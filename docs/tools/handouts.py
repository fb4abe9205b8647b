#!/usr/bin/python3
"""Handouts: two printed pages for each chapter, from its page of the book and the part [handout] of its teaching.toml.

The first page has the idea, the formulas with the paragraphs before them, and the key figure; the second one the listing that matters and three
questions with room for answers. Figure and questions take what room is left, and a handout in which something does not fit is refused. Headless
Chromium prints them, as it prints the book (docs/tools/pdf.py).
"""
import argparse
import html
import re
import sys
import tomllib
from pathlib import Path

from pdf import KEPT_OF_THE_HEAD, Unprintable, content, printed
import weave

ROOT = Path(__file__).resolve().parents[2]
PARTS = {"idea", "formulas", "figure", "listing", "questions"}
# What does not fit on its page, once the formulas are set: a page that is too high, and a figure or an answer without enough room.
FAULTS = """const height = (part, least, name) => part.getBoundingClientRect().height < least ? [`${name} has too little room`] : [];
return [...document.querySelectorAll('section.sheet')].flatMap((sheet, i) => [
  ...(sheet.scrollHeight > sheet.clientHeight + 1 ? [`page ${i + 1} is too high by ${sheet.scrollHeight - sheet.clientHeight} px`] : []),
  ...(sheet.scrollWidth > sheet.clientWidth + 1 ? [`page ${i + 1} is too wide by ${sheet.scrollWidth - sheet.clientWidth} px`] : []),
  ...[...sheet.querySelectorAll('.handout-figure')].flatMap(part => height(part, 220, 'the figure')),
  ...[...sheet.querySelectorAll('.room')].flatMap(part => height(part, 75, 'an answer'))]);"""


class DoesNotFit(Exception):
    """A handout asks for something that its page does not have, or has no room for it."""


def the_one(found, what):
    if len(found) != 1:
        raise DoesNotFit(f"{what}: {len(found)} of them on the page, not one")
    return found[0]


def formula(text, piece):
    """The formula of its own that holds a piece of TeX, with the paragraph before it."""
    bare = lambda tex: re.sub(r"\s", "", html.unescape(tex))
    found = [match for match in re.finditer(r'<p class="formulaDsp">(.*?)</p>', text, re.S) if bare(piece) in bare(match[1])]
    match = the_one(found, f"formula {piece}")
    before = re.search(r"<p\s*>((?:(?!<p\b).)*?)</p>\s*$", text[:match.start()], re.S)
    return (before[0] if before else "") + match[0]


def figure(text, name):
    """The picture of a figure, not of the live one in whose place it stands, with its caption."""
    for match in re.finditer(r'<div class="figure">(.*?)<div class="caption">(.*?)</div>\s*</div>', text, re.S):
        image = re.search(rf'<img src="[^"]*/{re.escape(name)}"[^>]*>', match[1])
        if image and 'class="live"' not in match[1]:
            return f'<div class="handout-figure">{image[0]}</div><p class="caption">{match[2]}</p>'
    raise DoesNotFit(f"figure {name}: the page does not show it")


def listing(text, source, name):
    """A listing that the page's source names as `file: region`: the page has them in the same order."""
    named = [f"{match[1]}: {match[2]}" for match in map(weave.LISTING.match, source.splitlines()) if match]
    found = re.findall(r'<div class="listing">.*?</div>\s*<div class="fragment">.*?<!-- fragment -->', text, re.S)
    if len(named) != len(found):
        raise DoesNotFit(f"the page has {len(found)} listings, its source {len(named)}")
    return the_one([code for told, code in zip(named, found) if told == name], f"listing {name}")


def handout(head, page, source, plan):
    """HTML of one chapter's two pages. @param page  of the finished book; @param source  of it; @param plan  the part [handout] of its teaching.toml"""
    if set(plan) != PARTS:
        raise DoesNotFit(f"[handout] has {', '.join(sorted(plan))}; it needs {', '.join(sorted(PARTS))}")
    title, text = content(page)
    asked = "".join(f"<li>{question}<div class=\"room\"></div></li>" for question in plan["questions"])
    return (f'<!DOCTYPE html><html lang="en" class="light-mode handout"><head><meta charset="utf-8"><title>{title}</title><base href="../">'
            f'{"".join(re.findall(KEPT_OF_THE_HEAD, head, re.S))}<link rel="stylesheet" href="handouts/handouts.css"></head><body><div id="doc-content">'
            f'<div class="contents"><section class="sheet textblock"><h1>{title}</h1><p>{plan["idea"]}</p>'
            f'{"".join(formula(text, piece) for piece in plan["formulas"])}{figure(text, plan["figure"])}</section>'
            f'<section class="sheet textblock"><p class="running"><span>{title}</span><span>Name: <i></i></span></p>{listing(text, source, plan["listing"])}'
            f'<ol>{asked}</ol></section></div></div></body></html>')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--book", type=Path, default=ROOT / "build/book", help="the book, which gets the handouts, too")
    book = parser.parse_args().book.resolve()
    place = book / "handouts"
    place.mkdir(exist_ok=True)
    (place / "handouts.css").write_bytes((ROOT / "docs/theme/handouts.css").read_bytes())
    head = (book / "index.html").read_text(encoding="utf-8").split("</head>")[0]
    written = []
    for teaching in sorted(ROOT.glob("chapters/[0-9][0-9]_*/teaching.toml")):
        number = teaching.parent.name[:2]
        plan = tomllib.loads(teaching.read_text(encoding="utf-8")).get("handout", {})
        page, pdf = place / f"chapter_{int(number)}.html", place / f"chapter_{int(number)}.pdf"
        try:
            text, source = (path.read_text(encoding="utf-8") for path in (book / f"chapter_{number}.html", teaching.parent / "chapter.md"))
            page.write_text(handout(head, text, source, plan), encoding="utf-8")
            pdf.write_bytes(printed(page, FAULTS))
        except (DoesNotFit, Unprintable) as fault:
            sys.exit(f"{teaching}: {fault}")
        finally:
            page.unlink(missing_ok=True)
        written.append(pdf)
    print(f"Handouts: {', '.join(map(str, written))}")


if __name__ == "__main__":
    main()
