"""The checks of the finished book: each is shown a page that has the fault, and one that has not."""
import sys
import tempfile
import unittest
from unittest import mock
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import build  # noqa: E402
import changes  # noqa: E402
import checks  # noqa: E402
import teaching  # noqa: E402

NOTATION = "| Symbol | Meaning |\n|:--|:--|\n| \\f$\\delta\\f$ | depth |\n| \\f$k, \\Delta t\\f$ | stiffness, step |\n"


def symbols(text, own=()):
    return list(checks.symbol_faults([("page.md", text, set(own))], NOTATION))


class Symbols(unittest.TestCase):
    def test_a_symbol_of_the_table_may_be_used(self):
        self.assertEqual(symbols("The push \\f$-k\\,\\delta\\f$ and \\f[ \\frac{k}{\\Delta t} \\f]."), [])

    def test_a_symbol_without_a_row_is_named(self):
        self.assertEqual(symbols("\\f$ k \\zeta + q_{slip} \\f$"), ["page.md: not in docs/notation.md, and not in the page's own @local: i, l, p, q, s, zeta"])

    def test_a_page_may_explain_a_symbol_itself(self):
        self.assertEqual(symbols("\\f$ q \\f$", own=["q"]), [])

    def test_words_in_a_formula_are_no_symbols(self):
        self.assertEqual(symbols("\\f$ k_\\mathrm{max} \\text{ if wet} \\f$"), [])

    def test_code_outside_of_formulas_is_not_read(self):
        self.assertEqual(symbols("`q = 1` and q"), [])

    def test_a_command_that_nobody_knows_is_named(self):
        self.assertIn("qqad", symbols("\\f$ k \\qqad \\delta \\f$")[0])


class Abbreviations(unittest.TestCase):
    def found(self, text):
        return list(checks.abbreviation_faults([("page.md", text, set())], "| CPF | continuous |"))

    def test_one_of_the_glossary_passes(self):
        self.assertEqual(self.found("CPF is better."), [])

    def test_one_that_is_missing_is_named(self):
        self.assertEqual(self.found("XPF is worse."), ["page.md: not in docs/glossary.md: XPF"])

    def test_code_is_left_out(self):
        self.assertEqual(self.found("`XPF` and \\f$ABC\\f$"), [])


class Figures(unittest.TestCase):
    def test_a_figure_that_no_sentence_mentions_is_named(self):
        pages = [("page.md", ["drop.svg", "fall.png"], "See @figref{drop.svg}.")]
        self.assertEqual(list(checks.figure_faults(pages)), ["page.md: no sentence mentions the figure fall.png (@figref)"])


class InAFolder(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.root = Path(held.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path


class Folders(InAFolder):
    def test_what_all_solvers_left_comes_last_and_each_folder_has_its_word_and_program(self):
        for folder in ("solvers", "06_last", "00_base", "other"):
            self.write(f"results/{folder}/a.csv", "1")
        folders = [path.name for path in checks.result_folders(self.root / "results")]
        self.assertEqual(folders, ["00_base", "06_last", "solvers"])
        self.assertEqual([checks.word_of(folder) for folder in folders], ["0", "6", "solvers"])
        self.assertEqual([checks.program_of(folder) for folder in folders], ["base", "chapter06", "solvers"])


class Links(InAFolder):
    def test_a_link_to_nothing_and_an_anchor_that_is_missing_are_named(self):
        self.write("a.html", '<a href="b.html#there">x</a><a href="b.html#gone">y</a><a href="c.html">z</a><img src="d.png"><a href="https://e.org/f">w</a>')
        self.write("b.html", '<h2 id="there">B</h2>')
        self.assertEqual(list(checks.link_faults(self.root)), ["a.html: leads to b.html#gone, an anchor that is not there",
                                                               "a.html: leads to c.html, which is not there", "a.html: leads to d.png, which is not there"])


class StaleResults(InAFolder):
    def test_results_of_another_program_are_named(self):
        program = self.write("bin/chapter01", "new")
        self.write("results/01_drop/.made_by", checks.made_by(program))
        self.assertEqual(list(checks.stale_results(self.root / "results", self.root / "bin")), [])
        program.write_text("newer")
        self.assertIn("the numbers are stale", list(checks.stale_results(self.root / "results", self.root / "bin"))[0])

    def test_results_without_a_maker_are_named(self):
        self.write("bin/chapter01", "new")
        self.write("results/01_drop/drop.csv", "1")
        self.assertEqual(len(list(checks.stale_results(self.root / "results", self.root / "bin"))), 1)


class WhatChanged(InAFolder):
    def test_the_block_needs_the_list_of_passes_and_no_chapters_results(self):
        self.write("chapters/01_drop/depth.hpp", "/// Depth of a point.\ndouble depth();\n")
        with self.assertRaisesRegex(FileNotFoundError, "solvers/passes.csv"):
            changes.changes_block(self.root, self.root / "results", "01_drop")
        self.write("results/solvers/passes.csv", "chapter,stage,pass\n1,detect,boxes\n")
        told = changes.changes_block(self.root, self.root / "results", "01_drop")
        self.assertIn("| detection | **boxes** |", told)
        self.assertIn("`depth.hpp`: Depth of a point.", told)
        self.assertNotIn("Behaviour", told)
        head = "scene,chapter,quantity,unit,bound,value,passes\n"
        self.write("results/solvers/ledger.csv", head + "slope,1,way,mm,at most 1 mm,2971,0\nslope,2,way,mm,at most 1 mm,0.2,1\n")
        self.assertIn("Behaviour", changes.changes_block(self.root, self.root / "results", "02_more"))

    def test_new_passes_are_bold_and_lost_ones_struck_through(self):
        passes = [{"chapter": c, "stage": "detect", "pass": p} for c, p in (("1", "boxes"), ("1", "queries"), ("2", "boxes"), ("2", "labels"))]
        table = changes.passes_table(passes, 2)
        self.assertIn("| detection | boxes, **labels**, <s>queries</s> |", table)

    def test_a_scene_whose_verdict_changed_is_told_with_both_numbers(self):
        def cell(chapter, value, passes):
            return {"scene": "slope", "chapter": chapter, "quantity": "way", "unit": "mm", "bound": "at most 1 mm", "value": value, "passes": passes}
        told = changes.verdicts([cell("3", "2971", "0"), cell("4", "0.195", "1")], 4)
        self.assertIn("2971 mm with chapter 3, **0.195 mm** with chapter 4, which holds", told)
        self.assertEqual(changes.verdicts([cell("3", "2", "1"), cell("4", "1", "1")], 4), "")

    def test_a_header_is_told_by_its_first_sentence(self):
        self.assertEqual(changes.first_sentence("#pragma once\n\n/// Impulse of a pair at both ends of the step: all of it.\n/// @param k  stiffness\nvoid f();\n"),
                         "Impulse of a pair at both ends of the step.")

    def test_a_header_is_told_by_what_it_is_named_after(self):
        text = "/// A half space.\nstruct Plane;\n/// One step of the world.\nvoid time_step(World&);\n"
        self.assertEqual(changes.first_sentence(text, "time_step"), "One step of the world.")
        self.assertEqual(changes.first_sentence(text.replace("void time_step(World&)", "class TimeStep"), "time_step"), "One step of the world.")
        self.assertEqual(changes.first_sentence(text, "other"), "A half space.")

    def test_only_the_first_paragraph_is_read(self):
        self.assertEqual(changes.first_sentence("/// A file on its way.\n///\n///     File file(\"a\");\nclass File;\n"), "A file on its way.")
        self.assertEqual(changes.first_sentence("/// Solves it\n///\n/// @see \"A paper\nvoid solve();\n"), "Solves it.")

    def test_a_constant_is_not_what_a_header_is_about(self):
        self.assertEqual(changes.first_sentence("/// Small.\nconstexpr int a = 1;\n\n/// Shares of mass.\nclass Shares;\n"), "Shares of mass.")


class Teaching(InAFolder):
    def plan(self, minutes):
        self.write("chapters/01_drop/teaching.toml", f'goals = ["fall"]\n[minutes]\n{minutes}')
        page = type("Page", (), {"folder": "01_drop", "lines": ["## Why?", "text", "## Exercises"]})()
        return teaching.plan_of(self.root, page)

    def test_each_section_has_its_minutes(self):
        self.assertEqual(self.plan('"Why?" = 10'), (["fall"], [("Why?", 10)]))

    def test_a_section_without_minutes_and_minutes_without_a_section_stop_the_book(self):
        with self.assertRaisesRegex(teaching.TeachingError, "no minutes for the section 'Why"):
            self.plan('"How?" = 10')
        with self.assertRaisesRegex(teaching.TeachingError, "there is no section 'How"):
            self.plan('"Why?" = 10\n"How?" = 10')


class Leftovers(InAFolder):
    def left(self, body):
        for name in ("pages/page.md", "page.html"):
            self.write(name, body)
        with mock.patch.object(build, "WORK", self.root):
            return list(build.leftovers(self.root))

    def test_marks_that_nothing_has_read_are_told(self):
        for mark in ("**", "\\f$", "@figure{drop.svg}"):
            self.assertEqual(len(self.left(f"<p>It is {mark} here</p>")), 1, mark)

    def test_code_and_formulas_may_hold_stars(self):
        self.assertEqual(self.left('<code>x**2</code>\n<div class="line">char **argv</div>\n\\(a^{**}\\)\n'), [])


if __name__ == "__main__":
    unittest.main()
