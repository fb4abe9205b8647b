"""The search of the book: what is indexed of a page, and that lunr finds it."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import book_search  # noqa: E402

PAGE = """<title>Enduring Contacts: Chapter 1: The drop</title><div class="contents"><div class="toc interactive"><h3>Table of Contents</h3><ul><li>Why?</li></ul></div><p>It falls \\(h\\) far.</p>
<h1><a class="anchor" id="why"></a>Why &amp; how?</h1><p>The capstan holds.</p><script>var gone;</script><ul><li>one</li><li>two</li></ul></div><!-- contents -->"""
HEADER = """<title>Enduring Contacts: fall.hpp File Reference</title><tr class="memitem:a"><td class="memItemRight" valign="bottom">
<a href="#a">height_of_drop</a> (double t)</td></tr><tr class="memdesc:a"><td class="mdescRight">How high it is. <a href="#more">More...</a></td></tr>"""


def lunr():
    return book_search.LIBRARY.is_file() and not subprocess.run(["/usr/bin/python3", "-c", "import lunr"], capture_output=True).returncode


class Search(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.book = Path(held.name)
        (self.book / "chapter_01.html").write_text(PAGE, encoding="utf-8")
        (self.book / "fall_8hpp.html").write_text(HEADER, encoding="utf-8")

    def test_a_page_of_text_is_indexed_by_its_sections_without_formulas_scripts_and_its_table_of_contents(self):
        first, second = book_search.sections(self.book / "chapter_01.html")
        self.assertEqual((first["place"], first["page"], first["text"]), ("chapter_01.html", "Chapter 1: The drop", "It falls far."))
        self.assertEqual((second["place"], second["heading"], second["text"]), ("chapter_01.html#why", "Why & how?", "The capstan holds. one two"))

    def test_a_page_of_the_code_is_indexed_by_its_names_and_what_they_are(self):
        self.assertEqual([entry["text"] for entry in book_search.sections(self.book / "fall_8hpp.html")], ["height_of_drop (double t) How high it is."])

    @unittest.skipUnless(lunr(), "needs libjs-lunr and python3-lunr")
    def test_the_index_leads_from_a_word_to_its_sections(self):
        book_search.bring(self.book, ["chapter_01"])
        text = (self.book / "search/index.js").read_text(encoding="utf-8")
        content = json.loads(text.removeprefix("window.BOOK_SEARCH = ").removesuffix(";\n"))
        at = {word: [int(field.split("/")[1]) for field, _ in content["index"]["fieldVectors"] if field.startswith("text/")] for word in ("capstan",)}["capstan"]
        found = dict(content["index"]["invertedIndex"])
        self.assertEqual([content["sections"][int(i)]["place"] for i in found["capstan"]["text"]], ["chapter_01.html#why"])
        self.assertEqual(len(at), 3)


if __name__ == "__main__":
    unittest.main()
