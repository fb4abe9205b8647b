#!/usr/bin/env python3
"""Slides for a lecturer: a deck for each chapter, and those of the instructors' plans (docs/tools/slide_plans.toml).

What to show stands beside each chapter's page, in slides.toml: for each slide one idea, a figure or formulas, and what to say. Pictures and formulas
are those of the finished page, so nothing is drawn or derived twice. Shown by reveal.js, a library from npm; its speaker view has the notes.
"""
import argparse
import html
import re
import shutil
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import npm
from pdf import KEPT_OF_THE_HEAD, content

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ["reveal.js", "reveal.css", "reset.css", "plugin/notes.js"]
KEYS = {"section", "idea", "figure", "formulas", "tex", "says", "notes"}
MOST_WORDS = {"idea": 14, "says": 45}  # of a slide: what is read while somebody speaks
FEWEST_NOTES = 20                      # words: less than that is no help to somebody who did not write the page
HEADING = re.compile(r"^## (.+?)(?: \{#\w+\})?$", re.M)
# N shows the notes below the slides; reveal's S opens the speaker view, and P prints slides with notes.
KEYS_OF_OURS = """keyboard: { 78: () => { Reveal.configure({ showNotes: !Reveal.getConfig().showNotes }); Reveal.layout(); },
  80: () => { location.search = '?view=print&showNotes=separate-page'; } }"""


class BadSlide(Exception):
    """A slide that cannot be shown, or says too little; the message names file and slide."""


@dataclass
class Slide:
    """One slide: @param idea  its heading; @param figure  file name or live figure of the page; @param formulas  pieces of TeX of the page;
    @param tex  a formula that the page does not have; @param says  what stands below; @param notes  for the speaker"""
    section: str
    idea: str
    notes: str
    figure: str = ""
    formulas: tuple = ()
    tex: str = ""
    says: str = ""


def read_slides(path):
    """The slides of a chapter, in order. @throws BadSlide"""
    found = tomllib.loads(path.read_text(encoding="utf-8")).get("slide", [])
    headings = HEADING.findall((path.parent / "chapter.md").read_text(encoding="utf-8"))
    for number, given in enumerate(found, 1):
        name = f"{path}: slide {number}"
        if unknown := set(given) - KEYS:
            raise BadSlide(f"{name}: unknown {', '.join(sorted(unknown))}")
        if missing := {"section", "idea", "notes"} - set(given):
            raise BadSlide(f"{name}: no {', '.join(sorted(missing))}")
        if given["section"] not in headings:
            raise BadSlide(f"{name}: the page has no section '{given['section']}'")
        if not given.keys() & {"figure", "formulas", "tex"}:
            raise BadSlide(f"{name}: neither a figure nor a formula")
        for key, most in MOST_WORDS.items():
            if len(given.get(key, "").split()) > most:
                raise BadSlide(f"{name}: '{key}' has more than {most} words")
        if len(given["notes"].split()) < FEWEST_NOTES:
            raise BadSlide(f"{name}: notes of fewer than {FEWEST_NOTES} words")
    return [Slide(**given) for given in found]


def marked_up(text):
    """Our few marks as HTML: $formula$, `code` and *stress*."""
    text = html.escape(" ".join(text.split()), quote=False)
    text = re.sub(r"\$(.+?)\$", r"\\(\1\\)", text)
    parts = re.split(r"(\\\(.*?\\\)|`[^`]+`)", text)
    return "".join(f"<code>{part[1:-1]}</code>" if part.startswith("`") else part if part.startswith("\\(") else re.sub(r"\*([^*\s][^*]*)\*", r"<em>\1</em>", part)
                   for part in parts)


def figure_of(page, name):
    """(HTML of a figure of a page, its caption). @param name  of the picture's file, or of a live figure. @throws BadSlide"""
    for match in re.finditer(r'<div class="figure">(.*?)<div class="caption">(.*?)</div>\s*</div>', page, re.S):
        if f'data-figure="{name}"' in match[1] or 'class="live"' not in match[1] and re.search(rf'<img src="[^"]*\b{re.escape(name)}"', match[1]):
            return re.sub(r'<a class="anchor"[^>]*></a>', "", match[1]), match[2]
    raise BadSlide(f"the page shows no figure '{name}'")


def formula_of(page, piece):
    """The formula of a page that holds a piece of TeX. @throws BadSlide"""
    bare = lambda tex: re.sub(r"\s", "", html.unescape(tex))
    for match in re.finditer(r'<p class="formulaDsp">(.*?)</p>', page, re.S):
        if bare(piece) in bare(match[1]):
            return match[1]
    raise BadSlide(f"the page has no formula with '{piece}'")


def slide_html(slide, page, running):
    """HTML of one slide. @param page  HTML of the chapter's page; @param running  what stands above. @throws BadSlide"""
    shown, notes = "", marked_up(slide.notes)
    for piece in slide.formulas:
        shown += f'<div class="formula">{formula_of(page, piece)}</div>'
    if slide.tex:
        shown += f'<div class="formula">\\[ {html.escape(slide.tex.strip(), quote=False)} \\]</div>'
    if slide.figure:
        picture, caption = figure_of(page, slide.figure)
        shown += f'<div class="shown">{picture}</div>'
        notes += f'<p class="caption">{caption}</p>'
    said = f"<p>{marked_up(slide.says)}</p>" if slide.says else ""
    return (f'<section><div class="slide"><p class="running">{running}</p><h2>{marked_up(slide.idea)}</h2>{shown}{said}</div>'
            f'<aside class="notes">{notes}</aside></section>')


def from_below(text):
    """Links to the book's files, from the folder slides."""
    return re.sub(r'\b(src|href)="(?!\w+:|#)', r'\1="../', text)


def by_section(slides, page, title):
    """HTML of slides: sections side by side, the slides of each below one another."""
    stacks = {}
    for number, slide in enumerate(slides, 1):
        try:
            stacks.setdefault(slide.section, []).append(slide_html(slide, page, f"{title.split(':')[0]} · {slide.section}"))
        except BadSlide as fault:
            raise BadSlide(f"{title}, slide {number} ('{slide.idea}'): {fault}") from None
    return "\n".join(f"<section>{''.join(stack)}</section>" for stack in stacks.values())


def first_slide(title, picture, goals):
    """The title, with a picture; its notes say what students can do afterwards."""
    listed = "".join(f"<li>{marked_up(goal)}</li>" for goal in goals)
    return (f'<section><div class="slide first"><h1>{title}</h1><p>Enduring Contacts</p><img src="{picture}" alt=""></div>'
            f'<aside class="notes"><p>Afterwards a student can</p><ul>{listed}</ul><p>S opens the speaker view, N shows the notes here, P prints both.</p></aside></section>')


def deck(head, title, first, body, live):
    """A whole deck. @param first  its first slide; @param body  the others; @param live  whether the book has live figures"""
    if live:
        body = re.sub(r'<div class="live" data-figure="(\w+)"', r'<div class="live" data-figure="\1" data-live="\1"', body)
    names = list(dict.fromkeys(re.findall(r'data-live="(\w+)"', body)))
    scripts = "".join(f'<script src="live/{name}.js"></script>' for name in (["live", "figure", "turning", *names] if names else []))
    library = "".join(f'<link rel="stylesheet" href="{name}">' for name in ("reset.css", "reveal.css", "slides.css"))
    formulas = "".join(part for part in re.findall(KEPT_OF_THE_HEAD, head, re.S) if not part.startswith("<link"))
    return (f'<!DOCTYPE html><html lang="en" class="light-mode"><head><meta charset="utf-8"><title>{title}</title>{library}{from_below(formulas)}'
            f'</head><body><div class="reveal"><div class="slides">{first}\n{from_below(body)}</div></div>{from_below(scripts)}'
            '<script src="reveal.js"></script><script src="plugin/notes.js"></script><script>\n'
            'Reveal.initialize({ hash: true, slideNumber: true, width: 1280, height: 720, margin: 0.04, center: false, transition: "none",\n'
            f'  plugins: [RevealNotes], {KEYS_OF_OURS} }});\n'
            'addEventListener("load", () => MathJax.Hub.Queue(() => Reveal.layout()));\n</script></body></html>')


def planned(plan, chapters):
    """(label, slides) of a plan, chapter by chapter. @param chapters  slides by label. @throws BadSlide"""
    for label, headings in plan.items():
        if label != "title":
            for heading in headings:
                if not any(slide.section == heading for slide in chapters.get(label, [])):
                    raise BadSlide(f"docs/tools/slide_plans.toml: {label} has no slide for '{heading}'")
            yield label, [slide for heading in headings for slide in chapters[label] if slide.section == heading]


def bring_library(place):
    """reveal.js, of the version and with the digest that docs/tools/npm/slides/package-lock.json says."""
    work = ROOT / "build/slides"
    if not npm.installed(ROOT / "docs/tools/npm/slides", work):
        sys.exit("npm could not fetch what shows the slides" if shutil.which("npm") else "The slides need npm. On Debian: apt-get install npm   (or: ./course docs --slides, which does)")
    for name in LIBRARY:
        (place / name).parent.mkdir(exist_ok=True)
        shutil.copyfile(work / "node_modules/reveal.js/dist" / name, place / name)
    shutil.copyfile(ROOT / "docs/theme/slides.css", place / "slides.css")


def write_decks(book, place):
    """Writes NN.html for each chapter, and NAME.html for each plan; gives their names. @throws BadSlide"""
    head, live = (book / "index.html").read_text(encoding="utf-8").split("</head>")[0], (book / "live").is_dir()
    pages, chapters, goals, decks = {}, {}, {}, {}
    for path in sorted(ROOT.glob("chapters/[0-9][0-9]_*/slides.toml")):
        number = path.parent.name[:2]
        label = f"chapter_{number}"
        pages[label] = content((book / f"{label}.html").read_text(encoding="utf-8"))
        chapters[label] = read_slides(path)
        goals[label] = tomllib.loads((path.parent / "teaching.toml").read_text(encoding="utf-8"))["goals"]
        shutil.copyfile(ROOT / "renders" / path.parent.name / "thumbnail.png", place / f"{number}.png")
        decks[number] = (pages[label][0], [label], {label: chapters[label]})
    for name, plan in tomllib.loads((ROOT / "docs/tools/slide_plans.toml").read_text(encoding="utf-8")).items():
        chosen = dict(planned(plan, chapters))
        decks[name] = (plan["title"], list(chosen), chosen)
    for name, (title, labels, chosen) in decks.items():
        body = "\n".join(by_section(slides, pages[label][1], pages[label][0]) for label, slides in chosen.items())
        first = first_slide(title, f"{labels[0][-2:]}.png", [goal for label in labels for goal in goals[label]] if len(labels) == 1 else goals[labels[0]][:1])
        (place / f"{name}.html").write_text(deck(head, title, first, body, live), encoding="utf-8")
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
    except BadSlide as fault:
        sys.exit(str(fault))
    print(f"Slides: {', '.join(f'{place / name}.html' for name in names)}")


if __name__ == "__main__":
    main()
