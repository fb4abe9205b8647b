#!/usr/bin/python3
"""Schematic drawings of the pages, which show an idea and no measurement: writes renders/drawings/NAME.svg (needs Debian's python3-matplotlib).

    docs/tools/drawings.py          all of them
    docs/tools/drawings.py FOLDER   into another folder
"""
import sys
from pathlib import Path

from drawing import INK, plt
from drawings_search import SEARCH
from drawings_solve import SOLVE

ROOT = Path(__file__).resolve().parents[2]


def main():
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "renders/drawings"
    keys = ("text.color", "axes.labelcolor", "axes.edgecolor", "axes.titlecolor")
    plt.rcParams.update({key: INK for key in keys} | {"font.size": 13, "lines.linewidth": 2, "svg.hashsalt": "drawings", "svg.fonttype": "path"})
    for name, draw in (SOLVE | SEARCH).items():
        figure = draw()
        figure.savefig(out / f"{name}.svg", transparent=True, metadata={"Date": None})
        plt.close(figure)


if __name__ == "__main__":
    main()
