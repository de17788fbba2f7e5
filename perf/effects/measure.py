#!/usr/bin/env python3
"""Time per step of one block as effects are added one at a time: measure.py EXECUTABLE FOLDER [--draw] [--turns N]

Writes FOLDER/effects.csv (medians over the turns, one row per variant and effect) and FOLDER/effects.png."""
import argparse
import csv
import importlib.util
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

# A block of 50 000 elements; the loads are small, so that nothing breaks until it is asked to.
BLOCK = {
    2: dict(shape="rectangle", origin="[0, 0]", size="[1, 1]", cells="[158, 158]", pattern="right"),
    3: dict(shape="box", origin="[0, 0, 0]", size="[1, 1, 1]", cells="[20, 20, 20]", pattern="kuhn"),
}
# Some hundred steps each; of a block that bursts so many that a part of its faces has become interfaces.
IDLE = {2: "0.2 ms", 3: "1 ms"}
SPRINGS = {2: "0.01 ms", 3: "0.06 ms"}
BURST = {2: "0.06 ms", 3: "0.1 ms"}
STRENGTH = """[fracture.rock]
tensile_strength = "8 MPa"
cohesion = "24 MPa"
friction_angle = "40 deg"
energy_tension = "{tension}"
energy_shear = "{shear}"
alpha = {alpha}
"""


def strength(alpha, dimension):
    energies = ("1 kJ/m2", "10 kJ/m2") if dimension == 2 else ("20 kJ/m2", "200 kJ/m2")
    return STRENGTH.format(alpha=alpha, tension=energies[0], shear=energies[1])


def vector(dimension, last):
    return "[" + ", ".join(["0"] * (dimension - 1) + [last]) + "]"


def added(dimension):
    """(what is added, where it goes, text) in order; each variant has all before it."""
    return [
        ("elastic block", "", ""),
        ("+ damping", "material", "damping = 0.02\n"),
        ("+ gravity", "sections", f"[gravity]\nacceleration = {vector(dimension, '-9.81')}\n"),
        ("+ boundary", "sections",
         f'[[boundary]]\nwhere = "b.bottom"\nfixed = {vector(dimension, "0")}\n'
         '[[boundary]]\nwhere = "b.top"\npressure = "10 kPa"\n'),
        ("+ fracture, idle", "sections", strength(0.95, dimension)),
        ("+ contact, idle", "sections", "[contact]\nfriction = 0.3\n"),
        ("+ 3 sensors", "sections",
         "".join(f'[[sensor]]\nname = "s{i}"\npoint = [{", ".join([str(0.3 + 0.1 * i)] * dimension)}]\n'
                 for i in range(3))),
        ("+ 100 rows of history", "history", "100"),
        ("+ 10 frames", "frames", "10"),
    ]


def variants(dimension):
    """name -> text of the scene"""
    scenes = {}
    parts = {"material": "", "sections": "", "history": "1", "frames": "0"}
    for name, place, text in added(dimension):
        if place in ("history", "frames"):
            parts[place] = text
        elif place:
            parts[place] += text
        scenes[name] = scene_text(dimension, parts)
    free = {"material": "damping = 0.02\n", "history": "1", "frames": "0"}
    contact = "[contact]\nfriction = 0.3\n"
    # All faces are springs from the start; nothing comes apart.
    scenes["interfaces in all faces"] = scene_text(
        dimension, dict(free, sections=strength(0, dimension), duration=SPRINGS[dimension]))
    burst = dict(free, sections=strength(0.95, dimension) + contact, spin=400, duration=BURST[dimension])
    scenes["bursting: cracks, contact"] = scene_text(dimension, burst)
    law = ('[[contact.pair]]\nbetween = ["rock"]\nfriction = 0.3\nlaw = "ageing"\na = 0.010\nb = 0.015\n'
           'state_slip = "10 um"\n')
    scenes["+ rate-and-state friction"] = scene_text(dimension, dict(burst, sections=burst["sections"] + law))
    return scenes


def scene_text(dimension, parts):
    block = BLOCK[dimension]
    spin = parts.get("spin", 0)
    spin = f"spin = {spin if dimension == 2 else [0, 0, spin]}\n" if spin else ""
    duration = parts.get("duration", IDLE[dimension])
    number, unit = duration.split()
    return f"""[run]
dimension = {dimension}
duration = "{duration}"
[[body]]
name = "b"
material = "rock"
{spin}shape = {{ {block["shape"]} = {{ corner = {block["origin"]}, size = {block["size"]} }} }}
mesh = {{ generator = "structured", jitter = 0.1, pattern = "{block["pattern"]}", cells = {block["cells"]} }}
[material.rock]
density = 2650
elastic = {{ young = 60e9, poisson = 0.25 }}
{parts["material"]}{parts["sections"]}[output]
frames = {parts["frames"]}
history = "{float(number) / int(parts["history"])} {unit}"
"""


def run(executable, text, folder):
    scene = folder / "scene.toml"
    scene.write_text(text)
    subprocess.run([executable, "run", scene, "--output", folder / "out", "--overwrite", "--quiet"], check=True,
                   env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"), stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return json.loads((folder / "out" / "report.json").read_text())


def measure(executable, turns):
    reports = {}
    with tempfile.TemporaryDirectory() as folder:
        for turn in range(turns):
            for dimension in BLOCK:
                for name, text in variants(dimension).items():
                    report = run(executable, text, pathlib.Path(folder))
                    reports.setdefault((dimension, name), []).append(report)
                    print(f"turn {turn + 1}  {dimension}D  {name:<36} {report['steps']:>6} steps "
                          f"{report['wall_seconds']:.2f} s", flush=True)
    rows = []
    for (dimension, name), list_of in reports.items():
        first = list_of[0]
        for effect, what in first["effects"].items():
            per_step = statistics.median(r["effects"][effect]["seconds"] / r["steps"] for r in list_of)
            rows.append(dict(dimension=dimension, variant=name, effect=effect, elements=first["elements"],
                             steps=first["steps"], microseconds_per_step=f"{per_step * 1e6:.2f}",
                             bytes_per_element=f"{what['bytes'] / first['elements']:.1f}",
                             inserted=first["interfaces"]["inserted"] + first["interfaces"]["released"],
                             bonded=first["interfaces"]["bonded"]))
    return rows


ORDER = ["solid", "motion", "boundary", "fracture", "contact", "guard", "output"]


def draw(rows, path):
    from breccia_plot import style
    import matplotlib.pyplot as plt

    style.set_up()
    colours = dict(zip(ORDER, ["#27567f", "#66a0bb", "#4f8a6b", "#d1202f", "#f08c00", style.SPARE, "#8b2fc9"]))
    figure, grid = plt.subplots(
        2, 2, figsize=(13, 7.5), gridspec_kw=dict(height_ratios=[9, 3], hspace=0.28, wspace=0.62))
    for column, dimension in enumerate((2, 3)):
        here = [row for row in rows if int(row["dimension"]) == dimension]
        names = list(dict.fromkeys(row["variant"] for row in here))
        for axes, part in zip(grid[:, column], (names[:9], names[9:])):
            for y, name in enumerate(part):
                left = 0.0
                own = {r["effect"]: r for r in here if r["variant"] == name}
                for effect in ORDER:
                    if effect not in own:
                        continue
                    width = float(own[effect]["microseconds_per_step"]) / int(own[effect]["elements"]) * 1e3
                    axes.barh(y, width, left=left, color=colours[effect], height=0.68)
                    left += width
                axes.text(left, y, f"  {left:.1f}" if left < 100 else f"  {left:.0f}", va="center", fontsize=10)
            axes.set_yticks(range(len(part)), part)
            axes.invert_yaxis()
            axes.grid(axis="y", visible=False)
            axes.margins(x=0.12)
        elements = int(here[0]["elements"])
        grid[0, column].set_title(f"{'Plane' if dimension == 2 else 'Space'}, {elements:,} elements".replace(",", " "))
        grid[1, column].set_xlabel("ns per element and step")
    handles = [plt.Rectangle((0, 0), 1, 1, color=colours[effect]) for effect in ORDER]
    figure.legend(handles, ORDER, loc="upper center", ncols=len(ORDER), frameon=False, bbox_to_anchor=(0.5, 0.985))
    figure.savefig(path, dpi=110, bbox_inches="tight")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("executable")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--draw", action="store_true", help="only the picture, from effects.csv")
    arguments = parser.parse_args()
    system = "/usr/bin/python3"  # a Python of the user's own often stands before it and has no packages
    if importlib.util.find_spec("matplotlib") is None and sys.executable != system and os.path.exists(system):
        os.execv(system, [system, *sys.argv])
    arguments.folder.mkdir(parents=True, exist_ok=True)
    table = arguments.folder / "effects.csv"
    if not arguments.draw:
        rows = measure(arguments.executable, arguments.turns)
        with table.open("w", newline="") as file:
            writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    with table.open() as file:
        draw(list(csv.DictReader(file)), arguments.folder / "effects.png")


if __name__ == "__main__":
    main()
