"""What README.md shows: a small picture for each chapter, cut out of a reference picture, and a film.
usage: front_page.py          renders/NN_name/thumbnail.png for each chapter
       front_page.py --film   renders/09_deep_contacts/film.webp: runs the experiment that films it, which takes minutes"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RENDERS = ROOT / "renders"
PROGRAMS = Path(os.environ.get("ENDURING_BUILD", ROOT / "build/release")) / "bin"
WIDTH, HEIGHT = 210, 140
MIDDLE_OF_THREE = "crop=440:300:446:0,"
PICTURES = {  # each chapter's reference picture, and what is cut out of it first
    "01_particle_plane": ("ground", ""),
    "02_collision_detection": ("gallery_tunnelling", MIDDLE_OF_THREE),
    "03_penalty_impulses": ("bar_on_cube", ""),
    "04_friction": ("slope", ""),
    "05_categorisation": ("hooked", ""),
    "06_redefinition": ("shifted", ""),
    "07_implicit_contact": ("stack", ""),
    "08_contact_by_distance": ("heap", ""),
    "09_deep_contacts": ("bunny_curve", ""),
    "10_self_contact": ("folded_strip", ""),
    "11_exact_contact": ("spring_error", ""),  # its plot, as a browser shows it
    "12_joints": ("double_pendulum", ""),      # the same
    "13_other_solvers": ("over_iterations", ""),  # as well
}


def ffmpeg(*words):
    done = subprocess.run(["ffmpeg", "-loglevel", "error", *map(str, words)], stdin=subprocess.DEVNULL, capture_output=True)
    if done.returncode:
        sys.exit(done.stderr.decode())
    return done.stdout


def pixels(picture, filters="null"):
    """RGB of the picture, three bytes a pixel."""
    return ffmpeg("-i", picture, "-vf", filters, "-frames:v", 1, "-pix_fmt", "rgb24", "-f", "rawvideo", "-")


def source_of(chapter):
    """The reference picture of a chapter, and the filters that make it small."""
    name, cut = PICTURES[chapter]
    fill = f"scale={WIDTH}:{HEIGHT}:force_original_aspect_ratio=increase:flags=area,crop={WIDTH}:{HEIGHT}"
    return RENDERS / chapter / f"{name}.png", cut + fill


def thumbnail_of(chapter):
    return RENDERS / chapter / "thumbnail.png"


def write_thumbnails():
    for chapter in PICTURES:
        picture, filters = source_of(chapter)
        ffmpeg("-y", "-i", picture, "-vf", filters, "-frames:v", 1, "-pix_fmt", "rgb24", "-fflags", "+bitexact", thumbnail_of(chapter))


def write_film():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAMS / "chapter09", "bunny_curve", "--out", folder], check=True)
        film = next(Path(folder).rglob("bunny_out.webp"))
        (RENDERS / "09_deep_contacts/film.webp").write_bytes(film.read_bytes())


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--film"]):
        sys.exit(__doc__)
    write_film() if sys.argv[1:] else write_thumbnails()
