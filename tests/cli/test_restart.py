#!/usr/bin/env python3
"""V-147 as a user meets it: a run that is stopped by SIGTERM or killed between checkpoints ends, once it is restarted,
with the same history and the same bits as one that nobody disturbed. test_restart.py EXECUTABLE [unittest options]"""

import json
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

EXECUTABLE = ""

# A block that is driven, loaded and damped; long enough to be caught in the middle.
SCENE = """\
title     = "a block that is shaken"
reference = "none"
expected  = "the same bits"

[run]
dimension = 2
duration  = "30 ms"

[[body]]
name     = "block"
material = "soft"
spin     = "50 rad/s"
shape    = { rectangle = { corner = [0, 0], size = ["100 mm", "50 mm"] } }
mesh     = { generator = "structured", size = "5 mm", jitter = 0.2 }

[material.soft]
density = "1000 kg/m3"
damping = 0.05
elastic = { young = "1 GPa", poisson = 0.3 }

[gravity]
acceleration = [0, "-9.81 m/s2"]

[[boundary]]
where    = "block.right"
traction = ["10 kPa", 0]
ramp     = "5 ms"

[[sensor]]
name  = "corner"
point = ["100 mm", "50 mm"]

[output]
frames     = 5
history    = "0.5 ms"
checkpoint = "30 ms"
"""


class Restart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="breccia-restart-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        (cls.folder / "scene.toml").write_text(SCENE)
        subprocess.run(cls.command("whole"), cwd=cls.folder, check=True, timeout=300)

    @staticmethod
    def command(output, *more):
        return [EXECUTABLE, "run", "scene.toml", "--quiet", "--threads", "1", "--output", output, *more]

    def run_to_end(self, output, *more):
        result = subprocess.run(self.command(output, *more), cwd=self.folder, capture_output=True, text=True, timeout=300)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def start(self, output, *more):
        return subprocess.Popen(self.command(output, *more), cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)

    def file(self, output, name):
        return self.folder / output / name

    def wait_for_checkpoint(self, process, output, newer_than=0):
        """Until a checkpoint newer than the given time is there; its time of writing."""
        checkpoint = self.file(output, "checkpoint.h5")
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:
            self.assertIsNone(process.poll(), "the run ended before it could be disturbed")
            if checkpoint.is_file() and checkpoint.stat().st_mtime_ns > newer_than:
                return checkpoint.stat().st_mtime_ns
            time.sleep(0.005)
        self.fail("no checkpoint came")

    def report(self, output):
        return json.loads(self.file(output, "report.json").read_text())

    def assert_same(self, one, other):
        a, b = self.report(one), self.report(other)
        for key in ("status", "steps", "time", "state_hash", "ledger", "time_step", "checks"):
            self.assertEqual(a[key], b[key], key)
        for name in ("history.csv", "fragments.csv", "frames.vtkhdf.series", "scene.toml"):
            self.assertEqual(self.file(one, name).read_bytes(), self.file(other, name).read_bytes(), name)
        frames = lambda run: sorted(p.name for p in (self.folder / run / "frames").iterdir())
        self.assertEqual(frames(one), frames(other))

    def test_sigterm_leaves_a_checkpoint_to_go_on_from(self):
        process = self.start("stopped")
        self.wait_for_checkpoint(process, "stopped")
        process.send_signal(signal.SIGTERM)
        said = process.communicate(timeout=60)[0]
        self.assertEqual(process.returncode, 1, said)
        self.assertIn("--restart", said)
        report = self.report("stopped")
        self.assertEqual(report["status"], "stopped")
        self.assertIn("interrupted", report["reason"])
        self.assertLess(report["time"], 30e-3)
        self.run_to_end("stopped", "--restart")
        self.assert_same("stopped", "whole")

    def test_killed_between_checkpoints_twice(self):
        written, more = 0, []
        for _ in range(2):
            process = self.start("killed", *more)
            written = self.wait_for_checkpoint(process, "killed", written)
            time.sleep(0.03)  # rows and frames are written beyond the checkpoint
            process.kill()
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, -signal.SIGKILL)
            self.assertFalse(self.file("killed", "report.json").exists())
            more = ["--restart"]
        self.run_to_end("killed", "--restart")
        self.assert_same("killed", "whole")

    def test_a_run_that_is_complete_may_be_restarted(self):
        shutil.copytree(self.folder / "whole", self.folder / "again")
        self.run_to_end("again", "--restart")
        self.assert_same("again", "whole")

    def test_another_scene_is_refused(self):
        self.run_to_end("short", "--set", "run.duration=1 ms")
        result = subprocess.run(self.command("short", "--restart"), cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertIn("checkpoint.h5", result.stderr)

    def test_a_truncated_checkpoint_is_refused(self):
        self.run_to_end("cut", "--set", "run.duration=1 ms")
        path = self.file("cut", "checkpoint.h5")
        path.write_bytes(path.read_bytes()[:-1000])
        result = subprocess.run(self.command("cut", "--restart", "--set", "run.duration=1 ms"), cwd=self.folder,
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertIn("checkpoint.h5", result.stderr)


if __name__ == "__main__":
    EXECUTABLE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
