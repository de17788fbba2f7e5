"""Colours, type and numbers that all pictures share."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap

INK, QUIET, FAINT = "#1f2933", "#66727f", "#d9dee4"
# Light at the low end, so that cracks stand out; equal steps of lightness.
SEQUENTIAL = LinearSegmentedColormap.from_list(
    "breccia", ["#f3f5f7", "#cfdfe6", "#9dc3d3", "#66a0bb", "#3d7a9e", "#27567f", "#1b335a"]
)
DIVERGING = LinearSegmentedColormap.from_list(
    "breccia_signed", ["#27567f", "#66a0bb", "#bcd6e0", "#f5f5f3", "#eccdb0", "#cf9259", "#94561d"]
)
CRACK = {"tension": "#d1202f", "mixed": "#8b2fc9", "shear": "#f08c00"}
LINES = ["#27567f", "#d1202f", "#4f8a6b", "#f08c00", "#8b2fc9", "#66a0bb"]
SPARE = "#9aa5b1"

PREFIXES = [(1e12, "T"), (1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")]


def set_up():
    plt.rcParams.update(
        {
            "font.family": "DejaVu Sans",
            "font.size": 11,
            "text.color": INK,
            "axes.edgecolor": QUIET,
            "axes.labelcolor": INK,
            "axes.linewidth": 0.8,
            "axes.titlesize": 12,
            "axes.titleweight": "bold",
            "axes.titlelocation": "left",
            "axes.titlepad": 10,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "axes.axisbelow": True,
            "grid.color": FAINT,
            "grid.linewidth": 0.6,
            "xtick.color": QUIET,
            "ytick.color": QUIET,
            "xtick.labelcolor": INK,
            "ytick.labelcolor": INK,
            "legend.frameon": False,
            "legend.fontsize": 10,
            "lines.linewidth": 1.8,
            "figure.facecolor": "white",
            "savefig.dpi": 150,
        }
    )


def prefixed(unit, largest):
    """Factor and unit that bring numbers up to `largest` into 1 ... 1000 ("Pa", 8e6: 1e-6, "MPa")."""
    if unit in ("", "1") or not np.isfinite(largest) or largest <= 0:
        return 1.0, "" if unit == "1" else unit
    if unit not in ("m", "s") and 0.1 <= largest < 1:
        return 1.0, unit  # 0.9 m/s rather than 900 mm/s
    for size, prefix in PREFIXES:
        if largest >= size:
            return 1 / size, prefix + unit
    return 1 / PREFIXES[-1][0], PREFIXES[-1][1] + unit


def count(number):
    """A whole number with its thousands apart: 20 000."""
    return f"{number:,}".replace(",", "\u2009")


def minus(text):
    return text.replace("-", "\u2212")


def label(name, unit):
    return f"{name} [{unit}]" if unit else name


def save(figure, path, dots_per_inch=None):
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=dots_per_inch or plt.rcParams["savefig.dpi"])
    plt.close(figure)
    print(path)
