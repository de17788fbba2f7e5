#!/usr/bin/python3
"""Friction of a gouge against slip, and a picture of it: friction.py PICTURE RUN_FOLDER ..."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

START = 25e-3  # s, the drive begins
SMOOTH = 5  # rows of the history, 0.5 ms: what is quicker is the ringing of the plates
EVENT = 0.05  # a fall of friction that counts as an event


def course(folder):
    """Slip (m), friction in the middle of the layer, that at the drive, rise of the bar since the start (m)."""
    h = np.genfromtxt(pathlib.Path(folder) / "history.csv", delimiter=",", names=True, deletechars="")
    rise = h["bar.y"][0]
    h = h[h["time"] >= START]
    h = {name: np.convolve(h[name], np.ones(SMOOTH) / SMOOTH, "valid") for name in h.dtype.names}
    shear = h["drive.x"] - (h["left.fx"] + h["right.fx"]) / 2
    normal = (h["left.fy"] + h["right.fy"]) / 2 - h["drive.y"]
    slip = h["upper.ux"] - h["upper.ux"][0]
    return slip, shear / normal, h["drive.x"] / -h["drive.y"], h["bar.y"] - rise


def events(friction):
    """Falls of friction between a maximum and the next minimum, each larger than EVENT."""
    falls, top, least, falling = [], friction[0], friction[0], False
    for mu in friction:
        if falling and mu > least + EVENT / 2:
            falls.append(top - least)
            top, falling = mu, False
        elif not falling and mu < top - EVENT:
            falling, least = True, mu
        top = top if falling else max(top, mu)
        least = min(least, mu) if falling else mu
    return np.array(falls)


def main(picture, folders):
    figure, axes = plt.subplots(figsize=(10, 3.6), constrained_layout=True)
    for folder in folders:
        slip, friction, drive, bar = course(folder)
        steady = slip > slip[-1] / 2
        falls = events(friction[steady])
        mu, scatter = friction[steady].mean(), friction[steady].std()
        print(
            f"{folder}: friction {mu:.3f}, variation {100 * scatter / mu:.1f} %, at the drive {drive[steady].mean():.3f}, "
            f"bar up by {1e3 * bar[steady].mean():.3f} mm, {len(falls)} events of {falls.mean() if len(falls) else 0:.3f}"
        )
        axes.plot(slip * 1e3, friction, label=f"{pathlib.Path(folder).name}: {mu:.2f}", linewidth=1)
    axes.axhspan(0.25, 0.35, color="0.9", zorder=0)
    axes.set(xlabel="slip, mm", ylabel="friction in the middle of the layer", xlim=(0, None), ylim=(0, 0.6))
    axes.legend(loc="lower right")
    figure.savefig(picture, dpi=80)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
