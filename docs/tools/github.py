#!/usr/bin/env python3
"""The book as GitHub shows it: the woven pages as Markdown, with pictures, tables, numbers and listings, for a branch `book`.

    docs/tools/github.py            build/github, from the pages that docs/tools/build.py has woven into build/docs

What Doxygen reads becomes what GitHub reads: \\ref a link, \\snippet the lines of the compiled file, \\f$ a formula between $` and `$. A link that
leads nowhere, or a command that nothing has turned into Markdown, is refused.
"""
import argparse
import html
import re
import shutil
import sys
import textwrap
from pathlib import Path

import address
import formulas

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build/docs"
HEADING = re.compile(r"^(#+) (.*?)\s*\{#(\w+)\}\s*$", re.M)
ANCHOR = re.compile(r"\\anchor (\w+)[ \n]?")
LEFT = re.compile(r"\\(?:ref|subpage|anchor|snippet|htmlonly|endhtmlonly|note|f[$\[\]])|<div|@\w+\{")
CODE = re.compile(r"(`+[^`\n](?:.*?[^`])?`+(?!`))")


class Markdown:
    """All pages, and where their labels and anchors are."""

    def __init__(self, pages, root=ROOT):
        self.root, self.texts = root, {}
        self.places, self.titles, self.faults = {}, {}, []
        for path in pages:
            text = path.read_text(encoding="utf-8")
            name = "README.md" if path.stem == "mainpage" else path.name
            self.texts[name] = text
            title, label = re.match(r"# (.*?) \{#(\w+)\}", text).groups()
            self.places[label] = self.places[path.stem] = name
            self.titles[label] = self.titles[path.stem] = title
            for _, heading, anchor in HEADING.findall(text)[1:]:
                self.places[anchor], self.titles[anchor] = f"{name}#{anchor}", re.sub(r"\\f\$(.*?)\\f\$", r"$`\1`$", heading)
            for anchor in ANCHOR.findall(text):
                self.places[anchor], self.titles[anchor] = f"{name}#{anchor}", anchor
        self.places["index"], self.titles["index"] = "README.md", "The start"

    def page(self, name):
        """One page for GitHub."""
        text = self.outside(self.texts[name])
        parts = [self.prose(part, name) if kind is None else part for kind, part in formulas._parts(text)]
        return re.sub(r"\n{3,}", "\n\n", "\n".join(parts)).strip() + "\n"

    def outside(self, text):
        """What spans lines: figures, listings, maps, formulas on their own."""
        text = re.sub(r"\\htmlonly\[block\]\n<nav .*?\\endhtmlonly", "", text, flags=re.S)
        text = re.sub(r"\\htmlonly\[block\]\n(<link .*?|<p class=\"live-note\">The laboratory.*?)\n\\endhtmlonly", "The laboratory runs in the book of the browser.", text, flags=re.S)
        text = re.sub(r'<div class="figure">\n\\anchor (\w+)\n\\htmlonly(?:\[block\]\n)?(.*?)\\endhtmlonly\n<div class="caption">(.*?)</div>\n</div>', self.figure, text, flags=re.S)
        text = re.sub(r'<div class="listing">(.*?)</div>\n+\\snippet (\S+) (.+)', self.listing, text)
        text = re.sub(r'<div class="listing">(.*?)</div>', r"`\1`:", text)
        text = re.sub(r"^( *)\\f\[\n(.*?)\n *\\f\]", r"\1```math\n\2\n\1```", text, flags=re.S | re.M)
        return re.sub(r"\\f\[(.*?)\\f\]", lambda found: f"\n```math\n{found[1].strip()}\n```\n", text, flags=re.S)

    def figure(self, found):
        anchor, shown, caption = found.groups()
        picture = re.search(r'<(?:img|video) src="([^"]+)"', shown)
        alt = html.unescape((re.search(r'(?:alt|aria-label)="([^"]*)"', shown) or [None, ""])[1]).replace("[", "(").replace("]", ")")
        image = f"[the film]({picture[1]})" if picture[1].endswith(".mp4") else f"![{alt}]({picture[1]})"
        return f'<a id="{anchor}"></a>\n\n{image}\n\n{caption}\n'

    def listing(self, found):
        shown, path, region = found.groups()
        lines = (self.root / path).read_text(encoding="utf-8").splitlines()
        first, last = [number for number, line in enumerate(lines) if f"[{region}]" in line]
        return f"`{shown}`:\n\n```cpp\n{textwrap.dedent(chr(10).join(lines[first + 1:last]))}\n```"

    @staticmethod
    def tick(found):
        """GitHub has no style for the name behind a tick, but shows a title to who points at it."""
        name = found[1].replace('"', "&quot;").replace("\\|", "|")
        return f'<span title="{name}">✓</span>'

    def prose(self, text, name):
        text = text.replace("[TOC]\n", "")
        text = re.sub(r"^# (.*?) \{#\w+\}\s*$", r"# \1", text, count=1, flags=re.M)
        text = HEADING.sub(r'<a id="\3"></a>\n\n\1 \2', text)
        text = re.sub(r"\\htmlonly(\[block\])?\n?|\\endhtmlonly", "", text)
        text = re.sub(r"^\\note (.*(?:\n(?!\n).*)*)", lambda found: "> " + found[1].replace("\n", "\n> "), text, flags=re.M)
        text = re.sub(r'<span class="quick".*?>(.*?)</span>', r"*(\1)*", text)
        text = re.sub(r'<span class="test" tabindex="0">✓<code class="test">(.*?)</code></span>', self.tick, text)
        text = re.sub(r'<div class="neighbours"><span>(.*?)</span> <span>(.*?)</span></div>', r"---\n\n\1 · \2", text)
        text = re.sub(r'<div class="(?:caption|exercise)">(.*?)</div>', r"\1\n", text)
        text = re.sub(r"</?div\b[^>]*>", "", text)
        text = re.sub(r"<b>(.*?)</b>", r"**\1**", text)
        parts = CODE.split(text)
        for i in range(0, len(parts), 2):
            parts[i] = self.inline(parts[i], name)
        return "".join(parts)

    def inline(self, text, name):
        text = re.sub(r'\\(?:ref|subpage) ([\w/.:()-]*\w)(?:\(\))?(?: "([^"]*)")?', lambda found: self.link(name, *found.groups()), text)
        text = ANCHOR.sub(r'<a id="\1"></a>', text)
        text = re.sub(r"\\f\$(.*?)\\f\$", r"$`\1`$", text, flags=re.S)
        self.faults += [f"{name}: left in the text: {text[found.start():found.start() + 60]!r}" for found in LEFT.finditer(text)]
        return text

    def link(self, name, label, words):
        if label not in self.places:
            if (self.root / label).is_file() or "::" in label:  # a header, or a name of the code
                return words if words and "`" in words else f"`{words or label.split('::')[-1]}`"
            self.faults.append(f"{name}: leads to {label}, which is not there")
            return words or label
        return f"[{words or self.titles[label]}]({self.places[label]})"


def front(where):
    """What stands above the first page."""
    hosted = f" The book of the browser, with figures that move and a search: {where['book']}." if where["book"] else ""
    return f"> This branch is made by `./course docs --github`: the pages with the pictures and numbers of the run.{hosted}\n\n"


def write(pages, figures, out, root=ROOT):
    """out/*.md and out/figures. @return what is wrong; then nothing is written"""
    book = Markdown(pages, root)
    texts = {name: book.page(name) for name in book.texts}
    texts["README.md"] = front(address.address(root)) + texts["README.md"]
    book.faults += [f"{name}: the picture {place} is missing" for name, text in texts.items() for place in re.findall(r"\]\((figures/[^)]+)\)", text)
                    if not (figures.parent / place).is_file()]
    if book.faults:
        return book.faults
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    shutil.copytree(figures, out / "figures")
    for name, text in texts.items():
        (out / name).write_text(text, encoding="utf-8")
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "build/github", help="where the pages go")
    options = parser.parse_args()
    pages = sorted((WORK / "pages").glob("*.md"))
    if not pages:
        sys.exit("There are no woven pages: ./course docs makes them")
    if faults := write(pages, WORK / "figures", options.out):
        sys.exit("\n".join(faults))
    print(f"{options.out}: {len(pages)} pages for GitHub")


if __name__ == "__main__":
    main()
