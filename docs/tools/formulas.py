"""Formulas, as a page writes them and as Doxygen reads them.

A page writes `$x$` in a line and `$$x$$` on its own, which GitHub and most editors show as formulas, too. They read the text as Markdown
first: it takes the backslash from `\\,` and `\\\\`, and an underscore after a bracket for emphasis. A formula with such signs is fenced,
as code is: $`x\\,y`$ in a line, and between ```math and ``` on its own. Of the formulas that need this, none is left without it.
"""
import re

MATH = re.compile(r"\$`(?P<fenced>[^`\n]+)`\$|(?P<code>(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`))"
                  r"|\$\$(?P<alone>(?:[^$\n]|\n(?!\s*\n))+)\$\$|\$(?P<bare>[^$`\n]+)\$")
EATEN = re.compile(r"\\[^A-Za-z0-9\s]|(?<![A-Za-z0-9'])_|\*|<[A-Za-z/!]|\]\(")
BOLD = re.compile(r"(?P<code>(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`))|\*\*(?=\S)(?P<bold>(?:(?!\*\*|\n\s*\n).)+?)(?<=\S)\*\*", re.S)
FENCE = re.compile(r"\s*(```+|~~~+)\s*(\w*)")


def for_doxygen(text):
    """A page's text with its formulas as Doxygen reads them, line by line; code is left as it is."""
    return "\n".join(_fenced(kind, part) if kind is not None else BOLD.sub(_bold, MATH.sub(_of_doxygen, part)) for kind, part in _parts(text))


def _bold(match):
    """Doxygen leaves the stars of bold words with a formula or a command among them."""
    return f"<b>{match['bold']}</b>" if match["bold"] and re.search(r"\\f\$|\\ref|@\w+\{", match["bold"]) else match[0]


def _parts(text):
    """The text in pieces of whole lines: (None, prose), ("cpp", a fenced piece with its fences)."""
    fence, kind, piece = None, None, []
    for line in text.split("\n"):
        match = FENCE.match(line)
        if fence is None and match:
            if piece:
                yield None, "\n".join(piece)
            fence, kind, piece = match[1], match[2], [line]
        elif fence is not None and match and match[1].startswith(fence) and not match[2]:
            yield kind, "\n".join([*piece, line])
            fence, piece = None, []
        else:
            piece.append(line)
    if piece:
        yield kind if fence else None, "\n".join(piece)


def _fenced(kind, part):
    """A fenced formula has as many lines as before, so that a mistake is told with its line."""
    if kind != "math":
        return part
    head, *lines, _ = part.split("\n")
    indent = head[:len(head) - len(head.lstrip())]
    return "\n".join([f"{indent}\\f[", *lines, f"{indent}\\f]"])


def _of_doxygen(match):
    if match["code"]:
        return match[0]
    if match["alone"]:
        return f"\\f[{match['alone']}\\f]"
    return f"\\f${match['bare'] or match['fenced']}\\f$"


def faults(text, first_line=1):
    """(line, what is wrong) of formulas that GitHub would show otherwise than the book, and of those that are not closed."""
    line = first_line
    for kind, part in _parts(text):
        if kind is None:
            yield from ((line + part.count("\n", 0, place), told) for place, told in _of_prose(part))
        line += part.count("\n") + 1


def _of_prose(part):
    for match in MATH.finditer(part):
        formula = match["bare"] or match["alone"]
        if formula and (found := EATEN.search(formula)):
            fenced = "$`...`$" if match["bare"] else "```math"
            yield match.start(), f"Markdown would read '{found[0]}' in the formula {formula.strip()[:40]}: write {fenced}"
        elif not match["code"] and re.match(r"\w", part[match.end():]):
            yield match.end(), f"a letter right behind a formula hides it from GitHub: {match[0][:40]}"
    rest = MATH.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), part)
    yield from ((match.start(), "a formula that is not closed") for match in re.finditer(r"\$", rest))
    yield from ((match.start(), "write formulas as $x$ and $$x$$") for match in re.finditer(r"\\f(?=[ \[\]])", rest))
