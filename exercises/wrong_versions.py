"""Wrong versions of the layers as they are written down: one file a layer, chapters/NN_name/tests/wrong.toml and common/.../NAME/tests/wrong.toml.

    [normal_flipped]
    says = "The impulse pulls p into B."
    fails = "penalty impulses: they push p out of B"     # the test that notices
    file = "chapters/03_penalty_impulses/impulses.cpp"
    find = "return -k * depth * n;"
    replace = "return k * depth * n;"

`find` stands once in the file. Lines may have moved since, and been broken elsewhere: space of any kind matches space of any kind. A
mistake that needs a second place has [[normal_flipped.also]] with a `find` and a `replace` of its own.
"""
import json
import re
import threading
import tomllib
from dataclasses import dataclass
from pathlib import Path

from catalogue import ROOT, CatalogueError, shown
from honest import DoesNotCompile

WRITING = threading.Lock()  # versions of one file are proved side by side
TEXTS = ("says", "fails", "file", "find", "replace")


@dataclass
class WrongVersion:
    """A mistake in one file of a layer."""
    home: Path      # where it is written down
    title: str
    says: str       # what is wrong
    fails: str      # the test that is expected to notice
    source: Path    # the file, as seen from the top
    changes: list   # (text to find, text in its place)

    @property
    def layer(self):
        """The layer's folder, as in "03_penalty_impulses" or "fem"."""
        return self.home.parents[1].name

    @property
    def number(self):
        """The chapter's number; 0 for the base."""
        return int(self.layer[:2]) if self.layer[:2].isdigit() else 0

    @property
    def name(self):
        return f"{self.layer}/{self.title}"

    @property
    def targets(self):
        """The layer's tests and the libraries that they are of, as CMake calls them, and that of the file, which may stand in a layer
        below; a chapter has one for its experiments."""
        chapter = f"chapter{self.layer[:2]}"
        own = (f"test_{chapter}", f"{chapter}_layer", f"{chapter}_experiments") if self.number else \
            (f"test_{self.layer}", f"enduring_{self.layer}")
        folder = self.source.parent.name
        return (*own, f"chapter{folder[:2]}_layer" if folder[:2].isdigit() else f"enduring_{folder}")

    def applied(self, text):
        """The file's text with the mistake in it.
        @throws DoesNotCompile  a text to find does not stand in it once"""
        for find, replace in self.changes:
            pattern = r"\s+".join(map(re.escape, find.split()))
            text, count = re.subn(pattern, lambda _, by=replace: by, text)
            if count != 1:
                raise DoesNotCompile(f"does not apply any more: its text stands {count} times in {self.source}, not once: {find.strip().splitlines()[0]}")
        return text


def read(home):
    """The wrong versions of one wrong.toml.
    @throws CatalogueError naming the file, the version and what it lacks"""
    try:
        entries = tomllib.loads(home.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise CatalogueError(f"{shown(home)}: {error}") from None
    return [_version(home, title, entry) for title, entry in entries.items()]


def _version(home, title, entry):
    def refuse(what):
        raise CatalogueError(f"{shown(home)}: [{title}] {what}")
    if not isinstance(entry, dict):
        refuse("is no table of a wrong version")
    if unknown := sorted(set(entry) - {*TEXTS, "also"}):
        refuse(f"has an unknown key: {unknown[0]}")
    for key in TEXTS:
        if not isinstance(entry.get(key), str) or key != "replace" and not entry[key].strip():
            refuse(f"lacks the text '{key}'")
    if not entry["says"].endswith("."):
        refuse("says what is wrong in a sentence, which ends with a full stop")
    places = [entry, *entry.get("also", [])]
    if any(not isinstance(place.get(key), str) for place in places for key in ("find", "replace")) or not all(place["find"].strip() for place in places):
        refuse("has a second place without 'find' or 'replace'")
    return WrongVersion(home, title, entry["says"], entry["fails"], Path(entry["file"]), [(place["find"], place["replace"]) for place in places])


def all_versions(root=ROOT):
    """Every wrong version, the chapters' first."""
    return [version for tree in ("chapters", "common")
            for home in sorted((root / tree).rglob("tests/wrong.toml")) for version in read(home)]


def write_fails(version, noticed):
    """Writes the name of another test into the version's home."""
    with WRITING:
        head, found, rest = version.home.read_text(encoding="utf-8").partition(f"[{version.title}]\n")
        rest = re.sub(r"^fails = .*$", lambda _: f"fails = {json.dumps(noticed, ensure_ascii=False)}", rest, count=1, flags=re.M)
        version.home.write_text(head + found + rest, encoding="utf-8")
