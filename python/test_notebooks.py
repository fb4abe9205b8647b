"""The notebooks run from the first cell to the last; each asserts what it shows. Run by ./course python; the module's folder is on PYTHONPATH."""
import os
import unittest
from pathlib import Path

os.environ.setdefault("PYDEVD_DISABLE_FILE_VALIDATION", "1")  # else each kernel warns of its debugger
try:
    import ipykernel  # noqa: F401  what a notebook's cells run in
    import nbformat
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError
except ImportError:
    nbformat = None

FOLDER = Path(__file__).resolve().parent / "notebooks"
SECONDS = 600  # for a cell, and for the start of its kernel on a busy machine


def run(notebook):
    NotebookClient(notebook, timeout=SECONDS, startup_timeout=SECONDS).execute()
    return notebook


@unittest.skipUnless(nbformat, "needs python3-nbclient and python3-ipykernel")
class Notebooks(unittest.TestCase):
    def test_each_runs_and_shows_a_picture_and_numbers(self):
        names = sorted(FOLDER.glob("*.ipynb"))
        self.assertGreaterEqual(len(names), 3)
        for name in names:
            with self.subTest(name.name):
                notebook = nbformat.read(name, 4)
                nbformat.validate(notebook)
                self.assertFalse(any(cell.get("outputs") for cell in notebook.cells), "outputs are not kept")
                kinds = {output["output_type"] for cell in run(notebook).cells for output in cell.get("outputs", [])}
                self.assertLessEqual({"stream", "display_data"}, kinds)

    def test_an_assertion_that_fails_fails_the_notebook(self):
        notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("assert 1 == 2")])
        with self.assertRaises(CellExecutionError):
            run(notebook)


if __name__ == "__main__":
    unittest.main()
