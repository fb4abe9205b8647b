"""Wrong versions of the layers: each is a patch that one of the layer's own tests has to notice.

They lie beside these tests, chapters/NN_name/tests/wrong/NAME.patch and common/.../NAME/tests/wrong/NAME.patch. A line says what is
wrong, a second one names the test that notices ("fails: ..."), and a unified diff of one source file follows.
"""
import functools
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import workshop
from catalogue import ROOT, CatalogueError, shown
from judge import run_cases

FEWEST = {"04_friction": 16}  # its laws and its passes; for all others
FEWEST_OF_A_LAYER = 8
SECONDS = 600                 # all tests of a layer; who takes longer runs in circles
FAILS = "fails: "


@dataclass
class WrongVersion:
    """A patch of one file of a layer."""
    patch: Path
    says: str      # what is wrong
    fails: str     # the test that is expected to notice
    source: Path   # the file, as seen from the top

    @property
    def layer(self):
        """The layer's folder, as in "03_penalty_impulses" or "fem"."""
        return self.patch.parents[2].name

    @property
    def number(self):
        """The chapter's number; 0 for the base."""
        return int(self.layer[:2]) if self.layer[:2].isdigit() else 0

    @property
    def name(self):
        return f"{self.layer}/{self.patch.stem}"

    @property
    def targets(self):
        """The layer's tests and the libraries that they are of, as CMake calls them, and that of the file, which may stand in a layer
        below; a chapter has one for its experiments."""
        chapter = f"chapter{self.layer[:2]}"
        own = (f"test_{chapter}", f"{chapter}_layer", f"{chapter}_experiments") if self.number else \
            (f"test_{self.layer}", f"enduring_{self.layer}")
        folder = self.source.parent.name
        return (*own, f"chapter{folder[:2]}_layer" if folder[:2].isdigit() else f"enduring_{folder}")


def read(patch):
    """One wrong version.
    @throws CatalogueError naming the file and what it lacks"""
    lines = patch.read_text(encoding="utf-8").splitlines()
    if len(lines) < 2 or not lines[0].endswith(".") or not lines[1].startswith(FAILS):
        raise CatalogueError(f"{shown(patch)}: begins with a sentence that says what is wrong, and '{FAILS}' with a test's name")
    files = re.findall(r"^\+\+\+ b/(\S+)", "\n".join(lines), re.M)
    if len(files) != 1:
        raise CatalogueError(f"{shown(patch)}: changes {len(files)} files, and should change one")
    return WrongVersion(patch, lines[0], lines[1].removeprefix(FAILS).strip(), Path(files[0]))


def all_versions(root=ROOT):
    """Every wrong version, the chapters' first."""
    return [read(patch) for tree in ("chapters", "common") for patch in sorted((root / tree).rglob("tests/wrong/*.patch"))]


def part_of(versions, part):
    """The K-th of N parts of about the same size.
    @param part  as in "2/4"
    @throws CatalogueError"""
    match = re.fullmatch(r"(\d+)/(\d+)", part)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise CatalogueError(f"--part {part} should be K/N with 1 <= K <= N, as in 2/4")
    return versions[int(match[1]) - 1::int(match[2])]


def prepare(versions):
    """Builds what stands around the wrong versions: the tests of their layers."""
    workshop.build({version.targets[0] for version in versions})


def prove(version, renew=False):
    """Runs a layer's tests with one of its files wrong.
    @param renew  when another test noticed than the patch says, write that one into the patch
    @return (a line that says what came of it, whether that is a fault)"""
    with tempfile.TemporaryDirectory(prefix="enduring_") as folder:
        try:
            outcome = outcome_of(version, Path(folder))
        except workshop.DoesNotCompile as error:
            return f"{version.name} {error}", True
    if outcome.state == "passed":
        return f"{version.name} SURVIVES {outcome.cases} tests. {version.says}", True
    noticed = outcome.failed_cases[0] if outcome.failed_cases else version.fails
    if not passes_in_the_build(version.targets[0], noticed):
        return f'{version.name}: "{noticed}" fails without it, too', True
    if not outcome.failed_cases:  # a crash, or a loop without end
        return f"{version.name}: {outcome.message}", False
    if noticed != version.fails and renew:
        write_fails(version, noticed)
    return f'{version.name}: noticed by "{noticed}"' + ("" if noticed == version.fails else f', not by "{version.fails}"'), False


@functools.cache
def passes_in_the_build(target, test):
    """Whether a test passes with the layer as it is."""
    outcome = run_cases(workshop.BUILD / "bin" / target, [f"--test-case={as_filter(test)}"], SECONDS)
    return outcome.state == "passed"


def outcome_of(version, folder):
    """What a layer's tests say to a wrong version: first the one that is expected to notice, then all."""
    program = folder / "tests"
    workshop.link(version.targets[0], compiled(version, folder), program)
    outcome = run_cases(program, [f"--test-case={as_filter(version.fails)}"], SECONDS)
    if outcome.state == "passed":
        outcome = run_cases(program, ["--abort-after=1"], SECONDS)
    return outcome


def as_filter(name):
    """A test's name as doctest's filter, in which a comma would end it."""
    return re.sub(r"[^\w ]", "?", name)


def compiled(version, folder):
    """The objects of the layer and its tests that a wrong version changes, by the build's name for each.
    @throws DoesNotCompile"""
    sources = folder / "sources"
    for tree in ("chapters", "common"):
        shutil.copytree(ROOT / tree, sources / tree, ignore=without_data)
    apply(version.patch, sources)
    changed = {pattern: folder / f"{i}.o" for i, pattern in enumerate(workshop.objects_that_read(version.source, version.targets))}
    if not changed:
        raise workshop.DoesNotCompile(f"changes {version.source}, which no test of its layer reads")
    for pattern, own in changed.items():
        workshop.compile_copy(pattern, sources, own)
    return changed


def without_data(folder, names):
    return [name for name in names if not (Path(folder) / name).is_dir() and not name.endswith((".cpp", ".hpp"))]


def apply(patch, sources, *options):
    """Applies a patch to a copy of the sources, also where lines have moved, and one line of context has changed.
    @param options  more of git apply's, as in --check
    @throws DoesNotCompile"""
    done = subprocess.run(["git", "apply", "--recount", "-C2", *options, "-"], cwd=sources, input=patch.read_text(encoding="utf-8"), text=True,
                          capture_output=True, env={"GIT_CEILING_DIRECTORIES": str(sources.parent), "PATH": "/usr/bin:/bin"})
    if done.returncode:
        raise workshop.DoesNotCompile(f"does not apply any more: {done.stderr.strip()}")


def write_fails(version, noticed):
    lines = version.patch.read_text(encoding="utf-8").split("\n")
    lines[1] = FAILS + noticed
    version.patch.write_text("\n".join(lines), encoding="utf-8")


def too_few(versions):
    """What a layer lacks."""
    for layer in sorted({version.layer for version in versions}):
        count, fewest = sum(version.layer == layer for version in versions), FEWEST.get(layer, FEWEST_OF_A_LAYER)
        if count < fewest:
            yield f"{layer}: {count} wrong versions, and it needs {fewest}"
