"""What a class has handed in, as schools' systems give it: folders, nested ones, zip files, and single files with the student's name before them."""
import os
import re
import stat
import sys
import zipfile
from pathlib import Path, PurePosixPath

from honest import LONGEST

NO_ANSWERS = re.compile(r"\.|__MACOSX$|build($|-)")         # folders in which nobody hands in
MOST_FILES = 10000
BEHIND = r"(?:[-_ ]?\(?\d+\)?)?\.cpp$"                      # what a system adds when a file comes a second time


def collect(folder, exercises, scratch, one=False):
    """The attempts of every student.

    @param folder   holds one entry for each student: a folder, a zip file, or files NAME_2_title.cpp; it may be a zip file itself
    @param scratch  an empty folder; zip files are unpacked there
    @param one      the folder is the work of one student, not of a class
    @return {student: {exercise's number: file}}, in order of the names"""
    if zipfile.is_zipfile(folder):
        folder = unpacked(folder, scratch / "class", folder.stem)
    if one:
        return {folder.resolve().name: attempts(folder, exercises, scratch / "one")}
    found = {}
    for entry in entries(folder):
        if entry.is_dir():
            found.setdefault(entry.name, {}).update(attempts(entry, exercises, scratch / f"in {entry.name}"))
        elif zipfile.is_zipfile(entry):
            found.setdefault(entry.stem, {}).update(attempts(unpacked(entry, scratch / f"of {entry.stem}", entry.stem), exercises, scratch))
        else:
            for exercise in exercises:
                if named := re.match(r"(.+?)[-_ ]+" + re.escape(exercise.name) + BEHIND, entry.name):
                    found.setdefault(named[1], {})[exercise.number] = entry
    return dict(sorted(found.items()))


def entries(folder):
    """What lies in a folder, without what is hidden and without links: they would lead out of it."""
    return sorted(path for path in folder.iterdir() if not NO_ANSWERS.match(path.name) and not path.is_symlink())


def attempts(folder, exercises, scratch):
    """{exercise's number: file} of one student. Of several files the one that was begun, then the one in answers/, then the uppermost."""
    files = list(files_below(folder))
    for archive in [file for file in files if file.suffix.lower() == ".zip" and zipfile.is_zipfile(file)]:
        files += files_below(unpacked(archive, scratch / archive.stem, archive.name))
    found = {}
    for exercise in exercises:
        mine = [file for file in files if re.fullmatch(r"(?:.*[^0-9])?" + re.escape(exercise.name) + BEHIND, file.name)]
        if mine:
            found[exercise.number] = min(mine, key=lambda file: (
                is_untouched(exercise, file), "answers" not in file.parts, exercise.chapter not in file.parts, len(file.parts), str(file)))
    return found


def is_untouched(exercise, file):
    return file.stat().st_size <= LONGEST and exercise.untouched(file)


def files_below(folder):
    """All files of a student, without links, builds, and the course's own solutions in a clone."""
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not NO_ANSWERS.match(name) and not is_ours(Path(place, name)))
        yield from (path for path in (Path(place, name) for name in sorted(names)) if path.is_file() and not path.is_symlink())


def is_ours(folder):
    """Whether this is the folder of solutions of a clone, or its chapters."""
    return folder.name in ("solutions", "chapters") and (folder.parent / "course").is_file()


def unpacked(archive, folder, name):
    """The C++ files and zip files of an archive, in a folder: no links, none too long, and none outside it."""
    folder.mkdir(parents=True, exist_ok=True)
    try:
        with zipfile.ZipFile(archive) as held:
            for info in held.infolist()[:MOST_FILES]:
                parts = [part for part in PurePosixPath(info.filename.replace("\\", "/")).parts if part not in ("/", "..")]
                if info.is_dir() or stat.S_ISLNK(info.external_attr >> 16) or not parts or not parts[-1].lower().endswith((".cpp", ".zip")):
                    continue
                target = folder.joinpath(*parts)
                target.parent.mkdir(parents=True, exist_ok=True)
                with held.open(info) as source:
                    target.write_bytes(source.read(20 * LONGEST if parts[-1].lower().endswith(".zip") else LONGEST + 1))
    except (zipfile.BadZipFile, RuntimeError, NotImplementedError, OSError, EOFError) as error:  # a password, a damaged file, a strange name
        print(f"course: {name}: cannot be unpacked: {error}", file=sys.stderr)
    inside = entries(folder)
    return inside[0] if len(inside) == 1 and inside[0].is_dir() else folder
