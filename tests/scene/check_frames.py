"""VTK's own reader opens our frames and finds every number: check_frames.py SAMPLE_RUN FOLDER

SAMPLE_RUN is the program that writes the frames; the numbers expected are computed here again."""
import subprocess
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOHDF import vtkHDFReader

FOLDER = sys.argv.pop()
SAMPLE_RUN = sys.argv.pop()


def read(name):
    reader = vtkHDFReader()
    path = f"{FOLDER}/{name}.vtkhdf"
    if not reader.CanReadFile(path):
        raise AssertionError(f"VTK {vtkVersion.GetVTKVersion()} cannot read {path}")
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def arrays(attributes):
    found = {}
    for k in range(attributes.GetNumberOfArrays()):
        found[attributes.GetArrayName(k)] = vtk_to_numpy(attributes.GetArray(k))
    return found


class Frames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([SAMPLE_RUN, FOLDER, "vtk"], check=True)

    def same(self, found, expected, kind):
        expected = np.asarray(expected)
        self.assertEqual(found.dtype, kind)
        self.assertEqual(found.shape, expected.shape)
        np.testing.assert_array_equal(found, expected)

    def cells(self, grid, kind, corners):
        self.assertEqual(grid.GetNumberOfCells(), len(corners))
        for k, nodes in enumerate(corners):
            self.assertEqual(grid.GetCellType(k), kind)
            cell = grid.GetCell(k)
            self.assertEqual([cell.GetPointId(a) for a in range(cell.GetNumberOfPoints())], nodes)

    def test_plane(self):
        grid = read("plane")
        points = vtk_to_numpy(grid.GetPoints().GetData())
        self.same(points, [[0, 0, 0], [1, 0.1, 0], [1, 1, 0], [0, 1.1, 0]], np.float64)
        self.cells(grid, 5, [[0, 1, 2], [0, 2, 3]])
        at_points, at_cells = arrays(grid.GetPointData()), arrays(grid.GetCellData())
        self.assertEqual(sorted(at_points), ["speed", "velocity"])
        self.assertEqual(sorted(at_cells), ["body", "damage", "plane_stress", "stress"])
        self.same(at_points["velocity"], [[0, 1, 0], [2, 3, 0], [4, 5, 0], [6, 7, 0]], np.float64)
        self.same(at_points["speed"], [0.5, 1.5, 2.5, 3.5], np.float32)
        self.same(at_cells["body"], [3, -7], np.int32)
        self.same(at_cells["damage"], [0.25, 1 / 3], np.float64)
        stress = 1e6 * np.arange(12).reshape(2, 6) + 0.125  # xx yy zz yz xz xy in memory
        self.same(at_cells["stress"], stress[:, [0, 1, 2, 5, 3, 4]], np.float64)
        plane = np.array([[1, 2, 0, 3, 0, 0], [4, 5, 0, 6, 0, 0]], dtype=np.float32)
        self.same(at_cells["plane_stress"], plane, np.float32)
        fields = arrays(grid.GetFieldData())
        self.same(fields["time"], [0.375], np.float64)
        self.same(fields["step"], [42], np.int64)

    def test_space(self):
        grid = read("space")
        points = vtk_to_numpy(grid.GetPoints().GetData())
        self.same(points, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float64)
        self.cells(grid, 10, [[0, 1, 2, 3], [1, 2, 3, 4]])
        self.same(arrays(grid.GetPointData())["displacement"], points, np.float64)

    def test_cracks(self):
        grid = read("cracks")
        self.cells(grid, 3, [[0, 1], [1, 2]])
        at_cells = arrays(grid.GetCellData())
        for name in ("damage", "mode", "opening", "slip", "time", "energy"):
            self.same(at_cells[name], [0.5, 1.0], np.float64)
        self.same(at_cells["status"], [1, 2], np.int32)

    def test_no_cracks_yet(self):
        grid = read("no_cracks")
        self.assertEqual((grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (0, 0))

    def test_the_check_can_fail(self):
        with open(f"{FOLDER}/plane.vtkhdf", "rb") as whole:
            part = whole.read()[:3000]
        with open(f"{FOLDER}/wrong.vtkhdf", "wb") as file:
            file.write(part)
        with self.assertRaises(AssertionError):
            read("wrong")


if __name__ == "__main__":
    unittest.main(verbosity=2)
