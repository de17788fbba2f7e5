"""The pictures as files: one frame, the histories, the ledger, the summary."""
import functools

import matplotlib.pyplot as plt

from . import catalogue, curves, fields, force_chains, mesh_picture, style
from .trouble import Trouble


def time_text(seconds):
    factor, unit = style.prefixed("s", seconds)
    return f"t = {seconds * factor:.4g} {unit or 's'}"


def headline(figure, title, line):
    height = figure.get_size_inches()[1]
    figure.text(0.02, 1 - 0.18 / height, title, size=14, weight="bold", va="top")
    if line:
        figure.text(0.02, 1 - 0.46 / height, line, size=10.5, color=style.QUIET, va="top")


def frame_size(grid):
    """Width and height [inch] of a figure whose middle fits the mesh; the colours take a sixth of the width."""
    place = grid.points[:, :2] if grid.dimension == 2 else (grid.points @ mesh_picture.camera().T)[:, :2]
    wide, high = place.max(axis=0) - place.min(axis=0)
    ratio = float(high / wide) if wide > 0 else 1.0
    width = 9.2 if ratio > 0.7 else 11.0
    return width, min(max(0.8 * width * ratio, 2.4), 10.0) + 1.5


def draw_frame(run, number, name, path, limits=None):
    grid, cracks = run.frame(number), run.cracks(number)
    figure = plt.figure(figsize=frame_size(grid))
    height = figure.get_size_inches()[1]
    axes = figure.add_axes([0.02, 0.5 / height, 0.96, 1 - 1.2 / height])
    mesh_picture.draw(axes, grid, cracks, name, limits)
    parts = [time_text(grid.time), f"{style.count(len(grid.cells))} elements"]
    released = 0 if cracks is None else int((cracks.arrays["status"].values == 2).sum())
    if released:
        parts.append(f"{style.count(released)} broken faces")
    headline(figure, run.title, ",  ".join(parts))
    style.save(figure, path)


def draw_forces(run, number, path):
    grid, chains = run.frame(number), run.contacts(number)
    if chains is None:
        raise Trouble(f"{run.path}: the scene has no [contact], so there are no forces to draw")
    figure = plt.figure(figsize=frame_size(grid))
    height = figure.get_size_inches()[1]
    force_chains.draw(figure.add_axes([0.02, 0.5 / height, 0.96, 1 - 1.2 / height]), grid, chains)
    touching = f"{style.count(len(chains.cells) // 2)} pairs of fragments that touch"
    headline(figure, run.title, f"{time_text(grid.time)},  {touching}")
    style.save(figure, path)


def common_limits(run, numbers, name):
    """One range of colours for a film: the widest of its frames."""
    ranges = [fields.limits(fields.field(run.frame(number), name).values) for number in numbers]
    low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
    signed = any(r[2] for r in ranges)
    return (-max(-low, high), max(-low, high), True) if signed else (low, high, False)


def draw_histories(run, path):
    history = run.history
    panels = [functools.partial(curves.draw_sensor, sensor=sensor) for sensor in curves.grouped(history)]
    panels.append(curves.draw_ledger)
    if curves.has_counts(history):
        panels.append(curves.draw_counts)
    across = min(len(panels), 2)
    down = (len(panels) + across - 1) // across
    figure, grid = plt.subplots(down, across, figsize=(5.5 * across, 2.8 * down + 0.8), squeeze=False)
    for axes, panel in zip(grid.flat, panels):
        panel(axes, history)
    for axes in list(grid.flat)[len(panels):]:
        axes.axis("off")
    headline(figure, run.title, "history of sensors and energies")
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.7 / figure.get_size_inches()[1]), h_pad=1.6, w_pad=2)
    style.save(figure, path)


def draw_ledger(run, path):
    figure, (energy, residual) = plt.subplots(2, 1, figsize=(9, 7), sharex=True, height_ratios=[2.2, 1])
    curves.draw_ledger(energy, run.history)
    energy.set_xlabel("")
    curves.draw_residuals(residual, run.history)
    headline(figure, run.title, "energy ledger: every joule stored or spent against the work done")
    figure.tight_layout(rect=(0, 0, 1, 0.91), h_pad=1.5)
    style.save(figure, path)


def draw_catalogue(run, path):
    """Emissions and fragments, of runs that have enough of them."""
    panels = catalogue.panels(run)
    if not panels:
        return
    down = len(panels) // 2
    figure, grid = plt.subplots(down, 2, figsize=(11, 3.4 * down + 0.8), squeeze=False)
    for axes, (draw, table) in zip(grid.flat, panels):
        draw(axes, table)
    headline(figure, run.title, "what broke: emissions by magnitude, fragments by size")
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.7 / figure.get_size_inches()[1]), h_pad=1.6, w_pad=2)
    style.save(figure, path)


def check_line(run):
    checks = run.report.get("checks", [])
    if not checks:
        return ""
    passed = sum(bool(check.get("pass")) for check in checks)
    return f"{passed} of {len(checks)} checks passed"


def draw_summary(run, number, name, path):
    grid, cracks = run.frame(number), run.cracks(number)
    figure = plt.figure(figsize=(12.4, 6.2))
    layout = figure.add_gridspec(2, 2, width_ratios=[1.4, 1], left=0.02, right=0.865, top=0.86, bottom=0.1,
                                 hspace=0.52, wspace=0.16)
    picture = figure.add_subplot(layout[:, 0])
    mesh_picture.draw(picture, grid, cracks, name)
    history = run.history
    sensor = curves.main_sensor(history) if history else None
    if sensor:
        axes = figure.add_subplot(layout[0, 1])
        curves.draw_sensor(axes, history, sensor)
        curves.mark_peak(axes, history, sensor)
    if history:
        curves.draw_ledger(figure.add_subplot(layout[1, 1] if sensor else layout[:, 1]), history)
    parts = [time_text(grid.time), f"{style.count(len(grid.cells))} elements", check_line(run)]
    headline(figure, run.title, ",  ".join(part for part in parts if part))
    style.save(figure, path)
