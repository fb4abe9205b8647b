"""README.md: two screens, its pictures are there and as the reference pictures, and its film is a film."""
import re
import shutil
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/tools"))
import front_page  # noqa: E402

README = (ROOT / "README.md").read_text(encoding="utf-8")


def frames_of(webp):
    """How long each frame of an animated WebP is shown [ms]."""
    data, at, times = webp.read_bytes(), 12, []
    while at < len(data):
        kind, size = data[at:at + 4], int.from_bytes(data[at + 4:at + 8], "little")
        if kind == b"ANMF":
            times.append(int.from_bytes(data[at + 20:at + 23], "little"))
        at += 8 + size + size % 2
    return times


class FrontPage(unittest.TestCase):
    def test_it_fits_on_two_screens(self):
        self.assertLessEqual(len(README.splitlines()), 100)

    def test_whatever_it_names_is_there(self):
        paths = re.findall(r"\]\(([^):]+)\)|(?:src|href)=\"([^\":]+)\"", README)
        paths = [first or second for first, second in paths] + re.findall(r"`((?:docs|examples|chapters)/[^` ]+)`", README)
        self.assertGreater(len(paths), 15)
        self.assertEqual([path for path in paths if not (ROOT / path).exists()], [])

    def test_each_chapter_has_a_picture(self):
        chapters = sorted(main.parent.name for main in (ROOT / "chapters").glob("[0-9]*/main.cpp"))
        self.assertEqual(re.findall(r"renders/(\w+)/thumbnail\.png", README), chapters)

    @unittest.skipUnless(shutil.which("ffmpeg"), "needs ffmpeg")
    def test_the_pictures_are_the_reference_pictures_made_small(self):
        for chapter in front_page.PICTURES:
            small, made = front_page.pixels(front_page.thumbnail_of(chapter)), front_page.pixels(*front_page.source_of(chapter))
            self.assertEqual(len(small), 3 * front_page.WIDTH * front_page.HEIGHT, chapter)
            off = sum(abs(a - b) for a, b in zip(small, made)) / len(made)
            self.assertLess(off, 2, f"{chapter}: `python3 docs/tools/front_page.py` makes it anew")

    def test_the_film_takes_ten_seconds_and_less_than_two_megabytes(self):
        film = ROOT / "renders/09_deep_contacts/film.webp"
        times = frames_of(film)
        self.assertGreater(len(times), 100)
        self.assertAlmostEqual(sum(times) / 1000, 10, delta=1)
        self.assertLess(film.stat().st_size, 2e6)


if __name__ == "__main__":
    unittest.main()
