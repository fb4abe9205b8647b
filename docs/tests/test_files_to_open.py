"""How the files that a reader opens are counted, on a small project of known size; and what they may be in ours."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
from files_to_open import READERS, ROOT, files_to_open, lines_of, names_of


class FilesToOpen(unittest.TestCase):
    def test_a_header_brings_its_source_and_what_either_includes_once(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "a").mkdir()
            for name, text in {"a/entry.hpp": '#include <vector>\n#include "a/part.hpp"\n', "a/entry.cpp": '#include "a/entry.hpp"\n#include "beside.hpp"\n',
                               "a/part.hpp": '#include "outside/library.hpp"\n', "a/beside.hpp": '#include "a/part.hpp"\n',
                               "a/beside.cpp": "int x;\n", "a/stranger.hpp": '#include "a/entry.hpp"\n'}.items():
                (root / name).write_text(text)
            found = files_to_open(["a/entry.hpp"], root)
            self.assertEqual({file.name for file in found}, {"entry.hpp", "entry.cpp", "part.hpp", "beside.hpp", "beside.cpp"})
            self.assertEqual({file.name for file in found[root / "a/part.hpp"]}, {"entry.hpp", "beside.hpp"})
            self.assertEqual(lines_of(found), 7)

    def test_the_entries_exist_and_a_higher_chapter_opens_more(self):
        counts = []
        for reader, entries in READERS.items():
            for entry in entries:
                self.assertTrue((ROOT / entry).is_file(), entry)
            if "the layer" in reader:
                counts.append(len(files_to_open(entries)))
        # chapter 8 finds its pairs without what chapters 5 and 6 remember, so it begins a count of its own
        self.assertEqual(counts[:7], sorted(counts[:7]))
        self.assertEqual(counts[7:-1], sorted(counts[7:-1]))
        self.assertLess(counts[7], counts[6])
        self.assertLess(counts[-1], counts[7])  # the other solvers of chapter 13 stand on the base alone

    def test_a_layer_names_headers_of_others_once_and_none_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "chapters/02_b").mkdir(parents=True)
            for name, text in {"main.cpp": '#include "chapters/01_a/main.hpp"\n', "one.hpp": '#include "chapters/01_a/a.hpp"\n',
                               "two.cpp": '#include "chapters/02_b/one.hpp"\n#include "chapters/01_a/a.hpp"\n#include <vector>\n'}.items():
                (root / "chapters/02_b" / name).write_text(text)
            own, foreign = names_of("chapters/02_b", root)
            self.assertEqual({file.name for file in own}, {"one.hpp", "two.cpp"})
            self.assertEqual(foreign, {"chapters/01_a/a.hpp"})

    def test_the_physics_measures_and_reads_nothing(self):
        for file in set().union(*(files_to_open(entries) for entries in READERS.values())):
            for folder in ("common/experiments", "common/scenes", "common/worked_step"):
                self.assertNotIn(folder, file.as_posix())


if __name__ == "__main__":
    unittest.main()
