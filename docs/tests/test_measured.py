"""Measured numbers: the book takes the run's, and a number in a page's source that is far from it is told."""
import os
import sys
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import measured  # noqa: E402

RUN = {"drop.kept": "50", "drop.error": "3·10⁻⁹", "bar.elements": "48 soft elements", "drop.time_ms": "7", "drop.noise": "9·10⁻¹⁵"}


def compare(text, quick=False, ci="true"):
    with mock.patch.dict(os.environ, {"CI": ci}):
        notes, mistakes = measured.compare([(3, text)], RUN.__getitem__, quick)
    return len(notes), len(mistakes)


class InTheBook(unittest.TestCase):
    def test_the_number_is_the_runs_whatever_stands_there(self):
        self.assertEqual(measured.woven("keeps 42<!--drop.kept--> % (1<!--drop.error-->)", RUN.__getitem__), "keeps 50 % (3·10⁻⁹)")

    def test_words_are_marked_at_both_ends(self):
        self.assertEqual(measured.woven("of <!---->40 soft elements<!--bar.elements-->.", RUN.__getitem__), "of 48 soft elements.")

    def test_another_comment_is_none(self):
        self.assertEqual(measured.woven("a<!-- drop.kept -->", RUN.__getitem__), "a<!-- drop.kept -->")


class FarFromTheRun(unittest.TestCase):
    def test_a_tenth_is_told_and_ten_times_stop_ci(self):
        self.assertEqual(compare("48<!--drop.kept-->"), (0, 0))
        self.assertEqual(compare("42<!--drop.kept-->"), (1, 0))
        self.assertEqual(compare("4<!--drop.kept-->"), (0, 1))
        self.assertEqual(compare("-50<!--drop.kept-->"), (0, 1))
        self.assertEqual(compare("3·10⁻⁷<!--drop.error-->"), (0, 1))

    def test_a_readers_book_is_built_all_the_same(self):
        self.assertEqual(compare("4<!--drop.kept-->", ci=""), (1, 0))

    def test_of_a_few_words_the_number_counts(self):
        self.assertEqual(compare("<!---->40 soft elements<!--bar.elements-->"), (1, 0))

    def test_a_quick_run_a_clock_and_rounding_errors_say_nothing(self):
        self.assertEqual(compare("4<!--drop.kept-->", quick=True), (0, 0))
        self.assertEqual(compare("1<!--drop.time_ms-->"), (0, 0))
        self.assertEqual(compare("2·10⁻¹⁶<!--drop.noise-->"), (0, 0))

    def test_a_word_in_the_place_of_a_number_is_refused_in_a_quick_run_too(self):
        self.assertEqual(compare("keeps<!--drop.kept-->", quick=True, ci=""), (0, 1))

    def test_code_is_left_alone(self):
        self.assertEqual(compare("`4<!--drop.kept-->`"), (0, 0))
        text = "`4<!--drop.kept-->`\n```\n4<!--drop.kept-->\n```\n"
        self.assertEqual(measured.renewed(text, RUN.__getitem__), text)


class Renewed(unittest.TestCase):
    def test_the_source_gets_the_runs_numbers_and_stays_as_it_is_otherwise(self):
        text = "It keeps 42<!--drop.kept--> % of <!---->40 soft elements<!--bar.elements-->.\n"
        self.assertEqual(measured.renewed(text, RUN.__getitem__), "It keeps 50<!--drop.kept--> % of <!---->48 soft elements<!--bar.elements-->.\n")


if __name__ == "__main__":
    unittest.main()
