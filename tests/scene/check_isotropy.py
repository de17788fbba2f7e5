#!/usr/bin/env python3
"""Do pebbles that have collided long enough move alike in all directions?

check_isotropy.py EXECUTABLE SCENE [--run FOLDER]

Runs the scene, which must pass its own checks, and holds the mean squares of the velocities along x and y against each
other, weighed by mass, over the last half of the frames; with --run a run that is there already.
"""

import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

ALIKE = 0.05  # VERIFICATION V-055
LONGEST = 0.05  # m, of what is a pebble


def squares(folder):
    """Mean squares of the velocities along x and y over the pebbles of each frame."""
    sums = {}
    with open(folder / "fragments.csv", newline="") as table:
        for row in csv.DictReader(table):
            if float(row["length"]) > LONGEST:
                continue
            mass, frame = float(row["mass"]), sums.setdefault(int(row["frame"]), [0.0, 0.0, 0.0])
            frame[0] += mass
            frame[1] += mass * float(row["velocity_x"]) ** 2
            frame[2] += mass * float(row["velocity_y"]) ** 2
    return [(x / mass, y / mass) for mass, x, y in (sums[k] for k in sorted(sums))]


def held(folder):
    late = squares(folder)
    late = late[len(late) // 2 :]
    x, y = (sum(frame[k] for frame in late) / len(late) for k in (0, 1))
    print(f"mean squares over {len(late)} frames: {x:.1f} along x, {y:.1f} m2/s2 along y, ratio {x / y:.3f}")
    return abs(x - y) <= ALIKE * (x + y) / 2


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("executable")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--run", type=pathlib.Path)
    a = parser.parse_args()
    if a.run:
        return 0 if held(a.run) else 1
    with tempfile.TemporaryDirectory(prefix="breccia-isotropy-") as folder:
        output = pathlib.Path(folder) / "run"
        command = [a.executable, "run", str(a.scene), "--output", str(output), "--quiet", "--threads", "1"]
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode:
            print(f"exit status {result.returncode}\n{result.stdout}{result.stderr}")
            return 1
        return 0 if held(output) else 1


if __name__ == "__main__":
    sys.exit(main())
