"""Wrong versions of layers: what notices them, what survives, and how they are written down. On a layer of three small files."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import layers  # noqa: E402
import prove  # noqa: E402
import workshop  # noqa: E402
import wrong_versions  # noqa: E402
from catalogue import CatalogueError  # noqa: E402

SOURCES = {
    "chapters/01_fall/fall.hpp": """#pragma once

inline double half(double x)
{
    return x / 2;
}

double speed(double t);
double height(double t);
""",
    "chapters/01_fall/fall.cpp": """#include "fall.hpp"

double speed(double t)
{
    double v = 0;
    for (int i = 0; i < 10; ++i)
        v += 0.981 * t;
    return v;
}

double height(double t)
{
    return half(speed(t) * t);
}
""",
    "chapters/01_fall/tests/falls.cpp": """#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "../fall.hpp"
#include <cstdlib>
#include <doctest/doctest.h>

double drop();

TEST_CASE("fall: speed, of \\"free\\" bodies, grows with time") { CHECK(speed(2) == doctest::Approx(19.62)); }
TEST_CASE("fall: the way is half of speed times time") { CHECK(height(2) == doctest::Approx(19.62)); }
TEST_CASE("fall: a drop takes a second") { CHECK(drop() == doctest::Approx(4.905)); }
TEST_CASE("fall: on the moon" * doctest::skip(!std::getenv("MOON"))) { CHECK(speed(1) == doctest::Approx(1.62)); }
""",
    "chapters/01_fall/experiments/drop.cpp": """#include "../fall.hpp"

double drop()
{
    return height(1);
}
""",
    "build/build.ninja": """rule cxx
  command = g++ -std=c++20 -I$root -MD -MT $out -MF $out.d -o $out -c $in
  deps = gcc
  depfile = $out.d
rule ar
  command = rm -f $out && ar qc $out $in
rule link
  command = : && g++ $objects -o $out $libraries && :
build CMakeFiles/chapter01_layer.dir/chapters/01_fall/fall.cpp.o: cxx $root/chapters/01_fall/fall.cpp
build CMakeFiles/chapter01_experiments.dir/chapters/01_fall/experiments/drop.cpp.o: cxx $root/chapters/01_fall/experiments/drop.cpp
build CMakeFiles/test_chapter01.dir/chapters/01_fall/tests/falls.cpp.o: cxx $root/chapters/01_fall/tests/falls.cpp
build libchapter01_layer.a: ar CMakeFiles/chapter01_layer.dir/chapters/01_fall/fall.cpp.o
build libchapter01_experiments.a: ar CMakeFiles/chapter01_experiments.dir/chapters/01_fall/experiments/drop.cpp.o
build bin/test_chapter01: link CMakeFiles/test_chapter01.dir/chapters/01_fall/tests/falls.cpp.o | libchapter01_experiments.a libchapter01_layer.a
  objects = CMakeFiles/test_chapter01.dir/chapters/01_fall/tests/falls.cpp.o
  libraries = libchapter01_experiments.a libchapter01_layer.a
""",
}
SPEED, WAY = 'fall: speed, of "free" bodies, grows with time', "fall: the way is half of speed times time"
DROP = "fall: a drop takes a second"


@unittest.skipUnless(shutil.which("g++") and shutil.which("ninja"), "needs g++ and ninja")
class ALayer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = Path(tempfile.mkdtemp()).resolve()
        cls.addClassCleanup(shutil.rmtree, cls.root)
        for name, text in SOURCES.items():
            path = cls.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text.replace("rule cxx", f"root = {cls.root}\nrule cxx"), encoding="utf-8")
        (cls.root / "common").mkdir()
        subprocess.run(["ninja", "-C", cls.root / "build"], check=True, capture_output=True)
        for module, name, value in ((layers, "ROOT", cls.root), (workshop, "ROOT", cls.root), (workshop, "BUILD", cls.root / "build")):
            held = mock.patch.object(module, name, value)
            held.start()
            cls.addClassCleanup(held.stop)
        workshop.recorded_includes.cache_clear()
        layers.passes_in_the_build.cache_clear()
        cls.addClassCleanup(workshop.recorded_includes.cache_clear)

    def wrong(self, find, replace, fails=SPEED, file="fall.cpp", name="wrong", says="It is wrong.", more=""):
        """A wrong version, written down behind those that the layer has."""
        home = self.root / "chapters/01_fall/tests/wrong.toml"
        self.addCleanup(lambda: home.unlink(missing_ok=True))
        values = {"says": says, "fails": fails, "file": f"chapters/01_fall/{file}", "find": find, "replace": replace}
        with home.open("a", encoding="utf-8") as out:
            out.write("\n".join([f"[{name}]", *(f"{key} = {json.dumps(value)}" for key, value in values.items()), more]) + "\n")
        return home

    def version(self, *arguments, **options):
        return wrong_versions.read(self.wrong(*arguments, **options))[-1]

    def proven(self, *arguments, renew=False, **options):
        return layers.prove(self.version(*arguments, **options), renew)

    def test_the_test_that_notices_is_named(self):
        self.assertEqual(self.proven("0.981", "1.62"), (f'01_fall/wrong: noticed by "{SPEED}"', False))

    def test_another_test_than_expected_is_named_and_can_be_written_down(self):
        said, fault = self.proven("speed(t) * t", "speed(t)", fails=SPEED, renew=True)
        self.assertFalse(fault)
        self.assertEqual(said, f'01_fall/wrong: noticed by "{WAY}", not by "{SPEED}"')
        self.assertEqual(wrong_versions.all_versions(self.root)[0].fails, WAY)

    def test_renewing_keeps_all_but_the_test(self):
        self.wrong("0.981", "1.62", name="first")
        home = self.wrong("speed(t) * t", "speed(t)", fails="fall: \\\"", name="second")
        self.wrong("0.981", "1.62", name="third")
        before = home.read_text()
        layers.prove(wrong_versions.read(home)[1], renew=True)
        self.assertEqual(home.read_text(), before.replace(json.dumps("fall: \\\""), json.dumps(WAY)))

    def test_a_survivor_is_a_fault(self):
        said, fault = self.proven("v = 0;", "v = 1e-9;", says="The speed begins at a nanometre a second.")
        self.assertTrue(fault)
        self.assertEqual(said, "01_fall/wrong SURVIVES 3 tests. The speed begins at a nanometre a second.")

    def test_a_test_that_fails_by_itself_proves_nothing(self):
        with mock.patch.dict(os.environ, MOON="1"):
            said, fault = self.proven("v = 0;", "v = 1e-9;")
        self.assertTrue(fault)
        self.assertEqual(said, '01_fall/wrong: "fall: on the moon" fails without it, too')

    def test_a_header_changes_all_that_read_it(self):
        self.assertEqual(self.proven("x / 2", "x", file="fall.hpp", fails=WAY), (f'01_fall/wrong: noticed by "{WAY}"', False))

    def test_an_experiment_is_of_the_layer_too(self):
        self.assertEqual(self.proven("height(1)", "height(2)", file="experiments/drop.cpp", fails=DROP),
                         (f'01_fall/wrong: noticed by "{DROP}"', False))

    def test_a_file_that_no_test_reads_is_a_fault(self):
        shutil.copy(self.root / "chapters/01_fall/fall.cpp", self.root / "chapters/01_fall/rise.cpp")
        self.addCleanup((self.root / "chapters/01_fall/rise.cpp").unlink)
        self.assertEqual(self.proven("0.981", "1.62", file="rise.cpp"),
                         ("01_fall/wrong changes chapters/01_fall/rise.cpp, which no test of its layer reads", True))
        self.assertEqual(self.proven("0.981", "1.62", file="gone.cpp", name="gone"), ("01_fall/gone changes chapters/01_fall/gone.cpp, which is not there", True))

    def test_a_loop_without_end_counts_as_noticed_and_is_told(self):
        with mock.patch.object(layers, "SECONDS", 1):
            said, fault = self.proven("++i", "i += 0 * i")
        self.assertFalse(fault)
        self.assertIn("Stopped after 1 s: a loop does not end", said)

    def test_a_crash_counts_as_noticed_and_is_told(self):
        said, fault = self.proven("double v = 0;", "double v = *static_cast<volatile double*>(nullptr);")
        self.assertFalse(fault)
        self.assertIn(SPEED, said)

    def test_a_text_that_does_not_stand_there_once_is_a_fault(self):
        for find, count in (("double w", 0), ("double", 5)):
            said, fault = self.proven(find, "float", name=f"found_{count}")
            self.assertTrue(fault)
            self.assertIn(f"does not apply any more: its text stands {count} times in chapters/01_fall/fall.cpp, not once: {find}", said)

    def test_lines_may_have_moved_and_been_broken_elsewhere(self):
        version = self.version("for (int i = 0;\n  i < 10; ++i)", "for (int i = 0; i < 9; ++i)")
        self.assertIn("// new\n    for (int i = 0; i < 9; ++i)\n", version.applied("// new\n    for (int i = 0; i < 10;\n         ++i)\n"))

    def test_a_mistake_may_have_two_places(self):
        version = self.version("double v = 0;", "", more='[[wrong.also]]\nfind = "return v;"\nreplace = "return 0;"')
        self.assertEqual(version.applied("double v = 0; return v;"), " return 0;")

    def test_one_that_does_not_compile_is_a_fault(self):
        said, fault = self.proven("double v = 0;", "double v = ;")
        self.assertTrue(fault)
        self.assertIn("does not compile", said)

    def test_the_sources_stay_as_they_are(self):
        self.proven("0.981", "1.62")
        for name, text in SOURCES.items():
            if name.startswith("chapters"):
                self.assertEqual((self.root / name).read_text(), text)

    def test_the_whole_proof_counts_faults(self):
        for name, new in (("a", "1.62"), ("b", "0.9810000001")):
            self.wrong("0.981", new, name=name)
        with mock.patch.object(layers, "prepare"), mock.patch("builtins.print") as told:
            self.assertEqual(prove.prove_layers(wrong_versions.all_versions(self.root), False), 1)
        self.assertIn("1 faults in 2 wrong versions", told.call_args[0][0])

    def test_what_one_lacks_is_named(self):
        for key, text, told in (("says", "says = 'It is wrong'", "a full stop"), ("fails", "", "lacks the text 'fails'"), ("find", "find = ' '", "lacks the text 'find'"),
                                ("file", "file = 3", "lacks the text 'file'"), ("replace", "", "lacks the text 'replace'"), ("replace", "replace = ''\nby = ''", "unknown key: by"),
                                ("replace", "replace = ''\n[[wrong.also]]\nfind = 'x'", "a second place"), ("replace", "replace = '", "Expected")):
            with self.subTest(told):
                home = self.wrong("0.981", "1.62")
                home.write_text(re.sub(rf"^{key} = .*$", lambda _, by=text: by, home.read_text(), flags=re.M))
                with self.assertRaisesRegex(CatalogueError, f"wrong.toml: .*{told}"):
                    wrong_versions.read(home)
                home.unlink()

    def test_a_layer_needs_eight(self):
        versions = [self.version("0.981", "1.62", name=f"wrong_{i}") for i in range(7)]
        self.assertEqual(list(layers.too_few(versions)), ["01_fall: 7 wrong versions, and it needs 8"])
        self.assertEqual(list(layers.too_few(versions + versions[:1])), [])


class TheCourse(unittest.TestCase):
    """What takes hours to prove in full, CI proves a part of at each commit; that every wrong version applies is known in a second."""

    def test_every_wrong_version_applies(self):
        for version in wrong_versions.all_versions():
            with self.subTest(version.name):
                source = wrong_versions.ROOT / version.source
                self.assertTrue(source.is_file(), version.source)
                text = source.read_text(encoding="utf-8")
                self.assertNotEqual(version.applied(text), text)

    def test_names_are_given_once_in_a_layer(self):
        names = [version.name for version in wrong_versions.all_versions()]
        self.assertEqual(len(names), len(set(names)))


class Parts(unittest.TestCase):
    def test_the_parts_together_are_all_and_each_once(self):
        for count in (1, 2, 5, 7):
            parts = [layers.part_of(list(range(23)), f"{k}/{count}") for k in range(1, count + 1)]
            self.assertEqual(sorted(sum(parts, [])), list(range(23)))
            self.assertLessEqual(max(map(len, parts)) - min(map(len, parts)), 1)

    def test_a_part_that_cannot_be_is_refused(self):
        for part in ("0/3", "4/3", "2", "a/b", "1/0"):
            with self.assertRaises(CatalogueError):
                layers.part_of([1, 2, 3], part)

    def test_of_sources_that_stand_together_in_one_file_of_the_build_the_copies_are_compiled(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            together, seen = folder / "unity_0_cxx.cxx", []
            together.write_text(f'#include "{workshop.ROOT}/chapters/a.cpp"\n#include "{workshop.ROOT}/chapters/b.cpp"\n', encoding="utf-8")
            command = ("c++", f"-I{workshop.ROOT}", "-o", "Unity/unity_0_cxx.cxx.o", "-c", str(together))
            with mock.patch.object(workshop, "last_command", return_value=command), \
                    mock.patch.object(workshop, "run_tool", side_effect=lambda words, _: seen.extend(words) or mock.Mock(returncode=0)):
                workshop.compile_copy("Unity/unity_0_cxx.cxx.o", folder / "sources", folder / "0.o")
            self.assertEqual(seen[:-1], ["c++", f"-I{folder}/sources", "-o", f"{folder}/0.o", "-c", f"{folder}/0.cxx"])
            self.assertEqual((folder / "0.cxx").read_text(encoding="utf-8"),
                             f'#include "{folder}/sources/chapters/a.cpp"\n#include "{folder}/sources/chapters/b.cpp"\n')


if __name__ == "__main__":
    unittest.main()
