#!/usr/bin/env python3
"""Makes a release of what is committed: dates CHANGELOG.md, writes version, date and address into CITATION.cff and the pages, commits and tags.

    docs/tools/release.py 0.2            nothing is pushed; the last line says how
    docs/tools/release.py 0.2 --check    only says what is in the way
"""
import argparse
import datetime
import re
import subprocess
import sys
from pathlib import Path

import address

ROOT = Path(__file__).resolve().parents[2]
UNRELEASED = "## [Unreleased]\n"


def git(*words):
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"git {' '.join(words)}: {done.stderr.strip()}")
    return done.stdout


def version_of(text):
    found = re.search(r'^version: "([\d.]+)"$', text, re.M)
    return found[1] if found else "0"


def as_numbers(version):
    return tuple(map(int, version.split(".")))


def in_the_way(version):
    """What keeps a release from being made."""
    if not re.fullmatch(r"\d+\.\d+(\.\d+)?", version):
        yield f"{version} is no version, as 0.2 is"
        return
    try:
        where = address.address(ROOT)
        yield from (f"docs/address.toml: no {key}: where will the release be found?" for key, value in where.items() if not value)
    except address.AddressError as error:
        yield str(error)
    before = version_of((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    if as_numbers(version) <= as_numbers(before):
        yield f"CITATION.cff: {version} does not come after {before}"
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").partition(UNRELEASED)[2].partition("\n## ")[0]
    if not re.search(r"^- ", changes, re.M):
        yield "CHANGELOG.md: nothing stands below [Unreleased]"
    if git("status", "--porcelain").strip():
        yield "the tree has changes that are not committed"
    if git("tag", "--list", f"v{version}").strip():
        yield f"there is a tag v{version} already"


def write(version, date):
    """The files of the release."""
    log = ROOT / "CHANGELOG.md"
    log.write_text(log.read_text(encoding="utf-8").replace(UNRELEASED, f"{UNRELEASED}\n## [{version}] - {date}\n", 1), encoding="utf-8")
    citation = ROOT / "CITATION.cff"
    text = re.sub(r"^date-released: .*\n", "", citation.read_text(encoding="utf-8"), flags=re.M)
    citation.write_text(re.sub(r"^version: .*$", f'version: "{version}"\ndate-released: "{date}"', text, count=1, flags=re.M), encoding="utf-8")
    for path, told in address.renewed(ROOT).items():
        path.write_text(told, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("version", help="as in 0.2")
    parser.add_argument("--check", action="store_true", help="only say what is in the way")
    options = parser.parse_args()
    if faults := list(in_the_way(options.version)):
        print("\n".join(f"No release: {fault}" for fault in faults), file=sys.stderr)
        return 1
    if options.check:
        print(f"Nothing is in the way of {options.version}.")
        return 0
    write(options.version, datetime.date.today().isoformat())
    git("commit", "--all", "--message", f"Release {options.version}")
    git("tag", "--annotate", f"v{options.version}", "--message", f"Release {options.version}")
    print(f"Committed, and tagged v{options.version}. Its book and its packages are made when you push:\n   git push --follow-tags")
    return 0


if __name__ == "__main__":
    sys.exit(main())
