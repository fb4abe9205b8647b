"""The concordance: what it binds stands in a table with links; an orphan of any sort stops the book."""
import json
import unittest

from test_weave import Book

PAGE = "# Concordance {#page_concordance}\n\n@concordance{equation}\n\n@concordance{figure}\n"
BOUND = {"of": "equation 1.1", "says": "depth", "function": "chapters/01_drop/depth.hpp depth", "test": "drop: |v| < 1",
         "paragraph": "chapter_01: How deep?"}
DRAWING = {"of": "figure 1.1", "says": "a sketch", "paragraph": "chapter_01",
           "why_not": {"function": "a sketch", "test": "nothing to check"}}
CHAPTER = "# The drop\n\n## How deep?\nNot far.\n"


def book(*entries, numbers=None, chapter=CHAPTER):
    result = Book(chapter)
    result.write("docs/concordance.md", PAGE)
    manifest = ",\n".join(json.dumps(entry) for entry in entries)
    numbers = json.dumps(numbers or {"equation": ["1.1"], "figure": ["1.1"]})
    result.write("docs/tools/concordance.json", f'{{"numbers": {numbers},\n"entries": [\n{manifest}\n]}}\n')
    return result


class WhatItBinds(unittest.TestCase):
    def test_an_entry_is_a_row_with_function_test_and_linked_paragraph(self):
        woven = book(BOUND, DRAWING)
        done = woven.weave()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        page = woven.page("page_concordance")
        self.assertIn('| (1.1) | depth <br>\\ref at_chapter_01_how_deep "Chapter 1: The drop: How deep?" | '
                      "`depth` <span class=\"path\">in chapters/01_drop/depth.hpp</span> <br>"
                      '<code class="test">drop: \\|v\\| &lt; 1</code> |', page)
        self.assertIn("| 1.1 | a sketch <br>\\ref chapter_01 | a sketch <br>nothing to check |", page)
        self.assertIn("## How deep? {#at_chapter_01_how_deep}\n", woven.page())

    def test_a_heading_keeps_an_anchor_of_its_own(self):
        woven = book(BOUND, DRAWING, chapter="# The drop\n\n## How deep? {#deep}\nNot far.\n")
        self.assertEqual(woven.weave().returncode, 0)
        self.assertIn('\\ref deep "', woven.page("page_concordance"))
        self.assertIn("## How deep? {#deep}\n", woven.page())

    def test_quotes_in_a_heading_do_not_end_the_link(self):
        woven = book(dict(BOUND, paragraph='chapter_01: "How" deep?'), DRAWING, chapter='# The drop\n\n## "How" deep?\nNot far.\n')
        self.assertEqual(woven.weave().returncode, 0)
        self.assertIn('\\ref at_chapter_01_how_deep "Chapter 1: The drop: “How” deep?"', woven.page("page_concordance"))

    def test_an_entry_binds_several_numbers_and_ranges(self):
        several = dict(BOUND, of="equation 1.1; 1.3-1.5")
        self.assertEqual(book(several, DRAWING, numbers={"equation": ["1.1", "1.3-1.5"], "figure": ["1.1"]}).weave().returncode, 0)


class WhatStopsTheBook(unittest.TestCase):
    def refused(self, message, *entries, numbers=None, chapter=CHAPTER):
        woven = book(*entries, numbers=numbers, chapter=chapter)
        done = woven.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn(message, done.stderr)
        self.assertFalse((woven.root / "out").exists(), "nothing is written")

    def without(self, part):
        return {key: value for key, value in BOUND.items() if key != part}

    def test_a_number_that_no_entry_binds(self):
        self.refused("docs/tools/concordance.json:1: equation 1.2 is bound to nothing", BOUND, DRAWING,
                     numbers={"equation": ["1.1-1.2"], "figure": ["1.1"]})

    def test_a_number_that_the_thesis_does_not_have(self):
        self.refused("figure 1.1 is bound, and not in the list", BOUND, DRAWING, numbers={"equation": ["1.1"]})

    def test_a_number_that_is_bound_twice(self):
        self.refused("equation 1.1 is bound 2 times", BOUND, BOUND, DRAWING)

    def test_an_entry_without_a_function(self):
        self.refused("docs/tools/concordance.json:3: equation 1.1: no function, and no reason why not", self.without("function"), DRAWING)

    def test_an_entry_without_a_test(self):
        self.refused("no test, and no reason why not", self.without("test"), DRAWING)

    def test_an_entry_without_a_paragraph(self):
        self.refused("no paragraph, and no reason why not", self.without("paragraph"), DRAWING)

    def test_a_reason_for_what_is_there(self):
        self.refused("a test, and a reason why not", dict(BOUND, why_not={"test": "too hard"}), DRAWING)

    def test_a_file_that_does_not_exist(self):
        self.refused("there is no file chapters/01_drop/height.hpp", dict(BOUND, function="chapters/01_drop/height.hpp depth"), DRAWING)

    def test_a_name_that_its_file_does_not_have(self):
        self.refused("chapters/01_drop/depth.hpp has no 'height'", dict(BOUND, function="chapters/01_drop/depth.hpp height"), DRAWING)

    def test_a_name_that_stands_in_a_comment_only(self):
        self.refused("chapters/01_drop/depth.hpp has no 'metres'", dict(BOUND, function="chapters/01_drop/depth.hpp metres"), DRAWING)

    def test_the_name_of_no_test(self):
        self.refused("docs/tools/concordance.json:3: equation 1.1: no test is called 'drop: v < 1'", dict(BOUND, test=["drop: v < 1"]), DRAWING)

    def test_a_page_that_does_not_exist(self):
        self.refused("no page has the label 'chapter_07'", dict(BOUND, paragraph="chapter_07: How deep?"), DRAWING)

    def test_a_heading_that_its_page_does_not_have(self):
        self.refused("the page chapter_01 has no heading 'How high?'", dict(BOUND, paragraph="chapter_01: How high?"), DRAWING)

    def test_a_kind_that_does_not_exist(self):
        self.refused("'table' is none of equation, algorithm", dict(BOUND, of="table 1.1"), DRAWING)

    def test_a_manifest_that_is_not_json(self):
        woven = book(BOUND)
        woven.write("docs/tools/concordance.json", "{")
        done = woven.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn("docs/tools/concordance.json:1: cannot be read", done.stderr)

    def test_a_page_that_shows_a_kind_there_is_not(self):
        woven = book(BOUND, DRAWING)
        woven.write("docs/concordance.md", "# Concordance\n\n@concordance{tables}\n")
        done = woven.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn("docs/concordance.md:3: @concordance{tables}", done.stderr)


if __name__ == "__main__":
    unittest.main()
