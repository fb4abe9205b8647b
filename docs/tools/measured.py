"""Measured numbers in a page: `42<!--damping.kept_percent-->`.

A reader of the repository sees the 42, what the last full run measured. A book of a full run takes the number of its own run, whatever stands
there; a book of a quick run, whose experiments are small, shows the 42.
Of a few words the first is marked: `<!---->48 soft elements<!--bar.elements-->`.
"""
import math
import os
import re

from compare_results import CLOCK

NUMBER = re.compile(r"(?:<!---->(?P<words>[^<]+)|(?P<word>[^\s(|<]+))<!--(?P<name>(?:\w+/)?\w+\.\w+)-->")
CODE = re.compile(r"(`[^`]*`)")
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
TOLD, REFUSED = 1.1, 10.0  # how many times one number is the other
ROUNDING = 1e-9            # numbers below it are rounding errors, which are another machine's own


def woven(text, fact, as_written=False):
    """The text with the numbers of this run, or as_written with those that stand in it, without their marks.
    @param fact  gives the text of a fact by its name, and throws where no run left it"""
    def shown(match):
        measured = fact(match["name"])
        return (match["words"] or match["word"]) if as_written else measured
    return NUMBER.sub(shown, text)


def number(text):
    """Of 42, -0.5, 2.4·10⁻⁸ and "48 elements"; nan of words."""
    match = re.match(r"([+-]?\d+(?:\.\d+)?)(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?(?!\S)", text)
    return float(match[1]) * 10.0 ** int((match[2] or "0").translate(RAISED)) if match else math.nan


def times(written, measured):
    """How many times one is the other: 1 where they agree, infinite between words and where only one is positive."""
    a, b = number(written), number(measured)
    if written == measured or max(abs(a), abs(b)) < ROUNDING:
        return 1.0
    return max(a / b, b / a) if a * b > 0 else math.inf


def compare(lines, fact, quick):
    """What the written numbers of a page are, against the run's: notes, and what stops the book. A quick run has other numbers, a clock
    measures others each time; so there only words in the place of a number are wrong. Elsewhere, too, the book itself has the right
    number, so it stops only the builds of CI, as a warning does.
    @param lines  (line, text)"""
    notes, mistakes = [], []
    for line, text in lines:
        for match in NUMBER.finditer("".join(CODE.split(text)[::2])):
            written, name = match["words"] or match["word"], match["name"]
            measured = fact(name)
            told = line, f"{name} is {measured}; the page says {written} (./course docs --renew)"
            if math.isnan(number(written)) and not math.isnan(number(measured)):
                mistakes.append((line, f"no number stands before <!--{name}-->, but {written}"))
            elif not quick and not CLOCK.search(name) and (factor := times(written, measured)) > TOLD:
                (mistakes if factor > REFUSED and os.environ.get("CI") == "true" else notes).append(told)
    return notes, mistakes


def renewed(text, fact):
    """A page's source with the numbers of this run written into it, code left as it is."""
    def written(match):
        measured = fact(match["name"])
        return f"{'<!---->' if ' ' in measured else ''}{measured}<!--{match['name']}-->"
    parts = re.split(r"(^ *```.*?^ *```|`[^`\n]*`)", text, flags=re.S | re.M)
    parts[::2] = [NUMBER.sub(written, part) for part in parts[::2]]
    return "".join(parts)
