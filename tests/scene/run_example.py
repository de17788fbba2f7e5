#!/usr/bin/env python3
"""Runs an example as a user does and holds it against its own checks:

run_example.py EXECUTABLE EXAMPLE_FOLDER [--threads N ...] [--set KEY=VALUE ...] [--unchecked]

With several numbers of threads the bits must be the same for all of them (V-145). --unchecked: the run was shortened
with --set, so that its checks cannot pass; it must complete all the same.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile


def run(executable, example, output, threads, options):
    command = [executable, "run", str(example), "--output", str(output), "--quiet", "--threads", str(threads)]
    for option in options:
        command += ["--set", option]
    result = subprocess.run(command, capture_output=True, text=True)
    return result.returncode, result.stdout + result.stderr


def faults(status, text, report, checked):
    """What is wrong with a run, as sentences."""
    if status not in ((0,) if checked else (0, 3)):
        yield f"exit status {status}: {text.strip()}"
    if report["status"] != "complete":
        yield f"status {report['status']}: {report['reason']}"
    if not report["ledger"]["res_1"] < 1e-10:
        yield f"res_1 is {report['ledger']['res_1']:.3g}, round-off of energy must be below 1e-10"
    if checked and not report["checks"]:
        yield "the scene has no checks"
    for check in report["checks"] if checked else ():
        if not check["pass"]:
            yield f"{check['name']}: {check['value']} instead of {check['reference']} {check.get('note', '')}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("executable")
    parser.add_argument("example", type=pathlib.Path)
    parser.add_argument("--threads", type=int, nargs="+", default=[1])
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--unchecked", action="store_true")
    a = parser.parse_args()
    wrong, hashes, histories = [], {}, {}
    for threads in a.threads:
        with tempfile.TemporaryDirectory(prefix="breccia-example-") as folder:
            output = pathlib.Path(folder) / "run"
            status, text = run(a.executable, a.example, output, threads, a.set)
            if not (output / "report.json").is_file():
                print(f"{threads} threads: no report, exit status {status}\n{text}")
                return 1
            report = json.loads((output / "report.json").read_text())
            wrong += [f"{threads} threads: {fault}" for fault in faults(status, text, report, not a.unchecked)]
            if report["threads"] != threads:
                wrong.append(f"asked for {threads} threads, ran with {report['threads']}")
            hashes[threads] = report["state_hash"]
            histories[threads] = (output / "history.csv").read_bytes()
            print(f"{threads} threads: {report['steps']} steps, {report['wall_seconds']:.1f} s, state {hashes[threads]}")
    if len(set(hashes.values())) > 1:
        wrong.append("the bits of the state depend on the number of threads")
    if len(set(histories.values())) > 1:
        wrong.append("history.csv depends on the number of threads")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
