"""What the schematic drawings share: axes without marks, arrows, boxes, and inks that read on light and on dark pages."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import FancyBboxPatch

INK, BLUE, RED, GREEN = "#808890", "#3d85c6", "#d1603d", "#4a9a60"


def axes(columns=1, size=(7.2, 3.2)):
    figure, places = plt.subplots(1, columns, figsize=size, layout="constrained")
    for axis in np.atleast_1d(places):
        axis.spines[["top", "right"]].set_visible(False)
        axis.set_xticks([])
        axis.set_yticks([])
    return figure, places


def arrow(axis, begin, end, colour=INK, text="", at=(0.06, 0.06)):
    axis.annotate("", end, begin, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2, "shrinkA": 0, "shrinkB": 0})
    axis.text(end[0] + at[0], end[1] + at[1], text, color=colour, ha="center", va="center")


def box(axis, left, low, width, high, text, colour):
    axis.add_patch(FancyBboxPatch((left, low), width, high, boxstyle="round,pad=0,rounding_size=0.12", fill=False, ec=colour, lw=2))
    axis.text(left + 0.15, low + high - 0.15, text, color=colour, va="top")


def scene(size=(6, 3.9), **limits):
    """A figure of one plane without axes, equal in both directions. @param limits  xlim and ylim"""
    figure, axis = axes(size=size)
    axis.axis("off")
    axis.set(aspect="equal", **limits)
    return figure, axis


def dot(axis, place, colour=INK, text="", at=(0.1, 0.1)):
    axis.plot(*place, "o", color=colour, ms=7)
    axis.text(place[0] + at[0], place[1] + at[1], text, color=colour, ha="center", va="center")
