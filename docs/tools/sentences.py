"""What a script can see of a page's prose: sentences with too many pronouns or words, bodies and solvers that want, know or say something, and
history of the text. docs/tools/sentences.toml has the limits of each group of pages, and the exceptions by name."""
import re
import tomllib
from dataclasses import dataclass
from fnmatch import fnmatch

PRONOUN = re.compile(r"\b(it|its|this|these|that|those|which|one|ones)\b", re.I)
MANY = 4  # pronouns in a sentence
LONG = 36  # words in a sentence; formulas and numbers are none
ACTOR = r"bod(?:y|ies)|pairs?|solvers?|steps?|springs?|vertex|vertices|faces?|edges?|ground|walls?|methods?|query|queries|cubes?|rounds?|particles?|chapter \d+"
MIND = re.compile(rf"\b(?:{ACTOR})\s+(?:\w+ly\s+|never |does not |do not |cannot )?(?:wants?|wanted to|knows?|knew|says?|said|asks?|asked|answers?|answered|thinks?|forgets?)\b", re.I)
HISTORY = re.compile(r"\b(?:(?:an?|the) (?:earlier|first|former) version|for long (?:it|this|they) (?:was|were|had)|until now|we would like|(?:was|were) asked for)\b", re.I)
OF = re.compile(r"^Of (?:\w+ )?\d")  # "Of 14 runs, 13 come to rest"
CAPTION = re.compile(r"^@(?:(?:figure|table)\{|live\{\s*\w+\s*,)\s*[\w./-]+\s*,\s*(.+)\}\s*$")
WORDS_OF_A_CAPTION, OFS = 40, 2
BEHIND = re.compile(r"^## For the curious\b", re.M)  # where a chapter's main line ends


@dataclass
class Sentence:
    line: int  # where its paragraph begins
    text: str

    @property
    def words(self):
        """How many there are, without those that stand for something else."""
        return sum(word != "X" and any(map(str.isalpha, word)) for word in self.text.split())


def without_code(text):
    """The text with a word in place of each formula, number, listing and reference; their lines stay."""
    blank = re.compile(r"```.*?```|\\f\[.*?\\f\]", re.S)
    text = blank.sub(lambda found: "\n" * found[0].count("\n"), text)
    return re.sub(r"<!--.*?-->|\\f\$.+?\\f\$|\$`.*?`\$|\$[^$\n]+\$|`[^`]*`|@\w+\{[^}]*\}|!?\[[^\]]*\]\([^)]*\)", " X ", text)


def sentences(text, first_line=1):
    """The sentences of a page, without headings, tables, what stands alone on a line, and indented listings."""
    paragraph, begin = [], first_line
    for number, line in enumerate([*without_code(text).split("\n"), ""], start=first_line):
        opens = re.match(r"\s*(?:[-*]|\d+\.)\s", line)
        skipped = not line.strip() or line.lstrip().startswith(("#", "|", "@", "<", "\\")) or not paragraph and line.startswith("    ")
        if paragraph and (skipped or opens):
            joined = " ".join(" ".join(paragraph).split())
            yield from (Sentence(begin, part) for part in re.split(r"(?<=[.!?:])\s+(?=[A-Z*\\\\])", joined) if len(part.split()) > 3)
            paragraph = []
        if not skipped:
            begin = begin if paragraph else number
            paragraph.append(line)


def group_of(groups, name):
    """The first group whose pattern the page's path fits; none for a page that is not checked."""
    return next((group for group in groups if fnmatch(name, group["pages"])), None)


def faults(name, text, rules, first_line=1):
    """What is wrong with one page.
    @param name   its path in the repository
    @param rules  of docs/tools/sentences.toml; the exceptions that are met are taken out of rules["unused"]"""
    group = group_of(rules["group"], name)
    if not group:
        return
    found = {"pronouns": [], "long": [], "minds": [], "history": []}
    all_sentences = list(sentences(text, first_line))
    for sentence in all_sentences:
        for kind, wrong in (("pronouns", len(PRONOUN.findall(sentence.text)) >= MANY), ("long", sentence.words >= LONG),
                            ("minds", MIND.search(sentence.text)), ("history", HISTORY.search(sentence.text))):
            if not wrong:
                continue
            excepted = [e for e in rules["exception"] if e["page"] == name and e["kind"] == kind and e["text"] in sentence.text]
            rules["unused"][:] = [e for e in rules["unused"] if e not in excepted]
            if not excepted:
                found[kind].append(sentence)
    told = {"pronouns": f"{MANY} or more of it, this, that, which, one", "long": f"{LONG} words or more", "minds": "only people want, know, say and ask", "history": "history of the text"}
    for kind, sentences_found in found.items():
        allowed = group[kind] * len(all_sentences) / 100 if kind in ("pronouns", "long") else group[kind]
        if len(sentences_found) > allowed:
            yield from (f"{name}:{s.line}: {told[kind]} ({len(sentences_found)} sentences, {allowed:.0f} allowed): {s.text[:90]}" for s in sentences_found)
    ofs = [sentence for sentence in all_sentences if OF.match(sentence.text)]
    if len(ofs) > OFS:
        yield from (f"{name}:{s.line}: 'Of N x, M y' ({len(ofs)} sentences, {OFS} allowed): {s.text[:90]}" for s in ofs)
    for line, caption in enumerate(text.split("\n"), start=first_line):
        if (found := CAPTION.match(caption)) and (count := len(re.sub(r"<!--.*?-->", "", found[1]).split())) > WORDS_OF_A_CAPTION:
            yield f"{name}:{line}: a caption of {count} words, {WORDS_OF_A_CAPTION} allowed"
    main = sum(len(s.text.split()) for s in sentences(BEHIND.split(text)[0]))
    if main > group["words"]:
        yield f"{name}:1: {main} words before 'For the curious', {group['words']} allowed"


def all_faults(root, pages):
    """Of all pages that a group names, and exceptions that nothing needs.
    @param pages  with path, lines and first_line"""
    path = root / "docs/tools/sentences.toml"
    if not path.is_file():
        return
    rules = tomllib.loads(path.read_text(encoding="utf-8"))
    rules.setdefault("exception", [])
    rules["unused"] = list(rules["exception"])
    for page in pages:
        if page.path.is_relative_to(root):
            yield from faults(page.path.relative_to(root).as_posix(), "\n".join(page.lines), rules, page.first_line)
    yield from (f"docs/tools/sentences.toml:1: no sentence of {e['page']} needs the exception '{e['text']}'" for e in rules["unused"])
