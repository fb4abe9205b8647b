"""Brings the new course while answers stay: those in answers/ are nobody's but the student's, those in exercises/ are moved there first."""
import shutil
import subprocess

from catalogue import ROOT, shown


class CannotUpdate(Exception):
    """The message says why, and what to do."""


def update(exercises, origin=None):
    """@param origin  a repository whose files come over ours, as a teacher's new handout; without it, what the clone was made from
    @return the exit status
    @throws CannotUpdate"""
    if git("rev-parse", "--show-toplevel").strip() != str(ROOT):
        raise CannotUpdate("this is no clone: there is nothing to update it from")
    git("fetch", "--quiet", *(["--", origin, "HEAD"] if origin else []))
    new, base = ("FETCH_HEAD", "HEAD") if origin else ("@{upstream}", git("merge-base", "HEAD", "@{upstream}").strip())
    put_back = keep_answers(exercises, base)
    if origin:
        git("checkout", "--quiet", new, "--", ".")
    else:
        if put_back and git("diff", "--cached", "--name-only"):  # they were committed
            git("commit", "--quiet", "-m", "Answers lie in answers/", "--", *put_back)
        git("merge", "--quiet", "--no-edit", new)
    print("The course is up to date. Your answers are as they were, in answers/.")
    return 0


def keep_answers(exercises, base):
    """Moves what was written into stubs, committed or not, and puts back the stubs of a commit; removes answers that were not begun.
    @return the stubs that were put back"""
    changed, put_back = git("diff", "--name-only", "-z", base).split("\0"), []
    for exercise in exercises:
        if exercise.answer.is_file() and exercise.untouched(exercise.answer):
            exercise.answer.unlink()
        if shown(exercise.stub) in changed and exercise.stub.is_file():
            print(keep_answer(exercise))
            put_back.append(shown(exercise.stub))
    if put_back:
        git("checkout", "--quiet", base, "--", *put_back)
    return put_back


def keep_answer(exercise):
    """Moves what was written into a stub to the student's own folder.
    @return a line that says so"""
    place, count = exercise.answer, 1
    while place.exists():
        count += 1
        place = exercise.answer.with_name(f"{exercise.name}.{count}.txt")
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.move(exercise.stub, place)
    return f"{shown(exercise.stub)}: what you wrote there is now {shown(place)}"


def git(*words):
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, errors="replace")
    if done.returncode:
        raise CannotUpdate(f"git {words[0]}: {done.stderr.strip()}")
    return done.stdout
