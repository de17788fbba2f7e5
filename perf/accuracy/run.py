#!/usr/bin/env python3
"""Measures what accuracy costs in time: run.py BRECCIA TABLE.csv [CASE ...]

Runs every case of cases.py with every kind and size of element on one thread and adds a row to the table for each. Rows that are
there are kept, so that a run that was interrupted goes on; delete a row to measure it again.
"""
import csv
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

import cases

COLUMNS = ["case", "element", "divisions", "size", "elements", "nodes", "steps", "seconds", "value", "reference", "error"]
REPEAT_BELOW = 2.0  # s; the best of three counts


def processor_seconds():
    """Of the programs run so far, s: what other users of the machine do counts little."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measure(breccia, scene, files):
    """The report of the fastest run, with its processor seconds."""
    best = None
    for _ in range(3):
        before = processor_seconds()
        with tempfile.TemporaryDirectory(prefix="breccia-accuracy-") as name:
            folder = pathlib.Path(name)
            (folder / "scene.toml").write_text(scene)
            for file, text in files.items():
                (folder / file).write_text(text)
            command = [breccia, "run", "scene.toml", "--output", "out", "--quiet", "--threads", "1"]
            environment = {**os.environ, "OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false"}
            result = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment)
            if result.returncode not in (0, 3):
                raise SystemExit(f"exit status {result.returncode}: {result.stderr}")
            report = json.loads((folder / "out" / "report.json").read_text())
        if report["status"] != "complete" or not report.get("rest", {"reached": True})["reached"]:
            raise SystemExit(f"the run did not come to its end: {report['reason']}")
        report["seconds"] = processor_seconds() - before
        if best is None or report["seconds"] < best["seconds"]:
            best = report
        if report["seconds"] > REPEAT_BELOW:
            break
    return best


def row_of(case, element, divisions, report):
    value, reference = (report["checks"][0][key] for key in ("value", "reference"))
    return {
        "case": case.name, "element": element, "divisions": divisions, "size": f"{case.width / divisions:.6g}",
        "elements": report["elements"], "nodes": report["nodes"], "steps": report["steps"],
        "seconds": f"{report['seconds']:.3g}", "value": f"{value:.8g}", "reference": f"{reference:.8g}",
        "error": f"{value / reference - 1:.6g}",
    }


def main(breccia, table, *chosen):
    breccia, table = os.path.abspath(breccia), pathlib.Path(table)
    rows = list(csv.DictReader(table.open(newline=""))) if table.exists() else []
    done = {(row["case"], row["element"], int(row["divisions"])) for row in rows}
    for case in cases.CASES:
        for element, ladder in case.ladder.items():
            for divisions in ladder:
                if (case.name, element, divisions) in done or (chosen and case.name not in chosen):
                    continue
                row = row_of(case, element, divisions, measure(breccia, *case.scene(element, divisions)))
                print("{case} {element} {divisions}: {error} in {seconds} s".format(**row), flush=True)
                new = not table.exists()
                with table.open("a", newline="") as file:
                    writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
                    if new:
                        writer.writeheader()
                    writer.writerow(row)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
