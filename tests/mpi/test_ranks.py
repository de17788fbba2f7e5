#!/usr/bin/env python3
"""Scenes on several numbers of ranks: the same bits of the state, the same history to round-off; restarts on another
number; one message where all ranks fail.

    test_ranks.py BRECCIA"""

import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

BRECCIA = sys.argv[1]
SCENES = pathlib.Path(__file__).parent / "scenes"
ENVIRONMENT = {
    **os.environ,
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
}
passed, failed = 0, 0


def expect(condition, text):
    global passed, failed
    passed, failed = passed + bool(condition), failed + (not condition)
    if not condition:
        print("FAILED:", text)


def command(ranks, *arguments):
    launcher = [] if ranks == 1 else ["mpirun", "-n", str(ranks)]
    return [*launcher, BRECCIA, *arguments]


def run(ranks, *arguments):
    return subprocess.run(command(ranks, *arguments), env=ENVIRONMENT, capture_output=True, text=True, timeout=240)


def run_scene(ranks, scene, output, *more):
    return run(ranks, "run", str(scene), "--quiet", "--threads", "1", "--output", str(output), *more)


def report(output):
    return json.loads((output / "report.json").read_text())


def history(output):
    rows = list(csv.reader(open(output / "history.csv")))
    return rows[0], [[float(x) for x in row] for row in rows[1:]]


def compare_histories(name, ranks, one, many):
    """Sums are added rank by rank: columns agree to a share of their largest value, momenta and residuals aside."""
    columns, rows = history(one)
    others, more = history(many)
    expect(columns == others and len(rows) == len(more), f"{name} on {ranks} ranks: columns or rows differ")
    for i, column in enumerate(columns):
        if "momentum" in column or column.startswith("RES"):
            continue
        scale = max(max(abs(row[i]) for row in rows), 1e-12)
        worst = max(abs(a[i] - b[i]) for a, b in zip(rows, more))
        expect(worst <= 1e-9 * scale, f"{name} on {ranks} ranks: {column} differs by {worst:.3g} of {scale:.3g}")


def check_scene(folder, name, numbers):
    one = folder / f"{name}.1"
    alone = run_scene(1, SCENES / f"{name}.toml", one)
    expect(alone.returncode == 0, f"{name} on one rank: {alone.stderr}")
    expected = report(one)
    for ranks in numbers:
        output = folder / f"{name}.{ranks}"
        result = run_scene(ranks, SCENES / f"{name}.toml", output)
        expect(result.returncode == 0, f"{name} on {ranks} ranks: status {result.returncode}, {result.stderr}")
        if result.returncode != 0:
            continue
        found = report(output)
        for key in ("state_hash", "steps", "elements", "nodes", "interfaces", "fragments"):
            expect(found[key] == expected[key], f"{name} on {ranks} ranks: {key} {found[key]}, not {expected[key]}")
        expect(found["ranks"] == ranks, f"{name}: the report says {found['ranks']} ranks, not {ranks}")
        compare_histories(name, ranks, one, output)
    return expected


def check_restart(folder, name, before, after):
    """Interrupted on one number of ranks, it ends on another with the bits of a run that was not."""
    output = folder / f"restart.{before}.{after}"
    job = subprocess.Popen(command(before, "run", str(SCENES / f"{name}.toml"), "--quiet", "--threads", "1", "--output",
                                   str(output), "--set", "output.checkpoint=0.2"), env=ENVIRONMENT,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    wait = time.time() + 60
    while not (output / "checkpoint.h5").exists() and job.poll() is None and time.time() < wait:
        time.sleep(0.02)
    running = job.poll() is None
    os.killpg(job.pid, signal.SIGKILL)  # with all its ranks: nobody can say goodbye
    job.wait()
    expect(running, f"{name} had ended before it could be interrupted")
    result = run_scene(after, SCENES / f"{name}.toml", output, "--restart", "--set", "output.checkpoint=0.2")
    expect(result.returncode == 0, f"restart of {name} on {after} ranks: {result.stderr}")
    return report(output)["state_hash"]


def check_failures(folder):
    result = run_scene(3, SCENES / "two_elements.toml", folder / "few")
    expect(result.returncode == 2, f"more ranks than elements: status {result.returncode}")
    expect(result.stderr.count("error:") == 1 and "3 ranks" in result.stderr, f"more ranks than elements: {result.stderr}")
    expect(not (folder / "few" / "report.json").exists(), "more ranks than elements: something was written")
    result = run_scene(2, folder / "absent.toml", folder / "absent")
    expect(result.returncode == 2 and result.stderr.count("error:") == 1, f"no scene: {result.stderr}")
    result = run_scene(2, SCENES / "strip.toml", folder / "rigid", "--set", "body.strip.rigid=true")
    expect(result.returncode == 2 and result.stderr.count("error:") == 1, f"a rigid body: {result.stderr}")
    result = run(2, "check", str(SCENES / "strip.toml"))
    expect(result.returncode == 2 and result.stderr.count("error:") == 1, f"check on two ranks: {result.stderr}")


def main():
    if shutil.which("mpirun") is None:
        print("skipped: there is no mpirun")
        return 77
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        check_scene(folder, "strip", (2, 3, 4, 7))
        check_scene(folder, "cube", (2, 3, 7))
        check_scene(folder, "blocks", (2, 4, 7))
        smash = check_scene(folder, "smash", (3, 5))
        hashes = {f"{a} to {b}": check_restart(folder, "smash", a, b) for a, b in ((3, 1), (1, 2), (2, 4))}
        for ways, found in hashes.items():
            expect(found == smash["state_hash"], f"restart from {ways} ranks: {found}, not {smash['state_hash']}")
        check_failures(folder)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


sys.exit(main())
