#!/usr/bin/env python3
"""Draws the two mountains side by side: wave fronts with the first arrivals of arrivals.py, cracks at the cavity.

compare.py ANISOTROPIC_RUN ISOTROPIC_RUN PICTURE; also prints the lengths of broken faces. Needs numpy, matplotlib, h5py.
"""
import csv
import math
import pathlib
import sys

import arrivals

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from breccia_plot import mesh_picture, style  # noqa: E402
from breccia_plot.run_folder import RunFolder  # noqa: E402

FRONTS, CRACKS = 7, 16  # frames
AROUND = 20.0  # m, that still counts as near the cavity


def broken(run):
    """Lengths of broken faces near the cavity and elsewhere, m."""
    with open(run.path / "events.csv", newline="", encoding="utf-8") as file:
        rows = [[float(row[name]) for name in ("x", "y", "area")] for row in csv.DictReader(file)]
    x, y = arrivals.CAVITY
    near = sum(area for a, b, area in rows if math.hypot(a - x, b - y) < AROUND)
    return near, sum(row[2] for row in rows) - near


def main(folders, picture):
    style.set_up()
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 2, figsize=(13, 9.2), height_ratios=[1, 1.15])
    for column, folder in enumerate(folders):
        run, name = RunFolder(folder), ("anisotropic", "isotropic")[column]
        fronts = run.frame(FRONTS)
        x, y, time = arrivals.first_arrivals(arrivals.layers_of(column == 1))
        top, bottom = axes[0][column], axes[1][column]
        mesh_picture.draw(top, fronts, None, "velocity", (0.0, 0.8, False), bar=False)
        top.contour(x, y, time, levels=[fronts.time], colors=style.CRACK["tension"], linewidths=1.2)
        for left, right in arrivals.DIPS:
            top.plot([0, arrivals.WIDTH], [left, right], color=style.QUIET, linewidth=0.8)
        top.set_title(f"{name}: speed at {1e3 * fronts.time:.1f} ms, red: first arrival")
        mesh_picture.draw(bottom, run.frame(CRACKS), run.cracks(CRACKS), "sigma_1", (-4e6, 4e6, True), bar=False)
        bottom.set_xlim(70, 130)
        bottom.set_ylim(22, 84)
        near, far = broken(run)
        bottom.set_title(f"broken: {near:.1f} m near the cavity")
        print(f"{name}: {near:.2f} m of broken faces within {AROUND:g} m of the cavity, {far:.2f} m elsewhere")
    figure.tight_layout()
    figure.savefig(picture)


if __name__ == "__main__":
    main(sys.argv[1:3], sys.argv[3])
