#!/usr/bin/env python3
"""The laboratory: the page that runs the layers themselves. Makes its files, brings them into the book, or serves them by themselves.

    docs/tools/lab.py                     build/lab: the page without the book
    docs/tools/lab.py --serve [FILE]      and opens it in a browser, with a scene of the reader's own, or with a run: replay.json

What draws comes from npm (three.js) in the version and with the digest of docs/tools/npm/lab/package-lock.json, and esbuild makes one file of it.
"""
import argparse
import base64
import gzip
import http.server
import json
import re
import shutil
import sys
import webbrowser
from functools import partial
from pathlib import Path

import lab_stars
import live
import npm

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build/lab"
MESHES = ["bunny_363.msh", "bunny_785.msh"]
LARGEST = 3_000_000  # bytes of all files, compressed: what a phone loads in some seconds
FILES = ["lab.js", "lab_data.js", "lab_page.js", "lab.css"]
LEDGER = re.compile(r'\{\s*"(?P<name>\w+)",\s*"(?P<file>\w+)",\s*(?:R"\((?P<patch>.*?)\)"|""),\s*"(?P<quantity>[^"]*)",\s*"(?P<unit>[^"]*)",\s*'
                    r'Bound::at_(?P<bound>\w+),\s*(?P<limit>-?[\d.]+),\s*"(?P<reason>[^"]*)",\s*"(?P<expected>[pf]+)"', re.S)
TITLE = re.compile(r"# Chapter (\d+): (.+)")
METHOD = re.compile(r'\{"(\w+)", "([^"]+)", \[\]')  # a row of other_methods()
BLOCK = ('<link rel="stylesheet" href="{place}lab.css"><div class="lab" data-lab="loading"><p>The laboratory is being loaded.</p></div>'
         '<script src="{place}lab.js"></script><script src="{place}lab_data.js"></script><script src="{place}lab_page.js"></script>')
PAGE = """<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>The laboratory - Enduring Contacts</title><style>
html { --page-background-color: #fff; --page-foreground-color: #2b3440; --page-secondary-foreground-color: #566473; --separator-color: #d8dee6;
       --code-background: #f5f7fa; --primary-color: #2768a3; }
html.dark-mode { --page-background-color: #1c1d1f; --page-foreground-color: #d5dbe3; --page-secondary-foreground-color: #a5b0bd; --separator-color: #3b4048;
       --code-background: #26282b; --primary-color: #6aa9e6; }
body { margin: 0 auto; padding: 1em; max-width: 1240px; font: 16px/1.5 "Source Sans 3", "Segoe UI", Roboto, "DejaVu Sans", sans-serif; background: var(--page-background-color);
       color: var(--page-foreground-color); }
h1 { font-size: 1.5em; margin: 0; }
</style><script>
const dark = matchMedia("(prefers-color-scheme: dark)"), theme = () => document.documentElement.classList.toggle("dark-mode", dark.matches);
dark.addEventListener("change", theme);
theme();
</script></head><body><h1>The laboratory of <i>Enduring Contacts</i></h1>""" + BLOCK.format(place="") + "</body></html>\n"


def solvers():
    """(key, title) of what the menu offers: a chapter's solver by its number, a method of chapter 13 by its name."""
    for path in sorted(ROOT.glob("chapters/[0-9][0-9]_*/chapter.md")):
        number, title = TITLE.match(path.read_text(encoding="utf-8")).groups()
        methods = METHOD.findall(text) if "other_methods()" in (text := (path.parent / "solver.cpp").read_text(encoding="utf-8")) else [(number, title)]
        yield from ((key, f"{number}: {name}") for key, name in methods)


def possible():
    """Whether what it is made with is there."""
    return live.possible() and shutil.which("npm") is not None


def changed(document, patch):
    """A scene after a change, as apply_patch() of common/input/json_document.hpp makes it."""
    if not isinstance(patch, dict):
        return patch
    result = dict(document) if isinstance(document, dict) else {}
    for key, value in patch.items():
        if key.startswith("/"):
            *steps, last = key[1:].split("/")
            at = result
            for step in steps:
                at = at[step] if isinstance(at, dict) else next(entry for i, entry in enumerate(at) if entry.get("name") == step or str(i) == step)
            at[last] = changed(at.get(last), value)
        elif value is None:
            result.pop(key, None)
        else:
            result[key] = changed(result.get(key), value)
    return result


def text_of(name, patch=None):
    text = (ROOT / f"common/scenes/{name}.json").read_text(encoding="utf-8")
    return json.dumps(changed(json.loads(text), json.loads(patch)), indent=1, ensure_ascii=False) + "\n" if patch else text


def ledger_scenes():
    """The rows of the failure ledger: under the first solver that passes, beside the one before it."""
    for row in LEDGER.finditer((ROOT / "chapters/motivating_scenes/motivating_scenes.cpp").read_text(encoding="utf-8")):
        solver = row["expected"].rindex("f") + 2 if "f" in row["expected"] else 1
        note = (f"{row['quantity'].capitalize()}: at {row['bound']} {row['limit']} {row['unit']}".rstrip() + f" ({row['reason']})."
                + (f" Chapter {solver - 1} fails, chapter {solver} holds." if solver > 1 else " All chapters hold."))
        text = text_of(row["file"], row["patch"])
        yield {"key": f"ledger_{row['name']}", "group": "Why a next chapter (the failure ledger)", "title": f"{row['name'].replace('_', ' ')}: why chapter {solver}?" if solver > 1 else row["name"],
               "text": text, "note": note, "solver": solver, "beside": 0 if solver_of(text) == 12 else solver - 1}  # a solver without joints refuses them


def all_scenes():
    stars = list(lab_stars.scenes())
    yield from stars
    patch = json.dumps({"/bodies/bunny/shape/file": "bunny_363.msh", "/bodies/bunny/basis": "quadratic"})
    yield {"key": "bunny_363_quadratic", "group": "Scenes of the course", "title": "bunny of 363 quadratic elements", "text": text_of("bunny_at_rest", patch),
           "note": "Here with 363 quadratic elements.", "solver": 10, "beside": 0}
    yield from ledger_scenes()
    for path in sorted((ROOT / "common/scenes").glob("*.json")):
        if path.stem not in {star["key"] for star in stars}:
            yield {"key": path.stem, "group": "Scenes of the course", "title": path.stem.replace("_", " "), "text": (text := path.read_text(encoding="utf-8")), "note": "",
                   "solver": solver_of(text), "beside": 0}


def meshes():
    """The meshes of the menu's scenes, by name."""
    return {name: (ROOT / "common/meshes" / name).read_text(encoding="utf-8") for name in MESHES} | {"stone.obj": lab_stars.stone()}


def solver_of(text):
    """The chapter whose solver a scene begins with: springs give, unless it asks for exact contact; joints are chapter 12's."""
    try:
        if json.loads(text).get("joints"):
            return 12
        return 11 if json.loads(text).get("contact", {}).get("exact") is True else 10
    except (ValueError, AttributeError):  # the page tells the mistake
        return 10


def own_scene(path):
    """A scene of the reader's own, and the meshes beside it that it names."""
    text = path.read_text(encoding="utf-8")
    names = set(re.findall(r'"file"\s*:\s*"([^"]+)"', text))
    meshes = {name: (path.parent / name).read_text(encoding="utf-8", errors="replace") for name in names if (path.parent / name).is_file()}
    return {"key": "given", "group": "Yours", "title": path.name, "text": text, "note": "", "solver": solver_of(text), "beside": 0}, meshes


def run_in(path):
    """The run that a program wrote into a file, or nothing where the file is something else."""
    try:
        run = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:  # a scene with a mistake in it, which the page tells
        return None
    return run if isinstance(run, dict) and "replay" in run else None


def data(own=None):
    scenes, offered, given = list(all_scenes()), list(solvers()), meshes()
    for scene in scenes:
        if "thumbnail" in scene:
            picture = (ROOT / "live/lab/thumbnails" / scene["thumbnail"]).read_bytes()
            scene["thumbnail"] = f"data:image/webp;base64,{base64.b64encode(picture).decode()}"
    if run := own and run_in(own):
        return {"scenes": scenes, "solvers": offered, "meshes": given, "run": run}
    if own:
        scene, its = own_scene(own)
        scenes.insert(0, scene)
        given |= its
    return {"scenes": scenes, "solvers": offered, "meshes": given}


def bundle():
    """lab_page.js: our scripts and what they need of three.js, in one file."""
    work = ROOT / "build/lab_npm"
    if not shutil.which("npm"):
        sys.exit("The laboratory needs npm. On Debian: apt-get install npm   (or: ./course lab, which does)")
    if not npm.installed(ROOT / "docs/tools/npm/lab", work):
        sys.exit("npm could not fetch what the laboratory draws with")
    live.run([str(work / "node_modules/.bin/esbuild"), str(ROOT / "live/lab/main.js"), "--bundle", "--minify", "--format=iife", "--legal-comments=none",
              "--banner:js=/* With three.js, MIT licence, (c) 2010-2025 three.js authors */", f"--outfile={WORK / 'lab_page.js'}"], {"NODE_PATH": str(work / "node_modules")})


def build(own=None):
    """build/lab, from compiled modules. @throws SystemExit  it is larger than it may be"""
    WORK.mkdir(parents=True, exist_ok=True)
    bundle()
    shutil.copyfile(live.WORK / "lab.js", WORK / "lab.js")
    shutil.copyfile(ROOT / "live/lab/lab.css", WORK / "lab.css")
    (WORK / "lab_data.js").write_text(f"window.LABORATORY = {json.dumps(data(own), ensure_ascii=False)};\n", encoding="utf-8")
    (WORK / "index.html").write_text(PAGE, encoding="utf-8")
    size = compressed_size(WORK)
    if size > LARGEST and not own:
        sys.exit(f"The laboratory is {size} bytes compressed; at most {LARGEST} are allowed")
    return size


def compressed_size(place):
    return sum(len(gzip.compress((place / name).read_bytes(), 9)) for name in FILES)


def bring(book):
    """Its files into the book."""
    size = build()
    for name in FILES:
        shutil.copyfile(WORK / name, book / "live" / name)
    print(f"The laboratory: {size / 1e6:.2f} MB compressed")


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def serve(opens, folder=WORK, page="", name="The laboratory"):
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder))) as server:
        place = f"http://127.0.0.1:{server.server_address[1]}/{page}"
        print(f"{name}: {place}   (Ctrl-C ends it)", flush=True)
        if opens:
            webbrowser.open(place)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene", type=Path, nargs="?", help="a scene of your own, or a run: replay.json")
    parser.add_argument("--serve", action="store_true", help="serves it until Ctrl-C, and opens it")
    parser.add_argument("--no-browser", action="store_true", help="only serves it")
    options = parser.parse_args()
    if options.scene and not options.scene.is_file():
        print(f"{options.scene}: there is no such file", file=sys.stderr)
        sys.exit(2)
    live.compile_module()
    print(f"{WORK / 'index.html'}: {build(options.scene) / 1e6:.2f} MB compressed")
    if options.serve:
        serve(not options.no_browser)


if __name__ == "__main__":
    main()
