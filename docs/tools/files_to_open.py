"""How many files a reader opens for one step of a chapter: the headers that a layer includes, directly or not, and of each the
.cpp beside it. Headers of libraries are not counted.

    docs/tools/files_to_open.py           the table
    docs/tools/files_to_open.py --list    and every file, with its lines and who includes it
"""
import argparse
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
READERS = {  # what a reader wants, and where he enters
    "chapter 1: one step of a rigid cube on a plane": ["chapters/01_particle_plane/solver.hpp", "common/simulation/rigid_body.hpp"],
} | {  # and of every chapter the layer alone, with those below it, without bodies
    f"chapter {int(solver.parent.name[:2])}: the layer, without bodies": [str(solver.relative_to(ROOT))]
    for solver in sorted(ROOT.glob("chapters/[0-9][0-9]_*/solver.hpp"))
}


def names_of(chapter, root=ROOT):
    """A layer's own files, and the headers of others that they name."""
    own = [file for file in (root / chapter).glob("*.[ch]pp") if file.name != "main.cpp"]
    named = {name for file in own for name in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.M)}
    return own, {name for name in named if not name.startswith(f"{chapter}/")}


def included(file, root=ROOT):
    """The project's own files that a file includes."""
    for name in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.M):
        found = next((path for path in (file.parent / name, root / name) if path.is_file()), None)
        if found:
            yield found.resolve()


def files_to_open(entries, root=ROOT):
    """The entries, all that they include, and the source of each header: file -> who asked for it."""
    asked_by, todo = {}, [((root / entry).resolve(), None) for entry in entries]
    while todo:
        file, by = todo.pop()
        asked_by.setdefault(file, set()).add(by)
        if len(asked_by[file]) == 1:
            source = file.with_suffix(".cpp")
            if file.suffix == ".hpp" and source.is_file():
                todo.append((source, file))
            todo += [(other, file) for other in included(file, root)]
    return asked_by


def lines_of(files):
    return sum(len(file.read_text(encoding="utf-8").splitlines()) for file in files)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--list", action="store_true", help="names every file, with its lines and who includes it")
    listing = parser.parse_args().list
    print("| a reader wants | files | lines |\n|:---|---:|---:|")
    for reader, entries in READERS.items():
        found = files_to_open(entries)
        print(f"| {reader} | {len(found)} | {lines_of(found)} |")
        for file in sorted(found) if listing else []:
            by = sorted(other.name for other in found[file] if other and other.with_suffix("") != file.with_suffix(""))
            print(f"    {lines_of([file]):4} {file.relative_to(ROOT)}" + (f"  < {', '.join(by)}" if by else ""))
    print("\n| a layer alone | its own files | lines | headers of others that it names |\n|:---|---:|---:|---:|")
    for chapter in sorted(solver.parent for solver in ROOT.glob("chapters/[0-9][0-9]_*/solver.hpp")):
        own, foreign = names_of(str(chapter.relative_to(ROOT)))
        print(f"| {chapter.name} | {len(own)} | {lines_of(own)} | {len(foreign)} |")


if __name__ == "__main__":
    main()
