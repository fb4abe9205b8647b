"""A release: refused while something is missing, else a dated changelog, a citation, a commit and a tag. And the address: one place for it."""
import io
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import address  # noqa: E402
import release  # noqa: E402

FILES = {
    "docs/address.toml": 'repository = "https://example.org/me/course"\nbook = "https://me.example.org/course"\n',
    "README.md": "# Course\n<!-- address: first_screen -->\nold\n<!-- /address -->\n",
    "docs/your_machine.md": "# Machine\n<!-- address: clone -->\nold\n<!-- /address -->\n",
    "CITATION.cff": 'version: "0.1"\nlicense: MIT\n',
    "CHANGELOG.md": "# Changelog\n\n## [Unreleased]\n\n### Added\n- A thing.\n\n## [0.1] - 2020-01-01\n- The first.\n",
}


class ACourse(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.root = Path(held.name)
        for name, text in FILES.items():
            (self.root / name).parent.mkdir(exist_ok=True)
            (self.root / name).write_text(text)
        for module in (address, release):
            patch = mock.patch.object(module, "ROOT", self.root)
            patch.start()
            self.addCleanup(patch.stop)
        self.git("init", "--quiet")
        self.git("config", "user.name", "me")
        self.git("config", "user.email", "me@example.org")
        self.commit()

    def git(self, *words):
        return subprocess.run(["git", "-C", self.root, *words], capture_output=True, text=True, check=True).stdout

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--allow-empty", "--message", "x")

    def release(self, *words):
        with mock.patch.object(sys, "argv", ["release.py", *words]), redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
            status = release.main()
        return status, out.getvalue() + err.getvalue()

    def read(self, name):
        return (self.root / name).read_text()

    def test_a_release_dates_cites_links_commits_and_tags(self):
        self.assertEqual(self.release("0.2")[0], 0)
        self.assertRegex(self.read("CHANGELOG.md"), r"## \[Unreleased\]\n\n## \[0\.2\] - \d{4}-\d\d-\d\d\n\n### Added\n- A thing\.")
        self.assertRegex(self.read("CITATION.cff"), r'version: "0\.2"\ndate-released: "\d{4}-\d\d-\d\d"\nrepository-code: "https://example\.org/me/course"\nurl: "https://me')
        self.assertIn("(https://me.example.org/course/lab.html)", self.read("README.md"))
        self.assertIn("git clone https://example.org/me/course ", self.read("docs/your_machine.md"))
        self.assertEqual((self.git("tag"), self.git("status", "--porcelain")), ("v0.2\n", ""))
        self.assertEqual(self.release("0.2")[0], 1)

    def test_what_is_in_the_way_is_told_and_nothing_changes(self):
        for name, old, new, told in (("docs/address.toml", '"https://me.example.org/course"', '""', "no book"), ("docs/address.toml", "https://ex", "ex", "is no address"),
                                     ("CHANGELOG.md", "- A thing.\n", "", "nothing stands below"), ("CITATION.cff", "0.1", "0.2", "does not come after 0.2")):
            with self.subTest(told):
                (self.root / name).write_text(FILES[name].replace(old, new))
                self.commit()
                status, said = self.release("0.2")
                self.assertEqual(status, 1)
                self.assertIn(told, said)
                (self.root / name).write_text(FILES[name])
                self.commit()
        (self.root / "README.md").write_text("changed")
        self.assertIn("not committed", self.release("0.2")[1])
        self.assertEqual(self.git("tag"), "")

    def test_check_changes_nothing(self):
        self.assertEqual(self.release("0.2", "--check"), (0, "Nothing is in the way of 0.2.\n"))
        self.assertEqual(self.git("tag"), "")

    def test_without_an_address_the_pages_say_what_makes_the_book(self):
        nowhere = {"repository": "", "book": ""}
        self.assertIn("./course docs --live", address.written(FILES["README.md"], nowhere))
        self.assertEqual(address.cited(address.cited(FILES["CITATION.cff"], {"repository": "https://a", "book": "https://b"}), nowhere), FILES["CITATION.cff"])


class TheCourse(unittest.TestCase):
    def test_the_pages_have_the_address_of_its_one_place(self):
        self.assertEqual(list(address.renewed(address.ROOT)), [])


if __name__ == "__main__":
    unittest.main()
