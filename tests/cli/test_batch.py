#!/usr/bin/env python3
"""`breccia batch` as a user meets it: test_batch.py EXECUTABLE [unittest options]"""

import csv
import json
import os
import pathlib
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import unittest

from pushed_bar import SCENE

EXECUTABLE = ""
ROOT = pathlib.Path(__file__).resolve().parents[2]

SWEEP = """\
[batch]
scene   = "bar.toml"
collect = { stress = "peak(-middle.sxx)" }

[[batch.vary]]
key    = "material.steel.elastic.young"
values = ["100 GPa", "200 GPa", "300 GPa"]
name   = "young"

[[batch.vary]]
key    = "cells"
values = [[4, 1], [8, 2]]
"""
DRAWN = """\
[batch]
scene = "bar.toml"
[[batch.uncertain]]
key           = "material.steel.density"
distribution  = "normal"
mean          = "8000 kg/m3"
std_deviation = "400 kg/m3"
name          = "density"
[batch.sampling]
samples = 5
"""
# A second each, with the state kept on disk all the while.
SLOW = SWEEP.replace("[[batch.vary]]", 'set = ["run.duration = 3e-4", "check.0.tolerance = 1", "boundary.0.traction = [\\"8 Pa\\", 0]",'
                     ' "body.bar.mesh.cells = [60, 15]", "output.checkpoint = 0.1", "output.history = 1e-4"]\n\n[[batch.vary]]',
                     1).split("[[batch.vary]]\nkey    = \"cells\"")[0]


class Batch(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="breccia-batch-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.out = self.folder / "sweep.batch"
        (self.folder / "bar.toml").write_text(SCENE)

    def command(self, *arguments, text=SWEEP):
        (self.folder / "sweep.toml").write_text(text)
        return [EXECUTABLE, "batch", "sweep.toml", *map(str, arguments)]

    def batch(self, *arguments, status=0, text=SWEEP):
        result = subprocess.run(self.command(*arguments, text=text), cwd=self.folder, capture_output=True, text=True,
                                timeout=120)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def start(self, *arguments, text=SWEEP):
        return subprocess.Popen(self.command(*arguments, text=text), cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def summary(self):
        with open(self.out / "summary.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def state(self, variant):
        return json.loads((self.out / variant / "variant.json").read_text())

    def report(self, variant):
        return json.loads((self.out / variant / "report.json").read_text())

    def times(self):
        return {path.parent.name: path.stat().st_mtime_ns for path in self.out.glob("*/report.json")}

    def wait_for(self, ready, seconds=30):
        end = time.monotonic() + seconds
        while not ready():
            self.assertLess(time.monotonic(), end, "it has not come so far")
            time.sleep(0.01)


def children(process):
    """Processes that a process has started, by their numbers."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            words = entry.read_text().rpartition(")")[2].split()
        except OSError:  # it has just ended
            continue
        if int(words[1]) == process:
            found.append(int(entry.parent.name))
    return found


def ended(process):
    """Whether a process has ended; nobody may have asked for its status yet."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


class Summary(Batch):
    def test_a_grid(self):
        result = self.batch()
        rows = self.summary()
        self.assertEqual([row["variant"] for row in rows], [f"{i:04}" for i in range(6)])
        self.assertEqual([row["young [Pa]"] for row in rows],
                         [str(n * 10**11) for n in (1, 1, 2, 2, 3, 3)])
        self.assertEqual([row["cells"] for row in rows], ["[4, 1]", "[8, 2]"] * 3)
        self.assertEqual({row["status"] for row in rows}, {"complete"})
        for row in rows:
            report = self.report(row["variant"])
            self.assertEqual(float(row["steps"]), report["steps"])
            self.assertEqual(float(row["wall_seconds"]), report["wall_seconds"])
            self.assertEqual(float(row["speed"]), report["checks"][0]["value"])
            self.assertEqual(row["speed: pass"], "1")
        self.assertEqual(len({row["stress"] for row in rows}), 6)
        stress = [float(row["stress"]) for row in rows]
        said = [f"{min(stress):.6g}", f"{statistics.mean(stress):.6g}", f"{max(stress):.6g}", f"{statistics.stdev(stress):.3g}"]
        line = next(line for line in result.stdout.splitlines() if line.startswith("  stress"))
        self.assertEqual(line.split(), ["stress", "6", *said])
        self.assertRegex(result.stdout, r"0003 +200 GPa +\[8, 2\] .* 1 of 1\n")

    def test_a_variant_is_the_run_that_set_makes(self):
        self.batch("--set", "material.steel.damping=0.1")
        subprocess.run([EXECUTABLE, "run", "bar.toml", "--set", "material.steel.damping=0.1", "--set",
                        "material.steel.elastic.young=200 GPa", "--set", "body.bar.mesh.cells=[8, 2]", "--quiet", "--output", "alone"], cwd=self.folder, check=True, timeout=120)
        alone = json.loads((self.folder / "alone" / "report.json").read_text())
        self.assertEqual(self.report("0003")["state_hash"], alone["state_hash"])
        self.assertEqual((self.out / "0003" / "scene.toml").read_bytes(), (self.folder / "alone" / "scene.toml").read_bytes())

    def test_keys_that_go_together(self):
        text = SWEEP.replace("[[4, 1], [8, 2]]", '[[4, 1], [8, 2], [2, 1]]\ntogether = "pair"')
        text = text.replace('name   = "young"', 'together = "pair"')
        text += '[[batch.vary]]\nkey = "run.step_factor"\nvalues = [0.4, 0.8]\n'
        lines = self.batch("--list", text=text).stdout.splitlines()
        self.assertEqual([line.split("young ")[1] for line in lines],
                         [f"{young} GPa, cells {cells}, run.step_factor {factor}"
                          for young, cells in ((100, "[4, 1]"), (200, "[8, 2]"), (300, "[2, 1]"))
                          for factor in (0.4, 0.8)])
        self.assertFalse(self.out.exists())

    def test_a_sweep_in_the_scene_itself(self):
        (self.folder / "bar.toml").write_text(SCENE + SWEEP.replace('scene   = "bar.toml"\n', ""))
        result = subprocess.run([EXECUTABLE, "batch", "bar.toml"], cwd=self.folder, capture_output=True, text=True,
                                timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((self.folder / "bar.batch" / "0005" / "report.json").exists())
        self.assertNotIn("[batch", (self.folder / "bar.batch" / "summary.csv").read_text())

    def test_a_check_that_fails_is_a_result(self):
        self.batch("--set", "check.0.tolerance=1e-9 m/s", status=3)
        self.assertEqual({(row["status"], row["attempts"], row["speed: pass"]) for row in self.summary()},
                         {("complete", "1", "0")})

    def test_a_name_that_no_run_has_ends_it_at_the_first_variant(self):
        text = SWEEP.replace("middle.sxx", "midle.sxx")
        result = self.batch("--jobs", 1, text=text, status=2)
        self.assertIn("sweep.toml:3: batch.collect: this run has no 'midle.sxx'. Did you mean 'middle.sxx'?", result.stderr)
        self.assertEqual(len(self.times()), 1)
        self.assertIn("midle", self.batch(text=text, status=2).stderr)
        self.assertEqual(len(self.times()), 1)
        before = self.times()
        self.batch()
        self.assertEqual(self.times()["0000"], before["0000"])

    def test_a_quantity_that_one_run_has_no_value_of(self):
        self.batch(text=SWEEP.replace("peak(-middle.sxx)", "arrival(-middle.sxx, 4 MPa)"))
        stress = [row["stress"] for row in self.summary()]
        self.assertIn("", stress)
        self.assertTrue(any(stress))

    def test_of_many_variants_only_the_noteworthy_are_printed(self):
        text = DRAWN.replace("samples = 5", "samples = 61")
        result = self.batch("--set", "check.0.tolerance=5 %", text=text, status=3)
        self.assertEqual(len(self.summary()), 61)
        self.assertIn("61 variants; those that are not complete, or fail a check:", result.stdout)
        failing = [row["variant"] for row in self.summary() if row["speed: pass"] == "0"]
        printed = [line.split()[0] for line in result.stdout.splitlines() if line.startswith("  00")]
        self.assertEqual(printed, failing)


class Samples(Batch):
    def values(self, text, *arguments):
        self.batch("--quiet", *arguments, text=text)
        return [float(row["density [kg/m3]"]) for row in self.summary()]

    def test_more_samples_leave_those_that_are_there(self):
        few = self.values(DRAWN)
        before = self.times()
        many = self.values(DRAWN.replace("samples = 5", "samples = 8"))
        self.assertEqual((few, len(set(many))), (many[:5], 8))
        after = self.times()
        self.assertEqual({name: after[name] for name in before}, before)
        speeds = [float(row["speed"]) * density for row, density in zip(self.summary(), many)]
        self.assertLess(max(speeds) / min(speeds) - 1, 1e-4)  # momentum: the runs had these densities

    def test_a_latin_hypercube_fills_every_share(self):
        text = DRAWN.replace("samples = 5", 'samples = 10\nsample_type = "lhs"')
        lines = self.batch("--list", text=text).stdout.splitlines()
        values = [float(line.split()[2]) for line in lines]
        shares = sorted(int(10 * statistics.NormalDist(8000, 400).cdf(value)) for value in values)
        self.assertEqual(shares, list(range(10)))

    def test_samples_of_every_variant_of_a_grid(self):
        grid = '[[batch.vary]]\nkey = "run.step_factor"\nvalues = [0.8, 0.4]\n'
        lines = self.batch("--list", text=DRAWN + grid).stdout.splitlines()
        self.assertEqual(len(lines), 10)
        self.assertEqual([line.split()[-1] for line in lines], ["0.8", "0.4"] * 5)
        self.assertEqual([line.split()[2] for line in lines[::2]], [line.split()[2] for line in lines[1::2]])


class Resume(Batch):
    def test_complete_variants_are_not_run_again(self):
        self.batch()
        before = self.times()
        self.batch()
        self.assertEqual(self.times(), before)
        (self.out / "0002" / "variant.json").unlink()
        self.batch()
        self.assertEqual([name for name, when in self.times().items() if when != before[name]], ["0002"])

    def test_values_that_have_changed_are_refused(self):
        self.batch()
        before = self.times()
        changed = SWEEP.replace("200 GPa", "210 GPa")
        result = self.batch(text=changed, status=2)
        self.assertIn("sweep.batch/0002: holds results of other values (young 200 GPa, cells [4, 1]; "
                      "now young 210 GPa, cells [4, 1])", result.stderr)
        self.assertIn("--overwrite runs the 2 variants that have changed anew", result.stderr)
        self.assertEqual(self.times(), before)
        self.batch("--overwrite", text=changed)
        self.assertEqual(sorted(name for name, when in self.times().items() if when != before[name]), ["0002", "0003"])
        self.assertIn("another scene or another build",
                      self.batch("--set", "run.duration=19 us", text=changed, status=2).stderr)

    def test_an_interrupt_leaves_a_state_that_goes_on(self):
        process = self.start("--jobs", 2, text=SLOW)
        self.wait_for(lambda: len(list(self.out.glob("*/checkpoint.h5"))) == 2)
        process.send_signal(signal.SIGTERM)
        _, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, error)
        self.assertIn("the same command goes on", error)
        self.assertEqual(children(process.pid), [])
        self.assertEqual([row["status"] for row in self.summary()], ["stopped", "stopped", "not run"])
        self.batch(text=SLOW)
        again = [self.report(name)["state_hash"] for name in ("0000", "0001")]
        # A restart goes on with the history of the run before.
        self.assertEqual((self.out / "0000" / "history.csv").read_text().count("time"), 1)
        shutil.rmtree(self.out)
        self.batch(text=SLOW)
        self.assertEqual([self.report(name)["state_hash"] for name in ("0000", "0001")], again)

    def test_two_at_once_are_refused(self):
        text = SLOW.replace('["100 GPa", "200 GPa", "300 GPa"]', '["200 GPa"]')
        process = self.start(text=text)
        self.wait_for(lambda: (self.out / "0000" / "checkpoint.h5").exists())
        self.assertIn("another breccia runs jobs in this folder", self.batch(text=text, status=2).stderr)
        run = children(process.pid)[0]
        process.kill()
        process.communicate()
        self.assertIn("another breccia", self.batch(text=text, status=2).stderr)  # its run is still there
        os.kill(run, signal.SIGKILL)
        self.wait_for(lambda: ended(run))
        self.batch(text=text)
        self.assertEqual(self.state("0000")["attempts"], 1)

    def test_some_variants_alone(self):
        self.batch("--variant", 4)
        self.assertEqual(list(self.times()), ["0004"])
        before = self.times()
        self.batch("--variant", 4)
        self.batch("--collect", status=1)
        self.assertEqual([row["status"] for row in self.summary()], ["not run"] * 4 + ["complete", "not run"])
        self.batch("--variant", 1, "--variant", 4, "--variant", 0)
        self.assertEqual(sorted(self.times()), ["0000", "0001", "0004"])
        self.batch()
        self.assertEqual(self.times()["0004"], before["0004"])
        self.batch("--collect")


class Trouble(Batch):
    def test_a_variant_that_fails_is_retried_once_and_listed(self):
        text = SWEEP.replace("cells", "run.step").replace("[[4, 1], [8, 2]]", '["0.1 us", "10 us"]')  # the last is unstable
        result = self.batch(text=text, status=1)
        rows = self.summary()
        self.assertEqual([(row["status"], row["attempts"]) for row in rows], [("complete", "1"), ("failed", "2")] * 3)
        self.assertIn("3 of 6 variants failed", result.stderr)
        self.assertIn("0003 (young 200 GPa, run.step 10 us): ", result.stderr)
        self.assertEqual(result.stdout.count("; once more"), 3)
        self.assertTrue(all(row["reason"] for row in rows[1::2]))
        self.assertTrue(all(not row["stress"] for row in rows[1::2]))

    def test_a_variant_that_was_killed_goes_on_from_its_checkpoint(self):
        text = SLOW.replace('["100 GPa", "200 GPa", "300 GPa"]', '["200 GPa"]')
        process = self.start(text=text)
        self.wait_for(lambda: (self.out / "0000" / "checkpoint.h5").exists())
        os.kill(children(process.pid)[0], signal.SIGKILL)
        out, error = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 0, error)
        self.assertIn("Killed (signal 9); once more", out)
        self.assertEqual((self.state("0000")["stage"], self.state("0000")["attempts"]), ("complete", 2))
        killed = self.report("0000")["state_hash"]
        shutil.rmtree(self.out)
        self.batch(text=text)
        self.assertEqual(self.report("0000")["state_hash"], killed)

    def test_a_variant_that_takes_too_long(self):
        text = SLOW.replace('["100 GPa", "200 GPa", "300 GPa"]', '["200 GPa"]').replace("3e-4", "1e3")
        result = self.batch("--set", "batch.time_limit=0.3 s", text=text, status=1)
        self.assertIn("0000 (young 200 GPa): longer than 0.3 s", result.stderr)
        self.assertEqual(self.state("0000")["attempts"], 2)

    def test_never_more_at_a_time_than_allowed(self):
        process = self.start("--jobs", 2, text=DRAWN.replace("samples = 5", "samples = 12"))
        most = 0
        while process.poll() is None:
            most = max(most, len(children(process.pid)))
        process.communicate()
        self.assertEqual((process.returncode, most), (0, 2))

    def test_without_slurm(self):
        self.batch("--slurm", "--dry-run")
        script = (self.out / "slurm" / "array.sh").read_text()
        self.assertIn("#SBATCH --array=0-5\n", script)
        self.assertFalse((self.out / "0000").exists())
        (self.folder / "sweep.toml").write_text(SWEEP)
        result = subprocess.run(self.command("--slurm"), cwd=self.folder, capture_output=True, text=True, timeout=60,
                                env={"PATH": "/nonexistent"})
        self.assertEqual(result.returncode, 2)
        self.assertIn("sbatch: cannot be started", result.stderr)


class Given(Batch):
    def test_the_example_of_the_tree_is_right(self):
        lines = subprocess.run([EXECUTABLE, "batch", str(ROOT / "examples" / "brazilian_disc" / "strengths.toml"), "--list"],
                               capture_output=True, text=True, timeout=60, check=True).stdout.splitlines()
        self.assertEqual(len(lines), 12)


if __name__ == "__main__":
    EXECUTABLE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
