#!/usr/bin/env python3
"""Hard cases: runs scenes and holds each against the common rule and its own checks.

run_cases.py EXECUTABLE CASE.toml ... [--long] [--mixed] [--table PAGE] [--keep FOLDER]

A case is a scene whose first lines say what it is:

    #: case S-08                      what it belongs to
    #: slow                           its test is in the slow set, not in the quick one
    #: run NAME KEY=VALUE; KEY=VALUE  one run with these settings; several such lines are several runs
    #: long KEY=VALUE; KEY=VALUE      settings of its version in the long set (--long)
    #: only_long                      it says something only there
    #: refused TEXT                   the scene must be refused (exit status 2) with TEXT in the message
    #: stops TEXT                     the run must not end but stop (exit status 1) with a reason that has TEXT in it
    #: residual 0.02 WHY              another limit for the balance of energy than 1 %
    #: alike 1e-6                     all runs have the history of the first within this share of each sensor's or energy's peak
    #: swapped 1e-12                  so has a run with the bodies in the opposite order

The common rule: the run completes, all numbers of history.csv are finite, mass is kept to 1e-12, momenta to 1e-10 where
nothing acts from outside (angular momentum to 1e-4 where faces break: an open face that still holds has a lever), res_1 is below 1e-10, and the balance of energy stays within 1 % of the largest energy, also
where CT_numeric, what contact gives unasked, counts as a gain. --table writes the rows of the page. --mixed: in mixed
precision, where torques are rounded to single and angular momentum is kept to 1e-6.
"""

import argparse
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

STORED = ("KE", "IE_elastic", "IF_stored", "CT_stored")
BEGIN, END = "<!-- cases -->", "<!-- end of cases -->"


class Case:
    def __init__(self, path):
        self.path, self.name = path, path.stem
        self.number, self.slow, self.stops, self.refused, self.limit = "", False, "", "", 0.01
        self.runs, self.long, self.alike, self.swapped = {}, [], 0.0, 0.0
        for word, rest in re.findall(r"^#: (\w+) ?(.*)$", path.read_text(encoding="utf-8"), re.M):
            if word == "case":
                self.number = rest
            elif word in ("slow", "only_long"):
                self.slow = True
            elif word == "run":
                name, _, settings = rest.partition(" ")
                self.runs[name] = split(settings)
            elif word == "long":
                self.long = split(rest)
            elif word in ("stops", "refused"):
                setattr(self, word, rest)
            elif word == "residual":
                self.limit = float(rest.split()[0])
            elif word in ("alike", "swapped"):
                setattr(self, word, float(rest))
            else:
                raise SystemExit(f"{path}: '#: {word}' means nothing")
        self.runs = self.runs or {"": []}

    def said(self, key):
        found = re.search(rf'^{key}\s*=\s*"(.*)"$', self.path.read_text(encoding="utf-8"), re.M)
        return found.group(1) if found else ""

    def alone(self):
        """Nothing acts from outside."""
        return not re.search(r"^\[+(boundary|gravity|excavate|run\.rest|initial_stress)", self.path.read_text("utf-8"), re.M)


def split(settings):
    return [setting.strip() for setting in settings.split(";") if setting.strip()]


def turned_round(text):
    """The scene with its bodies in the opposite order."""
    bodies = re.findall(r"^\[\[body\]\]\n(?:(?!\[(?!body\.)).*\n)*", text, re.M)
    for k, body in enumerate(bodies):
        text = text.replace(body, f"@{k}@\n", 1)
    for k, body in enumerate(reversed(bodies)):
        text = text.replace(f"@{k}@\n", body)
    return text


class Run:
    def __init__(self, executable, scene, settings, folder):
        command = [executable, "run", str(scene), "--output", str(folder), "--quiet", "--threads", "1"]
        for setting in settings:
            command += ["--set", setting]
        result = subprocess.run(command, capture_output=True, text=True)
        self.status, self.text = result.returncode, (result.stdout + result.stderr).strip()
        self.report, self.rows = None, []
        if (folder / "report.json").is_file():
            self.report = json.loads((folder / "report.json").read_text())
            with open(folder / "history.csv", newline="") as table:
                self.rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(table)]
            if self.report["status"] == "failed":  # the last row shows what stopped it
                self.rows.pop()
            with open(folder / "fragments.csv", newline="") as table:
                self.pieces = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(table)]

    def energies(self):
        """Names of what is stored and what is spent."""
        names = list(self.rows[0])
        names = names[names.index("KE") : names.index("RES_1")]
        return [n for n in names if n in STORED], [n for n in names if n not in STORED and n != "W_ext"]

    def scale(self):
        stored, spent = self.energies()
        return max(max(sum(r[n] for n in stored), abs(r.get("W_ext", 0)), sum(r[n] for n in spent)) for r in self.rows)

    def balance(self, without=()):
        """What energy has come from nowhere, J, row by row."""
        stored, spent = self.energies()
        kept = [n for n in stored + spent if n not in without]
        total = [sum(r[n] for n in kept) - r.get("W_ext", 0) for r in self.rows]
        return [t - total[0] for t in total]

    def residual(self):
        return max(abs(b) for b in self.balance()) / self.scale() if self.scale() > 0 else 0.0

    def growth(self):
        """What contact gives unasked counts as a gain."""
        return max(self.balance(("CT_numeric",))) / self.scale() if self.scale() > 0 else 0.0

    def drift(self, kind):
        """Largest change of a momentum over an upper bound of the sum of momenta; of angular momentum over that times the
        size of the scene."""
        first, most = self.rows[0], max(r["KE"] for r in self.rows)
        speed = math.sqrt(2 * first["mass"] * most)
        reach = max(math.hypot(p["x"], p["y"], p.get("z", 0)) + p["length"] for p in self.pieces)
        worst = 0.0
        for name in first:
            if name.split(".")[0] == kind and speed > 0:
                worst = max(worst, max(abs(r[name] - first[name]) for r in self.rows) / speed)
        return worst / (reach if kind == "angular_momentum" else 1.0)


def apart(run, other):
    """Largest difference of two histories, over the peak of the energy or of the sensor's kind."""
    names = list(run.rows[0])
    groups = {}
    for name in names[names.index("angular_momentum.z") + 1 : names.index("RES_1")]:
        if not name.startswith("contacts"):
            groups.setdefault(re.sub(r"(?<=[uv.])[xyz]$", "", name), []).append(name)
    worst = 0.0
    energy = run.scale()
    for group, members in groups.items():
        scale = max(abs(r[n]) for r in run.rows for n in members) if "." in group else energy
        gap = max((abs(a[n] - b[n]) for a, b in zip(run.rows, other.rows) for n in members), default=0.0)
        worst = max(worst, gap / scale if scale > 0 else gap)
    return worst if len(run.rows) == len(other.rows) else math.inf


def faults(case, run, mixed):
    """What is wrong with a run, as sentences."""
    if case.refused:
        if run.status != 2 or case.refused not in run.text:
            yield f"not refused: exit status {run.status}: {run.text}"
        return
    if run.report is None:
        yield f"no report, exit status {run.status}: {run.text}"
        return
    if case.stops:
        if run.status != 1 or run.report["status"] != "failed":
            yield f"did not stop: exit status {run.status}, {run.report['status']}"
        if case.stops not in run.report["reason"]:
            yield f"stopped for another reason: {run.report['reason']}"
    elif run.report["status"] != "complete":
        yield f"{run.report['status']}: {run.report['reason']}"
    elif run.status not in (0, 3):
        yield f"exit status {run.status}: {run.text}"
    wrong = sorted({n for r in run.rows for n, v in r.items() if not math.isfinite(v)})
    if wrong:
        yield f"not finite: {', '.join(wrong)}"
        return
    masses = [r["mass"] for r in run.rows]
    if max(abs(m - masses[0]) for m in masses) > 1e-12 * masses[0]:
        yield f"mass from {min(masses):.17g} to {max(masses):.17g} kg"
    turning = 1e-4 if "IF_stored" in run.rows[0] else 1e-6 if mixed else 1e-10
    for kind, most in (("momentum", 1e-10), ("angular_momentum", turning)):
        if case.alone() and not run.drift(kind) <= most:
            yield f"{kind} drifts by {run.drift(kind):.2g} of its sum"
    if not max(r["RES_1"] for r in run.rows) < 1e-10:
        yield f"res_1 is {max(r['RES_1'] for r in run.rows):.3g}"
    if not run.residual() <= case.limit:
        yield f"balance of energy off by {run.residual():.3g} of the largest energy"
    if not run.growth() <= case.limit:
        yield f"energy grows by {run.growth():.3g} of the largest energy"
    for check in run.report["checks"]:
        if not check["pass"] and not (case.stops and check["value"] is None):
            yield f"{check['name']}: {check['value']} instead of {check['reference']} {check.get('note', '')}"


def runs_of(case, long, folder):
    """Name, scene, settings, and how much like the first each run must be."""
    for k, (name, settings) in enumerate(case.runs.items()):
        yield name, case.path, settings + (case.long if long else []), case.alike if k else 0.0
    if case.swapped:
        other = folder / "swapped.toml"
        other.write_text(turned_round(case.path.read_text(encoding="utf-8")), encoding="utf-8")
        yield "swapped", other, case.long if long else [], case.swapped


def try_case(executable, case, long, mixed, keep):
    """Runs a case; rows for the table, and what is wrong."""
    rows, wrong, first = [], [], None
    with tempfile.TemporaryDirectory(prefix="breccia-case-") as scratch:
        for name, scene, settings, like in runs_of(case, long, pathlib.Path(scratch)):
            folder = pathlib.Path(keep or scratch) / (case.name + "." + name)
            run = Run(executable, scene, settings + ['run.precision="mixed"'] * mixed, folder)
            bad = list(faults(case, run, mixed))
            first = first or run
            if like and run.rows and not (gap := apart(first, run)) <= like:
                bad.append(f"differs by {gap:.2g} from the first run")
            print(told(case, name, run) + (f", like the first to {apart(first, run):.1e}" if like and run.rows else ""))
            wrong += [f"{case.name} {name}: {fault}" for fault in bad]
            verdict = "falls short" if bad else "refused" if case.refused else "stops by name" if case.stops else "holds"
            cost = (run.report["steps"], run.report["wall_seconds"], run.residual()) if run.rows else (0, 0.0, 0.0)
            rows.append((case, name, *cost, verdict))
    return rows, wrong


def told(case, name, run):
    said = f"{case.name} {name}: "
    if run.report:
        said += f"{run.report['steps']} steps, {run.report['wall_seconds']:.2f} s"
    for check in (run.report or {}).get("checks", []):
        shown = check["value"] if check["value"] is None else f"{check['value']:.6g}"
        said = f"    {check['name']}: {shown} ({check['reference']} within {check['tolerance']:.3g})\n" + said
    if run.rows:
        said += f", balance {run.residual():.1e}, growth {run.growth():.1e}, momenta {run.drift('momentum'):.0e} {run.drift('angular_momentum'):.0e}"
        said += f", res_1 {max(r['RES_1'] for r in run.rows):.1e}"
    return said


def table(rows):
    """Rows of Markdown: the worst of the runs of a case."""
    for path in dict.fromkeys(row[0].path for row in rows):
        mine = [row for row in rows if row[0].path == path]
        case, steps = mine[0][0], sorted({row[2] for row in mine})
        shown = " to ".join(f"{n:,}".replace(",", " ") for n in dict.fromkeys((steps[0], steps[-1]))) if steps[-1] else ""
        balance = f"{max(row[4] for row in mine):.0e}" if steps[-1] else ""
        verdict = next((row[5] for row in mine if row[5] == "falls short"), mine[0][5])
        runs = f" ({len(mine)} runs)" if len(mine) > 1 else ""
        yield (
            f"| `{case.name}`{runs} | {case.number} | {case.said('title')}: {case.said('expected')} | {shown} "
            f"| {sum(row[3] for row in mine):.1f} | {balance} | {verdict} |"
        )


def write_table(page, rows):
    text = page.read_text(encoding="utf-8")
    head = "| case | of | what must hold | steps | s | balance | verdict |\n|---|---|---|---|---|---|---|\n"
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    page.write_text(before + BEGIN + "\n" + head + "\n".join(table(rows)) + "\n" + END + after, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("executable")
    parser.add_argument("cases", type=pathlib.Path, nargs="+")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--mixed", action="store_true")
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path)
    a = parser.parse_args()
    rows, wrong = [], []
    for path in a.cases:
        found, bad = try_case(str(pathlib.Path(a.executable).resolve()), Case(path.resolve()), a.long, a.mixed, a.keep)
        rows, wrong = rows + found, wrong + bad
    if a.table:
        write_table(a.table, rows)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
