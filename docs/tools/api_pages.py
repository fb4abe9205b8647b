"""The list of headers, by chapter and by folder of the base, each with its idea."""
from changes import first_sentence


def api_block(root, chapters):
    """Markdown of the whole list.
    @param chapters  the chapters' pages, in their order"""
    lines = []
    for page in chapters:
        lines += ["", f"## {page.title}", "", *headers(root, f"chapters/{page.folder}")]
    for folder in sorted({path.parent for path in (root / "common").rglob("*.hpp") if path.parent.name not in ("tests", "on")}):
        shown = folder.relative_to(root).as_posix()
        lines += ["", f"## The base: {shown.removeprefix('common/')}", "", *headers(root, shown)]
    return "\n".join(lines)


def headers(root, folder):
    for path in sorted((root / folder).glob("*.hpp")):
        shown = path.relative_to(root).as_posix()
        idea = first_sentence(path.read_text(encoding="utf-8"), path.stem)
        # Doxygen tells files of one name apart by their folders; a page that begins with a digit breaks its scripts, so it gets none.
        link = f"`{path.name}`" if path.name == "solver.hpp" else f"\\ref {shown} \"{path.name}\""
        yield f"- {link}: {idea}" if idea else f"- {link}"
