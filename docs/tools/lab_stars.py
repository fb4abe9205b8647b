"""The scenes that the laboratory offers first, each with a picture (live/lab/thumbnails/KEY.webp) and what to look at.

    docs/tools/lab_stars.py FOLDER                 writes them as files, for ./course run solvers -- --scene FOLDER/heap.json
    docs/tools/lab_stars.py FOLDER --thumbnails    and runs them, and cuts the pictures out of those of the runs (with ffmpeg)
"""
import json
import math
import os
import random
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PALETTE = [[0.62, 0.14, 0.08], [0.08, 0.3, 0.55], [0.75, 0.5, 0.08], [0.12, 0.4, 0.2], [0.4, 0.16, 0.45], [0.1, 0.45, 0.5]]  # linear light
GROUND = {"name": "ground", "point": [0, 0, 0], "normal": [0, 1, 0]}
ROUGH = {"friction": {"model": "mass_splitting", "mu_s": 0.6, "mu_d": 0.5}}
STONES, INNER, OUTER, DEEP = 9, 1.0, 1.35, 0.5  # of the arch


def scene(name, description, bodies, camera, dt=0.01, duration=4, contact=None, planes=(GROUND,)):
    return {"name": name, "description": description, "dt": dt, "duration": duration, "contact": contact or ROUGH, "planes": list(planes), "bodies": bodies,
            "camera": {"eye": camera[0], "target": camera[1], "field_of_view_deg": 34}}


def rigid(name, size, position, i, **more):
    return {"name": name, "type": "rigid", "shape": {"box": {"size": size}}, "density": 500, "position": [round(x, 6) for x in position], **more,
            "look": {"color": PALETTE[i % len(PALETTE)]}}


def turned(angle, axis=(0, 0, 1)):
    return {"rotation": {"axis": list(axis), "angle_deg": round(angle, 6)}}


def heap():
    rng = random.Random(3)
    bodies = [rigid(f"cube {i + 1}", [0.4, 0.4, 0.4], [0.72 * (i % 3 - 1), 0.45 + 0.72 * (i // 3), 0.15 * rng.uniform(-1, 1)], i,
                    **turned(rng.uniform(0, 90), [rng.uniform(-1, 1) for _ in range(3)])) for i in range(15)]
    return scene("heap", "Fifteen cubes fall onto the ground.", bodies, ([4.4, 3.4, 6.3], [0, 1.5, 0]))


def card_house():
    long, thin, wide, lean = 0.9, 0.02, 0.6, 17
    sine, cosine = math.sin(math.radians(lean)), math.cos(math.radians(lean))
    half, high = (long * sine + thin * cosine) / 2 + 1e-4, (long * cosine + thin * sine) / 2
    bodies = []

    def pair(x, y):
        for side in (-1, 1):
            bodies.append(rigid(f"card {len(bodies) + 1}", [thin, long, wide], [x + side * half, y + high, 0], len(bodies), **turned(side * lean)))

    def plate(x, y, length):
        bodies.append(rigid(f"card {len(bodies) + 1}", [length, thin, wide], [x, y + thin / 2 + 1e-4, 0], len(bodies)))

    apart = 4 * half + 0.03
    for x in (-apart, 0, apart):
        pair(x, 0)
    for x in (-apart / 2, apart / 2):
        plate(x, 2 * high, apart - 0.01)
    second = 2 * high + thin + 2e-4
    for x in (-apart / 2, apart / 2):
        pair(x, second)
    plate(0, second + 2 * high, apart)
    pair(0, second + 2 * high + thin + 2e-4)
    return scene("card_house", "Fifteen cards lean on each other, on three floors.", bodies, ([2.6, 2.2, 5.4], [0, 1.25, 0]),
                 contact={"friction": {"model": "mass_splitting", "mu_s": 0.8, "mu_d": 0.7}})


def stone():
    """The text of one stone of the arch, an OBJ file: a ring's piece about the origin, standing on its lower face."""
    half = math.radians(180 / STONES / 2) - 1e-5
    corners = [(r * math.cos(a), r * math.sin(a), z) for z in (-DEEP / 2, DEEP / 2) for a in (-half, half) for r in (INNER, OUTER)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return "".join(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in corners) + "".join(f"f {a + 1} {b + 1} {c + 1}\nf {a + 1} {c + 1} {d + 1}\n" for a, b, c, d in quads)


def arch():
    step = 180 / STONES
    bodies = [{"name": f"stone {i + 1}", "type": "rigid", "shape": {"file": "stone.obj"}, "density": 2000, **turned(step * (i + 0.5)), "look": {"color": PALETTE[i % 2 * 2]}}
              for i in range(STONES)]
    return scene("arch", "Nine stones without mortar stand as an arch.", bodies, ([2.4, 1.7, 4.4], [0, 0.7, 0]),
                 contact={"friction": {"model": "mass_splitting", "mu_s": 0.7, "mu_d": 0.6}})


def dominoes():
    bodies = [rigid(f"domino {i + 1}", [0.08, 0.8, 0.4], [0.42 * i - 1.9, 0.4 + 1e-4, 0], i) for i in range(10)]
    bodies[0] |= turned(-9) | {"position": [-1.9 + 0.06, 0.402, 0]}
    return scene("dominoes", "The first domino leans, and falls.", bodies, ([1.6, 2.2, 5.4], [0, 0.4, 0]), duration=3)


def ton_on_a_kilogram():
    sizes = [("kilogram", 0.2, 1, 2), ("ton", 0.9, 1000, 0)]
    bodies, y = [], 0
    for name, size, mass, colour in sizes:
        body = rigid(name, [size] * 3, [0, y + size / 2 + 0.02, 0], colour) | {"mass": mass}
        del body["density"]
        bodies.append(body)
        y += size + 0.02
    return scene("ton_on_a_kilogram", "A cube of a ton falls two centimetres onto a cube of a kilogram.", bodies, ([1.7, 1.3, 3], [0, 0.5, 0]), duration=3)


def bunny_falls(position=(0.1, 1.2, 0)):
    """The bunny of the course in 363 linear elements."""
    falls = json.loads((ROOT / "common/scenes/bunny_at_rest.json").read_text(encoding="utf-8"))
    bunny = next(body for body in falls["bodies"] if body["name"] == "bunny")
    bunny |= {"basis": "linear", "position": list(position), "shape": {"file": "bunny_363.msh", "scale": 0.1}}
    return falls


def bunny_in_the_wall():
    return bunny_falls((0.72, 1.0, 0)) | {"name": "bunny_in_the_wall", "description": "A soft bunny begins in the wall of a bowl and comes out. Bunny: Stanford Computer Graphics Laboratory.", "duration": 3}


def tower():
    """Five cubes, with a floor below their block, each in a colour of its own."""
    tower = json.loads((ROOT / "common/scenes/tower.json").read_text(encoding="utf-8"))
    for i, body in enumerate(tower["bodies"][1:]):
        body["look"]["color"] = PALETTE[i]
    return tower | {"planes": [GROUND | {"point": [0, -0.25, 0]}]}


# Key, title, the solver and the one beside it, the scene (a function, or a file), and what to look at.
STARS = [
    ("heap", "A heap", 10, 0, heap, "The cubes come to rest, and stay. Pull one out from below."),
    ("card_house", "A card house", 10, 0, card_house, "Friction alone holds it. Lower mu: from which value on does it slide apart?"),
    ("arch", "An arch", 10, 0, arch, "No stone is glued. Pull the keystone up, then let go."),
    ("dominoes", "Dominoes", 10, 0, dominoes, "A wave of falls. Does its speed depend on mu?"),
    ("tower", "Five cubes, edge on edge", 10, 0, tower, "They never slip off. Put chapter 6 beside it, and compare the curves of the energy."),
    ("ton_on_a_kilogram", "A ton on a kilogram", 7, 3, ton_on_a_kilogram, "Chapter 3 needs a stiffness, and sinks in: change k. Chapter 7 finds one."),
    ("cradle", "A cradle", 10, 0, "examples/scenes/cradle.json", "The last ball leaves as the first one came. Write a restitution of 0.9 into the text."),
    ("bunny_in_the_wall", "A bunny in the wall", 10, 0, bunny_in_the_wall, "It begins inside the wall, comes out, and is not thrown."),
    ("bunny_363_linear", "A bunny falls into a bowl", 10, 0, bunny_falls, "363 soft elements. Pull it by an ear."),
    ("folded", "A strip folds", 10, 9, "common/scenes/folded.json", "Under chapter 9 its folds pass through each other. Chapter 10 finds where they touch."),
]
SHOWN = {"dominoes": (0, 1), "folded": (2, 1), "bunny_in_the_wall": (0, 0), "bunny_363_linear": (2, 1)}  # column and row of the picture's moment; else the first
WIDTH, HEIGHT = 168, 112


def text_of(source):
    return json.dumps(source(), indent=1, ensure_ascii=False) + "\n" if callable(source) else (ROOT / source).read_text(encoding="utf-8")


def scenes():
    """The menu's entries, as lab.py has the others, with a thumbnail and what to look at."""
    for key, title, solver, beside, source, look in STARS:
        yield {"key": key, "group": "To begin with", "title": title, "text": text_of(source), "note": "", "solver": solver, "beside": beside, "look": look,
               "thumbnail": f"{key}.webp"}


def write(folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "stone.obj").write_text(stone(), encoding="utf-8")
    shutil.copyfile(ROOT / "common/meshes/bunny_363.msh", folder / "bunny_363.msh")
    for key, *_, source, _ in STARS:
        name = json.loads(text_of(source))["name"]
        (folder / f"{name}.json").write_text(text_of(source), encoding="utf-8")
        yield key, folder / f"{name}.json"


def thumbnail(key, path, program):
    """Runs a scene, and cuts one of the six moments of its picture out."""
    out = path.with_suffix("")
    if not (out / "scene.png").is_file():
        subprocess.run([program, "--scene", path, "--out", out, "--quick"], check=True, stdout=subprocess.DEVNULL)
    column, row = SHOWN.get(key, (0, 0))
    cut = f"crop=iw/3:ih/2-49:iw/3*{column}:ih/2*{row},scale={WIDTH}:{HEIGHT}:force_original_aspect_ratio=increase:flags=area,crop={WIDTH}:{HEIGHT}"
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", out / "scene.png", "-vf", cut, "-frames:v", "1", "-quality", "80", ROOT / f"live/lab/thumbnails/{key}.webp"], check=True)


def main():
    for key, path in write(Path(sys.argv[1])):
        if "--thumbnails" in sys.argv:
            thumbnail(key, path, Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin/solvers")


if __name__ == "__main__":
    main()
