"""What broke, as seismology counts it: magnitudes of emissions, sizes of fragments."""
import numpy as np

from . import style

BIN = 0.1  # of magnitude
FEW = 5  # fewer rows make no distribution


def gutenberg_richter(magnitudes, width=BIN):
    """b, its standard error, and the magnitude from which the catalogue is complete.

    Complete from the fullest bin on (maximum curvature); b = log10(e) / (mean - (complete - width / 2)) (Aki 1965,
    Utsu 1966), error b / sqrt(n).
    """
    bins = np.round(np.asarray(magnitudes) / width) * width
    values, counts = np.unique(np.round(bins, 6), return_counts=True)
    complete = values[np.argmax(counts)]
    above = bins[bins > complete - 0.5 * width]
    b = np.log10(np.e) / (above.mean() - (complete - 0.5 * width))
    return b, b / np.sqrt(len(above)), complete


def finite_magnitudes(emissions):
    magnitudes = emissions.get("magnitude", np.empty(0))
    return magnitudes[np.isfinite(magnitudes)]


def draw_magnitudes(axes, emissions):
    """Number of emissions at least as large, and the line of Gutenberg and Richter."""
    magnitudes = np.sort(finite_magnitudes(emissions))
    number = np.arange(len(magnitudes), 0, -1)
    axes.step(magnitudes, number, where="post", color=style.LINES[0])
    if magnitudes[-1] - magnitudes[0] > 2 * BIN:
        b, error, complete = gutenberg_richter(magnitudes)
        at = np.array([complete, magnitudes[-1]])
        start = (magnitudes >= complete - 0.5 * BIN).sum()
        axes.plot(at, start * 10 ** (-b * (at - complete)), color=style.LINES[1],
                  label=style.minus(f"b = {b:.2f} ± {error:.2f}, complete from {complete:.1f}"))
        axes.legend(loc="upper right")
    axes.set_yscale("log")
    axes.set_ylim(bottom=0.8)
    axes.set_title(f"{style.count(len(magnitudes))} emissions by magnitude")
    axes.set_xlabel("moment magnitude M")
    axes.set_ylabel("number of M or more")


def draw_emission_times(axes, emissions):
    """Magnitudes over time; area of a dot by its energy."""
    time, magnitude = emissions["time"], emissions["magnitude"]
    factor, unit = style.prefixed("s", float(time.max(initial=0)))
    energy = emissions["energy"] / max(emissions["energy"].max(), 1e-300)
    mode = emissions["mode"]
    for low, high, colour, label in ((1, 1.1, style.CRACK["tension"], "tension"),
                                     (1.1, 1.9, style.CRACK["mixed"], "mixed"),
                                     (1.9, 2.1, style.CRACK["shear"], "shear")):
        some = (mode >= low) & (mode < high)
        if some.any():
            axes.scatter(time[some] * factor, magnitude[some], s=6 + 150 * energy[some] ** 0.5, color=colour,
                         alpha=0.6, linewidths=0, label=label)
    axes.set_title("emissions over time")
    axes.set_xlabel(style.label("time", unit))
    axes.set_ylabel("moment magnitude M")
    axes.legend(loc="lower right", markerscale=0.7)


def last_fragments(fragments):
    """Columns of the last frame that has any."""
    last = fragments["frame"] == fragments["frame"].max()
    return {name: values[last] for name, values in fragments.items()}


def draw_fragment_sizes(axes, fragments):
    """Number of fragments at least as large."""
    size = np.sort(last_fragments(fragments)["size"])
    factor, unit = style.prefixed("m", float(size[-1]))
    axes.step(size * factor, np.arange(len(size), 0, -1), where="post", color=style.LINES[0])
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(bottom=0.8)
    axes.set_title(f"{style.count(len(size))} fragments by size")
    axes.set_xlabel(style.label("size", unit))
    axes.set_ylabel("number as large or larger")


def draw_fragment_speeds(axes, fragments):
    """Speed against mass."""
    last = last_fragments(fragments)
    speed = np.sqrt(sum(values**2 for name, values in last.items() if name.startswith("velocity_")))
    mass_factor, mass_unit = style.prefixed("g", 1e3 * float(last["mass"].max()))
    factor, unit = style.prefixed("m/s", float(speed.max(initial=0)))
    axes.scatter(1e3 * last["mass"] * mass_factor, speed * factor, s=12, color=style.LINES[0], alpha=0.6, linewidths=0)
    axes.set_xscale("log")
    axes.set_title("fragments by mass and speed")
    axes.set_xlabel(style.label("mass", mass_unit))
    axes.set_ylabel(style.label("speed", unit))


def panels(run):
    """Those that the run has enough rows for."""
    found = []
    if len(finite_magnitudes(run.emissions)) >= FEW:
        found += [(draw_magnitudes, run.emissions), (draw_emission_times, run.emissions)]
    if run.fragments and len(last_fragments(run.fragments)["size"]) >= FEW:
        found += [(draw_fragment_sizes, run.fragments), (draw_fragment_speeds, run.fragments)]
    return found
