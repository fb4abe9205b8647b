"""What schools' systems read: each export is held against the format as it is published."""
import csv
import io
import json
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import exports  # noqa: E402
from grade import COLUMNS  # noqa: E402


def row(student, exercise, result, message="", hold="", properties=""):
    return dict.fromkeys(COLUMNS, "") | {"student": student, "exercise": exercise, "title": f"Title of {exercise}", "result": result,
                                         "message": message, "properties_hold": hold, "properties": properties}


ADA = "Ada & Eve <b>_4711_assignsubmission_file_"
ROWS = [row(ADA, "1.1", "right", hold=7, properties=7), row(ADA, "1.2", "wrong", "does not hold: push\nexpected 1, got \x00\x1b[31m2 & <3", 3, 4),
        row("O'Brien", "1.1", "missing"), row("O'Brien", "1.2", "crashed", "The program crashed.")]


class Gradescope(unittest.TestCase):
    """gradescope-autograders.readthedocs.io/en/latest/specs: which keys there are, and what they hold."""
    TOP = {"score": float, "execution_time": float, "output": str, "output_format": str, "test_output_format": str, "test_name_format": str,
           "visibility": str, "stdout_visibility": str, "extra_data": dict, "tests": list, "leaderboard": list}
    TEST = {"score": (int, float), "max_score": (int, float), "status": str, "name": str, "name_format": str, "number": str, "output": str,
            "output_format": str, "tags": list, "visibility": str, "extra_data": dict}
    VISIBLE = {"hidden", "after_due_date", "after_published", "visible"}
    FORMATS = {"text", "html", "simple_format", "md", "ansi"}

    def test_the_file_is_as_specified(self):
        told = json.loads(exports.gradescope(ROWS[:2]))
        for key, value in told.items():
            self.assertIsInstance(value, self.TOP[key])
        self.assertIn(told["stdout_visibility"], self.VISIBLE)
        for test in told["tests"]:
            for key, value in test.items():
                self.assertIsInstance(value, self.TEST[key])
            self.assertLessEqual({"score", "max_score"}, set(test))  # needed, since there is no score for all
            self.assertIn(test["status"], {"passed", "failed"})
            self.assertIn(test["visibility"], self.VISIBLE)
            self.assertIn(test["output_format"], self.FORMATS)

    def test_a_right_exercise_is_a_point(self):
        tests = json.loads(exports.gradescope(ROWS[:2]))["tests"]
        self.assertEqual([(test["score"], test["max_score"], test["status"]) for test in tests], [(1, 1, "passed"), (0, 1, "failed")])
        self.assertTrue(tests[1]["output"].startswith("wrong: 3 of 4 properties hold\ndoes not hold: push"))


class JUnit(unittest.TestCase):
    """junit-10.xsd of Jenkins' xUnit plugin: of each element the attributes it needs, those it may have, and its children."""
    SCHEMA = {"testsuites": (set(), {"name", "time", "tests", "failures", "errors"}, {"testsuite"}),
              "testsuite": ({"name", "tests", "failures", "errors"}, {"group", "time", "skipped", "timestamp", "hostname", "id", "package", "file", "log",
                            "url"}, {"testsuite", "properties", "testcase", "system-out", "system-err"}),
              "testcase": ({"name"}, {"time", "classname", "group"}, {"skipped", "error", "failure", "system-out", "system-err"}),
              "failure": (set(), {"type", "message"}, set()), "skipped": (set(), {"type", "message"}, set())}

    def test_the_file_is_as_specified(self):
        root = ElementTree.fromstring(exports.junit(ROWS))
        self.assertEqual(root.tag, "testsuites")
        for element in root.iter():
            needed, allowed, children = self.SCHEMA[element.tag]
            self.assertLessEqual(needed, set(element.attrib))
            self.assertLessEqual(set(element.attrib), needed | allowed)
            self.assertLessEqual({child.tag for child in element}, children)

    def test_the_counts_are_those_of_the_cases(self):
        suites = ElementTree.fromstring(exports.junit(ROWS)).findall("testsuite")
        self.assertEqual([suite.get("name") for suite in suites], [ADA, "O'Brien"])
        for suite in suites:
            self.assertEqual([int(suite.get(key)) for key in ("tests", "failures", "skipped")],
                             [len(suite.findall(path)) for path in ("testcase", "testcase/failure", "testcase/skipped")])
        self.assertEqual([suite.get("failures") for suite in suites], ["1", "1"])

    def test_what_xml_cannot_hold_is_left_out(self):
        failure = ElementTree.fromstring(exports.junit(ROWS)).find(".//failure")
        self.assertEqual(failure.text, "does not hold: push\nexpected 1, got ??[31m2 & <3")


class Moodle(unittest.TestCase):
    """mod/assign/feedback/offline/importgradeslib.php: the three columns without which it refuses, and how it cuts the number out."""

    def test_the_file_is_as_the_importer_wants_it(self):
        text, _ = exports.moodle(ROWS)
        header, line = csv.reader(io.StringIO(text, newline=""))
        self.assertLessEqual({"Identifier", "Grade", "Last modified (grade)"}, set(header))
        found = dict(zip(header, line))
        self.assertEqual(found["Identifier"][len("Participant "):], "4711")
        self.assertEqual((found["Full name"], float(found["Grade"])), ("Ada & Eve <b>", 50))
        self.assertEqual(found["Feedback comments"], "1.1 right: 7 of 7 properties hold; 1.2 wrong: 3 of 4 properties hold")

    def test_who_has_no_number_is_told(self):
        self.assertEqual(exports.moodle(ROWS)[1], ["O'Brien"])


class GitHub(unittest.TestCase):
    def test_no_name_breaks_the_table(self):
        lines = exports.summary([row("a|b\n<img>", "1.1", "right")]).splitlines()
        self.assertEqual(lines[2], "| a&#124;b&#10;&#60;img&#62; | 1.1 Title of 1.1 | right |")
        self.assertEqual(lines[-1], "1 of 1 right.")


if __name__ == "__main__":
    unittest.main()
