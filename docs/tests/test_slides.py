"""The slides: what each shows of its page, what a bad one is told, and that every chapter and plan has them."""
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]
ROOT = DOCS.parent
sys.path.insert(0, str(DOCS / "tools"))
import slides  # noqa: E402

PAGE = r"""<p >It falls.</p><p class="formulaDsp">\[ a_1 &lt; b \]</p><p class="formulaDsp">\[ c \]</p>
<div class="figure"> <a class="anchor" id="f"></a><div class="live" data-figure="drop"><a href="figures/d.svg"><img src="figures/d.svg" alt=""></a></div>
<div class="caption"><b>Figure 1.1.</b> A drop.</div></div>
<div class="figure"> <a class="anchor" id="g"></a> <a href="figures/01/d.svg"><img src="figures/01/d.svg" alt=""></a><div class="caption"><b>Figure 1.2.</b> Still.</div> </div>"""
NOTES = "Words for the speaker, of which there have to be enough, so that somebody who did not write the page can say what the picture shows."
GIVEN = f"""[[slide]]
section = "Two looks"
idea = "It falls"
figure = "drop"
notes = "{NOTES}"
"""
WHOLE_MINUTES = 15  # a section that takes so long in class has a slide


def read(text):
    with tempfile.TemporaryDirectory() as held:
        (Path(held) / "chapter.md").write_text("# T\n\n## Two looks {#looks}\n", encoding="utf-8")
        (Path(held) / "slides.toml").write_text(text, encoding="utf-8")
        return slides.read_slides(Path(held) / "slides.toml")


class OfASlide(unittest.TestCase):
    def test_it_has_a_section_of_the_page_one_idea_and_notes(self):
        slide, = read(GIVEN)
        self.assertEqual((slide.section, slide.idea, slide.figure, slide.notes), ("Two looks", "It falls", "drop", NOTES))

    def test_what_is_missing_or_too_much_is_told(self):
        for text, told in ((GIVEN.replace('figure = "drop"\n', ""), "slide 1: neither a figure nor a formula"),
                           (GIVEN.replace("Two looks", "Three looks"), "no section 'Three looks'"),
                           (GIVEN.replace(NOTES, "Few words."), "notes of fewer than 20 words"),
                           (GIVEN.replace("It falls", "It falls " * 8), "'idea' has more than 14 words"),
                           (GIVEN.replace("idea =", "thought ="), "unknown thought"),
                           (GIVEN.replace('idea = "It falls"\n', ""), "no idea"),
                           (GIVEN + GIVEN.replace('figure = "drop"\n', ""), "slide 2: neither")):
            with self.subTest(told), self.assertRaisesRegex(slides.BadSlide, told):
                read(text)

    def test_a_picture_is_the_pages_and_its_caption_is_for_the_speaker(self):
        shown = slides.slide_html(read(GIVEN.replace('"drop"', '"d.svg"'))[0], PAGE, "Chapter 1")
        self.assertIn('<a href="figures/01/d.svg"><img src="figures/01/d.svg" alt=""></a></div></div><aside class="notes">', shown)
        self.assertIn("<b>Figure 1.2.</b> Still.", shown.split("<aside")[1])
        self.assertIn(NOTES, shown.split("<aside")[1])

    def test_a_formula_is_found_by_a_piece_of_it(self):
        self.assertEqual(slides.formula_of(PAGE, "a_1<b"), r"\[ a_1 &lt; b \]")

    def test_what_the_page_does_not_have_is_told(self):
        for find, told in ((lambda: slides.figure_of(PAGE, "e.svg"), "no figure 'e.svg'"), (lambda: slides.formula_of(PAGE, "x"), "no formula with 'x'")):
            with self.assertRaisesRegex(slides.BadSlide, told):
                find()

    def test_our_marks_become_html_but_not_within_a_formula(self):
        self.assertEqual(slides.marked_up("*So* $a * b * c < d$, `x_*y*` & 5 * 6"),
                         r"<em>So</em> \(a * b * c &lt; d\), <code>x_*y*</code> &amp; 5 * 6")


class OfADeck(unittest.TestCase):
    def test_a_deck_lies_below_the_book_and_starts_the_live_figures_of_a_live_book(self):
        body = slides.by_section(read(GIVEN), PAGE, "Chapter 1: A drop")
        still, live = (slides.deck("<head>", "A drop", slides.first_slide("A drop", "01.png", ["see"]), body, live) for live in (False, True))
        self.assertIn('src="../figures/d.svg"', still)
        self.assertIn('<img src="01.png"', still)
        self.assertNotIn("data-live", still)
        self.assertIn('data-live="drop"', live)
        self.assertIn('<script src="../live/drop.js"></script>', live)

    def test_a_fault_is_told_with_chapter_and_slide(self):
        with self.assertRaisesRegex(slides.BadSlide, r"Chapter 1: A drop, slide 1 \('It falls'\): the page shows no figure 'drip'"):
            slides.by_section(read(GIVEN.replace('"drop"', '"drip"')), PAGE, "Chapter 1: A drop")


class OfTheChapters(unittest.TestCase):
    def test_each_has_slides_and_one_for_each_long_section(self):
        for folder in sorted(ROOT.glob("chapters/[0-9][0-9]_*")):
            shown = {slide.section for slide in slides.read_slides(folder / "slides.toml")}
            minutes = tomllib.loads((folder / "teaching.toml").read_text(encoding="utf-8"))["minutes"]
            with self.subTest(folder.name):
                self.assertEqual([section for section, long in minutes.items() if long >= WHOLE_MINUTES and section not in shown], [], folder.name)

    def test_each_picture_and_formula_stands_in_the_source_of_the_page(self):
        bare = lambda text: "".join(text.split())
        for folder in sorted(ROOT.glob("chapters/[0-9][0-9]_*")):
            page = (folder / "chapter.md").read_text(encoding="utf-8")
            for slide in slides.read_slides(folder / "slides.toml"):
                self.assertTrue(not slide.figure or f"@figure{{{slide.figure}," in page or f"@live{{{slide.figure}," in page, f"{folder.name}: {slide.figure}")
                for piece in slide.formulas:
                    self.assertIn(bare(piece), bare(page), folder.name)


class Plans(unittest.TestCase):
    def test_each_section_of_a_plan_has_slides(self):
        chapters = {f"chapter_{path.parent.name[:2]}": slides.read_slides(path) for path in ROOT.glob("chapters/*/slides.toml")}
        for plan in tomllib.loads((DOCS / "tools/slide_plans.toml").read_text(encoding="utf-8")).values():
            self.assertTrue(all(chosen for _, chosen in slides.planned(plan, chapters)))

    def test_one_that_has_none_stops_the_slides(self):
        with self.assertRaisesRegex(slides.BadSlide, "chapter_01 has no slide for 'Three looks'"):
            list(slides.planned({"title": "x", "chapter_01": ["Two looks", "Three looks"]}, {"chapter_01": read(GIVEN)}))


if __name__ == "__main__":
    unittest.main()
