#!/usr/bin/env python3
"""`breccia study` as a user meets it: test_study.py EXECUTABLE [unittest options]"""

import csv
import importlib.util
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

from pushed_bar import SCENE

EXECUTABLE = ""
ROOT = pathlib.Path(__file__).resolve().parents[2]
PLOT = ROOT / "tools" / "plot"

STUDY = """
[study]
[[study.knob]]
key    = "cells"
values = [[4, 1], [8, 2], [16, 4]]
[[study.quantity]]
name      = "energy"
value     = "final(IE_elastic)"
reference = "finest"
"""


class Study(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="breccia-study-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.environment = {**os.environ, "BRECCIA_PLOT": "/nonexistent"}

    def study(self, *arguments, status=0, text=SCENE + STUDY):
        (self.folder / "bar.toml").write_text(text)
        result = subprocess.run([EXECUTABLE, "study", "bar.toml", *map(str, arguments)], cwd=self.folder,
                                capture_output=True, text=True, timeout=120, env=self.environment)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def found(self):
        return json.loads((self.folder / "bar.study" / "study.json").read_text())

    def times(self):
        return {path.parent.name: path.stat().st_mtime_ns for path in self.folder.glob("bar.study/*/report.json")}


class Ladder(Study):
    def test_what_it_writes_and_says(self):
        text = self.study("--repeats", 2).stdout
        self.assertIn("against Richardson's estimate", text)
        for word in ("energy, 5 %: ", "energy, 0.1 %: ", "observed order", "* front",
                     "for a picture: tools/plot bar.study"):
            self.assertIn(word, text)
        with open(self.folder / "bar.study" / "study.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["cells"] for row in rows], ["[4, 1]", "[8, 2]", "[16, 4]"])
        for row in rows:
            self.assertEqual(float(row["element_steps"]), float(row["elements"]) * float(row["steps"]))
            self.assertLessEqual(float(row["wall_min"]), float(row["wall_median"]))
            self.assertLessEqual(float(row["wall_median"]), float(row["wall_max"]))
        errors = self.found()["quantities"][0]["errors"]
        self.assertEqual(errors, [float(row["energy: error"]) for row in rows])
        self.assertLess(errors[2], errors[1])
        self.assertLess(errors[1], errors[0])
        self.assertEqual([len(job["wall_seconds"]["each"]) for job in self.found()["jobs"]], [2, 2, 2])

    def test_a_job_is_the_run_that_set_makes(self):
        self.study("--set", "material.steel.damping=0.1")
        subprocess.run([EXECUTABLE, "run", "bar.toml", "--set", "material.steel.damping=0.1", "--set",
                        "body.bar.mesh.cells=[8, 2]", "--quiet"], cwd=self.folder, check=True, timeout=120)
        hashes = [json.loads((self.folder / path / "report.json").read_text())["state_hash"]
                  for path in ("bar.out", "bar.study/002_cells_8_2")]
        self.assertEqual(hashes[0], hashes[1])

    def test_a_solution_and_a_check_as_reference(self):
        text = STUDY.replace('value     = "final(IE_elastic)"\nreference = "finest"',
                             'value = "peak(-middle.sxx)"\nsolution = "bar.stress"\n'
                             'scale = "8 MPa"\nparameters = { velocity = "0.2 m/s", young = "200 GPa", density = 8000 }')
        text += '[[study.quantity]]\ncheck = "speed"\nscale = "1 m/s"\n'
        self.study(text=SCENE + text)
        stress, speed = self.found()["quantities"]
        self.assertAlmostEqual(stress["references"][0], 8e6)
        self.assertAlmostEqual(speed["references"][0], 0.5)
        self.assertLess(max(speed["errors"]), 1e-5)  # momentum is right on every mesh

    def test_a_target_that_a_finer_rung_misses_again(self):
        middle = STUDY.replace('"finest"', '"5.34447 mJ"')  # what [8, 2] gives
        text = self.study(text=SCENE + middle).stdout
        self.assertRegex(text, r"energy, 0\.1 %: the cheapest setting is cells \[8, 2\] .*; a later rung of its ladder has "
                               r"0\.1\d* % again, so chance may have helped\.")

    def test_a_curve_against_a_table(self):
        # The integral of a smooth ramp.
        rows = [f"{20e-6 * s / 40:.9g}, {(s / 40) ** 3 - (s / 40) ** 4 / 2:.9g}" for s in range(41)]
        (self.folder / "right.csv").write_text("\n".join(["time, v", "# by hand", *rows]) + "\n")
        text = STUDY.replace('value     = "final(IE_elastic)"\nreference = "finest"',
                             'curve = "middle.vx"\ntable = "right.csv"')
        self.study(text=SCENE + text)
        errors = self.found()["quantities"][0]["errors"]
        self.assertTrue(all(0 < error < 0.05 for error in errors), errors)

    def test_one_knob_at_a_time(self):
        text = STUDY.replace("[study]", '[study]\nwalk = "one"') + (
            '[[study.knob]]\nkey = "step factor"\nvalues = [0.8, 0.4]\n')
        self.assertEqual(len(self.study("--list", text=SCENE + text).stdout.splitlines()), 5)
        self.assertFalse((self.folder / "bar.study").exists())

    def test_a_study_in_a_file_of_its_own(self):
        (self.folder / "scenes").mkdir()
        (self.folder / "scenes" / "base.toml").write_text(SCENE)
        self.study(text=STUDY.replace("[study]", '[study]\nscene = "scenes/base.toml"\nset = ["output.history = 1e-6"]'))
        resolved = (self.folder / "bar.study" / "001_cells_4_1" / "scene.toml").read_text()
        self.assertIn("history = 1e-06", resolved)

    def test_its_tables_lie_beside_it(self):
        (self.folder / "scenes").mkdir()
        (self.folder / "scenes" / "base.toml").write_text(SCENE)
        (self.folder / "right.csv").write_text("0, 0\n20e-6, 0.5\n")
        text = STUDY.replace("[study]", '[study]\nscene = "scenes/base.toml"')
        self.study(text=text.replace('value     = "final(IE_elastic)"\nreference = "finest"',
                                     'curve = "middle.vx"\ntable = "right.csv"'))

    def test_jobs_side_by_side(self):
        self.study("--jobs", 3)
        self.assertEqual([job["state"] for job in self.found()["jobs"]], ["complete"] * 3)


    @unittest.skipUnless(importlib.util.find_spec("matplotlib") and importlib.util.find_spec("h5py"), "no matplotlib")
    def test_the_picture(self):
        self.environment["BRECCIA_PLOT"] = str(PLOT)
        self.environment["MPLCONFIGDIR"] = str(self.folder)
        self.assertIn("picture: bar.study/study.png", self.study().stdout)
        self.assertEqual((self.folder / "bar.study" / "study.png").read_bytes()[1:4], b"PNG")


class Resume(Study):
    def test_finished_jobs_are_not_run_again(self):
        self.study()
        before = self.times()
        self.study()
        self.assertEqual(self.times(), before)
        # A rung before the others: theirs move to their new numbers.
        self.study(text=SCENE + STUDY.replace("[[4, 1]", "[[2, 1], [4, 1]"))
        after = self.times()
        self.assertEqual(after["002_cells_4_1"], before["001_cells_4_1"])
        self.assertEqual(sorted(after), ["001_cells_2_1", "002_cells_4_1", "003_cells_8_2", "004_cells_16_4"])
        # Another scene: all of them again.
        self.study("--set", "run.duration=19 us")
        names = ["001_cells_4_1", "002_cells_8_2", "003_cells_16_4"]
        again = self.times()
        self.assertTrue(all(again[name] != before[name] for name in names), (before, again))

    def test_only_missing_repeats_are_run(self):
        self.study()
        first = self.found()["jobs"][0]["wall_seconds"]["each"]
        self.study("--repeats", 3)
        each = self.found()["jobs"][0]["wall_seconds"]["each"]
        self.assertEqual((each[0], len(each)), (first[0], 3))

    def test_a_failed_job_loses_no_other(self):
        text = STUDY.replace('key    = "cells"', 'key    = "run.step"')
        text = text.replace("[[4, 1], [8, 2], [16, 4]]", '["10 us", "0.1 us", "0.05 us"]')  # the first is unstable
        result = self.study(text=SCENE + text)
        self.assertIn("1 of 3 jobs have no result", result.stderr)
        self.assertIn("failed: ", result.stdout)
        states = [job["state"] for job in self.found()["jobs"]]
        self.assertEqual(states, ["failed", "complete", "complete"])
        self.assertIn("step", self.found()["jobs"][0]["reason"])
        self.assertTrue((self.folder / "bar.study" / "001_step_10_us" / "log.txt").read_text())

    def test_a_job_that_takes_too_long_is_ended(self):
        text = SCENE.replace('"20 us"\n[[body]]', '"20 s"\n[[body]]') + STUDY
        result = self.study("--set", "study.time_limit=0.5 s", status=1, text=text)
        self.assertIn("no job is complete", result.stderr)
        self.assertIn("longer than", self.found()["jobs"][0]["reason"])

    def test_an_interrupt_leaves_what_is_done(self):
        slow = SCENE + STUDY.replace("[16, 4]", "[400, 100]")
        slow = slow.replace('duration  = "20 us"', 'duration  = "2 ms"').replace("8 MPa", "8 Pa")
        (self.folder / "bar.toml").write_text(slow)
        process = subprocess.Popen([EXECUTABLE, "study", "bar.toml"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, env=self.environment)
        third = self.folder / "bar.study" / "003_cells_400_100" / "scene.toml"
        for _ in range(600):
            if third.exists():
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, error)
        self.assertIn("the same command goes on", error)
        self.assertEqual([job["state"] for job in self.found()["jobs"]], ["complete", "complete", "not run"])


class Given(unittest.TestCase):
    def test_the_studies_of_the_tree_are_right(self):
        scenes = sorted((ROOT / "perf" / "accuracy").glob("*.toml"))
        self.assertGreaterEqual(len(scenes), 12)
        for scene in scenes:
            with self.subTest(scene.name):
                result = subprocess.run([EXECUTABLE, "study", str(scene), "--list"], capture_output=True, text=True,
                                        timeout=60)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertGreaterEqual(len(result.stdout.splitlines()), 3)


class Trouble(Study):
    def test_a_quantity_that_is_constant(self):
        text = STUDY.replace('"final(IE_elastic)"', '"nodes - nodes + 3"')
        result = self.study(text=SCENE + text, status=1)
        self.assertIn("the value is 3 in all jobs; the knobs do not move it", result.stderr)
        result = self.study(text=SCENE + text.replace(" + 3", ""), status=1)
        self.assertIn("the value is 0 in all jobs", result.stderr)

    def test_a_quantity_without_a_value(self):
        # Coarse jobs may have no arrival where finer ones have; here none has.
        text = STUDY.replace('"final(IE_elastic)"', '"arrival(all.vx, 1 m/s)"')
        result = self.study(text=SCENE + text, status=1)
        self.assertIn("energy: has a value in no job: ", result.stderr)
        self.assertEqual(len(self.times()), 3)

    def test_a_formula_without_an_answer_ends_it_at_the_first_job(self):
        result = self.study(text=SCENE + STUDY.replace("IE_elastic", "IE_elastik"), status=2)
        self.assertIn("Did you mean 'IE_elastic'?", result.stderr)
        self.assertEqual(len(self.times()), 1)

    def test_solutions_are_those_of_the_page(self):
        result = subprocess.run([EXECUTABLE, "study", "--solutions"], capture_output=True, text=True, timeout=60)
        page = ROOT / "docs" / "study.md"
        self.assertIn(result.stdout, page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    EXECUTABLE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
