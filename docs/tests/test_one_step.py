"""The page of one step: at most twenty terms, each with a name that the code has, and one screen of pseudo-code and of formulas."""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/one_step.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| (?P<term>[^|]+) \| [^|]+ \| \\ref enduring::(?P<name>\w+) \"(?P<shown>\w+)\", `(?P<file>[^`]+)` \|$", re.M)
FEWEST, SCREEN = 15, 30


def declared(name, text):
    """Whether a header declares a type or a function of this name at the margin."""
    return bool(re.search(rf"^(?:struct|class|enum class) {name}\b|^[A-Za-z].*\b{name}\(", text, re.M))


class TheStepOnOnePage(unittest.TestCase):
    def test_each_term_has_a_name_that_the_code_declares(self):
        for row in ROW.finditer(PAGE):
            with self.subTest(term=row["term"]):
                headers = [header for folder in ("common", "chapters") for header in (ROOT / folder).rglob(row["file"])]
                self.assertEqual(len(headers), 1, f"{row['file']} is not one file")
                self.assertTrue(declared(row["name"], headers[0].read_text(encoding="utf-8")), f"{row['file']} declares no {row['name']}")
                self.assertEqual(row["name"], row["shown"])

    def test_there_are_at_most_twenty_terms_and_each_line_of_the_table_is_one(self):
        table = len(re.findall(r"^\| (?!Term )\w", PAGE, re.M))
        self.assertEqual(len(ROW.findall(PAGE)), table)
        self.assertTrue(FEWEST <= table <= 20, f"{table} terms")

    def test_pseudo_code_and_formulas_fit_a_screen(self):
        code, formulas = re.search(r"```\n(.*?)```", PAGE, re.S)[1], re.search(r"```math\n(.*?)```", PAGE, re.S)[1]
        self.assertLessEqual(code.count("\n"), SCREEN)
        self.assertEqual(re.findall(r"\\text\{\((\d)\)\}", formulas), list("123456"))

    def test_its_numbers_are_those_of_the_code(self):
        search = (ROOT / "chapters/08_contact_by_distance/distance_parts.hpp").read_text(encoding="utf-8")
        choice = (ROOT / "chapters/07_implicit_contact/pair_memory.hpp").read_text(encoding="utf-8")
        for said, code, where in (("ten times the 100", "double stiffer = 10;", search), ("half a thousandth", "double skin = 5e-4;", search),
                                  ("100\\,m", "k_dt2_over_m = 100;", choice), ("10^7\\,m", "max_k_dt2_over_m = 1e7;", choice)):
            self.assertIn(said, PAGE)
            self.assertIn(code, where)

    def test_the_pseudo_code_points_to_formulas_that_are_there(self):
        code = re.search(r"```\n(.*?)```", PAGE, re.S)[1]
        self.assertEqual(sorted(set(re.findall(r"\((\d)\)", code))), list("3456"))


if __name__ == "__main__":
    unittest.main()
