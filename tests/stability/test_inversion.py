#!/usr/bin/env python3
"""S-01 and S-03 as a user meets them: an element that inverts stops the run by name, and one that is inverted or doubled
or has no size from the start is refused. test_inversion.py EXECUTABLE [unittest options]"""

import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

EXECUTABLE = ""

# The right side is pushed through the left one at 50 m/s.
PUSHED = """\
[run]
dimension = 2
duration  = "10 ms"

[[body]]
name     = "block"
material = "soft"
shape    = { rectangle = { corner = [0, 0], size = ["100 mm", "50 mm"] } }
mesh     = { generator = "structured", size = "10 mm" }

[material.soft]
density = "1000 kg/m3"
elastic = { young = "1 GPa", poisson = 0.3 }

[[boundary]]
where = "block.left"
fixed = [0, 0]

[[boundary]]
where    = "block.right"
velocity = ["-50 m/s", 0]

[output]
frames  = 10
history = "0.1 ms"
"""

FROM_FILE = """\
[run]
dimension = 2
duration  = "1 us"

[[body]]
name     = "block"
material = "soft"
shape    = { file = "block.msh" }

[material.soft]
density = "1000 kg/m3"
elastic = { young = "1 GPa", poisson = 0.3 }
"""

MESH = """\
$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
5
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0.5 0.5 0
$EndNodes
$Elements
4
1 2 2 1 1 1 2 5
2 2 2 1 1 2 3 5
3 2 2 1 1 3 4 5
4 2 2 1 1 4 1 5
$EndElements
"""


class Inversion(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="breccia-inversion-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_scene(self, scene, status):
        (self.folder / "scene.toml").write_text(scene)
        result = subprocess.run([EXECUTABLE, "run", "scene.toml", "--quiet", "--threads", "1", "--output", "out"],
                                cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def test_inversion_while_running(self):
        said = self.run_scene(PUSHED, 1)
        out = self.folder / "out"
        report = json.loads((out / "report.json").read_text())
        self.assertEqual(report["status"], "failed")
        for text in (said, report["reason"]):
            self.assertRegex(text, r"element \d+ of body 'block' at \(.*\) m")
            self.assertRegex(text, r"time [\d.e+-]+ s \(step \d+\)")
            self.assertIn("likely cause", text)
        # Nothing was carried on: the last state is finite, its energy that of the work done.
        self.assertTrue((out / "checkpoint.h5").is_file())
        rows = list(csv.DictReader((out / "history.csv").read_text().splitlines()))
        last = {key: float(value) for key, value in rows[-1].items()}
        self.assertTrue(all(abs(value) < 1e300 for value in last.values()), last)
        self.assertAlmostEqual(last["time"], report["time"], delta=report["time_step"]["max"])
        self.assertLess(report["ledger"]["res_1"], 1e-10)
        self.assertLess(report["ledger"]["res_2"], 0.01)
        frames = sorted((out / "frames").iterdir())
        series = json.loads((out / "frames.vtkhdf.series").read_text())["files"]
        self.assertEqual(len(frames), len(series))
        self.assertAlmostEqual(series[-1]["time"], report["time"], delta=report["time_step"]["max"])

    def test_load_that_is_beyond_all_numbers(self):
        push = 'velocity = ["-50 m/s", 0]'
        said = self.run_scene(PUSHED.replace(push, "traction = [1e305, 0]"), 1)
        self.assertRegex(said, r"element \d+ of body 'block' has a non-finite position at time [\d.e+-]+ s")
        self.assertIn("a load that is not finite", said)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual(report["status"], "failed")
        self.assertTrue((self.folder / "out" / "checkpoint.h5").is_file())

    def test_pushed_block_is_far_from_its_end(self):
        self.run_scene(PUSHED, 1)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        # At 50 m/s the block of 100 mm is gone after 2 ms; 0.1 of its volume is left at 1.8 ms at the latest.
        self.assertLess(report["time"], 2e-3)
        self.assertGreater(report["time"], 0.5e-3)

    def refused(self, mesh, *words):
        (self.folder / "block.msh").write_text(mesh)
        said = self.run_scene(FROM_FILE, 2)
        for word in ("block.msh", *words):
            self.assertIn(word, said)
        self.assertFalse((self.folder / "out").exists())

    def test_right_mesh_runs(self):
        (self.folder / "block.msh").write_text(MESH)
        self.run_scene(FROM_FILE, 0)

    def test_inverted_at_the_start(self):
        self.refused(MESH.replace("2 2 2 1 1 2 3 5", "2 2 2 1 1 3 2 5"), "inverted")

    def test_doubled_element(self):
        self.refused(MESH.replace("$Elements\n4", "$Elements\n5").replace("4 2 2 1 1 4 1 5", "4 2 2 1 1 4 1 5\n5 2 2 1 1 1 2 5"))

    def test_element_without_size(self):
        self.refused(MESH.replace("5 0.5 0.5 0\n", "5 0.5 0 0\n"))

    def test_coincident_nodes(self):
        self.refused(MESH.replace("$Nodes\n5", "$Nodes\n6").replace("5 0.5 0.5 0\n", "5 0.5 0.5 0\n6 0.5 0.5 0\n")
                     .replace("4 2 2 1 1 4 1 5", "4 2 2 1 1 4 1 6"))


if __name__ == "__main__":
    EXECUTABLE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
