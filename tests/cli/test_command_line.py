#!/usr/bin/env python3
"""The executable as a user meets it: test_command_line.py EXECUTABLE [unittest options]"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "errors"))
import scenes  # noqa: E402  (the right scenes of tests/errors)

EXECUTABLE = ""
RUN_FILES = {"scene.toml", "frames", "frames.vtkhdf.series", "history.csv", "report.json"}


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="breccia-cli-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "block.toml").write_text(scenes.PLANE)

    def breccia(self, *arguments, status=0, front=()):
        result = subprocess.run([*front, EXECUTABLE, *map(str, arguments)], cwd=self.folder,
                                capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def names(self, folder="."):
        return {path.name for path in (self.folder / folder).iterdir()}

    def report(self, folder="block.out"):
        return json.loads((self.folder / folder / "report.json").read_text())


class Words(CommandLine):
    def test_version(self):
        self.assertRegex(self.breccia("--version").stdout, r"^breccia \d+\.\d+\.\d+ \(.+\)\n$")

    def test_usage_names_every_verb(self):
        text = self.breccia("--help").stdout
        for verb in ("run", "check", "help", "mesh", "info"):
            self.assertRegex(text, rf"\n +{verb} +\w")
        self.assertIn("--overwrite", self.breccia("run", "--help").stdout)

    def test_no_verb_is_a_mistake(self):
        self.assertIn("breccia --help", self.breccia(status=2).stderr)

    def test_info_names_backends_and_parts(self):
        text = self.breccia("info").stdout
        for word in ("breccia ", "compiler", "Kokkos", "concurrency", "MPI", "HDF5", "Gmsh"):
            self.assertIn(word, text)

    def test_help_lists_sections_and_explains_keys(self):
        text = self.breccia("help").stdout
        for section in ("[run]", "[[body]]", "[material.NAME]", "[[check]]"):
            self.assertIn(section, text)
        text = self.breccia("help", "material.granite.density").stdout
        for word in ("unit     kg/m3", "range    above 0", "default  none", "meaning", "example"):
            self.assertIn(word, text)


class Check(CommandLine):
    def test_check_tells_what_would_run_and_writes_nothing(self):
        text = self.breccia("check", "block.toml").stdout
        for word in ("elements", "step", "contact", "no [[excavate]]", "not foreseen", "rows of history.csv"):
            self.assertIn(word, text)
        self.assertRegex(text, r"solid +on +\S+ \S+ +[0-9.e-]+  every scene")
        self.assertEqual(self.names(), {"block.toml"})

    def test_check_and_run_tell_where_single_precision_is_felt(self):
        rest = ("--set", 'run.rest={ method = "local", tolerance = 1e-7 }')
        mixed = ("block.toml", "--set", 'run.precision="mixed"')
        self.assertNotIn("single precision", self.breccia("check", *mixed).stderr)
        self.assertNotIn("single precision", self.breccia("check", "block.toml", *rest).stderr)
        for verb in ("check", "run"):
            self.assertIn("forces in single precision balance to some 3e-06", self.breccia(verb, *mixed, *rest).stderr)
        self.assertEqual(self.report()["precision"], "mixed")

    def test_check_names_what_stays_in_double(self):
        text = self.breccia("check", "block.toml", "--set", 'run.precision="mixed"', "--set",
                            "material.steel.j2.yield=1e9").stdout
        self.assertIn("elements of 'steel' are computed in double: the material yields", text)

    def test_a_folder_stands_for_its_scene(self):
        (self.folder / "case").mkdir()
        (self.folder / "case" / "scene.toml").write_text(scenes.SPACE)
        self.breccia("check", "case")
        self.breccia("check", "case/scene.toml")


class Run(CommandLine):
    def test_a_run_leaves_the_promised_files(self):
        self.breccia("run", "block.toml")
        self.assertEqual(self.names(), {"block.toml", "block.out"})
        self.assertLessEqual(RUN_FILES, self.names("block.out"))
        report = self.report()
        self.assertEqual(report["status"], "complete")
        self.assertEqual([check["pass"] for check in report["checks"]], [True])

    def test_results_are_not_lost_by_accident(self):
        self.breccia("run", "block.toml")
        text = self.breccia("run", "block.toml", status=2).stderr
        self.assertIn("--overwrite", text)
        self.assertIn("--restart", text)
        self.breccia("run", "block.toml", "--overwrite")

    def test_output_goes_where_it_is_told(self):
        self.breccia("run", "block.toml", "--output", "here")
        self.assertEqual(self.names(), {"block.toml", "here"})

    def test_quiet_is_quiet(self):
        result = self.breccia("run", "block.toml", "--quiet")
        self.assertEqual((result.stdout, result.stderr), ("", ""))

    def test_a_log_has_plain_lines(self):
        result = self.breccia("run", "block.toml")
        for mark in ("\r", "\x1b"):
            self.assertNotIn(mark, result.stdout + result.stderr)

    def test_a_failed_check_has_status_3(self):
        self.breccia("run", "block.toml", "--set", "check.drift.reference=\"1 km\"", status=3)
        self.assertEqual([check["pass"] for check in self.report()["checks"]], [False])

    def test_set_changes_the_resolved_scene(self):
        self.breccia("run", "block.toml", "--set", "run.duration=5 us", "--set",
                     "body.plate.velocity=[0, 0]", "--set", "material.steel.damping=0.1")
        text = (self.folder / "block.out" / "scene.toml").read_text()
        self.assertIn("duration = 5e-06", text)
        self.assertIn("damping = 0.1  # --set", text)
        self.assertAlmostEqual(self.report()["time"], 5e-6)

    def test_the_resolved_scene_is_the_same_run(self):
        self.breccia("run", "block.toml", "--set", "material.steel.damping=0.1")
        self.breccia("run", "block.out/scene.toml", "--output", "again")
        self.assertEqual(self.report()["state_hash"], self.report("again")["state_hash"])

    def test_the_number_of_threads_does_not_change_the_bits(self):
        for threads in (1, 2, 4):
            self.breccia("run", "block.toml", "--threads", threads, "--output", f"t{threads}")
            self.assertEqual(self.report(f"t{threads}")["threads"], threads)
        hashes = {self.report(f"t{threads}")["state_hash"] for threads in (1, 2, 4)}
        self.assertEqual(len(hashes), 1)

    @unittest.skipIf(shutil.which("mpirun") is None, "no launcher")
    def test_many_ranks_are_for_runs(self):
        result = self.breccia("check", "block.toml", front=("mpirun", "-n", "2"), status=2)
        self.assertEqual(result.stderr.count("started on 2 ranks"), 1)
        self.assertIn("many are for `breccia run`", result.stderr)
        self.assertEqual(self.names(), {"block.toml"})


class Mesh(CommandLine):
    def test_mesh_writes_one_file_that_a_scene_can_use(self):
        self.breccia("mesh", "block.toml", "-o", "mesh.h5")
        self.assertEqual(self.names(), {"block.toml", "mesh.h5"})
        text = scenes.PLANE
        text = text.replace('rectangle = { corner = [0, 0], size = ["20 mm", "10 mm"] }',
                            'file = "mesh.h5", region = "block"')
        text = text.replace('mesh     = { generator = "structured", size = "5 mm" }\n', "")
        (self.folder / "again.toml").write_text(text)
        self.breccia("run", "block.toml")
        self.breccia("run", "again.toml")
        self.assertEqual(self.report("block.out")["state_hash"],
                         self.report("again.out")["state_hash"])


if __name__ == "__main__":
    EXECUTABLE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
