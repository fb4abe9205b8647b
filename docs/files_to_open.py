"""How many files a reader opens for one step of a chapter: the headers that a layer includes, directly or not, and of each the
.cpp beside it. Headers of libraries are not counted.

    docs/files_to_open.py           the table
    docs/files_to_open.py --list    and every file, with its lines and who includes it
"""
import argparse
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
READERS = {  # what a reader wants, and where he enters
    "chapter 1: one step of a rigid cube on a plane": ["chapters/01_particle_plane/solver.hpp", "common/simulation/rigid_body.hpp"],
    "chapter 3: the layer, without bodies": ["chapters/03_penalty_impulses/solver.hpp"],
    "chapter 6: the layer, without bodies": ["chapters/06_redefinition/solver.hpp"],
}


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


if __name__ == "__main__":
    main()
