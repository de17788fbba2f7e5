#!/usr/bin/python3
"""What an impact leaves in the bed: decay.py RUN_FOLDER

Arrivals below the impact, the mean peak velocity of the grains in shells around the place that was hit, and who carries the
bead's momentum.
"""

import pathlib
import sys

import numpy as np

DEPTHS = np.array([3.0, 5.4, 7.8, 12.6, 17.4, 22.2, 27.0])  # mm, of the sensors
FIRST = 1.0  # m/s, what counts as an arrival
WALLS = 2  # the first fragments


def sensors(folder):
    h = np.genfromtxt(folder / "history.csv", delimiter=",", names=True, deletechars="")
    down = [np.abs(h[f"down_{k}.vz"]) for k in range(len(DEPTHS))]
    peak = np.array([v.max() for v in down])
    arrival = np.array([h["time"][np.argmax(v > FIRST)] for v in down]) * 1e6
    for depth, v, t in zip(DEPTHS, peak, arrival):
        print(f"{depth:5.1f} mm: {v:6.1f} m/s, arrives at {t:5.1f} us")
    print(f"correlation of arrival and depth: {np.corrcoef(DEPTHS, arrival)[0, 1]:.3f}")


def shells(rows):
    """Means of the largest speed of each grain in any frame, by distance and by angle from straight down."""
    grains = rows[:, WALLS + 1 :]
    speed = np.sqrt(sum(grains[f"velocity_{c}"] ** 2 for c in "xyz")).max(axis=0)
    x, y, z = (grains[c][0] for c in "xyz")
    distance, angle = np.sqrt(x**2 + y**2 + z**2) * 1e3, np.degrees(np.arctan2(np.hypot(x, y), -z))
    for low, high in ((0, 20), (20, 45)):
        where, peak = [], []
        for inner in range(4, 30, 2):
            shell = (angle >= low) & (angle < high) & (distance >= inner) & (distance < inner + 2)
            if shell.sum() > 2 and np.median(speed[shell]) > 10:
                where.append(inner + 1)
                peak.append(speed[shell].mean())
        power = np.polyfit(np.log(where), np.log(peak), 1)[0]
        print(f"{low} to {high} degrees: " + ", ".join(f"{d} mm {v:.0f} m/s" for d, v in zip(where, peak)) + f"; power {power:.2f}")


def momenta(rows):
    start = None
    for now in rows:
        p = now["mass"] * now["velocity_z"]
        bead, bed = now[WALLS], p[WALLS + 1 :]
        start = start or p[WALLS]
        print(
            f"{bead['time'] * 1e6:5.1f} us: bead at {bead['z'] * 1e3:6.2f} mm, {bead['velocity_z']:7.1f} m/s; "
            f"of m v the bead has {p[WALLS] / start:.3f}, grains that fall {bed[bed < 0].sum() / start:.3f}, "
            f"that rise {bed[bed > 0].sum() / start:.3f}; {(np.abs(now['velocity_z'][WALLS + 1 :]) > FIRST).sum()} move"
        )


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    sensors(folder)
    rows = np.genfromtxt(folder / "fragments.csv", delimiter=",", names=True)
    rows = rows.reshape(len(np.unique(rows["frame"])), -1)
    shells(rows)
    momenta(rows[::2])
