"""The chapter's scene, run with a student's code, and its picture beside the one of the chapter's own code."""
import html
import shutil

import sandbox
import workshop
from catalogue import ROOT, shown
from judge import SEEN

SECONDS = 120
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title><style>
body {{ font-family: sans-serif; margin: 2em; color-scheme: light dark; background: Canvas; color: CanvasText; }}
main {{ display: flex; flex-wrap: wrap; gap: 1.5em; }} figure {{ margin: 0; flex: 1 1 24em; }} img {{ max-width: 100%; }}
</style></head><body><h1>{title}</h1><p>The experiment <code>{scene}</code> of chapter {chapter}, in its small version:
{verdict}</p><main>
<figure><img src="yours/{picture}" alt="the picture made with your code"><figcaption>with your code</figcaption></figure>
<figure><img src="reference/{picture}" alt="the reference picture"><figcaption>with the chapter's code</figcaption></figure>
</main></body></html>
"""


def lay_beside(exercise, folder):
    """Runs the experiment of a rebuild twice, with the answer that was judged in this folder and with the chapter's own
    code, and writes a page with both pictures.

    @return (the page's path, whether the two pictures are the same byte by byte), or a sentence that says why not"""
    program = f"chapter{exercise.chapter[:2]}"
    workshop.link_instead(program, folder / "answer.o", folder / "program")
    for name, run in (("yours", folder / "program"), ("reference", workshop.BUILD / "bin" / program)):
        shutil.rmtree(folder / name, ignore_errors=True)
        (folder / name).mkdir()
        done = sandbox.run([run, exercise.scene, "--quick", "--out", folder / name], ROOT, readable=[run, *(ROOT / seen for seen in SEEN)],
                           writable=[folder / name], limits=sandbox.Limits(seconds=SECONDS))
        if done.stopped:
            return f"The scene {exercise.scene} was stopped with your code: too much {done.stopped} (it may take {SECONDS} s)."
        if done.returncode or not (folder / name / exercise.picture).is_file():
            return f"The scene {exercise.scene} did not end well: {done.err.strip()[-300:]}"
    return write_page(exercise, folder)


def write_page(exercise, folder):
    yours, reference = (folder / name / exercise.picture for name in ("yours", "reference"))
    same = yours.read_bytes() == reference.read_bytes()
    page = folder / "beside.html"
    page.write_text(PAGE.format(title=html.escape(f"{exercise.number} {exercise.title}"), scene=exercise.scene,
                                chapter=int(exercise.chapter[:2]), picture=exercise.picture,
                                verdict="the two pictures are the same." if same else "the two pictures differ."), encoding="utf-8")
    return page, same


def told(result):
    """The result as lines for the terminal."""
    if isinstance(result, str):
        return result
    page, same = result
    return f"Your picture beside the chapter's{', the same to the last byte' if same else ''}: {shown(page)}"
