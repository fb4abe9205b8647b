# %% [markdown]
# A soft cube and a rigid ball fall on the ground: heights and energies of both, under one chapter's solver.
# Run it as a script, `./course python python/bounce.py`, or cell by cell in an editor that knows `# %%`.

# %%
import sys

import matplotlib

matplotlib.use("Agg")  # draws into a file
import matplotlib.pyplot as plt
import numpy as np

import enduring

# %% A scene is a dictionary, with the keys of a scene file.
SCENE = {
    "name": "bounce", "dt": 0.002, "duration": 1.2, "planes": [{"name": "ground"}],
    "bodies": [
        {"name": "soft cube", "type": "deformable", "shape": {"bar": {"size": [0.3, 0.3, 0.3], "cells": [3, 3, 3]}},
         "density": 1000, "young": 4e5, "poisson": 0.3, "position": [-0.5, 0.65, 0]},
        {"name": "rigid ball", "type": "rigid", "shape": {"sphere": {"radius": 0.15}}, "density": 1000, "position": [0.5, 0.65, 0]},
    ],
}


# %% Each step leaves a row.
def bounce(chapter):
    scene = enduring.read(SCENE, chapter=chapter)
    lowest = [body.positions[:, 1] for body in scene.bodies.values()]  # views: the solver's own memory, so one is enough
    times, heights, energies, forces = [], [], [], []
    while scene.time < scene.duration:
        scene.step()
        times.append(scene.time)
        heights.append([y.min() for y in lowest])
        energies.append(scene.energies)
        forces.append(scene.forces[:, 1])
    return np.array(times), np.array(heights), np.array(energies), np.array(forces)


times, heights, energies, forces = bounce(chapter=10)

# %% Middle grey reads on light and on dark pages.
plt.rcParams.update({key: "#808890" for key in ("text.color", "axes.labelcolor", "axes.edgecolor", "xtick.color", "ytick.color", "grid.color")})
plt.rcParams.update({"font.size": 12, "lines.linewidth": 2, "svg.hashsalt": "bounce"})
figure, axes = plt.subplots(3, sharex=True, figsize=(8, 8), layout="constrained")
colours = ["#d1603d", "#3d7ea6"]
for body, (name, colour) in enumerate(zip(["soft cube", "rigid ball"], colours)):
    axes[0].plot(times, 1000 * heights[:, body], color=colour, label=name)
    axes[1].plot(times, forces[:, body] / 1000, color=colour)
for part, style in zip(range(3), ["-", "--", ":"]):
    axes[2].plot(times, energies[:, 0, part], style, color=colours[0], label=["kinetic", "of gravity", "elastic"][part])
axes[0].set_ylabel("lowest vertex [mm]")
axes[1].set_ylabel("contact force [kN]")
axes[2].set_ylabel("energy of the soft cube [J]")
axes[2].set_xlabel("time [s]")
for axis in axes:
    axis.grid(alpha=0.3)
    axis.spines[["top", "right"]].set_visible(False)
axes[0].legend(frameon=False)
axes[2].legend(frameon=False)

# %%
file = sys.argv[1] if len(sys.argv) > 1 else "bounce.svg"
figure.savefig(file, dpi=110, transparent=True)
print(f"lowest {1000 * heights.min():.3f} mm; the soft cube's second top {1000 * heights[times > 0.5, 0].max():.0f} mm, "
      f"the ball's {1000 * heights[times > 0.5, 1].max():.1f} mm: {file}")
