#!/usr/bin/env python3
"""Draws error over seconds from a table of run.py and says what it teaches: draw.py TABLE.csv PICTURE.png

A ring marks a point that no other beats in both (the Pareto front). Prints, as Markdown, the observed order of each element and the
cheapest setting for errors of 5 % and 1 %, with the next cheaper one that fails. Needs matplotlib.
"""
import csv
import math
import sys

import cases
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {"tri3": "#d1202f", "tri6c": "#27567f", "tet4": "#f08c00", "tet10c": "#4f8a6b"}
TARGETS = (0.05, 0.01)


def points_of(table, case):
    """Rows of a case as (element, size, seconds, error), in the order of the ladder."""
    with open(table, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["case"] == case.name]
    found = [(r["element"], int(r["divisions"]), float(r["size"]), float(r["seconds"]), abs(float(r["error"]))) for r in rows]
    return sorted(found, key=lambda p: (p[0], p[1]))


def front(points):
    return [p for p in points if not any(q[3] <= p[3] and q[4] < p[4] for q in points)]


def order(points, element):
    """Slope of the error over the size on the two finest meshes."""
    mine = [p for p in points if p[0] == element]
    if len(mine) < 2 or 0 in (mine[-1][4], mine[-2][4]):
        return math.nan
    return math.log(mine[-2][4] / mine[-1][4]) / math.log(mine[-2][2] / mine[-1][2])


def setting(p):
    return f"`{p[0]}`, {p[1]} divisions, {p[3]:.2g} s ({100 * p[4]:.2g} %)"


def lesson(points, target):
    good = sorted((p for p in points if p[4] <= target), key=lambda p: p[3])
    if not good:
        best = min(points, key=lambda p: p[4])
        return f"none of these; best {setting(best)}"
    failing = [p for p in points if p[3] < good[0][3]]
    text = setting(good[0])
    return text + (f"; not {setting(max(failing, key=lambda p: p[3]))}" if failing else "")


def draw_case(axes, case, points):
    for element in case.ladder:
        mine = [p for p in points if p[0] == element]
        if not mine:
            continue
        label = f"{element}, order {order(points, element):.1f}".replace("-", "\u2212")
        axes.loglog([p[3] for p in mine], [p[4] for p in mine], "o-", color=COLOURS[element], label=label, markersize=5)
    best = front(points)
    axes.plot([p[3] for p in best], [p[4] for p in best], "o", mfc="none", mec="#1f2933", markersize=11)
    for target in TARGETS:
        axes.axhline(target, color="#9aa5b1", linewidth=0.8, linestyle="--")
        axes.annotate(f"{100 * target:g} %", (1, target), xycoords=("axes fraction", "data"), xytext=(-2, 2),
                      textcoords="offset points", ha="right", size=8, color="#66727f")
    axes.set_title(case.title, loc="left", fontsize=10.5, fontweight="bold")
    axes.grid(True, which="major", color="#d9dee4", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel("seconds, one thread")
    axes.set_ylabel("error")
    axes.legend(frameon=False, fontsize=9)


def main(table, picture):
    figure, axes = plt.subplots(2, 2, figsize=(11, 8.2))
    print("| case | order in the size | 5 % | 1 % |\n|---|---|---|---|")
    for place, case in zip(axes.flat, cases.CASES):
        points = points_of(table, case)
        draw_case(place, case, points)
        orders = ", ".join(f"`{e}` {order(points, e):.1f}" for e in case.ladder)
        print(f"| {case.title} | {orders} | {lesson(points, 0.05)} | {lesson(points, 0.01)} |")
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
