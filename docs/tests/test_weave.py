"""The weaver: what a page asks for arrives, and what is not there stops the book with file and line."""
import atexit
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

WEAVE = Path(__file__).resolve().parents[1] / "tools/weave.py"
sys.path.insert(0, str(WEAVE.parent))

import weave  # noqa: E402

CODE = """#pragma once
// [depth]
double depth();  // metres
// [depth]
// [nothing]

// [nothing]
// [once]
"""


class Book:
    """A small repository with one chapter and the results of its run."""

    def __init__(self, text, second_chapter=None):
        self.root = Path(tempfile.mkdtemp())
        atexit.register(shutil.rmtree, self.root)
        self.write("chapters/01_drop/chapter.md", text)
        self.write("chapters/01_drop/depth.hpp", CODE)
        self.write("chapters/01_drop/tests/drop.cpp", 'TEST_CASE("drop: |v| < 1")\n{\n}\n')
        self.write("docs/main.md", "# Title {#mainpage}\n\n@pages{chapters}\n")
        self.write("build/results/01_drop/facts_drop.csv", 'name,value,text\nheight,0.1,"0.1 m, about"\n')
        self.write("build/results/01_drop/steps.md", "| dt |\n|---:|\n| 0.14 |")
        self.write("build/results/01_drop/drop.svg", "<svg/>")
        self.write("build/results/01_drop/fall.mp4", "clip")
        if second_chapter:
            self.write("chapters/02_more/chapter.md", second_chapter)
            self.write("build/results/02_more/facts_drop.csv", "name,value,text\nheight,0.2,0.2 m\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def weave(self, *options):
        return subprocess.run([sys.executable, str(WEAVE), "--root", str(self.root), "--results",
                               str(self.root / "build/results"), "--out", str(self.root / "out"), *options],
                              capture_output=True, text=True)

    def page(self, label="chapter_01"):
        return (self.root / "out/pages" / f"{label}.md").read_text(encoding="utf-8")


class WhatArrives(unittest.TestCase):
    def woven(self, text, *options):
        book = Book("# The drop\n" + text)
        done = book.weave(*options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return book.page()

    def test_a_chapter_gets_its_number_and_label(self):
        self.assertTrue(self.woven("Why?").startswith("# Chapter 1: The drop {#chapter_01}\n"))

    def test_a_fact_is_the_text_of_the_run(self):
        self.assertIn("It falls 0.1 m, about.", self.woven("It falls 0.1<!--drop.height-->."))

    def test_code_is_left_as_it_is(self):
        page = self.woven("`0.1<!--drop.height-->`\n\n```\n1<!--no.such-->\n```\n")
        self.assertIn("`0.1<!--drop.height-->`", page)
        self.assertIn("1<!--no.such-->", page)

    def test_figures_are_numbered_copied_and_linked(self):
        book = Book("# The drop\nSee @figref{drop.svg} and @figref{fall.mp4}.\n\n@figure{drop.svg, Up}\n@figure{fall.mp4, Down 0.1<!--drop.height-->}\n")
        self.assertEqual(book.weave().returncode, 0)
        self.assertIn('and \\ref fig_chapter_01_fall_mp4 "Figure 1.2".', book.page())
        self.assertIn("<b>Figure 1.2.</b> Down 0.1 m, about", book.page())
        self.assertEqual((book.root / "out/figures/01_drop/fall.mp4").read_text(), "clip")

    def test_a_table_stands_in_the_page(self):
        page = self.woven("@tabref{steps}\n\n@table{steps, Stable steps}\n")
        self.assertIn("| 0.14 |", page)
        self.assertIn('"Table 1.1"', page)

    def test_a_table_of_many_rows_is_folded(self):
        book = Book("# The drop\n@table{steps, Steps}\n")
        for rows, folded in ((30, False), (31, True)):
            book.write("build/results/01_drop/steps.md", "| dt |\n|---:|\n" + "| 0.14 |\n" * rows)
            self.assertEqual(book.weave().returncode, 0)
            self.assertEqual(f"<summary>All {rows} rows</summary>" in book.page(), folded)

    def test_a_snippet_names_its_file_from_the_top(self):
        self.assertIn("\\snippet chapters/01_drop/depth.hpp depth\n", self.woven("[depth.hpp: depth](depth.hpp)\n"))

    def test_a_list_of_pages_says_what_each_is_about(self):
        book = Book("# The drop\n@about{A drop, 0.1<!--drop.height--> high.}\n\nWhy? Because.")
        self.assertEqual(book.weave().returncode, 0)
        self.assertIn("\\subpage chapter_01 <br>A drop, 0.1 m, about high.", book.page("mainpage"))
        self.assertNotIn("about{", book.page())
        self.assertIn("Why? Because.", book.page())

    def test_without_it_the_list_shows_the_first_sentence(self):
        book = Book("# The drop\n\nWhy? Because.")
        self.assertEqual(book.weave().returncode, 0)
        self.assertIn("\\subpage chapter_01 <br>Why?\n", book.page("mainpage"))

    def test_mistakes_below_it_are_named_with_their_line(self):
        done = Book("# The drop\n@about{A drop.}\n\n1<!--drop.depth-->").weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn("chapter.md:4: ", done.stderr)

    def test_a_test_is_named_so_that_a_table_survives_it(self):
        self.assertIn('| <code class="test">drop: \\|v\\| &lt; 1</code> |', self.woven("| Test |\n|:--|\n| @test{drop: |v| < 1} |"))

    def test_in_a_sentence_a_test_is_a_tick_with_its_name_behind_it(self):
        self.assertIn('It falls (<span class="test" tabindex="0">✓<code class="test">drop: \\|v\\| &lt; 1</code></span>).', self.woven("It falls (@test{drop: |v| < 1})."))

    def test_a_wrong_version_names_the_test_that_fails_in_it(self):
        book = Book("# The drop\n@wrong{upside_down}")
        wrong = '[upside_down]\nsays = "It falls up."\nfails = "%s"\nfile = "chapters/01_drop/depth.hpp"\nfind = "depth"\nreplace = "height"\n'
        book.write("chapters/01_drop/tests/wrong.toml", wrong % "drop: |v| < 1")
        self.assertEqual((book.weave().returncode, book.page().count('title="fails: drop: |v| &lt; 1">upside_down</code>')), (0, 1))
        book.write("chapters/01_drop/tests/wrong.toml", wrong % "drop: another")
        self.assertIn("no test is called 'drop: another'", book.weave().stderr)

    def test_a_quick_run_marks_its_figures_and_tables_alone(self):
        text = "@figref{drop.svg}, @tabref{steps}\n\n@figure{drop.svg, Up}\n\n@table{steps, Steps}\n\n@table{steps}\n"
        self.assertEqual(self.woven(text, "--quick").count("quick run"), 3)
        self.assertNotIn("quick run", self.woven(text))
        self.assertNotIn("quick run", self.woven("Why?", "--quick"))

    def test_a_sentence_of_a_quick_run_keeps_the_number_of_the_full_one(self):
        self.assertIn("It falls 7 m.", self.woven("It falls <!---->7 m<!--drop.height-->.", "--quick"))
        self.assertEqual(Book("# The drop\n7<!--drop.depth-->").weave("--quick").returncode, 2)

    def test_bold_words_may_hold_a_formula(self):
        page = self.woven("It is **stable for every $k$**, **always**; `**p $k$**`.")
        self.assertIn("<b>stable for every \\f$k\\f$</b>, **always**; `**p $k$**`", page)

    def test_the_main_page_asks_what_the_chapter_asks(self):
        book = Book("# The drop\n\nHow deep does\nit fall? Far.\n")
        self.assertEqual(book.weave().returncode, 0)
        self.assertIn("- \\subpage chapter_01 <br>How deep does it fall?\n", book.page("mainpage"))

    def test_a_chapter_takes_its_own_fact(self):
        book = Book("# A\n0.1<!--drop.height-->\n", "# B\n0.2<!--drop.height-->\n")
        self.assertEqual(book.weave().returncode, 0)
        self.assertIn("\n0.2 m\n", book.page("chapter_02"))


    def test_a_page_tells_what_changed_before_a_later_chapter_or_the_ledger_has_run(self):
        book = Book("# A\n0.1<!--drop.height-->\n\n@changes\n", "# B\n@changes\n")
        shutil.rmtree(book.root / "build/results/02_more")
        self.assertIn("solvers/passes.csv is not there", book.weave().stderr)
        book.write("build/results/solvers/passes.csv", "chapter,stage,pass\n1,detect,planes\n2,detect,planes\n2,detect,faces\n")
        done = book.weave()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("| detection | **planes** |", book.page())
        self.assertIn("| detection | planes, **faces** |", book.page("chapter_02"))
        self.assertNotIn("Behaviour", book.page("chapter_02"))
        book.write("build/results/solvers/ledger.csv", "scene,chapter,quantity,unit,bound,value,passes\n"
                   "fall,1,way,m,at most 1 m,3,0\nfall,2,way,m,at most 1 m,0.5,1\nfall,Bullet,way,m,at most 1 m,9,0\n")
        self.assertEqual(book.weave().returncode, 0)
        self.assertIn("**0.5 m** with chapter 2, which holds", book.page("chapter_02"))

    def test_a_chapters_number_before_a_name_decides(self):
        book = Book("# A\n", "# B\n")
        book.write("build/results/02_more/drop.svg", "<svg>2</svg>")
        book.write("docs/page.md", "# Page\n0.2<!--2/drop.height--> 0.1<!--1/drop.height-->\n\n@figure{2/drop.svg, Up}\n@figref{2/drop.svg}\n")
        done = book.weave()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("\n0.2 m 0.1 m, about\n", book.page("page_page"))
        self.assertEqual((book.root / "out/figures/02_more/drop.svg").read_text(), "<svg>2</svg>")

    def test_what_all_solvers_left_is_named_by_their_word(self):
        book = Book("# A\n")
        book.write("build/results/solvers/steps.md", "| all |\n|---:|\n| 9 |")
        book.write("docs/page.md", "# Page\n@table{solvers/steps}\n@table{1/steps}\n")
        done = book.weave()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("| 9 |", book.page("page_page"))
        self.assertIn("| 0.14 |", book.page("page_page"))


class NamesOfTests(unittest.TestCase):
    def test_none_has_a_semicolon_at_which_ctest_would_cut_it_and_then_run_no_test_at_all(self):
        self.assertEqual([name for name in weave.test_names(WEAVE.parents[2]) if ";" in name], [])


class WhatStopsTheBook(unittest.TestCase):
    def refused(self, text, message, **more):
        book = Book(text, **more)
        done = book.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn(message, done.stderr)
        self.assertFalse((book.root / "out").exists(), "nothing is written")

    def test_an_unknown_fact(self):
        self.refused("# The drop\n\nIt falls 1<!--drop.depth-->.", "chapters/01_drop/chapter.md:3: no run left the fact 'drop.depth'")

    def test_an_unknown_table(self):
        self.refused("# The drop\n@table{stops}", "chapter.md:2: no run left the table 'stops.md'")

    def test_an_unknown_figure(self):
        self.refused("# The drop\n@figure{drop.png, A drop}", "chapter.md:2: no run left the figure 'drop.png'")

    def test_a_figure_without_a_caption(self):
        self.refused("# The drop\n@figure{drop.svg}", "chapter.md:2: cannot read @figure{drop.svg}")

    def test_a_reference_to_a_figure_that_no_page_shows(self):
        self.refused("# The drop\n@figref{drop.svg}", "chapter.md:2: @figref{drop.svg}: no page shows it")

    def test_a_snippet_of_no_file(self):
        self.refused("# The drop\n[height.hpp: depth](height.hpp)", "chapter.md:2: the listing height.hpp: height.hpp is no file")

    def test_a_snippet_that_leads_to_another_file(self):
        self.refused("# The drop\n[height.hpp: depth](depth.hpp)", "the listing height.hpp leads to chapters/01_drop/depth.hpp")

    def test_the_name_of_no_test(self):
        self.refused("# The drop\n@test{drop: v < 1}", "chapter.md:2: no test is called 'drop: v < 1'")

    def test_a_wrong_version_that_nobody_has(self):
        self.refused("# The drop\n@wrong{upside_down}", "chapter.md:2: 0 wrong versions are called 'upside_down'")

    def test_an_empty_snippet(self):
        self.refused("# The drop\n[depth.hpp: nothing](depth.hpp)", "the region [nothing] of chapters/01_drop/depth.hpp is empty")

    def test_a_snippet_whose_mark_is_left_open(self):
        self.refused("# The drop\n[depth.hpp: once](depth.hpp)", "the mark [once] stands 1 times")

    def test_a_snippet_without_a_mark(self):
        self.refused("# The drop\n[depth.hpp: width](depth.hpp)", "the mark [width] stands 0 times")

    def test_a_fact_that_two_other_chapters_have(self):
        book = Book("# A\n", "# B\n")
        book.write("docs/page.md", "# Page\n1<!--drop.height-->")
        done = book.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn("docs/page.md:2: the fact 'drop.height' is in several chapters: 01_drop, 02_more", done.stderr)

    def test_a_page_without_a_title(self):
        self.refused("The drop\n", "chapter.md:1: a page begins with its title")

    def test_an_erratum_that_is_tested_but_not_listed(self):
        book = Book("# A\n")
        book.write("chapters/01_drop/tests/errata.cpp", 'TEST_CASE("errata: (1.1) has the wrong sign")')
        done = book.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn("the test 'errata: (1.1) has the wrong sign' is not listed", done.stderr)

    def test_two_pages_with_one_label(self):
        book = Book("# A\n")
        book.write("common/fem/start.md", "# Start {#mainpage}\n")
        done = book.weave()
        self.assertEqual(done.returncode, 2)
        self.assertIn("has the label {#mainpage} already", done.stderr)

    def test_every_mistake_is_reported_at_once(self):
        done = Book("# The drop\n1<!--a.b-->\n1<!--c.d-->\n").weave()
        self.assertEqual(done.stderr.count("no run left"), 2)


if __name__ == "__main__":
    unittest.main()
