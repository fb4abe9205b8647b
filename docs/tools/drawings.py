#!/usr/bin/python3
"""Schematic drawings of the pages, which show an idea and no measurement: writes renders/drawings/NAME.svg (needs Debian's python3-matplotlib).

    docs/tools/drawings.py          all of them
    docs/tools/drawings.py FOLDER   into another folder
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import FancyBboxPatch, Polygon

ROOT = Path(__file__).resolve().parents[2]
INK, BLUE, RED, GREEN = "#808890", "#3d85c6", "#d1603d", "#4a9a60"  # they read on light and on dark pages


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


def potentials():
    """Chapter 7, formulas 1 and 2: the potential of the normal spring, and that of lagged friction."""
    figure, (normal, friction) = axes(2)
    depth = np.linspace(-1, 1, 200)
    normal.plot(depth, np.minimum(depth, 0) ** 2, color=BLUE)
    normal.axvline(0, color=INK, lw=0.8, ls=":")
    normal.set(xlabel="$\\delta_1$", title="normal spring")
    normal.text(-0.55, 0.75, "pressed:\nparabola", color=BLUE)
    normal.text(0.35, 0.08, "free: zero", color=BLUE)
    slip, limit = np.linspace(-1.6, 1.6, 300), 0.6
    friction.plot(slip, np.where(abs(slip) < limit, slip**2 / 2, limit * abs(slip) - limit**2 / 2), color=RED)
    for border in (-limit, limit):
        friction.axvline(border, color=INK, lw=0.8, ls=":")
    friction.set(xlabel="$Y$", title="lagged friction")
    friction.text(0, 0.35, "holds:\nparabola", color=RED, ha="center")
    friction.text(1.1, 0.12, "slips:\nslope $F/\\Delta t$", color=RED, ha="center")
    return figure


def box(axis, left, low, width, high, text, colour):
    axis.add_patch(FancyBboxPatch((left, low), width, high, boxstyle="round,pad=0,rounding_size=0.12", fill=False, ec=colour, lw=2))
    axis.text(left + 0.15, low + high - 0.15, text, color=colour, va="top")


def loops():
    """Chapter 7: what repeats within what, from the step to the line search."""
    figure, axis = axes(size=(7.2, 3.9))
    axis.axis("off")
    box(axis, 0, 0, 10, 5.6, "step: pairs, their stiffness, last impulses", INK)
    box(axis, 0.4, 0.35, 9.2, 4.6, "round: normals, velocities and limits of the last motion", GREEN)
    box(axis, 0.8, 0.7, 4.7, 3.6, "Newton's method:\ngradient and Hessian", BLUE)
    box(axis, 1.2, 1.05, 3.9, 1.7, "line search:\nuntil the slope\nis a tenth", RED)
    axis.text(5.75, 4.1, "mix with the last rounds;\nimpulses act on the bodies", color=GREEN, va="top")
    axis.text(5.75, 2.5, "small residual:\nlevers follow, and pairs\nthat are too soft stiffen", color=GREEN, va="top")
    axis.set(xlim=(-0.1, 10.1), ylim=(-0.1, 5.7))
    return figure


def lift():
    """Chapter 11: a slipping contact is exact. Its velocity, lifted by mu |u_t|, is at right angles to its impulse, at the border of the cone."""
    figure, axis = axes(size=(6, 4))
    axis.axis("off")
    mu = 0.6
    axis.add_patch(Polygon([(-1.5, 2.5), (0, 0), (1.5, 2.5)], closed=False, fill=True, fc=INK, alpha=0.18))
    axis.plot([-1.5, 0, 1.5], [2.5, 0, 2.5], color=INK, lw=1)
    axis.text(0, 2.2, "cone of friction", color=INK, ha="center")
    axis.axhline(0, color=INK, lw=0.8)
    slip = 1.3
    arrow(axis, (0, 0), (slip, 0), RED, "$u$", (0.1, -0.16))
    arrow(axis, (slip, 0), (slip, mu * slip), INK, "", (0, 0))
    axis.text(slip + 0.08, mu * slip / 2, "lift $\\mu\\,|u_t|$", color=INK, va="center")
    arrow(axis, (0, 0), (slip, mu * slip), GREEN, "$\\tilde u$", (0.1, 0.12))
    arrow(axis, (0, 0), (-mu * 1.8, 1.8), BLUE, "$r$", (-0.14, 0.1))
    corner = 0.16 * np.array([np.array([1, mu]), np.array([1 - mu, 1 + mu]), np.array([-mu, 1])]) / np.hypot(1, mu)
    axis.plot(*corner.T, color=INK, lw=1)
    axis.set(xlim=(-1.9, 2.3), ylim=(-0.35, 2.6), aspect="equal")
    return figure


def rod():
    """Chapter 11: Painlevé's rod slides with its lower end ahead; friction turns it so that this end is pressed into the ground."""
    figure, axis = axes(size=(6, 3.9))
    axis.axis("off")
    angle = np.arctan(2)
    top = 2.4 * np.array([np.cos(angle), np.sin(angle)])
    axis.axhline(0, color=INK, lw=2)
    axis.plot([0, top[0]], [0, top[1]], color=INK, lw=6, solid_capstyle="round")
    axis.plot(*top / 2, "o", color="white", mec=INK, ms=8)
    arc = np.linspace(0, angle, 40)
    axis.plot(0.5 * np.cos(arc), 0.5 * np.sin(arc), color=INK, lw=1)
    axis.text(0.52, 0.33, "$a$", color=INK)
    arrow(axis, (-0.4, 0.55), (-1.3, 0.55), RED, "slides", (0.4, 0.2))
    arrow(axis, (0, 0), (0, 1.3), BLUE, "$r_n$", (-0.22, 0.05))
    arrow(axis, (0, 0), (1.3, 0), GREEN, "$\\mu\\,r_n$", (0.2, 0.2))
    arc = np.linspace(np.radians(70), np.radians(150), 40)
    centre, radius = top / 2, 0.55
    axis.plot(centre[0] + radius * np.cos(arc), centre[1] + radius * np.sin(arc), color=GREEN, lw=1.2)
    arrow(axis, centre + radius * np.array([np.cos(arc[-2]), np.sin(arc[-2])]), centre + radius * np.array([np.cos(arc[-1]), np.sin(arc[-1])]) + [-0.02, -0.05], GREEN)
    axis.text(centre[0] - 0.75, centre[1] + 0.45, "turns", color=GREEN, ha="center")
    axis.set(xlim=(-1.7, 2.2), ylim=(-0.25, 2.4), aspect="equal")
    return figure


DRAWINGS = {"potentials": potentials, "loops": loops, "lift": lift, "rod": rod}


def main():
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "renders/drawings"
    keys = ("text.color", "axes.labelcolor", "axes.edgecolor", "axes.titlecolor")
    plt.rcParams.update({key: INK for key in keys} | {"font.size": 13, "lines.linewidth": 2, "svg.hashsalt": "drawings", "svg.fonttype": "path"})
    for name, draw in DRAWINGS.items():
        draw().savefig(out / f"{name}.svg", transparent=True, metadata={"Date": None})


if __name__ == "__main__":
    main()
