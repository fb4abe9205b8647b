"""What a finished book must not have: dead links, figures that no sentence mentions, symbols and abbreviations that nothing explains, results of
another program. Each check yields what is wrong, with its place."""
import hashlib
import re
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

FORMULA = re.compile(r"\\f\$(.+?)\\f\$|\\f\[(.+?)\\f\]", re.S)
# Commands of TeX that are no symbols: what shapes a formula, functions, relations and operators.
SHAPES = set("""frac tfrac dfrac binom tbinom sqrt left right big Big bigl bigr Bigl Bigr bigg text mathrm mathtt mathbf mathit operatorname boldsymbol
    begin end quad qquad hspace limits nolimits displaystyle textstyle boxed underbrace overbrace phantom pmatrix matrix cases aligned array
    sin cos tan cot arcsin arccos arctan exp log ln max min det tr lim sup inf mod bmod le ge ne leq geq neq ll gg approx sim simeq equiv propto in
    notin subset to mapsto leftarrow rightarrow Rightarrow Leftrightarrow iff implies wedge vee cap cup times cdot cdots ldots dots vdots pm mp ast circ
    perp parallel partial nabla int oint sum prod infty forall exists prime colon mid lvert rvert lVert rVert vert Vert lbrace rbrace langle rangle
    lfloor rfloor lceil rceil hat bar tilde dot ddot vec overline underline top T mathrel not , ; : ! \\ { }""".split())
GREEK = set("""alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta kappa lambda mu nu xi rho sigma tau phi varphi chi psi omega
    Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega pi ell""".split())


# ------------------------------------------------------------------------------------------------------------- symbols
def symbols_of(formula):
    """The letters of a formula: {"delta", "n", "k", "v"}. Words in text are no symbols."""
    formula = re.sub(r"\\(text|mathrm|mathtt|operatorname)\s*\{[^{}]*\}", " ", formula)
    formula = re.sub(r"\\begin\{\w+\}(\{[^}]*\})?|\\end\{\w+\}", " ", formula)
    found = {name for name in re.findall(r"\\([A-Za-z]+)", formula) if name in GREEK}
    return found | set(re.findall(r"(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])|[A-Za-z]", re.sub(r"\\[A-Za-z]+", " ", formula)))


def unknown_commands(formula):
    return {name for name in re.findall(r"\\([A-Za-z]+)", formula) if name not in SHAPES | GREEK}


def explained_symbols(notation):
    """The symbols of the table of notation: all in the formulas of its first column."""
    rows = [line.split("|")[1] for line in notation.splitlines() if line.startswith("|")]
    return set().union(*(symbols_of(first or second) for row in rows for first, second in FORMULA.findall(row)))


def symbol_faults(pages, notation):
    """Formulas with a symbol that neither the table of notation nor the page itself explains.
    @param pages  (path, text, symbols that the page explains in place) of each"""
    known = explained_symbols(notation)
    for path, text, own in pages:
        missing = set()
        for first, second in FORMULA.findall(text):
            missing |= (symbols_of(first or second) | unknown_commands(first or second)) - known - own
        if missing:
            yield f"{path}: not in docs/notation.md, and not in the page's own @local: {', '.join(sorted(missing))}"


# ------------------------------------------------------------------------------------------- abbreviations and figures
def abbreviation_faults(pages, glossary):
    """Abbreviations in capitals that the glossary does not have."""
    known = set(re.findall(r"\b[A-Z]{2,4}\b", glossary)) | COMMON
    for path, text, _ in pages:
        words = re.sub(r"`[^`]*`|```.*?```|\\f\$.*?\\f\$|\\f\[.*?\\f\]|\]\([^)]*\)|\{[^}]*\}|https?://\S+", " ", text, flags=re.S)
        if missing := sorted(set(re.findall(r"(?<![\w.-])[A-Z]{2,4}s?\b(?![\w-])", words)) - known):
            yield f"{path}: not in docs/glossary.md: {', '.join(missing)}"


COMMON = set("TU IGD ACM IEEE SIAM CPU SI HTML PDF PNG SVG CSV MIT OK OBJ TOC XML JSON II III IV VI SIGGRAPH CAGD DOI API GPU IMA TVCG RFC VTK MB".split())


def figure_faults(pages):
    """Numbered figures that no sentence mentions.
    @param pages  (path, figures' names, text) of each"""
    mentioned = set(re.findall(r"@figref\{\s*([^}]+?)\s*\}", "\n".join(text for _, _, text in pages)))
    for path, figures, _ in pages:
        yield from (f"{path}: no sentence mentions the figure {name} (@figref)" for name in figures if name not in mentioned)


# --------------------------------------------------------------------------------------------------------- stale results
def made_by(program):
    """What a run leaves beside its results, to say which program made them."""
    return hashlib.sha256(program.read_bytes()).hexdigest()


def result_folders(results):
    """Those of the base and of the chapters, in their order; then what all solvers left together, and other engines."""
    return [path for pattern in ("[0-9][0-9]_*", "solvers", "engines") for path in sorted(results.glob(pattern)) if path.is_dir()]


def word_of(folder):
    """What a user calls it: 3 for 03_penalty_impulses, solvers for solvers."""
    return str(int(folder[:2])) if folder[:2].isdigit() else folder


def program_of(folder):
    return "base" if folder == "00_base" else f"chapter{folder[:2]}" if folder[:2].isdigit() else folder


def stale_results(results, programs):
    """Folders of results that another program than the present one has made."""
    for folder in result_folders(results):
        program, stamp = programs / program_of(folder.name), folder / ".made_by"
        if program.is_file() and (not stamp.is_file() or stamp.read_text(encoding="utf-8").strip() != made_by(program)):
            yield f"{folder}: the numbers are stale, {program.name} is another program now (./course run {word_of(folder.name)}, or ./course docs)"


# ------------------------------------------------------------------------------------------------------------ dead links
class Page(HTMLParser):
    """Links and anchors of one page."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("id", "name") and value:
                self.anchors.add(value)
            elif key in ("href", "src") and value:
                self.links.add(value)


def link_faults(book):
    """Links between the book's files that lead nowhere."""
    pages = {path: Page(path.read_text(encoding="utf-8", errors="replace")) for path in sorted(book.glob("*.html"))}
    for path, page in pages.items():
        for link in sorted(page.links):
            parts = urlsplit(link)
            if parts.scheme in ("http", "https", "mailto", "javascript", "data") or "$" in link:
                continue
            target = book / unquote(parts.path) if parts.path else path
            if not target.exists():
                yield f"{path.name}: leads to {link}, which is not there"
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors:
                yield f"{path.name}: leads to {link}, an anchor that is not there"
