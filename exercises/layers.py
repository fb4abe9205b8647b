"""Proves the tests of the layers: one of the layer's own tests has to notice each wrong version (wrong_versions.py)."""
import functools
import re
import shutil
import tempfile
from pathlib import Path

import workshop
from catalogue import ROOT, CatalogueError
from judge import run_cases
from wrong_versions import write_fails

FEWEST = {"04_friction": 16}  # its laws and its passes; for all others
FEWEST_OF_A_LAYER = 8
SECONDS = 600                 # all tests of a layer; who takes longer runs in circles


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
    @param renew  when another test noticed than is written down, write that one down
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
    source = sources / version.source
    if not source.is_file():
        raise workshop.DoesNotCompile(f"changes {version.source}, which is not there")
    source.write_text(version.applied(source.read_text(encoding="utf-8")), encoding="utf-8")
    changed = {pattern: folder / f"{i}.o" for i, pattern in enumerate(workshop.objects_that_read(version.source, version.targets))}
    if not changed:
        raise workshop.DoesNotCompile(f"changes {version.source}, which no test of its layer reads")
    for pattern, own in changed.items():
        workshop.compile_copy(pattern, sources, own)
    return changed


def without_data(folder, names):
    return [name for name in names if not (Path(folder) / name).is_dir() and not name.endswith((".cpp", ".hpp"))]


def too_few(versions):
    """What a layer lacks."""
    for layer in sorted({version.layer for version in versions}):
        count, fewest = sum(version.layer == layer for version in versions), FEWEST.get(layer, FEWEST_OF_A_LAYER)
        if count < fewest:
            yield f"{layer}: {count} wrong versions, and it needs {fewest}"
