"""Drawings about the solve: chapters 7 and 11."""
import numpy as np
from drawing import BLUE, GREEN, INK, RED, arrow, axes, box, scene
from matplotlib.patches import Polygon


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


def line_search():
    """Chapter 7: the energy along the direction of Newton's method; a step is taken where the slope is less than a tenth of that at its beginning."""
    figure, axis = axes(size=(6.4, 3.4))
    place = np.linspace(0, 1.75, 300)
    energy = lambda s: np.where(s < 0.7, 1 - 1.05 * s + 0.2 * s**2, 1 - 1.05 * s + 0.2 * s**2 + 1.4 * (s - 0.7) ** 2)
    slope = lambda s: (energy(s + 1e-4) - energy(s - 1e-4)) / 2e-4
    axis.plot(place, energy(place), color=BLUE)
    taken = place[np.abs(slope(place)) < 0.1 * abs(slope(1e-3))]
    axis.axvspan(taken[0], taken[-1], color=GREEN, alpha=0.2, lw=0)
    axis.text(taken.mean(), 1.02, "slope below\na tenth", color=GREEN, ha="center", va="top")
    axis.plot([0, 0.45], [1, 1 + 0.45 * slope(1e-3)], color=RED, lw=1.5)
    axis.text(0.02, 0.62, "slope at\nthe start", color=RED)
    axis.plot(1, energy(1.0), "o", color=INK, ms=7)
    axis.text(1.03, float(energy(1.0)) - 0.03, "whole step of Newton's method", color=INK, va="top")
    axis.axvline(0.7, color=INK, lw=0.8, ls=":")
    axis.text(0.68, 0.12, "here a pair\nbegins to push", color=INK, ha="right")
    axis.set(xlabel="along the direction", ylabel="$\\Phi$", ylim=(0, 1.08), xlim=(0, 1.75))
    return figure


def wedge():
    """Chapter 8: a cube between two planes that lean; each pushes with N, and its friction holds with mu times the N found before."""
    figure, axis = scene(xlim=(-2.4, 2.4), ylim=(-1.5, 1.75))
    lean = np.radians(20)
    along, across = np.array([np.sin(lean), np.cos(lean)]), np.array([np.cos(lean), -np.sin(lean)])
    for side in (-1, 1):
        mirror = np.array([side, 1])
        foot = np.array([0.42, -1.1])
        axis.plot(*np.array([mirror * foot, mirror * (foot + 2.7 * along)]).T, color=INK, lw=3)
    body = [np.array([-0.76, -0.17]), np.array([0.76, -0.17]), np.array([1.12, 0.83]), np.array([-1.12, 0.83])]
    axis.add_patch(Polygon(body, closed=True, fc=BLUE, alpha=0.3, ec=BLUE, lw=2))
    for side in (-1, 1):
        mirror, touch = np.array([side, 1]), np.array([0.94, 0.33])
        arrow(axis, mirror * touch, mirror * (touch + 0.75 * np.array([-across[0], -across[1]])), RED, "$N$", (0.05, 0.14))
        arrow(axis, mirror * touch, mirror * (touch + 0.85 * along), GREEN, "$\\mu N_0$", (0.36 * side, 0.0))
    arrow(axis, (0, 0.2), (0, -0.75), INK, "$W$", (0.18, 0.05))
    axis.plot([-0.42, -0.42], [-1.1, -0.3], color=INK, lw=0.8, ls=":")
    axis.text(-0.53, -0.4, "$\\alpha$", color=INK, ha="center")
    return figure


def spectrum():
    """Chapter 11: what a pass leaves of an error, over the eigenvalue of the response, scaled by the masses that contacts feel."""
    figure, axis = axes(size=(6.4, 3.4))
    value = np.logspace(-8, 0.5, 300)
    for h, colour, name in ((1e2, RED, "$h = 10^2$"), (1e4, GREEN, "$h = 10^4$"), (1e6, BLUE, "$h = 10^6$")):
        axis.semilogx(value, 1 / (1 + h * value), color=colour)
        axis.text(0.2 / h, 0.46, name, color=colour, ha="center", va="center")
    axis.text(1.5e-8, 1.12, "contacts that depend on each other: an error stays", color=INK)
    axis.text(2.5, 0.4, "single contacts:\nan error goes", color=INK, ha="right")
    axis.set(xlabel="eigenvalue $w$ of the scaled response", ylabel="$1/(1 + h w)$", ylim=(0, 1.2), xlim=(1e-8, 10**0.5))
    axis.set_xticks([1e-6, 1e-4, 1e-2, 1])
    axis.set_yticks([0, 1])
    axis.tick_params(colors=INK)
    return figure


SOLVE = {"potentials": potentials, "loops": loops, "line_search": line_search, "wedge": wedge, "lift": lift, "rod": rod, "spectrum": spectrum}
