"""What a class hands in, in all the shapes that schools' systems give it."""
import io
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import submissions  # noqa: E402


def exercise(number, chapter, name):
    return SimpleNamespace(number=number, chapter=chapter, name=name, untouched=lambda path: path.read_text() == "stub")


EXERCISES = [exercise("1.2", "01_fall", "2_fall"), exercise("2.1", "02_rise", "1_rise")]


class Collecting(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name, "class")
        self.folder.mkdir()
        self.scratch = Path(held.name, "scratch")

    def put(self, name, text="mine"):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def zipped(self, name, files):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        with zipfile.ZipFile(self.folder / name, "w") as archive:
            for inside, text in files.items():
                archive.writestr(inside, text)

    def collected(self, folder=None, **options):
        """{student: {exercise: what the file holds}}"""
        found = submissions.collect(folder or self.folder, EXERCISES, self.scratch, **options)
        return {student: {number: file.read_text() for number, file in attempts.items()} for student, attempts in found.items()}

    def test_folders_flat_and_nested(self):
        for student, place in (("Ada", ""), ("Ben", "01_fall/"), ("Cid", "exercises/01_fall/"), ("O'Brien", "my work/homework 1/"), ("Jörg", "answers/01_fall/")):
            self.put(f"{student}/{place}2_fall.cpp", student)
        self.assertEqual(self.collected(), {name: {"1.2": name} for name in ("Ada", "Ben", "Cid", "Jörg", "O'Brien")})

    def test_files_with_the_name_of_their_student(self):
        self.put("lovelaceada_2_fall.cpp", "a")
        self.put("lovelaceada_12345_67890_1_rise-1.cpp", "b")
        self.put("Jörg Müller - 2_fall (2).cpp", "c")
        self.assertEqual(self.collected(), {"Jörg Müller": {"1.2": "c"}, "lovelaceada": {"1.2": "a"}, "lovelaceada_12345_67890": {"2.1": "b"}})

    def test_zip_files_of_a_student_in_a_folder_and_of_the_class(self):
        self.zipped("Ada.zip", {"work/2_fall.cpp": "a", "work/1_rise.cpp": "r"})
        self.zipped("Ben Bit_123_assignsubmission_file_/all.zip", {"2_fall.cpp": "b"})
        expected = {"Ada": {"1.2": "a", "2.1": "r"}, "Ben Bit_123_assignsubmission_file_": {"1.2": "b"}}
        self.assertEqual(self.collected(), expected)
        whole = self.folder.parent / "whole.zip"
        with zipfile.ZipFile(whole, "w") as archive:
            for file in self.folder.rglob("*.zip"):
                archive.write(file, Path("submissions", file.relative_to(self.folder)))
        self.scratch = self.folder.parent / "another"
        self.assertEqual(self.collected(whole), expected)

    def test_of_several_files_the_one_that_was_begun(self):
        self.put("Ada/exercises/01_fall/2_fall.cpp", "stub")
        self.put("Ada/answers/01_fall/2_fall.cpp", "begun")
        self.put("Ben/exercises/01_fall/2_fall.cpp", "begun")
        self.put("Ben/answers/01_fall/2_fall.cpp", "stub")
        self.assertEqual(self.collected(), {"Ada": {"1.2": "begun"}, "Ben": {"1.2": "begun"}})

    def test_a_clone_does_not_hand_in_our_solution(self):
        self.put("Ada/course", "")
        for place in ("solutions/01_fall", "build/exercises/proof/1.2/solution", ".git/x"):
            self.put(f"Ada/{place}/2_fall.cpp", "solution")
        self.assertEqual(self.collected(), {"Ada": {}})
        self.put("Ben/solutions/2_fall.cpp", "mine")
        self.assertEqual(self.collected()["Ben"], {"1.2": "mine"})

    def test_one_student(self):
        self.put("2_fall.cpp", "a")
        self.assertEqual(self.collected(one=True), {"class": {"1.2": "a"}})

    def test_a_zip_file_writes_nothing_outside_and_brings_no_links(self):
        self.zipped("Ada.zip", {"../../../2_fall.cpp": "up", "/tmp/1_rise.cpp": "down"})
        link = zipfile.ZipInfo("2_fall.cpp")
        link.external_attr = 0o120777 << 16
        with zipfile.ZipFile(self.folder / "Eve.zip", "w") as archive:
            archive.writestr(link, "/etc/passwd")
        self.assertEqual(self.collected(), {"Ada": {"1.2": "up", "2.1": "down"}, "Eve": {}})
        outside = [path for path in self.folder.parent.rglob("*.cpp") if self.scratch not in path.parents]
        self.assertEqual(outside, [])

    def test_a_bomb_is_cut_and_a_damaged_file_is_told(self):
        with zipfile.ZipFile(self.folder / "Ada.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("2_fall.cpp", b"/" * (50 << 20))
        self.zipped("Ben.zip", {"2_fall.cpp": "text that will be damaged"})
        damaged = bytearray((self.folder / "Ben.zip").read_bytes())
        damaged[45] ^= 255
        (self.folder / "Ben.zip").write_bytes(damaged)
        with mock.patch("sys.stderr", io.StringIO()) as told:
            found = submissions.collect(self.folder, EXERCISES, self.scratch)
        self.assertEqual(found["Ada"]["1.2"].stat().st_size, submissions.LONGEST + 1)
        self.assertEqual(found["Ben"], {})
        self.assertIn("Ben: cannot be unpacked", told.getvalue())

    def test_links_are_not_followed(self):
        self.put("Ada/2_fall.cpp")
        (self.folder / "Eve").mkdir()
        (self.folder / "Eve/2_fall.cpp").symlink_to(self.folder / "Ada/2_fall.cpp")
        (self.folder / "Mal").symlink_to(self.folder / "Ada")
        self.assertEqual(self.collected(), {"Ada": {"1.2": "mine"}, "Eve": {}})


if __name__ == "__main__":
    unittest.main()
