"""A repository for students: the course without its solutions, with a workflow that judges each push."""
import shutil
import subprocess

from catalogue import ROOT

KEPT_BACK = ("solutions/", ".github/", ".ci/")
NEXT = """
{folder} holds the course without solutions. To make it the students' repository:
  cd {folder} && git init && git add . && git commit -m "The course"
Answers lie in its folder answers/, which belongs to the students. A later handout comes to them by: ./course update URL
Solutions to the exercises of the kind "rebuild" are the chapters' own files, which the course is built from; including them is found.
"""


class CannotHandOut(Exception):
    """The message says why."""


def handout(exercises, folder, exams=()):
    """Writes the students' repository into a new folder.
    @param exams  exercises that are kept back
    @throws CannotHandOut"""
    if folder.exists() and any(folder.iterdir()):
        raise CannotHandOut(f"{folder} is not empty")
    kept_back = (*KEPT_BACK, *(f"exercises/{exam.chapter}/{exam.name}." for exam in exams))
    for name in tracked_files():
        if not name.startswith(kept_back):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name, follow_symlinks=False)
    for exercise in exercises:
        for path in (exercise.stub, exercise.kept_stub):
            (folder / path.relative_to(ROOT)).write_text(exercise.stub_text(), encoding="utf-8")
    ignored = folder / ".gitignore"
    ignored.write_text("".join(line for line in ignored.read_text(encoding="utf-8").splitlines(True) if line.strip() != "/answers/"), encoding="utf-8")
    (folder / ".github/workflows").mkdir(parents=True)
    shutil.copy2(ROOT / "exercises/for_schools/check.yml", folder / ".github/workflows/check.yml")
    print(NEXT.format(folder=folder))


def tracked_files():
    done = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        raise CannotHandOut(f"only a clone of the course can be handed out: {done.stderr.strip()}")
    return [name for name in done.stdout.split("\0") if name and (ROOT / name).is_file()]
