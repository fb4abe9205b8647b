"""A table of grades in the formats that schools' systems read. An exercise counts one point, when it is right."""
import csv
import io
import json
import re
import xml.etree.ElementTree as ElementTree

NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
PARTICIPANT = re.compile(r"(.+)_(\d+)_assignsubmission_(?:file|onlinetext)_?$")  # how Moodle names a student's folder
MOODLE = ["Identifier", "Full name", "Grade", "Maximum Grade", "Last modified (grade)", "Feedback comments"]
NOT_BEGUN = ("missing", "not started")


def points(row):
    return int(row["result"] == "right")


def by_student(rows):
    """{student: rows}"""
    found = {}
    for row in rows:
        found.setdefault(row["student"], []).append(row)
    return found


def gradescope(rows):
    """One student's results.json.
    @see https://gradescope-autograders.readthedocs.io/en/latest/specs/"""
    tests = [{"number": row["exercise"], "name": row["title"], "score": points(row), "max_score": 1,
              "status": "passed" if points(row) else "failed", "output": f"{row['result']}{properties(row)}\n{row['message']}".strip(),
              "output_format": "text", "visibility": "visible"} for row in rows]
    return json.dumps({"stdout_visibility": "hidden", "tests": tests}, indent=1) + "\n"


def properties(row):
    return f": {row['properties_hold']} of {row['properties']} properties hold" if row["properties"] else ""


def junit(rows):
    """A suite for each student, a case for each exercise, as Jenkins, GitLab and GitHub's actions read it.
    @see junit-10.xsd of Jenkins' xUnit plugin"""
    root = ElementTree.Element("testsuites", name="Enduring Contacts")
    for student, own in by_student(rows).items():
        skipped, right = (sum(1 for row in own if row["result"] in kinds) for kinds in (NOT_BEGUN, ("right",)))
        suite = ElementTree.SubElement(root, "testsuite", name=valid(student), tests=str(len(own)), failures=str(len(own) - right - skipped),
                                       errors="0", skipped=str(skipped))
        for row in own:
            case = ElementTree.SubElement(suite, "testcase", classname=f"exercise {row['exercise']}", name=valid(row["title"]))
            if row["result"] != "right":
                kind = "skipped" if row["result"] in NOT_BEGUN else "failure"
                ElementTree.SubElement(case, kind, message=row["result"] + properties(row)).text = valid(row["message"])
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def valid(text):
    """Without the characters that XML cannot hold."""
    return NOT_XML.sub("?", text)


def moodle(rows):
    """Moodle's offline grading worksheet, of 100 points; for whom Moodle's download says the number (NAME_NUMBER_assignsubmission_file_).
    @see mod/assign/feedback/offline/importgradeslib.php
    @return (text, the students without a number)"""
    held, without = io.StringIO(), []
    table = csv.DictWriter(held, MOODLE, lineterminator="\r\n")
    table.writeheader()
    for student, own in by_student(rows).items():
        if not (named := PARTICIPANT.match(student)):
            without.append(student)
            continue
        comment = "; ".join(f"{row['exercise']} {row['result']}{properties(row)}" for row in own)
        table.writerow({"Identifier": f"Participant {named[2]}", "Full name": named[1], "Grade": f"{100 * sum(map(points, own)) / len(own):.2f}",
                        "Maximum Grade": "100", "Last modified (grade)": "-", "Feedback comments": comment})
    return held.getvalue(), without


def summary(rows):
    """A table in Markdown, for the page of a GitHub workflow's run."""
    lines = ["| Student | Exercise | Result |", "|:--|:--|:--|"]
    lines += [f"| {escaped(row['student'])} | {row['exercise']} {escaped(row['title'])} | {row['result']}{properties(row)} |" for row in rows]
    return "\n".join([*lines, "", f"{sum(map(points, rows))} of {len(rows)} right.", ""])


def escaped(text):
    return re.sub(r"([|\\`<>*_\[\]\n])", lambda found: f"&#{ord(found[1])};", text)
