#!/usr/bin/python3
"""Angles of the two flanks of heaps: flanks.py RUN_FOLDER ...

The surface is the highest grain in each strip as wide as a grain. A line goes through the strips, from the middle outwards,
between 85 and 15 per cent of the heap's height, which is the mean of the three highest strips: what rolls about beyond
the foot does not count.
"""

import pathlib
import sys

import numpy as np

STRIP = 0.010  # m, the largest grain
LOW, HIGH = 0.15, 0.85


def grains(folder):
    """Fragments of the last frame that are grains."""
    rows = np.genfromtxt(pathlib.Path(folder) / "fragments.csv", delimiter=",", names=True)
    return rows[(rows["frame"] == rows["frame"].max()) & (rows["length"] < 2 * STRIP)]


def flanks(folder):
    """Angles of the left and of the right flank, degrees, and the height of the heap, m."""
    heap = grains(folder)
    top = heap["y"] + heap["size"] / 2
    strips = np.floor((heap["x"] - np.median(heap["x"])) / STRIP).astype(int)
    surface = {k: top[strips == k].max() for k in np.unique(strips)}
    height = np.sort(list(surface.values()))[-3:].mean()
    return flank(surface, -1, -1, height), flank(surface, 0, 1, height), height


def flank(surface, first, step, height):
    """Angle, degrees, of the flank that begins at the strip `first` and goes on by `step`."""
    x, y, k = [], [], first
    while surface.get(k, 0) > LOW * height:
        if surface[k] < HIGH * height:
            x.append(abs(k) * STRIP)
            y.append(surface[k])
        k += step
    return np.degrees(np.arctan(-np.polyfit(x, y, 1)[0]))


def main(folders):
    found = []
    for folder in folders:
        left, right, height = flanks(folder)
        found.append((left, right))
        print(f"{folder}: left {left:.1f}, right {right:.1f}, mean {(left + right) / 2:.1f} degrees, {height * 1e3:.0f} mm high")
    left, right = np.mean(found, axis=0)
    both = np.mean(found, axis=1)
    print(f"mean of {len(found)}: left {left:.1f}, right {right:.1f}, both {both.mean():.1f} +- {both.std():.1f} degrees")


if __name__ == "__main__":
    main(sys.argv[1:])
