#!/usr/bin/env python3
"""The project's address, docs/address.toml, where readers meet it: README.md, docs/your_machine.md and CITATION.cff.

    docs/tools/address.py           writes it there: between <!-- address --> and <!-- /address -->, and into CITATION.cff
    docs/tools/address.py --check   says where another one stands
"""
import argparse
import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"<!-- address: (\w+) -->\n.*?<!-- /address -->", re.S)
PAGES = {"book": "", "laboratory": "lab.html", "exercises": "exercises_01.html"}


class AddressError(Exception):
    """docs/address.toml does not hold an address."""


def address(root=ROOT):
    """{"repository": ..., "book": ...}, each without a slash at its end, or empty.
    @throws AddressError"""
    place = root / "docs/address.toml"
    try:
        told = tomllib.loads(place.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise AddressError(f"{place}: {error}") from None
    if set(told) != {"repository", "book"}:
        raise AddressError(f"{place}: holds 'repository' and 'book'")
    for key, value in told.items():
        if not isinstance(value, str) or value and not re.fullmatch(r"https://[\w.-]+(/[\w.~-]+)*", value):
            raise AddressError(f"{place}: {key} is no address without a slash at its end: {value!r}")
    return told


def first_screen(where):
    """README.md's line of what can be read and tried at once."""
    if not where["book"]:
        return "**The book, the laboratory and exercises in the page:** `./course docs --live` makes them, in `build/book/index.html`."
    links = [f"**[{'Exercises in the page' if name == 'exercises' else f'The {name}'}]({where['book']}/{page})**" for name, page in PAGES.items()]
    return " · ".join([*links, *([f"[the book here on GitHub]({where['repository']}/tree/book)"] if where["repository"] else [])])


def clone_line(where):
    """What brings the course onto a machine."""
    return f"```\ngit clone {where['repository'] or 'ADDRESS'} enduring-contacts\ncd enduring-contacts\n```"


BLOCKS = {"first_screen": first_screen, "clone": clone_line}


def written(text, where):
    """A page's text with the address in its blocks."""
    return BLOCK.sub(lambda found: f"<!-- address: {found[1]} -->\n{BLOCKS[found[1]](where)}\n<!-- /address -->", text)


def cited(text, where):
    """CITATION.cff with the address, or without where there is none."""
    text = re.sub(r"^(repository-code|url): .*\n", "", text, flags=re.M)
    lines = "".join(f'{key}: "{where[name]}"\n' for key, name in (("repository-code", "repository"), ("url", "book")) if where[name])
    return text.replace("license: ", f"{lines}license: ", 1)


def renewed(root=ROOT):
    """{file: its text with the address} of those with another one.
    @throws AddressError"""
    where = address(root)
    wanted = {}
    for name, renew in (("README.md", written), ("docs/your_machine.md", written), ("CITATION.cff", cited)):
        path = root / name
        old = path.read_text(encoding="utf-8")
        if (new := renew(old, where)) != old:
            wanted[path] = new
    return wanted


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; 1 where another address stands")
    options = parser.parse_args()
    try:
        wanted = renewed()
    except AddressError as error:
        print(error, file=sys.stderr)
        return 2
    for path, text in wanted.items():
        print(f"{path.relative_to(ROOT)}: " + ("another address than in docs/address.toml: python3 docs/tools/address.py" if options.check else "written"))
        if not options.check:
            path.write_text(text, encoding="utf-8")
    return 1 if wanted and options.check else 0


if __name__ == "__main__":
    sys.exit(main())
