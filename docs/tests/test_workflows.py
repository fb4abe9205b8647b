"""The workflow files: they can be read, what a step uses is there, and each command of ours in them can be typed."""
import os
import re
import shlex
import subprocess
import unittest
from pathlib import Path

from test_commands import refusal

try:
    import yaml
except ImportError:
    yaml = None

ROOT = Path(__file__).resolve().parents[2]
EXPRESSION = re.compile(r"\$\{\{(.*?)\}\}")
TOP = {"name", "on", "permissions", "concurrency", "jobs", "env"}
OF_A_JOB = {"name", "runs-on", "container", "timeout-minutes", "strategy", "steps", "needs", "if", "permissions", "environment", "env"}
OF_A_STEP = {"name", "id", "if", "uses", "with", "run", "env"}


def files():
    listed = subprocess.run(["git", "ls-files", "*.yml", "*.yaml"], cwd=ROOT, capture_output=True, text=True, encoding="utf-8").stdout.split()
    return [ROOT / name for name in listed]


def commands(script):
    """What a script of the shell runs, one list of words for each command."""
    for line in script.splitlines():
        words, found = [], shlex.shlex(line, posix=True, punctuation_chars=True)
        found.whitespace_split = True
        for word in [*found, ";"]:
            if word not in ("&&", "||", ";", "|"):
                words.append(word)
                continue
            yield words
            if words[:2] == ["docker", "run"]:
                yield from commands(words[-1])
            words = []


def faults(text):
    """What is wrong with a workflow, one text each."""
    flow = yaml.safe_load(text)
    flow["on"] = flow.pop(True, flow.get("on"))  # in YAML 1.1 the word is a boolean
    yield from (f"unknown: {word}" for word in set(flow) - TOP)
    for name, job in flow["jobs"].items():
        yield from (f"{name}: unknown: {word}" for word in set(job) - OF_A_JOB)
        needs = job.get("needs", [])
        yield from (f"{name} needs {other}, which is no job" for other in ([needs] if isinstance(needs, str) else needs) if other not in flow["jobs"])
        given = {key for row in job.get("strategy", {}).get("matrix", {}).get("include", []) for key in row}
        yield from (f"{name}: the matrix has no {used}" for used in re.findall(r"matrix\.(\w+)", str(job["steps"])) if used not in given)
        for step in job["steps"]:
            yield from (f"{name}: unknown: {word}" for word in set(step) - OF_A_STEP)
            if ("uses" in step) == ("run" in step):
                yield f"{name}: a step that neither runs nor uses one thing: {step}"
            if "uses" in step and not re.fullmatch(r"[\w-]+/[\w/-]+@v\d+", step["uses"]):
                yield f"{name}: no version: {step['uses']}"
            for words in commands(EXPRESSION.sub("", step.get("run", ""))):
                yield from command_faults(name, words)


def command_faults(name, words):
    if "./course" in words:
        passed = [re.sub(r"^\$GITHUB_\w+$", "file", word) for word in words[words.index("./course") + 1:]]
        passed = tuple(word for word in passed if not word.startswith("$") and word != "--no-install")  # a list of exercises may be empty
        if said := refusal(passed):
            yield f"{name}: ./course {' '.join(passed)}: {said.splitlines()[0]}"
    if ".ci/bare_root" in words:
        known = (ROOT / ".ci/bare_root").read_text(encoding="utf-8")
        yield from (f"{name}: .ci/bare_root does not know {word}" for word in words if word.startswith("--") and not re.search(rf"{word}\b", known))


@unittest.skipUnless(yaml or os.environ.get("CI") == "true", "needs python3-yaml (./course setup style)")
class Workflows(unittest.TestCase):
    def test_each_can_be_read_and_what_it_runs_can_be_typed(self):
        self.assertGreater(len(files()), 2)
        for path in files():
            with self.subTest(path.relative_to(ROOT).as_posix()):
                self.assertEqual(list(faults(path.read_text(encoding="utf-8"))), [])

    def test_a_fault_is_told(self):
        text = """{on: push, jobs: {a: {runs-on: x, needs: b, steps: [{uses: actions/checkout}, {run: ./course docs --pfd}, {run: "true ${{matrix.c}}", user: me},
            {run: sudo .ci/bare_root trixie --slow}]}}}"""
        told = "\n".join(faults(text))
        for fault in ("a needs b, which is no job", "the matrix has no c", "no version: actions/checkout", "docs --pfd", "unknown: user", "does not know --slow"):
            self.assertIn(fault, told)
        self.assertEqual(len(list(faults(text))), 6)


if __name__ == "__main__":
    unittest.main()
