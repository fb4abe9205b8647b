"""The book's Markdown for a terminal: links keep their words, formulas become text that reads aloud."""
import re
import sys

LETTERS = {"alpha": "α", "delta": "δ", "varepsilon": "ε", "epsilon": "ε", "varphi": "φ", "zeta": "ζ", "beta": "β", "gamma": "γ", "kappa": "κ", "lambda": "λ", "mu": "μ", "pi": "π", "sigma": "σ", "tau": "τ", "omega": "ω", "Omega": "Ω"}
SIGNS = {"cdot": "·", "times": "×", "le": "≤", "ge": "≥", "in": "∈", "sim": "~", "pm": "±", "mp": "∓", "int": "∫", "oint": "∮", "sum": "Σ", "dots": "…",
         "parallel": "∥", "perp": "⊥", "min": "min", "max": "max"}
IN_ASCII = {"·": "*", "×": "x", "≤": "<=", "≥": ">=", "∈": "in", "±": "+-", "∓": "-+", "∫": "integral", "∮": "integral", "Σ": "sum", "∥": "par", "⊥": "perp", "√": "sqrt", "…": "...",
            "²": "^2", "³": "^3"} | {sign: name for name, sign in LETTERS.items()} | {"Δ": "Delta "}
SPACES = {",": " ", ";": " ", "!": "", "quad": "   ", "qquad": "   ", "left": "", "right": "", "big": "", "Big": "", "{": "{", "}": "}"}
TOKEN = re.compile(r"\\([A-Za-z]+|.)|([{}^_])|(\s+)|([^\\{}^_\s])")
WIDE = "·×≤≥∈~±∓"  # with a space on both sides
FRACTION = re.compile("<<([^<>]*)>>")  # on its way: brackets come when it is seen what stands beside it
ALONE_BEHIND, ALONE_BEFORE = "=+(,≤", "=+-),.≤"


def plain(text):
    """The text of an exercise as a terminal shows it."""
    text = re.sub(r"[ \n]*\$\$(.*?)\$\$[ \n]*", lambda found: f"\n\n    {formula(found[1])}\n\n", text.strip(), flags=re.S)
    text = re.sub(r"\$(.*?)\$", lambda found: formula(found[1]), text, flags=re.S)
    return readable_here(re.sub(r'\\ref \w+(?: "([^"]*)")?', lambda found: found[1] or "the book", text))


def readable_here(text):
    """Signs that the terminal's encoding does not know, by their names."""
    encoding = sys.stdout.encoding or "ascii"
    return "".join(sign if sign.encode(encoding, "ignore") else IN_ASCII.get(sign, "?") for sign in text)


def formula(tex):
    """A TeX formula in one line: \\frac{a+b}{c} becomes (a + b) / c, and Greek letters are letters.
    @throws ValueError for a command that it does not know: an exercise's text would show it to a student"""
    text = sequence([match.groups() for match in TOKEN.finditer(tex.strip())])
    while found := FRACTION.search(text):
        before, after = text[:found.start()].rstrip(), text[found.end():].lstrip()
        alone = (not before or before[-1] in ALONE_BEHIND) and (not after or after[0] in ALONE_BEFORE)
        text = text[:found.start()] + (found[1] if alone else f"({found[1]})") + text[found.end():]
    text = re.sub(r"\s*([" + WIDE + r"])\s*", r" \1 ", text)
    return re.sub(r" +([,.])", r"\1", re.sub(r"\( +", "(", re.sub(r" +", " ", text))).strip()


def sequence(tokens):
    """Takes the tokens of a group, to its closing brace, and gives its text."""
    text = ""
    while tokens:
        if tokens[0][1] == "}":
            tokens.pop(0)
            break
        text += one(tokens)
    return text


def one(tokens):
    """Takes one token, with its arguments, and gives its text."""
    command, brace, space, sign = tokens.pop(0)
    if brace == "{":
        return sequence(tokens)
    if brace in ("^", "_"):
        return script(brace, argument(tokens))
    if space or sign:
        return " " if space else sign
    return of_command(command, tokens)


def of_command(command, tokens):
    if command in ("frac", "tfrac"):
        above, below = argument(tokens), argument(tokens)
        return f"<<{in_brackets(above)} / {in_brackets(below)}>>"
    if command == "sqrt":
        return f"√({argument(tokens)})"
    if command == "binom":
        return f"binom({argument(tokens)}, {argument(tokens)})"
    if command == "dot":
        return f"{argument(tokens)}'"
    if command in ("hat", "text", "mathtt", "mathrm"):
        return argument(tokens)
    if command == "Delta":
        return "Δ" + argument(tokens)
    for known in (LETTERS, SIGNS, SPACES, {name: f"{name} " for name in ("tan", "cos", "sin", "exp", "arccos")}):
        if command in known:
            return known[command]
    raise ValueError(f"a terminal cannot show \\{command}")


def argument(tokens):
    """The next token or group, past spaces."""
    while tokens and tokens[0][2]:
        tokens.pop(0)
    return one(tokens).strip() if tokens else ""


def script(mark, text):
    if mark == "^" and text in ("2", "3"):
        return {"2": "²", "3": "³"}[text]
    return mark + (text if re.fullmatch(r"[^\W_]+|[∥⊥]", text) else f"({text})")


def in_brackets(text):
    """A numerator or denominator that is more than one factor."""
    return text if re.fullmatch(r"[^\s+\-·/]+|\|[^|]*\|[²³]?|\([^()]*\)", text) else f"({text})"
