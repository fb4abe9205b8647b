"""What changed since the last chapter: the passes, from the solvers' lists, the files, from the folders, and the verdicts, from
the failure ledger, once that has run."""
import csv
import re

STAGES = {"refresh": "pairs that endure", "detect": "detection", "respond": "response", "finish": "before the commit",
          "after_commit": "after the commit"}


def changes_block(root, results, folder):
    """The block of one chapter, for its page.
    @param results  the folder of results of this build
    @throws FileNotFoundError  the solvers' passes were not listed (./course run solvers passes: a second)"""
    chapter = int(folder[:2])
    ledger = rows(results, "ledger") if (results / "solvers/ledger.csv").is_file() else []
    parts = [passes_table(rows(results, "passes"), chapter), files_list(root, folder), verdicts(ledger, chapter)]
    return "\n".join(["<div class=\"changes\">", "", *filter(None, parts), "", "</div>"])


def rows(results, name):
    with (results / f"solvers/{name}.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def passes_table(passes, chapter):
    """Each stage of the step with its passes; new ones bold, those that are gone struck through."""
    def of(number, stage):
        return [row["pass"] for row in passes if int(row["chapter"]) == number and row["stage"] == stage]

    lines = ["<div class=\"data\">", "", "| Stage of the step | Passes |", "|:--|:--|"]
    for stage, words in STAGES.items():
        now, before = of(chapter, stage), of(chapter - 1, stage)
        told = [name if name in before else f"**{name}**" for name in now] + [f"<s>{name}</s>" for name in before if name not in now]
        if told:
            lines.append(f"| {words} | {', '.join(told)} |")
    return "\n".join([*lines, "", "</div>"])


def files_list(root, folder):
    """The layer's headers, each with the first sentence of what it declares first."""
    headers = sorted((root / "chapters" / folder).glob("*.hpp"))
    items = [f"`{path.name}`: {idea}" for path in headers if (idea := first_sentence(path.read_text(encoding="utf-8"), path.stem))]
    return "\nThe layer's files:\n\n" + "\n".join(f"- {item}" for item in items) + "\n" if items else ""


def first_sentence(text, stem=""):
    """Of the documented declaration that the file is named after, else of the first that is no mere constant or other
    name, else of the first: up to its full stop, or to a colon with some words before it.
    @param stem  the file's name without its ending"""
    named = re.compile(rf"\b({stem}|{''.join(part.title() for part in stem.split('_'))})\b") if stem else None
    told = []
    for comment, declared in re.findall(r"^((?:///.*\n)+)(?!///)(.*)", text, re.M):
        paragraph = comment.split("\n///\n")[0]
        words = " ".join(line[4:] for line in paragraph.splitlines() if not line.startswith("/// @"))
        if sentence := re.match(r"(.+?)(?:([.?])(?=\s|$)|(?<=.{25}):(?=\s|$)|$)", words):
            rank = 0 if named and named.search(declared) else 2 if re.match(r"(inline )?constexpr|using ", declared) else 1
            told.append((rank, len(told), sentence[1] + (sentence[2] or ".")))
    return min(told)[2].replace("|", "\\|").replace("<", "&lt;") if told else ""


def verdicts(ledger, chapter):
    """The scenes on which this chapter's solver and the one before disagree."""
    lines = []
    for scene in dict.fromkeys(row["scene"] for row in ledger):
        cells = {int(row["chapter"]): row for row in ledger if row["scene"] == scene and row["chapter"].isdigit()}  # not Bullet's
        before = [number for number in cells if number < chapter]
        if chapter in cells and before and cells[max(before)]["passes"] != cells[chapter]["passes"]:
            old, new = cells[max(before)], cells[chapter]
            lines.append(f"- `{scene}`, {new['quantity']} ({new['bound'].strip()}): {value(old)} with chapter {max(before)}, "
                         f"**{value(new)}** with chapter {chapter}, which {'holds' if new['passes'] == '1' else 'fails'}")
    return "\nBehaviour (\\ref page_failure_ledger):\n\n" + "\n".join(lines) + "\n" if lines else ""


def value(row):
    if not row["value"]:
        return "nothing to measure"
    number = float(row["value"])
    return f"{number:.0f} {row['unit']}".strip() if abs(number) >= 100 else f"{number:.3g} {row['unit']}".strip()
