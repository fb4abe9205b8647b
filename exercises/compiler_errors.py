"""What a compiler says to a student's file, made readable."""
import re
from pathlib import Path

from catalogue import shown

MOST = 3
MESSAGE = r"^([^\s:][^:\n]*):(\d+):(\d+): +(?:fatal )?(error|required from)(?:: )?(.*)$"


def readable(output, compiled, source=None):
    """The first errors of the compiler, each at its line of the student's file, without the headers' tale.
    @param output    all that the compiler wrote
    @param compiled  the file that it read
    @param source    the student's file, where that one is a copy of it"""
    source = Path(source or compiled)
    lines, told, cause = source.read_bytes().decode("utf-8", errors="replace").split("\n"), [], None
    for file, line, column, kind, message in re.findall(MESSAGE, output, re.M):
        if kind == "required from":
            cause = (int(line), int(column)) if file == str(compiled) else cause  # what led into a header
        elif kind:
            place = (int(line), int(column)) if file == str(compiled) else cause
            message = re.sub(r"\s*\[with .*\]|\s*\[-W\S+\]", "", message)
            told.append(told_error(message, source, lines, place) if place else f"{shown(Path(file))}:{line}: {message}")
            cause = None
    if not told:
        return output[-3000:].replace(str(compiled), shown(source))
    if len(told) > MOST:
        told[MOST:] = [f"... and {len(told) - MOST} more, which often go away with the first."]
    return "\n".join(told)


def told_error(message, source, lines, place):
    """file:line: message, the line, and a mark below it. A #line in the file may name a line that it does not have."""
    line, column = place
    words = lines[line - 1].rstrip("\r") if 1 <= line <= len(lines) else ""
    return f"{shown(source)}:{line}: {message}\n    {words}\n    {' ' * min(column - 1, len(words))}^"
