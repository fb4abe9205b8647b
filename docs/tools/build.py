#!/usr/bin/env python3
"""Builds the book: weaves its pages, runs Doxygen on them and on the headers, and moves the result into place.

The finished book is one folder that works from file:// without a network.
"""
import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

import book_search
import checks
import editor
import lab
import live
import weave

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build/docs"
THEME = Path("/usr/share/doxygen-awesome-css")
MATHJAX = Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ["MathJax.js", "extensions", "jax/element/mml", "jax/input/TeX", "jax/output/SVG/jax.js",
                 "jax/output/SVG/config.js", "jax/output/SVG/autoload", "jax/output/SVG/fonts/TeX"]


def need_tools():
    for thing, package in ((shutil.which("doxygen"), "doxygen"), (THEME.is_dir(), "doxygen-awesome-css"),
                           (MATHJAX.is_dir(), "libjs-mathjax"), (book_search.LIBRARY.is_file(), "libjs-lunr")):
        if not thing:
            sys.exit(f"The book needs {package}. On Debian: apt-get install {package}   (or: ./course setup)")


def write_header():
    """Doxygen's own page header, with the theme's scripts and a view that fits a phone."""
    frame = [WORK / "header.html", WORK / "footer.html", WORK / "style.css"]
    subprocess.run(["doxygen", "-w", "html", *map(str, frame), "docs/Doxyfile"], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    header = frame[0].read_text(encoding="utf-8")
    if "viewport" not in header:
        header = header.replace("<head>", '<head>\n<meta name="viewport" content="width=device-width, initial-scale=1">')
    scripts = (ROOT / "docs/theme/scripts.html").read_text(encoding="utf-8")
    frame[0].write_text(header.replace("</head>", scripts + "</head>"), encoding="utf-8")


def run_doxygen():
    settings = (ROOT / "docs/Doxyfile").read_text(encoding="utf-8")
    settings += f"OUTPUT_DIRECTORY = {WORK}\nHTML_HEADER = {WORK}/header.html\nWARN_LOGFILE = {WORK}/warnings.txt\n"
    shutil.rmtree(WORK / "html", ignore_errors=True)
    done = subprocess.run(["doxygen", "-"], cwd=ROOT, input=settings, text=True, encoding="utf-8", errors="surrogateescape")
    warnings = (WORK / "warnings.txt").read_text(encoding="utf-8").replace(f"{ROOT}/", "")
    if done.returncode or warnings.strip():
        print(warnings, end="", file=sys.stderr)
        sys.exit("The book was not built: Doxygen has the warnings above.")


def leftovers(book):
    """What Doxygen passes without a warning, but a reader of our pages would see."""
    names = {path.stem.replace("mainpage", "index") + ".html" for path in (WORK / "pages").glob("*.md")}
    for page in (book / name for name in sorted(names)):
        text = page.read_text(encoding="utf-8", errors="replace")
        for place in set(re.findall(r'(?:src|href)="(figures/[^"]+)"', text)):
            if not (book / place).is_file():
                yield f"{page.name}: {place} is missing"
        body = re.sub(r'(?s:<(code|pre)\b.*?</\1>|\\\(.*?\\\)|\\\[.*?\\\])|<div class="line">.*', "", text)
        yield from (f"{page.name}: left in the text: {found}"
                    for found in re.findall(r"@(?:fact|figure|table|figref|tabref|test|concordance)\{[^}]*\}|\\f[$\[].{0,40}|\*\*.{0,40}", body))


def keep_together(book):
    """Where lines may not break, and how far each line of a listing is indented, so that a broken one hangs behind
    itself. Both are for the style sheet."""
    for page in (WORK / "pages").glob("*.md"):
        place = book / (page.stem.replace("mainpage", "index") + ".html")
        lines = place.read_text(encoding="utf-8").split("\n")
        for number, line in enumerate(lines):
            if '<div class="line">' in line:
                line = line.replace("-&gt;", '<span class="whole">-&gt;</span>')
                line = re.sub(r'<div class="line">( +)(?=[^ ])', lambda found:
                              f'<div class="line" style="--indentation: {len(found[1])}ch">'
                              f'<span class="indentation">{found[1]}</span>', line)
            else:  # a formula, and the bracket or comma at its side
                line = re.sub(r"(\( ?|)(\\\((?:(?!\\\)).)+\\\))([,.;:?!)]*)", lambda found:
                              f'<span class="whole">{found[1].strip()}{found[2]}{found[3]}</span>', line)
            lines[number] = line
        place.write_text("\n".join(lines), encoding="utf-8")


def mend_member_lists(book):
    """Doxygen links a page's summary to a list of nested classes also where all of them are private, and there is none."""
    for page in book.glob("class*.html"):
        text = page.read_text(encoding="utf-8")
        if 'name="nested-classes"' not in text:
            page.write_text(re.sub(r'<a href="#nested-classes">Classes</a>(\s*&#124;)?', "", text), encoding="utf-8")


HELD = {"listings": r"^ *\[\S+: .+\]\(\S+\)$", "measured numbers": r"<!--(?:\w+/)?\w+\.\w+-->", "figures": r"^@(?:figure|live)\{", "live ones among them": r"^@live\{",
        "tables": r"^@table\{", "tests named": r"@test\{"}


def what_it_holds(book):
    """One line about the book: its pages, and what the run and the code put into them."""
    pages = weave.all_pages(ROOT)
    text = "\n".join("\n".join(page.lines) for page in pages if page.label != "page_writing")  # that one shows how it is written
    counts = ", ".join(f"{len(re.findall(pattern, text, re.M))} {what}" for what, pattern in HELD.items())
    return f"{len(pages)} pages of text, {len(list(book.glob('*.html')))} with those of the code: {counts}"


def copy_mathjax(book):
    for part in MATHJAX_PARTS:
        source, place = MATHJAX / part, book / "mathjax" / part
        place.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, place)
        else:
            shutil.copyfile(source, place)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--results", type=Path, default=ROOT / "build/results", help="what the run left")
    parser.add_argument("--book", type=Path, default=ROOT / "build/book", help="where the book goes")
    parser.add_argument("--live", action="store_true", help="compile the live figures (needs emscripten)")
    parser.add_argument("--programs", type=Path, help="where the chapters' programs are: results of others are refused")
    options = parser.parse_args()
    need_tools()
    WORK.mkdir(parents=True, exist_ok=True)
    extra = ["--quick"] if options.results.name.endswith("quick") else []
    if options.programs:
        extra += ["--programs", str(options.programs)]
    if options.live:
        live.compile_module()
        extra.append("--live")
    woven = subprocess.run([sys.executable, str(ROOT / "docs/tools/weave.py"), "--results", str(options.results), *extra])
    if woven.returncode:
        sys.exit(woven.returncode)
    write_header()
    run_doxygen()
    html = WORK / "html"
    shutil.copytree(WORK / "figures", html / "figures")
    keep_together(html)
    copy_mathjax(html)
    if options.live:
        live.bring(html)
        lab.bring(html)
        editor.bring(html)
    mend_member_lists(html)
    book_search.bring(html, [page.stem.replace("mainpage", "index") for page in sorted((WORK / "pages").glob("*.md"))])
    if faults := [*leftovers(html), *checks.link_faults(html)]:
        sys.exit("\n".join(faults))
    (html / ".made_from").write_text(str(options.results), encoding="utf-8", errors="surrogateescape")
    shutil.rmtree(options.book, ignore_errors=True)
    html.rename(options.book)
    print(what_it_holds(options.book))


if __name__ == "__main__":
    main()
