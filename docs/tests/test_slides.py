"""The slides: what they take from a page, and the plans, which name sections that are there."""
import re
import sys
import tomllib
import unittest
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(DOCS / "tools"))
import slides  # noqa: E402

PAGE = r"""<html><head></head><body><div class="header"><div class="title">Chapter 1: A drop </div></div><div class="contents">
<div class="textblock"><p >It falls. How hard? Where does it rest when <a href="b.html">the ground</a> is soft?</p>
<h1><a class="anchor" id="x"></a>
Two looks</h1>
<p>Take \(a = 1. 2\), as e.g. <code>f. g</code> does. So</p><p class="formulaDsp">\[ a \]</p><p class="formulaDsp">\[ b \]</p>
<div class="figure"> <a class="anchor" id="f"></a><div class="live" data-figure="drop"><a href="figures/d.svg"><img src="figures/d.svg" alt=""></a></div>
<div class="caption"><b>Figure 1.1.</b> A drop.</div></div><p class="formulaDsp">\[ c \]</p><p>Folded?</p>
<h1>Exercises</h1><p>Which?</p><h1>What still fails</h1><ul><li>All.</li></ul>
<div class="neighbours">x</div> </div></div><!-- contents --></body></html>"""


class OfAPage(unittest.TestCase):
    def setUp(self):
        self.sections = slides.sections(PAGE)

    def shown(self, number):
        return re.findall(r"<section>(?!<section>)(.*?)</section>", slides.slides_of(*self.sections[number]), re.S)

    def test_its_sections_but_those_for_the_desk(self):
        self.assertEqual([heading for heading, _ in self.sections], ["Chapter 1: A drop", "Two looks", "What still fails"])

    def test_a_section_begins_with_its_questions_a_short_one_with_what_it_is_about(self):
        self.assertEqual(self.shown(0), ["<h2>Chapter 1: A drop</h2><p>It falls. How hard?</p><p>Where does it rest when the ground is soft?</p>"])

    def test_a_formula_comes_with_the_sentence_before_it_and_no_more_than_two_on_a_slide(self):
        first, formulas, figure, last = self.shown(1)
        self.assertIn(r"<p>So</p><p>\[ a \]</p><p></p><p>\[ b \]</p>", formulas)
        self.assertIn(r"\[ c \]", last)

    def test_a_figure_comes_with_its_caption(self):
        self.assertIn('<img src="figures/d.svg" alt=""></a></div>', self.shown(1)[2])
        self.assertIn('<p class="caption"><b>Figure 1.1.</b> A drop.</p>', self.shown(1)[2])

    def test_a_sentence_ends_neither_in_a_formula_nor_in_code(self):
        self.assertEqual(slides.sentences(r"Take \(a = 1. 2\), 0.5 or <code>f. g</code>. So?"), [r"Take \(a = 1. 2\), 0.5 or <code>f. g</code>.", "So?"])

    def test_a_deck_lies_below_the_book_and_starts_the_live_figures_of_a_live_book(self):
        still, live = (slides.deck(PAGE.split("</head>")[0], "A drop", self.sections, live) for live in (False, True))
        self.assertIn('src="../figures/d.svg"', still)
        self.assertNotIn("data-live", still)
        self.assertIn('data-live="drop"', live)
        self.assertIn('<script src="../live/drop.js"></script>', live)


class Plans(unittest.TestCase):
    def test_each_section_of_a_plan_is_a_heading_of_its_chapter(self):
        for name, plan in tomllib.loads((DOCS / "tools/slide_plans.toml").read_text(encoding="utf-8")).items():
            for label, headings in plan.items():
                if label != "title":
                    page = next((DOCS.parent / "chapters").glob(f"{label[-2:]}_*/chapter.md")).read_text(encoding="utf-8")
                    there = re.findall(r"^## (.+?)(?: \{#\w+\})?$", page, re.M)
                    self.assertLessEqual(set(headings), set(there), f"{name}: {label}")

    def test_one_that_is_not_there_stops_the_slides(self):
        with self.assertRaisesRegex(slides.NoSection, "chapter_01 has no section 'Three looks'"):
            list(slides.planned({"title": "x", "chapter_01": ["Two looks", "Three looks"]}, {"chapter_01": slides.sections(PAGE)}))


if __name__ == "__main__":
    unittest.main()
