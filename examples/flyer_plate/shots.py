#!/usr/bin/python3
"""Spall strengths of several shots and their picture: shots.py PICTURE RUN_FOLDER ..."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

IMPEDANCE = 2630 * 5000  # Pa s/m, granite
RESOLVED = 0.1  # m/s, a rise that a VISAR tells from noise


def pull_back(time, velocity):
    """Highest velocity before the release comes, m/s, how far it falls to its first minimum, and when."""
    first = np.flatnonzero(time < 2.95e-6)
    top = first[velocity[first].argmax()]
    least = top
    for k in range(top, len(velocity)):
        if velocity[k] < velocity[least]:
            least = k
        elif velocity[k] > velocity[least] + RESOLVED and velocity[top] - velocity[least] > 2:
            break
    return velocity[top], velocity[top] - velocity[least], time[least]


def main(picture, folders):
    figure, (whole, near) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    for folder in folders:
        history = np.genfromtxt(pathlib.Path(folder) / "history.csv", delimiter=",", names=True)
        time, velocity = history["time"], history["rearvx"]
        top, fall, when = pull_back(time, velocity)
        strength = IMPEDANCE * fall / 2 / 1e6
        print(f"{folder}: {top:.2f} m/s, pulled back by {fall:.2f} m/s at {when * 1e6:.2f} us: {strength:.1f} MPa")
        whole.plot(time * 1e6, velocity)
        near.plot(time * 1e6, velocity - top, label=f"{top:.0f} m/s: {strength:.1f} MPa")
    whole.set(xlabel="time, us", ylabel="velocity of the free surface, m/s", xlim=(1.4, 4), ylim=(0, 450))
    near.set(xlabel="time, us", ylabel="below its peak, m/s", xlim=(1.8, 4), ylim=(-9, 1))
    near.legend(title="peak: spall strength", loc="lower left", ncols=2)
    figure.savefig(picture, dpi=80)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
