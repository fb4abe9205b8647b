"""The check of prose: each fault is found with its line, and what a script must not read is left out."""
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import sentences  # noqa: E402

STRICT = '[[group]]\npages = "chapters/07_*/chapter.md"\npronouns = 0\nlong = 0\nminds = 0\nhistory = 0\nwords = 30\n'
PRONOUNS = "This is what it does to that which comes."
NAME = "chapters/07_more/chapter.md"


class Book(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.root = Path(held.name)

    def faults(self, text, name=NAME, rules=STRICT):
        (self.root / "docs/tools").mkdir(parents=True, exist_ok=True)
        (self.root / "docs/tools/sentences.toml").write_text(rules)
        page = SimpleNamespace(path=self.root / name, lines=text.split("\n"), first_line=2)
        return list(sentences.all_faults(self.root, [page]))


class Faults(Book):
    def test_four_pronouns_are_found_with_the_line_and_three_are_not(self):
        found = self.faults(f"A cube lies on the floor.\n\n{PRONOUNS}")
        self.assertEqual(len(found), 1)
        self.assertIn(f"{NAME}:4: 4 or more", found[0])
        self.assertEqual(self.faults("This is what it does to that body."), [])

    def test_bodies_and_solvers_with_a_mind_are_found_and_people_are_not(self):
        for wrong in ("The solver wants a small step.", "A body never knows its neighbour.", "The pairs do not say so.", "Each wall asks for its share."):
            self.assertEqual(len(self.faults(wrong)), 1, wrong)
        self.assertEqual(self.faults("We ask for the depth. Students know the answer. A step takes the normal."), [])

    def test_history_of_the_text_is_found(self):
        for wrong in ("In an earlier version the cube fell.", "For long it was the slowest part.", "We would like at most three."):
            self.assertEqual(len(self.faults(wrong)), 1, wrong)
        self.assertEqual(self.faults("An earlier step has found the pair."), [])

    def test_a_long_sentence_is_found_and_formulas_and_numbers_count_for_nothing(self):
        long = "The cube lies on " + "a very wide and even " * 6
        for sentence, count in ((f"{long}floor.", 0), (f"{long}green floor.", 1), (f"{long}$x$ `y` 7<!--drop.depth--> 1.5 % floor.", 0)):
            self.assertEqual(len([fault for fault in self.faults(sentence) if "36 words or more" in fault]), count, sentence)

    def test_a_sentence_ends_before_a_reference(self):
        self.assertEqual(self.faults("This is what the cube does to it. \\ref page_notation has that symbol."), [])

    def test_a_share_below_the_limit_passes(self):
        rules = STRICT.replace("pronouns = 0", "pronouns = 50")
        self.assertEqual(self.faults(f"{PRONOUNS} A cube lies on the floor.", rules=rules), [])
        self.assertEqual(len(self.faults(f"{PRONOUNS} {PRONOUNS} A cube lies on the floor.", rules=rules)), 2)

    def test_a_caption_of_more_than_40_words_is_found_and_its_marks_and_places_count_for_nothing(self):
        for kind in ("@figure{9/drop.svg", "@table{drop", "@live{drop, drop.svg"):
            self.assertEqual(self.faults(f"{kind}, {'word ' * 39}7<!--drop.depth-->}}"), [], kind)
            self.assertIn("a caption of 41 words, 40 allowed", self.faults(f"{kind}, {'word ' * 40}7<!--drop.depth-->}}")[0])

    def test_three_sentences_that_begin_with_of_and_a_number_are_too_many(self):
        of = "Of 14<!--drop.runs--> runs, 13 come to rest. "
        self.assertEqual(self.faults(of * 2 + "All of 14 runs come to rest."), [])
        self.assertEqual(len(self.faults(of * 2 + "Of all 14 runs some come to rest.")), 3)

    def test_only_the_main_line_is_counted(self):
        long = "A cube lies on the wide and even floor. " * 5
        self.assertIn("45 words before 'For the curious', 30 allowed", self.faults(long)[0])
        self.assertEqual(self.faults(f"A cube lies there.\n\n## For the curious\n{long}"), [])


class WhatIsNotRead(Book):
    def test_code_formulas_tables_headings_and_names_of_tests(self):
        for text in (f"```\n{PRONOUNS}\n```", f"| {PRONOUNS} |", f"## {PRONOUNS}", f"A cube lies (@test{{{PRONOUNS}}}) there.", f"The name is `{PRONOUNS}` here."):
            self.assertEqual(self.faults(text), [], text)

    def test_an_indented_listing(self):
        self.assertEqual(self.faults(f"A cube lies there:\n\n    {PRONOUNS}\n    {PRONOUNS}\n"), [])

    def test_lines_after_a_block_of_code_keep_their_numbers(self):
        self.assertIn(f"{NAME}:6:", self.faults(f"```\na\nb\n```\n{PRONOUNS}")[0])

    def test_each_item_of_a_list_is_read_by_itself(self):
        self.assertEqual(self.faults("- this cube lies there and it\n- sees that floor which is one"), [])

    def test_a_page_without_a_group(self):
        self.assertEqual(self.faults(PRONOUNS, name="docs/other.md"), [])


class Exceptions(Book):
    def excepted(self, text, page=NAME):
        return STRICT + f'[[exception]]\npage = "{page}"\nkind = "minds"\ntext = "{text}"\nwhy = "a quotation"\n'

    def test_a_named_sentence_passes_and_no_other_one(self):
        rules = self.excepted("solver wants a small")
        self.assertEqual(self.faults("The solver wants a small step.", rules=rules), [])
        self.assertEqual(len(self.faults("The solver wants a small step. The body wants no step at all.", rules=rules)), 1)

    def test_one_that_no_sentence_needs_is_told(self):
        self.assertIn("needs the exception 'a flat floor'", self.faults("The cube lies there.", rules=self.excepted("a flat floor"))[0])

    def test_one_of_another_page_does_not_count(self):
        found = self.faults("The solver wants a small step.", rules=self.excepted("solver wants", page="chapters/08_x/chapter.md"))
        self.assertEqual(len(found), 2)


if __name__ == "__main__":
    unittest.main()
