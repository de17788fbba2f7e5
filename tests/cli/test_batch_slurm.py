#!/usr/bin/env python3
"""`breccia batch --slurm` against a real Slurm of this machine alone: test_batch_slurm.py EXECUTABLE [unittest options]

Ends with status 77, which ctest calls skipped, where no Slurm can be started."""

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
import unittest

import slurm_node
from pushed_bar import SCENE

EXECUTABLE = ""
SKIPPED = 77
QUEUE_SECONDS = 60

# Four runs are right; a fixed step of 10 us is unstable.
SWEEP = """\
[batch]
scene = "bar.toml"
collect = ["peak(-middle.sxx)"]
[batch.slurm]
partition = "main"
options   = ['--comment="a sweep"']
setup     = ["export SWEEP_SETUP=done"]
[[batch.vary]]
key    = "run.step"
values = ["0.1 us", "0.09 us", "10 us", "0.08 us", "0.07 us"]
"""
# Some seconds, with the state kept on disk all the while.
LONG = """\
[batch]
scene = "bar.toml"
set = ["run.duration = 6e-4", "boundary.0.traction = [\\"8 Pa\\", 0]", "check.0.tolerance = 1",
       "body.bar.mesh.cells = [60, 15]", "output.checkpoint = 0.1", "output.history = 1e-4"]
[[batch.vary]]
key    = "material.steel.elastic.young"
values = ["200 GPa"]
"""


class Slurm(unittest.TestCase):
    node = None  # a slurm_node.Node that runs

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="breccia-slurm-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.out = self.folder / "sweep.batch"
        (self.folder / "bar.toml").write_text(SCENE)
        self.addCleanup(self.node.output, "scancel", "--user=root")

    def batch(self, *arguments, status=0, text=SWEEP):
        (self.folder / "sweep.toml").write_text(text)
        result = subprocess.run([EXECUTABLE, "batch", "sweep.toml", *arguments], cwd=self.folder, capture_output=True,
                                text=True, timeout=120, env=self.node.environment)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr + self.said())
        return result

    def said(self):
        return "".join(f"\n== {path.name}\n{path.read_text()}" for path in self.out.glob("slurm/*"))

    def summary(self):
        with open(self.out / "summary.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def report(self):
        return json.loads((self.out / "0000" / "report.json").read_text())

    def job(self):
        return json.loads((self.out / "slurm" / "job.json").read_text())["job"]

    def cancel(self):
        self.node.output("scancel", self.job())

    def kill(self):
        """As if the machine went down: the task and the run that it has started."""
        for entry in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = entry.read_bytes().decode(errors="replace")
            except OSError:
                continue
            if str(self.out) in words:
                os.kill(int(entry.parent.name), signal.SIGKILL)

    def wait_for(self, ready):
        end = time.monotonic() + QUEUE_SECONDS
        while not ready():
            self.assertLess(time.monotonic(), end, self.said() + self.node.output("squeue"))
            time.sleep(0.05)

    def wait_for_queue(self):
        """Until no task is left; the largest number of tasks that ran at a time."""
        most = 0

        def empty():
            nonlocal most
            states = self.node.output("squeue", "--noheader", "--array", "--format=%T").split()
            most = max(most, states.count("RUNNING"))
            return not states

        self.wait_for(empty)
        return most

    def test_an_array_with_a_variant_that_fails(self):
        self.assertIn("5 variants with Slurm as job", self.batch("--slurm", "--jobs", "2").stdout)
        for words in (["--slurm"], []):
            self.assertIn("Slurm still runs these variants", self.batch(*words, status=2).stderr)
        self.assertIn("Slurm still has tasks of job", self.batch("--collect", status=1).stdout)
        self.assertLessEqual(self.wait_for_queue(), 2)
        script = (self.out / "slurm" / "array.sh").read_text()
        self.assertIn("#SBATCH --array=0-4%2\n", script)
        self.assertIn("#SBATCH --comment=\"a sweep\"\n\nexport SWEEP_SETUP=done\nexec ", script)

        # The first collection sends the one that has failed to Slurm again, alone.
        self.assertIn("1 variant with Slurm as job", self.batch("--collect", status=1).stdout)
        self.assertIn("#SBATCH --array=2\n", (self.out / "slurm" / "array.sh").read_text())
        self.wait_for_queue()
        result = self.batch("--collect", status=1)
        self.assertIn("1 of 5 variants failed\n  0002 (run.step 10 us): ", result.stderr)
        self.assertEqual([(row["status"], row["attempts"]) for row in self.summary()],
                         [("complete", "1")] * 2 + [("failed", "2")] + [("complete", "1")] * 2)
        self.assertTrue(all(row["peak(-middle.sxx)"] for row in self.summary() if row["status"] == "complete"))
        self.assertFalse((self.out / "slurm" / "job.json").exists())

        # What Slurm has run is not run again here.
        before = (self.out / "0000" / "report.json").stat().st_mtime_ns
        self.batch(status=1)
        self.assertEqual((self.out / "0000" / "report.json").stat().st_mtime_ns, before)

    def test_tasks_of_several_variants(self):
        text = SWEEP.replace('"10 us"', '"0.06 us"').replace('partition = "main"', "variants_per_task = 2")
        self.batch("--slurm", text=text)
        self.assertIn("#SBATCH --array=0-2\n", (self.out / "slurm" / "array.sh").read_text())
        self.wait_for_queue()
        self.batch("--collect", text=text)
        self.assertEqual([(row["status"], row["attempts"]) for row in self.summary()], [("complete", "1")] * 5)

    def test_a_task_that_is_killed_goes_on_from_its_checkpoint(self):
        for end, reason in ((self.kill, "ended without a word"), (self.cancel, "interrupted at time")):
            shutil.rmtree(self.out, ignore_errors=True)
            self.batch("--slurm", text=LONG)
            self.wait_for((self.out / "0000" / "checkpoint.h5").exists)
            end()
            self.wait_for_queue()
            self.batch("--collect", "--dry-run", status=1, text=LONG)
            self.assertIn(reason, self.summary()[0]["reason"])
            self.batch("--collect", status=1, text=LONG)
            self.wait_for_queue()
            self.batch("--collect", text=LONG)
            self.assertEqual((self.summary()[0]["status"], self.summary()[0]["attempts"]), ("complete", "2"))
            restarted = self.report()
        shutil.rmtree(self.out)
        self.batch(text=LONG)
        self.assertEqual(self.report()["state_hash"], restarted["state_hash"])

    def test_a_job_that_slurm_refuses(self):
        result = self.batch("--slurm", text=SWEEP.replace('"main"', '"mian"'), status=2)
        self.assertIn("sbatch: Slurm has refused the job: ", result.stderr)
        self.assertIn("partition", result.stderr)
        self.assertFalse((self.out / "slurm" / "job.json").exists())
        self.batch("--collect", status=1)
        self.assertEqual({row["status"] for row in self.summary()}, {"not run"})

    def test_tasks_that_never_begin(self):
        self.batch("--slurm", text=SWEEP.replace("SWEEP_SETUP=done", "SWEEP_SETUP=; exit 5"))
        self.wait_for_queue()
        self.batch("--collect", status=1)
        self.assertEqual({(row["status"], row["attempts"]) for row in self.summary()}, {("not run", "0")})
        self.assertIn("has not begun", self.summary()[0]["reason"])


def main():
    try:
        # In /tmp, because the name of a socket has at most 107 letters.
        with tempfile.TemporaryDirectory(prefix="slurm-", dir="/tmp") as folder, slurm_node.Node(folder) as node:
            Slurm.node = node
            return 0 if unittest.main(exit=False).result.wasSuccessful() else 1
    except slurm_node.NoSlurm as reason:
        print(f"skipped: {reason}")
        return SKIPPED


if __name__ == "__main__":
    EXECUTABLE = os.path.abspath(sys.argv.pop(1))
    sys.exit(main())
