"""Histories and the energy ledger."""
import dataclasses
import re

import numpy as np

from . import style

# Energies of the ledger (docs/output.md), how a reader calls them, and their colours: blue is stored, cracks have
# the colours of the cracks. Stacked in this order.
ENERGIES = {
    "KE": ("kinetic", "#1b335a"),
    "IE_elastic": ("elastic", "#3d7a9e"),
    "IF_stored": ("interfaces, stored", "#8fbdd0"),
    "CT_stored": ("contact, stored", "#c5dde7"),
    "FL_internal": ("fluid, internal", "#2a9d8f"),
    "FL_kinetic": ("fluid, kinetic", "#7cc8bf"),
    "D_viscous": ("viscous damping", "#4f8a6b"),
    "D_bulkq": ("bulk viscosity", "#86b391"),
    "D_plastic": ("plastic", "#b5a642"),
    "IF_G1": ("fracture, tension", "#d1202f"),
    "IF_G2": ("fracture, shear", "#f08c00"),
    "IF_friction": ("crack friction", "#f4c27a"),
    "IF_viscous": ("crack damping", "#c9b79c"),
    "CT_friction": ("contact friction", "#8b2fc9"),
    "CT_viscous": ("contact damping", "#c9a0e6"),
    "CT_numeric": ("contact, numerical", "#e6d5f2"),
    "FL_drag": ("fluid, drag", "#577590"),
    "FL_leak": ("fluid, leaked", "#90a4b4"),
    "FS_exchange": ("fluid exchange", "#b8c4ce"),
    "HEAT": ("heat", "#e76f51"),
    "ERODED": ("eroded", "#9aa5b1"),
    "EJECTED": ("ejected", "#b6bec7"),
    "MASS_SCALED": ("mass scaling", "#cbd2d9"),
    "RELAX": ("relaxation", "#dfe3e8"),
}
WORK = "W_ext"
RESIDUALS = {"RES_1": ("bookkeeping (level 1)", 1e-10), "RES_2": ("consistency (level 2)", 1e-2)}
COUNTS = ("bonded", "inserted", "released", "fragments", "contact_points", "contacts",
          "contacts_lost", "nodes", "crack_area", "crack_energy", "mass")
# Kept or lost by the whole scene; columns such as momentum.x.
TOTALS = ("momentum.", "angular_momentum.")
NO_SENSOR = {"time", "step", "dt", WORK, *ENERGIES, *COUNTS}


def column(history, name):
    """A column whatever its case, or None."""
    for key, values in history.items():
        if key.lower() == name.lower():
            return values
    return None


def is_ledger(name):
    known = {k.lower() for k in NO_SENSOR} | {k.lower() for k in RESIDUALS}
    return name.lower() in known or name.lower().startswith(("w_", *TOTALS))


def sensors(history):
    return [name for name in history if not is_ledger(name)]


# Columns of a sensor end in what they measure (docs/output.md): load.y, gauge.ux, gauge.sxy.
QUANTITIES = [
    (re.compile(r"^(.*)\.([xyz])$"), "force", "N"),
    (re.compile(r"^(.*)\.u([xyz])$"), "displacement", "m"),
    (re.compile(r"^(.*)\.v([xyz])$"), "velocity", "m/s"),
    (re.compile(r"^(.*)\.s([xyz]{2})$"), "stress", "Pa"),
]


@dataclasses.dataclass
class Sensor:
    """Columns of one quantity at one sensor, by component."""

    title: str
    unit: str
    columns: dict

    def scale(self):
        values = np.concatenate(list(self.columns.values()))
        finite = values[np.isfinite(values)]
        return style.prefixed(self.unit, float(np.abs(finite).max(initial=0)))


def grouped(history):
    """Sensors of the history, the components of one quantity together."""
    found = {}
    for name in sensors(history):
        for pattern, quantity, unit in QUANTITIES:
            match = pattern.match(name)
            if match:
                title = f"{match[1]}, {quantity}"
                found.setdefault(title, Sensor(title, unit, {})).columns[match[2]] = history[name]
                break
        else:
            found[name] = Sensor(name, "", {"": history[name]})
    return list(found.values())


def time_axis(history):
    """Time in a unit fit for print, and the label of the axis."""
    time = history["time"]
    factor, unit = style.prefixed("s", float(np.nanmax(time)) if len(time) else 0)
    return time * factor, style.label("time", unit)


def draw_sensor(axes, history, sensor):
    time, label = time_axis(history)
    factor, unit = sensor.scale()
    axes.axhline(0, color=style.QUIET, linewidth=0.7)
    for k, (component, values) in enumerate(sensor.columns.items()):
        colour = style.LINES[k % len(style.LINES)]
        axes.plot(time, values * factor, color=colour, label=component, zorder=3 - 0.01 * k)  # the first on top
    axes.set_title(sensor.title)
    axes.set_ylabel(unit)
    axes.set_xlabel(label)
    axes.margins(x=0)
    if len(sensor.columns) > 1:
        axes.legend(ncol=min(len(sensor.columns), 3), loc="best", handlelength=1.2, columnspacing=1)


def mark_peak(axes, history, sensor):
    """A dot and a number at the largest value."""
    time, _ = time_axis(history)
    factor, unit = sensor.scale()
    values = max(sensor.columns.values(), key=lambda v: np.abs(np.nan_to_num(v)).max(initial=0)) * factor
    if not np.isfinite(values).any():
        return
    k = int(np.nanargmax(np.abs(values)))
    left, up = time[k] > 0.5 * time[-1], values[k] > 0
    axes.plot(time[k], values[k], "o", color=style.INK, markersize=5)
    text = style.minus(f"{values[k]:.4g} {unit}")
    axes.annotate(text, (time[k], values[k]), xytext=(-7 if left else 7, 7 if up else -7), textcoords="offset points",
                  ha="right" if left else "left", va="bottom" if up else "top", size=10, weight="bold")
    axes.margins(y=0.2)


def draw_counts(axes, history):
    """How many faces opened and broke, in how many pieces the bodies are."""
    time, label = time_axis(history)
    for name, colour in (("inserted", style.LINES[0]), ("released", style.LINES[1]), ("fragments", style.LINES[2])):
        values = column(history, name)
        if values is not None:
            axes.plot(time, values, color=colour, label={"released": "broken"}.get(name, name))
    axes.set_title("faces and fragments")
    axes.set_xlabel(label)
    axes.margins(x=0)
    axes.legend(loc="upper left")


def has_counts(history):
    return any(column(history, name) is not None for name in ("inserted", "released", "fragments"))


def present_energies(history):
    """(title, colour, values) of the energies that ever matter, in the order of stacking."""
    found = [(*drawn, column(history, name)) for name, drawn in ENERGIES.items()]
    found = [entry for entry in found if entry[2] is not None and np.isfinite(entry[2]).any()]
    largest = max((np.nanmax(np.abs(values)) for *_, values in found), default=0)
    return [entry for entry in found if np.nanmax(np.abs(entry[2])) > 1e-3 * largest]


def draw_ledger(axes, history):
    """Energies stacked, the work done on the bodies as a line on top."""
    time, label = time_axis(history)
    energies = present_energies(history)
    work = column(history, WORK)
    tops = [np.nanmax(sum(np.maximum(v, 0) for *_, v in energies))] if energies else [0]
    if work is not None:
        tops.append(np.nanmax(np.abs(work)))
    factor, unit = style.prefixed("J", max(tops))
    if energies:
        titles, colours, values = zip(*energies)
        axes.stackplot(time, [np.maximum(v, 0) * factor for v in values], colors=colours, linewidth=0, labels=titles)
    if work is not None:
        axes.plot(time, work * factor, color=style.INK, linewidth=1.5, linestyle=(0, (4, 2)), label="external work")
    axes.set_title("energy")
    axes.set_ylabel(unit)
    axes.set_xlabel(label)
    axes.margins(x=0)
    axes.set_ylim(bottom=min(0, axes.get_ylim()[0]))
    handles, names = axes.get_legend_handles_labels()
    if handles:  # top of the stack first, as the eye meets it
        axes.legend(handles[::-1], names[::-1], loc="upper left", bbox_to_anchor=(1.0, 1.03), fontsize=9,
                    labelspacing=0.35, handlelength=1.2)


def draw_residuals(axes, history):
    time, label = time_axis(history)
    for (name, (title, alarm)), colour in zip(RESIDUALS.items(), style.LINES):
        values = column(history, name)
        if values is None:
            continue
        axes.semilogy(time, np.where(values == 0, np.nan, np.abs(values)), color=colour)
        axes.axhline(alarm, color=colour, linewidth=1, linestyle=(0, (2, 2)))
        axes.annotate(f"{title}: alarm at {alarm:g}", (0.005, alarm), xycoords=("axes fraction", "data"),
                      xytext=(0, 3), textcoords="offset points", size=9, color=colour)
    axes.set_title("residuals of the ledger")
    axes.set_xlabel(label)
    axes.margins(x=0, y=0.12)


def main_sensor(history):
    """The sensor a reader looks at first: a force if there is one, reduced to its largest component."""
    groups = grouped(history)
    groups = [g for g in groups if g.unit == "N"] or groups
    if not groups:
        return None
    sensor = groups[0]
    component, values = max(sensor.columns.items(), key=lambda c: np.abs(np.nan_to_num(c[1])).max(initial=0))
    title = f"{sensor.title} {component}".strip()
    return Sensor(title, sensor.unit, {component: values})
