"""Drawings about the search for pairs: chapters 8, 9 and 10."""
import numpy as np
from drawing import BLUE, GREEN, INK, RED, arrow, axes, dot, scene
from matplotlib.patches import Polygon


def shape(axis, corners, colour=INK, alpha=0.25, **line):
    axis.add_patch(Polygon(corners, closed=True, fc=colour, alpha=alpha, lw=0))
    axis.add_patch(Polygon(corners, closed=True, fill=False, ec=colour, **{"lw": 2} | line))


def skin():
    """Chapter 8: a body's own surface, and that for the search, which lies inside by the skin; at a sharp tip it recedes by more."""
    figure, axis = scene(size=(7, 3.2), xlim=(-0.3, 7.6), ylim=(-0.3, 2.9))
    shape(axis, [(0, 0), (2.4, 0), (2.4, 2.4), (0, 2.4)], BLUE)
    shape(axis, [(0.4, 0.4), (2, 0.4), (2, 2), (0.4, 2)], GREEN, 0, ls="--")
    arrow(axis, (2.4, 2.4), (2, 2), RED, "$d$", (0.42, 0.22))
    axis.annotate("", (1.2, 0), (1.2, 0.4), arrowprops={"arrowstyle": "<->", "color": INK, "lw": 1.2, "shrinkA": 0, "shrinkB": 0})
    axis.text(1.32, 0.2, "$s$", color=INK, va="center")
    tip, inner = [(3.4, 0), (7.4, 1.2), (3.4, 2.4)], [(3.8, 0.54), (6.0, 1.2), (3.8, 1.86)]
    shape(axis, tip, BLUE)
    shape(axis, inner, GREEN, 0, ls="--")
    arrow(axis, (7.4, 1.2), (6.0, 1.2), RED, "$d$", (0.7, 0.2))
    axis.text(3.95, 1.2, "for the search", color=GREEN, va="center", fontsize=11)
    axis.text(5.5, 2.1, "the body's own", color=BLUE)
    return figure


def nearest():
    """Chapter 8: a vertex has a pair with the nearest point of the other surface if no neighbour stands before the plane across the normal."""
    figure, axis = scene(size=(7.2, 3.4), xlim=(-2.9, 7.1), ylim=(-1.2, 3))
    for left, neighbours, fits in ((0, [(-1.7, 1.9), (1.6, 2.3)], True), (4.4, [(-1.5, 2.2), (1.9, 0.55)], False)):
        place = lambda point: (point[0] + left, point[1])
        shape(axis, [place((-2.1, -1)), place((2.1, -1)), place((2.1, 0)), place((-2.1, 0))], INK)
        shape(axis, [place((0, 1)), place(neighbours[0]), (left + 0.1, 2.7), place(neighbours[1])], BLUE)
        axis.plot([left - 1.9, left + 2.1], [1, 1], color=INK, lw=1, ls=":")
        dot(axis, place((0, 1)), BLUE, "$p$", (-0.3, 0.22))
        dot(axis, place((0, 0)), INK, "$q$", (-0.3, -0.3))
        arrow(axis, place((0, 0)), place((0, 0.85)), GREEN if fits else RED, "$n$", (0.28, -0.35))
        for neighbour in neighbours:
            dot(axis, place(neighbour), RED if neighbour[1] < 1 else GREEN, "$y$", (0.3 * np.sign(neighbour[0]), 0.1))
        axis.text(left, -0.62, "a pair" if fits else "no pair: $y$ is nearer", color=GREEN if fits else RED, ha="center", va="center")
    return figure


def crossing():
    """Chapter 8: the free path of a point crosses the top of a table, and later its side; only the first crossing becomes a pair, and the answer to it changes the rest."""
    figure, axis = scene(xlim=(-3.2, 2.6), ylim=(-1.9, 1.9))
    shape(axis, [(-3.1, -1.8), (0.6, -1.8), (0.6, 0), (-3.1, 0)], INK)
    begin, end = np.array([-1.9, 1.6]), np.array([2.2, -1.5])
    axis.plot(*np.array([begin, end]).T, color=RED, ls="--")
    first = begin + (end - begin) * 1.6 / 3.1
    side = begin + (end - begin) * 2.5 / 4.1
    dot(axis, begin, BLUE)
    dot(axis, first, GREEN, "first: a pair", (-1.25, -0.35))
    dot(axis, side, RED, "a consequence", (1.15, -0.1))
    axis.text(1.55, -1.5, "free path", color=RED, ha="right")
    arrow(axis, first + [0, 0.05], (2.2, 0.12), BLUE, "path with the pair", (-0.75, 0.3))
    arrow(axis, first, first + [0, 0.9], GREEN, "$n$", (0.2, 0))
    return figure


def turning():
    """Chapter 8: along facets, a vertex is pushed at right angles to the mean of its velocities before and after."""
    figure, axis = scene(size=(6.6, 3.2), xlim=(-3.1, 3.1), ylim=(-0.9, 1.9))
    bend = np.array([[-2.8, 0.35], [0, -0.6], [2.8, 0.35]])
    axis.plot(*bend.T, color=INK, lw=3)
    for part, name, at in ((0, "$n_0$", (-0.28, 0.05)), (1, "$n_1$", (0.28, 0.05))):
        middle, along = (bend[part] + bend[part + 1]) / 2, (bend[part + 1] - bend[part]) / np.linalg.norm(bend[part + 1] - bend[part])
        arrow(axis, middle, middle + 1.1 * np.array([-along[1], along[0]]), INK, name, at)
        shift = 0.22 * np.array([-along[1], along[0]])
        arrow(axis, middle + shift - 0.95 * along, middle + shift + 0.15 * along, BLUE, f"$u_{part}$", (-0.62, 0.33) if part == 0 else (-0.7, 0.05))
    arrow(axis, bend[1], bend[1] + [0, 1.5], GREEN, "$n \\parallel n_0 + n_1$", (0, 0.2))
    return figure


def hand_on():
    """Chapter 8: a vertex that slides to the next face hands its spring on: the compression stays, and the rest offset takes up the difference."""
    figure, axis = scene(size=(7, 3.2), xlim=(-3.4, 3.5), ylim=(-1.3, 1.5))
    axis.plot([-3.2, 0, 3.2], [0, 0, -0.75], color=INK, lw=3)
    turned = np.radians(-13)
    for place, angle, colour in (((-1.5, -0.55), 0.0, BLUE), ((1.6, -1.02), turned, GREEN)):
        normal = np.array([-np.sin(angle), np.cos(angle)])
        along = np.array([normal[1], -normal[0]])
        way = np.linspace(0, 1.45, 60)
        coil = np.array(place) + np.outer(way, normal) + np.outer(0.12 * np.sin(way / 1.45 * 6 * 2 * np.pi) * (way > 0.1), along)
        axis.plot(*coil.T, color=colour, lw=1.5)
        dot(axis, place, colour)
    arrow(axis, (-0.85, 0.95), (0.95, 0.7), INK, "$l,\\; k,\\; s,\\; \\delta - r$", (-0.9, 0.42))
    axis.text(-1.5, -0.95, "old key", color=BLUE, ha="center")
    axis.text(2.45, -1.12, "new key", color=GREEN, ha="center")
    return figure


def pieces():
    """Chapter 9: two faces that cross have two piercings in common, the ends of their piece of the curve."""
    figure, axis = scene(size=(6.6, 3.4), xlim=(-3.1, 3.1), ylim=(-1.5, 1.9))
    shape(axis, [(-2.9, -0.9), (2.2, -1.1), (0.5, 1.2)], BLUE, 0.2)
    shape(axis, [(-1.7, 1.7), (2.8, 1.5), (0.35, -1.35)], GREEN, 0.2)
    first, second = np.array([-0.52, 0.28]), np.array([1.15, 0.35])
    axis.plot(*np.array([first, second]).T, color=RED, lw=3)
    dot(axis, first, RED, "a piercing", (-0.95, 0.12))
    dot(axis, second, RED, "a piercing", (0.98, -0.15))
    for end, way in ((first, (-0.75, -0.5)), (second, (0.75, 0.45))):
        axis.plot(*np.array([end, end + way]).T, color=RED, lw=2, ls=":")
    axis.text(0.32, 0.5, "piece", color=RED, ha="center")
    axis.text(-2.2, -0.62, "face of A", color=BLUE)
    axis.text(1.0, 1.3, "face of B", color=GREEN)
    return figure


def shift():
    """Chapter 9: boxes of one size meet in ties; after a shift by less than every number their curve is closed."""
    figure, axis = scene(size=(7, 3), xlim=(-0.4, 7.4), ylim=(-0.6, 2.9))
    shape(axis, [(0, 0), (2, 0), (2, 2), (0, 2)], BLUE, 0.25)
    shape(axis, [(0, 0), (2, 0), (2, 2), (0, 2)], GREEN, 0, ls="--")
    axis.text(1, 1, "edge on edge:\nin or out?", color=INK, ha="center", va="center")
    e = np.array([0.5, 0.28])
    corners = np.array([(4.4, 0), (6.4, 0), (6.4, 2), (4.4, 2)])
    shape(axis, corners, GREEN, 0.15, ls="--")
    shape(axis, corners + e, BLUE, 0.25)
    for place in ((6.4, 0.28), (4.9, 2)):
        dot(axis, place, RED)
    arrow(axis, corners[0], corners[0] + e, RED, "$e$", (0.2, 0.18))
    axis.text(5.7, -0.38, "two piercings: the curve closes", color=RED, ha="center")
    return figure


def fade():
    """Chapter 9: the rest offset of a pair fades by a tenth in a step, but no faster than at a given speed; the body follows."""
    figure, axis = axes(size=(6.4, 3.3))
    depth, offset, fastest = 1.0, [1.0], 0.025
    for _ in range(80):
        offset.append(offset[-1] - min(0.1 * offset[-1], fastest))
    steps = np.arange(len(offset))
    axis.plot(steps, depth * 0.9**steps, color=RED, ls="--")
    axis.plot(steps, offset, color=GREEN)
    axis.plot(steps, np.array(offset) + 0.035, color=BLUE)
    axis.text(6.2, 0.32, "a tenth in\neach step", color=RED, ha="right", va="top")
    axis.text(22, 0.6, "depth", color=BLUE)
    axis.text(17, 0.38, "rest offset", color=GREEN, ha="center", va="top")
    axis.text(17, 0.95, "at a bounded speed", color=GREEN)
    axis.set(xlabel="steps", ylim=(0, 1.1), xlim=(-8, 70))
    return figure


def neighbours():
    """Chapter 10: what is near through the body is no contact, what is near through the air is one."""
    figure, axis = scene(size=(7.2, 3.3), xlim=(-0.3, 8.1), ylim=(-0.9, 2.7))
    shape(axis, [(0, 0.7), (3.2, 0.7), (3.2, 1.3), (0, 1.3)], BLUE)
    dot(axis, (1.6, 1.3), RED, "$u$", (0, 0.3))
    dot(axis, (1.6, 0.7), RED, "$v$", (0, -0.3))
    axis.plot([1.6, 1.6], [0.7, 1.3], color=RED)
    axis.text(1.6, -0.45, "short path through the body:\nneighbours, no contact", color=RED, ha="center", va="center")
    turn = np.linspace(np.pi / 2, -np.pi / 2, 40)
    outer = np.c_[6.4 + 1.1 * np.cos(turn), 1.1 + 1.1 * np.sin(turn)]
    inner = np.c_[6.4 + 0.35 * np.cos(turn[::-1]), 1.1 + 0.35 * np.sin(turn[::-1])]
    shape(axis, [(4.5, 2.2), *outer, (4.5, 0), (4.5, 0.75), *inner, (4.5, 1.45)], BLUE)
    dot(axis, (5.2, 1.45), GREEN, "$u$", (-0.05, 0.32))
    dot(axis, (5.2, 0.75), GREEN, "$v$", (-0.05, -0.32))
    axis.plot([5.2, 5.2], [0.75, 1.45], color=GREEN, ls=":")
    path = np.r_[[(5.2, 1.45)], [(5.2, 1.82)], np.c_[6.4 + 0.72 * np.cos(turn), 1.1 + 0.72 * np.sin(turn)], [(5.2, 0.38)], [(5.2, 0.75)]]
    axis.plot(*path.T, color=GREEN, lw=1.5)
    axis.text(6.0, -0.45, "near through the air, the path is long:\na contact", color=GREEN, ha="center", va="center")
    return figure


SEARCH = {"skin": skin, "nearest": nearest, "crossing": crossing, "turning": turning, "hand_on": hand_on,
          "pieces": pieces, "shift": shift, "fade": fade, "neighbours": neighbours}
