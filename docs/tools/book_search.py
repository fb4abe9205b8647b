"""The full-text search of the book: an index of its pages, made with the book by lunr.py, and searched in the browser by lunr.js (both Debian's).

A page of text is indexed section by section, a page of the code by its names and first sentences. The index is a script, which a page loads
when a reader first types: so it works from file://, too.
"""
import html
import json
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

LIBRARY = Path("/usr/share/javascript/lunr/lunr.min.js")
THEME = Path(__file__).resolve().parents[1] / "theme"
TITLE = re.compile(r"<title>(?:Enduring Contacts: )?(.*?)</title>", re.S)
HEADINGS = ("h1", "h2", "h3", "h4")
BLOCKS = {"p", "li", "td", "th", "tr", "div", "br", *HEADINGS}
OF_THE_CODE = re.compile(r"(class|struct|namespace|union)\w*\.html|\w+_8hpp\.html")
NAMES = re.compile(r'<td class="(?:mem(?:Item|Templ|TemplItem)Right|mdescRight)"[^>]*>(.*?)</td>', re.S)  # Doxygen's: a name, and its first sentence
CONTENTS = re.compile(r'<div class="toc\b.*?</div>', re.S)  # Doxygen's list of a page's headings, which stand below, too
UNSEEN = {"script", "style", "nav", "svg"}


class Sections(HTMLParser):
    """(anchor, heading, text) of each section of a page's text."""

    def __init__(self, text):
        super().__init__()
        self.found, self.heading, self.hidden, self.in_heading = [["", "", []]], "", 0, False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag in UNSEEN:
            self.hidden += 1
        elif tag in HEADINGS:
            self.found.append(["", "", []])
            self.in_heading = True
        elif self.in_heading and tag == "a" and (anchor := dict(attributes).get("id")):
            self.found[-1][0] = anchor
        elif tag in BLOCKS:
            self.found[-1][2].append(" ")

    def handle_endtag(self, tag):
        if tag in UNSEEN:
            self.hidden -= 1
        elif tag in HEADINGS:
            self.in_heading = False

    def handle_data(self, data):
        if self.in_heading:
            self.found[-1][1] += data
        elif not self.hidden:
            self.found[-1][2].append(data)


def words(text):
    return " ".join(re.sub(r"\\[(\[].*?\\[)\]]", " ", text, flags=re.S).split())


def sections(page):
    """What is indexed of a page: dictionaries with place, page, heading and text."""
    text = page.read_text(encoding="utf-8", errors="replace")
    title = html.unescape(TITLE.search(text)[1]) if TITLE.search(text) else page.stem
    if OF_THE_CODE.fullmatch(page.name):
        told = " ".join(html.unescape(re.sub(r"<a [^>]*>More\.\.\.</a>|<[^>]+>", " ", cell)) for cell in NAMES.findall(text))
        return [{"place": page.name, "page": title, "heading": "", "text": words(told)}]
    body = CONTENTS.sub("", text[text.find('<div class="contents">'):text.rfind("<!-- contents -->")])
    return [{"place": page.name + (f"#{anchor}" if anchor else ""), "page": title, "heading": words(heading), "text": words("".join(told))}
            for anchor, heading, told in Sections(body).found if anchor or words("".join(told))]


def index_of(entries):
    """lunr's index of some sections; their number is what it finds. Made by Debian's python, which has Debian's lunr.
    @throws SystemExit  lunr.py is missing"""
    done = subprocess.run(["/usr/bin/python3", __file__], input=json.dumps(entries), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"The book's search needs Debian's python3-lunr   (or: ./course setup)\n{done.stderr}")
    return json.loads(done.stdout)


def bring(book, labels):
    """The search into a book.
    @param labels  of the pages of text; the other pages are those of the code"""
    pages = [book / f"{label}.html" for label in labels] + [page for page in sorted(book.glob("*.html")) if OF_THE_CODE.fullmatch(page.name) and page.stem not in labels]
    entries = [entry for page in pages for entry in sections(page)]
    place = book / "search"
    place.mkdir(exist_ok=True)
    shutil.copyfile(LIBRARY, place / "lunr.js")
    shutil.copyfile(THEME / "search.js", place / "search.js")
    content = {"index": index_of(entries), "sections": entries}
    (place / "index.js").write_text(f"window.BOOK_SEARCH = {json.dumps(content, ensure_ascii=False, sort_keys=True, separators=(',', ':'))};\n", encoding="utf-8")
    print(f"The search: {len(entries)} sections, {(place / 'index.js').stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    from lunr import lunr
    FIELDS = [{"field_name": "heading", "boost": 8}, {"field_name": "page", "boost": 4}, "text"]
    json.dump(lunr(ref="id", fields=FIELDS, documents=[{"id": i, **entry} for i, entry in enumerate(json.load(sys.stdin))]).serialize(), sys.stdout)
