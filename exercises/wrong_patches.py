"""Wrong versions that are still patches: tests/wrong/NAME.patch. A line says what is wrong, a second one names the test that notices
("fails: ..."), and a unified diff of one source file follows."""
import re
from pathlib import Path

from catalogue import CatalogueError, shown

FAILS = "fails: "


def read_all(folder, make):
    return [read(patch, make) for patch in sorted(folder.glob("*.patch"))]


def read(patch, make):
    """One wrong version.
    @param make  WrongVersion
    @throws CatalogueError naming the file and what it lacks"""
    text = patch.read_text(encoding="utf-8")
    lines = text.splitlines()
    if len(lines) < 2 or not lines[0].endswith(".") or not lines[1].startswith(FAILS):
        raise CatalogueError(f"{shown(patch)}: begins with a sentence that says what is wrong, and '{FAILS}' with a test's name")
    files = re.findall(r"^\+\+\+ b/(\S+)", text, re.M)
    if len(files) != 1:
        raise CatalogueError(f"{shown(patch)}: changes {len(files)} files, and should change one")
    hunks = re.split(r"^@@.*@@.*\n", text, flags=re.M)[1:]
    return make(patch, patch.stem, lines[0], lines[1].removeprefix(FAILS).strip(), Path(files[0]), [_sides(hunk) for hunk in hunks])


def _sides(hunk):
    """Before and after, with two lines around the change: others may have changed."""
    lines = [line for line in hunk.split("\n") if line[:1] in (" ", "-", "+")]
    changed = [i for i, line in enumerate(lines) if line[0] != " "]
    lines = lines[max(0, changed[0] - 2):changed[-1] + 3]
    return tuple("\n".join(line[1:] for line in lines if line[0] in signs).strip("\n") for signs in (" -", " +"))


def write_fails(version, noticed):
    lines = version.home.read_text(encoding="utf-8").split("\n")
    lines[1] = FAILS + noticed
    version.home.write_text("\n".join(lines), encoding="utf-8")
