"""What a run folder holds, as arrays."""
import csv
import dataclasses
import json
import pathlib
import re

import h5py
import numpy as np

from .trouble import Trouble

LINE, TRIANGLE, TETRAHEDRON = 3, 5, 10  # VTK's numbers
CORNERS = {LINE: 2, TRIANGLE: 3, TETRAHEDRON: 4}


@dataclasses.dataclass
class Array:
    """A named array over points or cells."""

    name: str
    values: np.ndarray  # one row per entity
    unit: str
    on_points: bool


@dataclasses.dataclass
class Grid:
    """One VTKHDF file: points (n, 3), cells (m, corners), arrays by name."""

    points: np.ndarray
    cells: np.ndarray
    kind: int
    arrays: dict
    time: float
    dimension: int


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def read_arrays(group, on_points, into):
    for name, data in group.items():
        into[name] = Array(name, data[()], text_of(data.attrs.get("unit", "")), on_points)


def keep_cells(cells, arrays, here):
    """The cells that are `here`; their arrays are cut alike."""
    for array in arrays.values():
        if not array.on_points:
            array.values = array.values[here]
    return cells[here]


def read_grid(path):
    """Reads a frame or a crack file."""
    try:
        with h5py.File(path, "r") as file:
            root = file["VTKHDF"]
            types = root["Types"][()]
            kind = int(types[0]) if len(types) else LINE
            arrays = {}
            read_arrays(root["PointData"], True, arrays)
            read_arrays(root["CellData"], False, arrays)
            cells = root["Connectivity"][()].reshape(-1, CORNERS[kind])
            if "present" in arrays:  # excavated elements are not drawn
                cells = keep_cells(cells, arrays, arrays["present"].values > 0)
            time = float(root["FieldData/time"][0])
            dimension = int(root.attrs["dimension"][0])
            return Grid(root["Points"][()], cells, kind, arrays, time, dimension)
    except (OSError, KeyError, ValueError) as error:
        raise Trouble(f"{path}: cannot be read as a frame ({error})") from error


def read_table(path):
    """Columns of a CSV file by name, in order; empty when there is no file."""
    if not path.exists():
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    if not rows:
        return {}
    width = len(rows[0])
    # The last line of a running job may be half written.
    numbers = [[float(cell or "nan") for cell in row] for row in rows[1:] if len(row) == width]
    table = np.array(numbers).reshape(-1, width)
    return {name: table[:, k] for k, name in enumerate(rows[0])}


class RunFolder:
    """The folder of one run."""

    def __init__(self, path, without=()):
        self.path = pathlib.Path(path)
        self.without = without  # numbers of bodies that are not drawn
        if not self.path.is_dir():
            raise Trouble(f"{path}: there is no such folder")
        known = ("scene.toml", "history.csv", "report.json", "frames")
        if not any((self.path / name).exists() for name in known):
            raise Trouble(f"{path}: this is not the folder of a run (no {', '.join(known)} in it)")
        self.frames = sorted(
            int(match[1])
            for entry in (self.path / "frames").glob("*.vtkhdf")
            if (match := re.fullmatch(r"(\d+)\.vtkhdf", entry.name))
        )
        self.history = read_table(self.path / "history.csv")
        self.emissions = read_table(self.path / "emissions.csv")
        self.fragments = read_table(self.path / "fragments.csv")
        self.report = self.read_report()

    def read_report(self):
        path = self.path / "report.json"
        if not path.exists():
            return {}
        try:
            return json.loads(path.read_text(encoding="utf-8"))
        except ValueError as error:
            raise Trouble(f"{path}: {error}") from error

    @property
    def title(self):
        if self.report.get("title"):
            return self.report["title"]
        scene = self.path / "scene.toml"
        if scene.exists():
            match = re.search(r'^title\s*=\s*"([^"]*)"', scene.read_text(encoding="utf-8"), re.M)
            if match:
                return match[1]
        return self.path.name

    def chosen(self, which):
        """Frame numbers for --frame N, last or all."""
        if not self.frames:
            raise Trouble(f"{self.path}: the run has no frames to draw (set [output] frames in the scene)")
        if which == "all":
            return self.frames
        if which == "last":
            return self.frames[-1:]
        if not which.isdigit() or int(which) not in self.frames:
            raise Trouble(
                f"{self.path}: there is no frame {which}; there are {self.frames[0]} to {self.frames[-1]}, last, all"
            )
        return [int(which)]

    def frame(self, number):
        path = self.path / "frames" / f"{number:06d}.vtkhdf"
        grid = read_grid(path)
        if self.without:
            body = grid.arrays["body"].values
            grid.cells = keep_cells(grid.cells, grid.arrays, ~np.isin(body, self.without))
            if not len(grid.cells):
                raise Trouble(f"{path}: without bodies {self.without} of {np.unique(body).tolist()} nothing is left")
            used, place = np.unique(grid.cells, return_inverse=True)
            grid.cells = place.reshape(grid.cells.shape)
            grid.points = grid.points[used]
            for array in grid.arrays.values():
                if array.on_points:
                    array.values = array.values[used]
        return grid

    def cracks(self, number):
        """Crack faces of a frame, or None."""
        path = self.path / "frames" / f"cracks_{number:06d}.vtkhdf"
        if not path.exists():
            return None
        grid = read_grid(path)
        return grid if len(grid.cells) else None

    def contacts(self, number):
        """Legs of force chains of a frame, or None where the scene has no contact."""
        path = self.path / "frames" / f"contacts_{number:06d}.vtkhdf"
        return read_grid(path) if path.exists() else None
