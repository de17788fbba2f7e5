"""tools/plot draws every picture of a run and refuses what it cannot draw: check_pictures.py SAMPLE_RUN PLOT FOLDER"""
import pathlib
import shutil
import subprocess
import sys
import unittest

import h5py
import matplotlib.image
import numpy as np

FOLDER = pathlib.Path(sys.argv.pop())
PLOT = sys.argv.pop()
SAMPLE_RUN = sys.argv.pop()


def plot(*words):
    return subprocess.run([sys.executable, PLOT, *map(str, words)], capture_output=True, text=True)


def share(path, colour, slack=0.08):
    """Share of the pixels within `slack` of a colour."""
    pixels = matplotlib.image.imread(path)[:, :, :3]
    return (np.abs(pixels - np.array(colour)).max(axis=2) < slack).mean()


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        for kind in ("disc", "beam"):
            subprocess.run([SAMPLE_RUN, FOLDER / kind, kind, "3"], check=True)

    def draws(self, *words):
        done = plot(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [pathlib.Path(line) for line in done.stdout.split("\n") if line]

    def refuses(self, expected, *words):
        done = plot(*words)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(expected, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def is_a_picture(self, path):
        pixels = matplotlib.image.imread(path)
        self.assertGreater(min(pixels.shape[:2]), 300, path)
        ink = (pixels[:, :, :3] < 0.97).any(axis=2).mean()
        self.assertGreater(ink, 0.02, f"{path} is blank")
        self.assertLess(ink, 0.8, f"{path} has no white left")

    def test_every_picture_of_a_plane_run(self):
        made = self.draws(FOLDER / "disc")
        self.assertEqual(
            sorted(path.name for path in made), ["frame_000002.png", "histories.png", "ledger.png", "summary.png"]
        )
        for path in made:
            self.assertEqual(path.parent, FOLDER / "disc" / "pictures")
            self.is_a_picture(path)

    def test_cracks_are_seen(self):
        red = (0xD1 / 255, 0x20 / 255, 0x2F / 255)
        out = FOLDER / "seen"
        self.draws(FOLDER / "disc", "--frame", "all", "-o", out)
        self.assertGreater(share(out / "frame_000002.png", red), 5e-4)
        self.assertEqual(share(out / "frame_000000.png", red), 0)  # nothing has broken yet
        self.draws(FOLDER / "beam", "-o", out / "beam")
        self.assertGreater(share(out / "beam" / "frame_000002.png", red, 0.3), 5e-3)

    def test_field_of_a_space_run(self):
        out = FOLDER / "field"
        made = self.draws(FOLDER / "beam", "--field", "displacement.z", "--frame", "1", "-o", out)
        self.assertIn(out / "frame_000001.png", made)
        self.is_a_picture(out / "frame_000001.png")

    def test_fields_have_the_values_of_their_names(self):
        sys.path.insert(0, str(pathlib.Path(PLOT).parent))
        from breccia_plot import fields
        from breccia_plot.run_folder import Array, Grid

        # Uniaxial 2, simple shear 3, and pressure 5: xx yy zz xy yz xz.
        stress = np.array([[2.0, 0, 0, 0, 0, 0], [0, 0, 0, 3, 0, 0], [-5, -5, -5, 0, 0, 0]])
        velocity = np.array([[3.0, 4, 0], [0, 0, -2]])
        arrays = {"stress": Array("stress", stress, "Pa", False), "velocity": Array("velocity", velocity, "m/s", True)}
        grid = Grid(np.zeros((2, 3)), np.zeros((3, 3), int), 5, arrays, 0.0, 2)
        expected = {
            None: [2, 3 * 3**0.5, 0],
            "sigma_1": [2, 3, -5],
            "sigma_3": [0, -3, -5],
            "pressure": [-2 / 3, 0, 5],
            "stress.xy": [0, 3, 0],
            "velocity": [5, 2],
            "velocity.z": [0, -2],
        }
        for name, values in expected.items():
            np.testing.assert_allclose(fields.field(grid, name).values, values, atol=1e-14, err_msg=str(name))
        self.assertEqual(fields.limits(np.array([1.0, 2, 3, 4]), share=0), (0.0, 4.0, False))
        low, high, signed = fields.limits(np.array([-1.0, 2.0]), share=0)
        self.assertEqual((low, high, signed), (-2, 2, True))
        self.assertEqual(fields.limits(np.array([7.0, 7.0])), (6.5, 7.5, False))

    def test_b_value_is_that_of_its_distribution(self):
        sys.path.insert(0, str(pathlib.Path(PLOT).parent))
        from breccia_plot import catalogue

        # 20 000 magnitudes above -6 with b = 1.2, some below lost: error 0.01.
        rng = np.random.default_rng(1)
        magnitudes = -6 + rng.exponential(np.log10(np.e) / 1.2, 20000)
        b, error, complete = catalogue.gutenberg_richter(magnitudes)
        self.assertLess(abs(b - 1.2), 4 * error + 0.02)
        self.assertLess(abs(complete + 6), 0.11)
        self.assertLess(error, 0.02)

    def test_catalogue_of_a_run_that_broke_enough(self):
        out = FOLDER / "broken"
        shutil.copytree(FOLDER / "disc", out, dirs_exist_ok=True)
        self.assertFalse((FOLDER / "disc" / "pictures" / "catalogue.png").exists())
        rows = [f"{k}e-5,0,{k}e-3,0,1,1e-3,{1 + 0.1 * k},{k + 1},{10 ** k},{2 / 3 * k - 6.03}" for k in range(8)]
        (out / "emissions.csv").write_text(
            "time,duration,x,y,breaks,area,mode,energy,moment,magnitude\n" + "\n".join(rows) + "\n")
        rows = [f"1e-3,2,{k},5,{10.0 ** -k},{0.1 / (k + 1)},0,0,{k},1,0,0.1,0.05" for k in range(8)]
        (out / "fragments.csv").write_text(
            "time,frame,fragment,elements,mass,size,x,y,velocity_x,velocity_y,spin,length,width\n" +
            "\n".join(rows) + "\n")
        made = self.draws(out)
        self.assertIn(out / "pictures" / "catalogue.png", made)
        self.is_a_picture(out / "pictures" / "catalogue.png")

    def test_force_chains_are_as_wide_as_their_forces(self):
        out = FOLDER / "chains"
        shutil.copytree(FOLDER / "disc", out, dirs_exist_ok=True)
        self.refuses("no [contact]", out, "--forces")
        points = [[-0.02, 0, 0], [0, 0, 0], [0.02, 0, 0], [0, 0.02, 0]]
        arrays = {"force": [[5.0, 0, 0], [-5, 0, 0], [0, -1, 0]], "size": [1.0, 1, 9], "partner_size": [1.0, 1, 1]}
        with h5py.File(out / "frames" / "contacts_000002.vtkhdf", "w") as file:
            root = file.create_group("VTKHDF")
            root.attrs["dimension"] = [2]
            root["Types"], root["Connectivity"] = np.array([3, 3, 3], np.uint8), np.array([0, 1, 1, 2, 1, 3])
            root["Points"], root["FieldData/time"] = np.array(points), np.array([0.0])
            root.create_group("PointData")
            for name, values in arrays.items():
                root["CellData/" + name] = np.array(values)
        made = self.draws(out, "--forces")
        self.assertIn(out / "pictures" / "forces_000002.png", made)
        self.is_a_picture(out / "pictures" / "forces_000002.png")
        sys.path.insert(0, str(pathlib.Path(PLOT).parent))
        from breccia_plot import force_chains, run_folder

        ends, force = force_chains.legs(run_folder.RunFolder(out).contacts(2))
        np.testing.assert_allclose(force, [5, 5])  # the leg into the floor is left out
        self.assertEqual(ends.shape, (2, 2, 3))

    def test_what_cannot_be_drawn_is_refused(self):
        self.refuses("no such folder", FOLDER / "nowhere")
        (FOLDER / "empty").mkdir(exist_ok=True)
        self.refuses("not the folder of a run", FOLDER / "empty")
        self.refuses("no frame 17; there are 0 to 2", FOLDER / "disc", "--frame", "17")
        self.refuses("no frame x", FOLDER / "disc", "--frame", "x")
        self.refuses("no field 'heat'; there are von_mises", FOLDER / "disc", "--field", "heat")
        self.refuses("no field 'velocity.q'", FOLDER / "disc", "--field", "velocity.q")
        self.refuses("RUN_FOLDER")

    def test_run_without_frames_still_shows_its_histories(self):
        bare = FOLDER / "bare"
        bare.mkdir(exist_ok=True)
        for name in ("scene.toml", "history.csv"):
            shutil.copy(FOLDER / "disc" / name, bare)
        self.refuses("has no frames", bare)
        self.is_a_picture(bare / "pictures" / "histories.png")
        self.is_a_picture(bare / "pictures" / "ledger.png")

    def test_damaged_frame_is_named(self):
        broken = FOLDER / "broken"
        shutil.copytree(FOLDER / "disc", broken, dirs_exist_ok=True)
        frame = broken / "frames" / "000002.vtkhdf"
        frame.write_bytes(frame.read_bytes()[:1000])
        self.refuses("000002.vtkhdf", broken)

    def test_row_in_the_making_is_left_out(self):
        running = FOLDER / "running"
        shutil.copytree(FOLDER / "disc", running, dirs_exist_ok=True)
        with open(running / "history.csv", "a", encoding="utf-8") as file:
            file.write("0.001,3")
        self.draws(running, "-o", FOLDER / "row")


if __name__ == "__main__":
    unittest.main(verbosity=2)
