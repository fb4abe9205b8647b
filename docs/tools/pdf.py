#!/usr/bin/python3
"""Prints the book: one PDF of its chapters with their exercises, the base, and what is looked up, with bookmarks and page numbers.

The pages are joined into one, which headless Chromium prints. Needs Debian's chromium-driver and python3-selenium.
"""
import argparse
import base64
import re
from pathlib import Path

import weave

ROOT = Path(__file__).resolve().parents[2]
NAME = "enduring-contacts.pdf"
LOOKED_UP = ["page_failure_ledger", "page_glossary", "page_notation", "page_errata", "page_bibliography"]
KEPT_OF_THE_HEAD = r'<link [^>]*stylesheet[^>]*>|<script type="text/x-mathjax-config">.*?</script>|<script[^>]*mathjax/MathJax\.js[^>]*></script>'
FOOTER = ('<div style="font: 8px sans-serif; width: 100%; text-align: center; color: #555"><span class="pageNumber"></span></div>')
PAPER = {"paperWidth": 8.27, "paperHeight": 11.69, "marginTop": 0.7, "marginBottom": 0.75, "marginLeft": 0.65, "marginRight": 0.65}


def labels(root=ROOT):
    """The pages of the PDF, in its order."""
    pages = weave.all_pages(root)
    for page in pages:
        if page.folder:
            yield page.label
            yield from (other.label for other in pages if other.label == f"exercises_{page.folder[:2]}")
    yield from (page.label for page in pages if page.path.parent.parent.name == "common")
    yield from (page.label for page in pages if page.label in LOOKED_UP)


def content(html):
    """(title, text) of a page of the book: what stands between its navigation."""
    title = re.search(r'<div class="title">(.*?)</div>', html, re.S)[1].strip()
    text = re.search(r'<div class="textblock">(.*)</div></div><!-- contents -->', html, re.S)[1]
    text = re.sub(r'<div class="neighbours">.*?</div>', "", text, flags=re.S)
    text = re.sub(r'<script\b.*?</script>|<video\b.*?</video>| data-live="\w+"| loading="lazy"', "", text, flags=re.S)
    return title, text


def one_deeper(text):
    """Below the title of its page each heading is one deeper."""
    return re.sub(r"<(/?)h([1-5])\b", lambda found: f"<{found[1]}h{int(found[2]) + 1}", text)


def linked_within(text, within):
    """Links between the joined pages lead to their places; those to others are only words."""
    def link(found):
        page, _, place = found[1].partition("#")
        if page and page.removesuffix(".html") not in within:
            return found[0] if "://" in page else ""
        return f'href="#{place or page.removesuffix(".html")}"'
    return re.sub(r'href="([^"]*)"', link, text)


def joined(book, chosen):
    """One page of the chosen ones, with a title and a list of contents before them."""
    pages = {label: content((book / f"{label}.html").read_text(encoding="utf-8")) for label in chosen}
    head = (book / "index.html").read_text(encoding="utf-8").split("</head>")[0]
    listed = "".join(f'<li class="{label.split("_")[0]}"><a href="#{label}">{title}</a></li>' for label, (title, _) in pages.items())
    body = "".join(f'<h1 class="printed" id="{label}">{title}</h1><div class="textblock">{linked_within(one_deeper(text), pages)}</div>'
                   for label, (title, text) in pages.items())
    return (f'<!DOCTYPE html><html lang="en" class="light-mode pdf"><head><meta charset="utf-8"><title>Enduring Contacts</title>'
            f'{"".join(re.findall(KEPT_OF_THE_HEAD, head, re.S))}</head><body><div id="doc-content"><div class="contents">'
            f'<div class="cover">Enduring Contacts<small>a contact solver, chapter by chapter</small></div>'
            f'<ul class="cover-list">{listed}</ul>{body}</div></div></body></html>')


class Unprintable(Exception):
    """A page that would not look right on paper."""


def printed(page, faults="return [];"):
    """The bytes of the PDF. @param faults  a script that tells what is wrong with the page on paper
    @throws Unprintable"""
    from browser_test import browser, open_page  # which needs selenium; what stands above does not
    driver = browser()
    try:
        open_page(driver, page)
        driver.set_script_timeout(600)
        driver.command_executor.set_timeout(600)
        driver.execute_async_script("const go = arguments[0]; MathJax.Hub.Queue(() => setTimeout(go, 500));")
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        if found := driver.execute_script(faults):
            raise Unprintable(", ".join(found))
        # In parts: a whole book is too long for one answer of the driver.
        stream = driver.execute_cdp_cmd("Page.printToPDF", PAPER | {
            "printBackground": True, "displayHeaderFooter": True, "headerTemplate": "<span></span>", "footerTemplate": FOOTER,
            "generateTaggedPDF": True, "generateDocumentOutline": True, "transferMode": "ReturnAsStream"})["stream"]
        pdf, end = b"", False
        while not end:
            part = driver.execute_cdp_cmd("IO.read", {"handle": stream, "size": 1 << 20})
            pdf, end = pdf + base64.b64decode(part["data"]), part["eof"]
        return pdf
    finally:
        driver.quit()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--book", type=Path, default=ROOT / "build/book", help="the book, which gets the PDF, too")
    book = parser.parse_args().book.resolve()
    page, part = book / "printed.html", book / f"{NAME}.part"
    try:
        page.write_text(joined(book, list(labels())), encoding="utf-8")
        part.write_bytes(printed(page))
        part.replace(book / NAME)
    finally:
        page.unlink(missing_ok=True)
    print(f"In print: {book / NAME}")


if __name__ == "__main__":
    main()
