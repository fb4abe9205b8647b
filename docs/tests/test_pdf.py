"""The printed book: the pages are joined with their links and headings, and the PDF has bookmarks and page numbers."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from test_browser import PYTHON, possible

DOCS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(DOCS / "tools"))
import pdf  # noqa: E402

PAGE = """<html><head><link href="book.css" rel="stylesheet"/><script src="navtree.js"></script></head><body>
<div class="header"><div class="headertitle"><div class="title">%s </div></div></div>
<div class="contents"><div class="toc"><a href="#why">Why?</a></div>
<div class="textblock"><h1><a id="why"></a>Why?</h1><p>%s</p><script>live()</script>
<div class="neighbours"><a href="other.html">next</a></div> </div></div><!-- contents --></body></html>"""


def book(folder, **pages):
    for name, text in pages.items():
        (Path(folder) / f"{name}.html").write_text(PAGE % (name.title(), text))
    return Path(folder)


class Joined(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        text = 'See <a href="fall.html#why">there</a>, <a href="fall.html">fall</a>, <a href="list.html">list</a> and <a href="https://a.b/c">c</a>.'
        self.page = pdf.joined(book(held.name, index="", drop=text, fall="It falls."), ["drop", "fall"])

    def test_links_lead_within_it_or_out_of_the_book(self):
        self.assertIn('<a href="#why">there</a>, <a href="#fall">fall</a>, <a >list</a> and <a href="https://a.b/c">c</a>', self.page)

    def test_a_title_is_above_its_pages_headings(self):
        self.assertIn('<h1 class="printed" id="fall">Fall</h1>', self.page)
        self.assertEqual(self.page.count('<h2><a id="why"></a>Why?</h2>'), 2)

    def test_only_the_text_is_printed_in_the_books_style(self):
        for gone in ("neighbours", "live()", "toc", "navtree"):
            self.assertNotIn(gone, self.page)
        self.assertIn('<link href="book.css" rel="stylesheet"/>', self.page)

    def test_it_begins_with_a_list_of_its_pages(self):
        self.assertRegex(self.page, '(?s)cover-list.*<a href="#drop">Drop</a>.*<a href="#fall">Fall</a>.*<h1')


class InItsOrder(unittest.TestCase):
    def test_each_chapter_is_followed_by_its_exercises_and_no_page_comes_twice(self):
        labels = list(pdf.labels())
        self.assertEqual(labels[:4], ["chapter_01", "exercises_01", "chapter_02", "exercises_02"])
        self.assertEqual(len(labels), len(set(labels)))
        self.assertLessEqual({"base_fem", *pdf.LOOKED_UP}, set(labels))


@unittest.skipUnless(possible(), "needs python3-selenium")
class Printed(unittest.TestCase):
    def test_it_has_bookmarks_and_page_numbers(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            page.write_text("<script>MathJax = {Hub: {Queue: go => go()}}</script><h1>Drop</h1><h2>Why?</h2>"
                            "<h1 style='break-before: page'>Fall</h1>")
            script = f"import sys; sys.path.insert(0, {str(DOCS / 'tools')!r}); import pdf; from pathlib import Path; " \
                     f"Path({folder!r}, 'a.pdf').write_bytes(pdf.printed(Path({str(page)!r})))"
            subprocess.run([PYTHON, "-c", script], check=True)
            text = subprocess.run(["pdftotext", "a.pdf", "-"], cwd=folder, capture_output=True, text=True, check=True).stdout
            outline = subprocess.run(["pdftohtml", "-xml", "-stdout", "a.pdf"], cwd=folder, capture_output=True, text=True, check=True).stdout
        self.assertEqual([words.split() for words in text.split("\f")[:2]], [["Drop", "Why?", "1"], ["Fall", "2"]])
        self.assertEqual(re.findall(r"<item[^>]*>(.*?)</item>", outline), ["Drop", "Why?", "Fall"])


if __name__ == "__main__":
    unittest.main()
