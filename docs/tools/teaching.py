"""For instructors: the goals of each chapter and the minutes of each section, from chapters/NN_name/teaching.toml."""
import re
import tomllib

from exercise_pages import by_chapter

NOT_TAUGHT = {"Exercises", "For the curious", "Try it", "Further reading", "What changed"}  # sections without minutes of their own


class TeachingError(Exception):
    """A chapter's plan and its page do not fit together; the message names the file."""


def plan_of(root, page):
    """Goals and minutes of one chapter.
    @throws TeachingError  a section of the page has no minutes, or minutes have no section"""
    path = root / "chapters" / page.folder / "teaching.toml"
    plan = tomllib.loads(path.read_text(encoding="utf-8"))
    sections = [match[1].strip() for line in page.lines if (match := re.match(r"## (.+?)(?:\s*\{#\w+\})?\s*$", line))]
    taught = [section for section in sections if section not in NOT_TAUGHT]
    for section in taught:
        if section not in plan["minutes"]:
            raise TeachingError(f"{path}: no minutes for the section '{section}'")
    for section in plan["minutes"]:
        if section not in taught:
            raise TeachingError(f"{path}: there is no section '{section}'")
    return plan["goals"], [(section, plan["minutes"][section]) for section in taught]


def block(root, kind, chapters):
    """All chapters' goals, or all sections' minutes, as Markdown."""
    told = []
    exercises = by_chapter(root)
    for page in chapters:
        goals, minutes = plan_of(root, page)
        told += ["", f"### {page.title}", ""]
        if kind == "goals":
            told += [f"A student who has worked through \\ref {page.label} \"the chapter\" can", "", *(f"- {goal}" for goal in goals)]
        else:
            practice = sum(exercise.minutes for exercise in exercises.get(page.folder, []))
            told += ["<div class=\"data\">", "", "| Section | Minutes |", "|:--|--:|", *(f"| {section} | {m} |" for section, m in minutes),
                     f"| **to read and discuss** | **{sum(m for _, m in minutes)}** |", f"| exercises, all | {practice} |", "", "</div>"]
    return "\n".join(told)
