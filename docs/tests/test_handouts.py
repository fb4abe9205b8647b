"""The handouts: what they take from a page, what they refuse, and that each of them is two pages."""
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

from test_browser import PYTHON, possible

DOCS = Path(__file__).resolve().parents[1]
BOOK = DOCS.parent / "build/book"
sys.path.insert(0, str(DOCS / "tools"))
import handouts  # noqa: E402
import weave  # noqa: E402

SOURCE = "Text.\n[a.cpp: fall](a.cpp)\n\n[b.cpp: rest](../b.cpp)\n"
TEXT = r"""<p >It falls. So</p><p class="formulaDsp">\[ a &lt; \frac{1}{2} \]</p><p>Or</p><p class="formulaDsp">\[ b \]</p>
<div class="figure"><div class="live" data-figure="drop"><a href="figures/d.svg"><img src="figures/d.svg" alt=""></a></div><div class="caption">Live.</div></div>
<div class="figure"><a href="figures/d.svg"><img src="figures/d.svg" alt=""></a><div class="caption"><b>Figure 1.1.</b> Drop.</div></div>
<div class="listing">x/a.cpp</div> <div class="fragment"><div class="line">fall();</div></div><!-- fragment -->
<div class="listing">b.cpp</div> <div class="fragment"><div class="line">rest();</div></div><!-- fragment -->"""
PAGE = f"""<html><head></head><body><div class="title">Chapter 1 </div><div class="contents"><div class="textblock">{TEXT}
 </div></div><!-- contents --></body></html>"""
PLAN = {"idea": "It falls.", "formulas": [r"a < \frac{1}{2}"], "figure": "d.svg", "listing": "b.cpp: rest", "questions": ["Why?"] * 3}


class OfAPage(unittest.TestCase):
    def test_a_formula_is_found_by_a_piece_of_it_and_comes_with_the_paragraph_before_it(self):
        self.assertEqual(handouts.formula(TEXT, r"a<\frac{1}{2}"), r'<p >It falls. So</p><p class="formulaDsp">\[ a &lt; \frac{1}{2} \]</p>')

    def test_a_figure_has_the_caption_of_the_picture_and_not_of_the_live_figure(self):
        self.assertIn('<p class="caption"><b>Figure 1.1.</b> Drop.</p>', handouts.figure(TEXT, "d.svg"))

    def test_a_listing_is_the_one_that_the_source_names(self):
        self.assertIn("rest();", handouts.listing(TEXT, SOURCE, "b.cpp: rest"))
        self.assertNotIn("fall();", handouts.listing(TEXT, SOURCE, "b.cpp: rest"))

    def test_what_the_page_does_not_have_once_is_refused(self):
        for take in (lambda: handouts.formula(TEXT, "z"), lambda: handouts.formula(TEXT, r"\["), lambda: handouts.figure(TEXT, "e.svg"),
                     lambda: handouts.listing(TEXT, SOURCE, "b.cpp: fall"), lambda: handouts.listing(TEXT, SOURCE + "[b.cpp: up](b.cpp)\n", "b.cpp: up"),
                     lambda: handouts.handout("", PAGE, SOURCE, {"idea": "?"})):
            with self.assertRaises(handouts.DoesNotFit):
                take()

    def test_each_question_has_room_below_it(self):
        page = handouts.handout("", PAGE, SOURCE, PLAN)
        self.assertEqual(page.count('Why?<div class="room"></div>'), 3)
        self.assertEqual(page.count('<section class="sheet'), 2)


class OfTheChapters(unittest.TestCase):
    def test_each_has_an_idea_two_or_three_formulas_a_listing_of_its_page_and_three_questions(self):
        for path in sorted(DOCS.parent.glob("chapters/[0-9][0-9]_*/teaching.toml")):
            with self.subTest(path.parent.name):
                plan, source = tomllib.loads(path.read_text(encoding="utf-8"))["handout"], (path.parent / "chapter.md").read_text(encoding="utf-8")
                self.assertEqual(set(plan), handouts.PARTS)
                self.assertIn(len(plan["formulas"]), (2, 3))
                self.assertEqual(len(plan["questions"]), 3)
                self.assertIn(f"[{plan['listing']}](", source.replace("common/simulation/", ""))
                self.assertIn(f"@figure{{{plan['figure']},", source)
                named = next(match for match in map(weave.LISTING.match, source.splitlines()) if match and f"{match[1]}: {match[2]}" == plan["listing"])
                lines = (path.parent / named[3]).read_text(encoding="utf-8").splitlines()
                begin, end = (number for number, line in enumerate(lines) if f"[{named[2]}]" in line)
                self.assertLess(end - begin - 1, 40, "three answers need room below the listing")
                bare = re.sub(r"\s", "", source)
                for piece in plan["formulas"]:
                    self.assertEqual(bare.count(re.sub(r"\s", "", piece)), 1, piece)


@unittest.skipUnless(possible(), "needs python3-selenium")
class Printed(unittest.TestCase):
    def pages(self, text):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "handouts").mkdir()
            (Path(folder) / "handouts/handouts.css").write_bytes((DOCS / "theme/handouts.css").read_bytes())
            page = Path(folder) / "handouts/chapter_1.html"
            mathjax = '<script>window.MathJax = {Hub: {Queue: go => go()}};</script>'
            page.write_text(handouts.handout("", PAGE.replace("rest();", text), SOURCE, PLAN).replace("<body>", f"<body>{mathjax}"), encoding="utf-8")
            done = subprocess.run([PYTHON, "-c", "import sys; sys.path.insert(0, sys.argv[1]); import handouts, pathlib\n"
                                   "sys.stdout.buffer.write(handouts.printed(pathlib.Path(sys.argv[2]), handouts.FAULTS))", DOCS / "tools", page], capture_output=True)
            return len(re.findall(rb"/Type /Page\b", done.stdout)), done.stderr.decode()

    def test_a_handout_is_two_pages(self):
        self.assertEqual(self.pages("rest();"), (2, ""))

    def test_one_with_a_listing_that_leaves_no_room_for_answers_is_refused(self):
        count, said = self.pages("rest();" + "<br>on();" * 50)
        self.assertEqual(count, 0)
        self.assertRegex(said, "Unprintable: .*an answer has too little room")


if __name__ == "__main__":
    unittest.main()
