"""Pictures of `breccia study`: error against seconds and against element-steps."""
import json
import math
import textwrap

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from . import style
from .trouble import Trouble

TARGETS = (0.05, 0.01, 0.001)
MARKS = "osD^vPX"


def read(folder):
    """study.json of a folder, or None where there is none."""
    path = folder / "study.json"
    if not path.is_file():
        return None
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except ValueError as trouble:
        raise Trouble(f"{path}: not readable: {trouble}") from None


def number(value):
    return math.nan if value is None else float(value)


def ladder_knob(study):
    """The knob that lines are drawn along: the first one of numbers, else the first one."""
    numeric = [k for k, knob in enumerate(study["knobs"]) if knob["numeric"]]
    return numeric[0] if numeric else 0


def series_of(study, quantity, costs):
    """Points by ladder: {(knob, others): [(cost, error, rung, on the front)]}, in the order of the rungs."""
    knob = ladder_knob(study)
    series = {}
    for job, cost, error, front in zip(study["jobs"], costs, quantity["errors"], quantity["front"]):
        cost, error = number(cost), number(error)
        if not (cost > 0 and error > 0 and math.isfinite(error)):
            continue
        set_here = [k for k, rung in enumerate(job["rungs"]) if rung]
        if len(study["knobs"]) > 1 and len(set_here) == 1:  # one knob at a time: a line for each
            only = set_here[0]
            series.setdefault((only, study["knobs"][only]["name"]), []).append((cost, error, job["rungs"][only], front))
            continue
        others = [f"{study['knobs'][k]['name']} {job['rungs'][k]}" for k in set_here if k != knob]
        series.setdefault((knob, ", ".join(others)), []).append((cost, error, job["rungs"][knob], front))
    return series


def order_of(study, quantity, knob, others):
    """Over all rungs, where the error falls along the ladder."""
    name = study["knobs"][knob]["name"]
    for line in quantity["lines"]:
        if line["knob"] == name and line["others"] in (others, "") and line["falls"]:
            return line["order_over_all"]
    return None


def mark_targets(axes, errors):
    low, high = min(errors), max(errors)
    for target in TARGETS:
        if not 0.3 * low <= target <= 3 * high:
            continue
        axes.axhline(target, color=style.SPARE, linewidth=0.9, linestyle=(0, (4, 3)), zorder=1)
        axes.annotate(
            f"{100 * target:g} %", (0, target), xycoords=("axes fraction", "data"), xytext=(4, 3),
            textcoords="offset points", ha="left", size=8.5, color=style.QUIET,
        )


def percent(value, _position=None):
    return f"{100 * value:g} %"


def plain_seconds(axes):
    """0.2, 0.5, 3 instead of powers of ten: a ladder rarely spans more than three."""
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())


def draw_spread(axes, study, quantity):
    """From the quickest to the slowest of the repeats."""
    for job, error in zip(study["jobs"], quantity["errors"]):
        spread = job[f"{study['cost']}_seconds"]
        if error and len(spread["each"]) > 1:
            axes.plot([spread["min"], spread["max"]], [error, error], color=style.SPARE, linewidth=3, alpha=0.6,
                      zorder=2, solid_capstyle="butt")


def draw_panel(axes, study, quantity, costs, front_known, named):
    series = series_of(study, quantity, costs)
    shown = [p for points in series.values() for p in points]
    if not shown:
        raise Trouble(f"{quantity['name']}: no job has an error above zero, so there is nothing to draw")
    front = []
    for place, ((knob, others), points) in enumerate(series.items()):
        colour, mark = style.LINES[place % len(style.LINES)], MARKS[place // len(style.LINES) % len(MARKS)]
        order = order_of(study, quantity, knob, others)
        words = [others or study["knobs"][knob]["name"]]
        words += [style.minus(f"order {order:.1f}")] if order is not None else []
        axes.loglog(
            [p[0] for p in points], [p[1] for p in points], marker=mark, color=colour, markersize=5.5,
            label=", ".join(words), zorder=3,
        )
        for turn, (cost, error, rung, on_front) in enumerate(points):
            axes.annotate(
                rung, (cost, error), xytext=(6, 5 if turn % 2 == 0 else -11), textcoords="offset points", size=8,
                color=colour, zorder=4,
            )
            if on_front:
                front.append((cost, error))
    if front_known:
        front.sort()
        axes.step([p[0] for p in front], [p[1] for p in front], where="post", color=style.FAINT, linewidth=5,
                  zorder=2, solid_capstyle="round")
        axes.plot([p[0] for p in front], [p[1] for p in front], "o", mfc="none", mec=style.INK, markersize=11,
                  label="not beaten in both", zorder=3)
    mark_targets(axes, [p[1] for p in shown])
    axes.yaxis.set_major_formatter(FuncFormatter(percent))
    low, high = min(p[1] for p in shown), max(p[1] for p in shown)
    axes.yaxis.set_minor_formatter(FuncFormatter(percent) if high < 5 * low else NullFormatter())
    axes.margins(x=0.16, y=0.12)
    axes.set_ylabel(textwrap.fill(f"error of {quantity['name']}", 34) if named else "error")
    if axes.get_legend_handles_labels()[1]:
        axes.legend(fontsize=8.5, loc="best", frameon=True, framealpha=0.85, edgecolor="none")


def seconds_label(study):
    kind = "processor seconds" if study["cost"] == "processor" else "seconds by the clock"
    threads = study["threads"]
    return f"{kind}, {threads} thread{'s' if threads > 1 else ''}"


def draw(study, path):
    """One row of two panels for each quantity."""
    quantities = study["quantities"]
    figure, rows = plt.subplots(
        len(quantities), 2, figsize=(12.5, 4.6 * len(quantities) + 0.7), squeeze=False, layout="constrained"
    )
    seconds = [job[f"{study['cost']}_seconds"]["median"] for job in study["jobs"]]
    steps = [job["element_steps"] for job in study["jobs"]]
    for row, quantity in zip(rows, quantities):
        draw_panel(row[0], study, quantity, seconds, True, True)
        draw_spread(row[0], study, quantity)
        plain_seconds(row[0])
        row[0].set_xlabel(seconds_label(study))
        draw_panel(row[1], study, quantity, steps, False, False)
        row[1].set_xlabel("elements × steps")
        if row[1].get_legend():
            row[1].get_legend().remove()
    knob = study["knobs"][ladder_knob(study)]["name"]
    figure.suptitle(f"{study['title'] or study['name']}  (points: {knob})", x=0.01, ha="left", weight="bold", size=13)
    style.save(figure, path, 100)
