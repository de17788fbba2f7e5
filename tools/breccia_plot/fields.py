"""The number that colours the mesh: an array of the frame, a component of it, or what follows from it."""
import dataclasses

import numpy as np

from .trouble import Trouble

COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "xz"]}
TENSORS = ("von_mises", "sigma_1", "sigma_3", "pressure")
TITLES = {
    "von_mises": "von Mises stress",
    "sigma_1": "largest principal stress",
    "sigma_3": "smallest principal stress",
    "pressure": "pressure",
}


@dataclasses.dataclass
class Field:
    """One number per point or per cell."""

    title: str
    values: np.ndarray
    unit: str
    on_points: bool


def von_mises(t):
    xx, yy, zz, xy, yz, xz = t.T
    shear = 6 * (xy**2 + yz**2 + xz**2)
    return np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2 + shear) / 2)


def principal(t):
    xx, yy, zz, xy, yz, xz = t.T
    rows = np.stack([xx, xy, xz, xy, yy, yz, xz, yz, zz], axis=1)
    return np.linalg.eigvalsh(rows.reshape(-1, 3, 3))  # ascending


def from_stress(name, stress):
    tensor = stress.values.astype(float)
    if name == "von_mises":
        values = von_mises(tensor)
    elif name == "pressure":
        values = -tensor[:, :3].mean(axis=1)
    else:
        values = principal(tensor)[:, 2 if name == "sigma_1" else 0]
    return Field(TITLES[name], values, stress.unit, stress.on_points)


def has_stress(grid):
    return "stress" in grid.arrays and grid.arrays["stress"].values.ndim == 2


def names(grid):
    """Everything --field can name."""
    found = [name for name in TENSORS if name not in grid.arrays] if has_stress(grid) else []
    for array in grid.arrays.values():
        found.append(array.name)
        if array.values.ndim == 2:
            found += [f"{array.name}.{c}" for c in COMPONENTS.get(array.values.shape[1], [])]
    return found


def default(grid):
    if has_stress(grid) or "von_mises" in grid.arrays:
        return "von_mises"
    for name in ("velocity", "displacement"):
        if name in grid.arrays:
            return name
    if not grid.arrays:
        raise Trouble("the frame has no field to draw")
    return next(iter(grid.arrays))


def field(grid, name=None):
    """The field of this name, or the default one."""
    name = name or default(grid)
    if name in TENSORS and name not in grid.arrays and has_stress(grid):
        return from_stress(name, grid.arrays["stress"])
    base, _, component = name.rpartition(".")
    if name in grid.arrays:
        array = grid.arrays[name]
        values = array.values.astype(float)
        if values.ndim == 1:
            return Field(TITLES.get(name, name.replace("_", " ")), values, array.unit, array.on_points)
        if values.shape[1] == 6:
            return Field(f"{name}, norm", np.sqrt((values**2).sum(axis=1)), array.unit, array.on_points)
        return Field(name.replace("_", " "), np.linalg.norm(values, axis=1), array.unit, array.on_points)
    if base in grid.arrays and grid.arrays[base].values.ndim == 2:
        array = grid.arrays[base]
        known = COMPONENTS.get(array.values.shape[1], [])
        if component in known:
            values = array.values[:, known.index(component)].astype(float)
            return Field(f"{base.replace('_', ' ')} {component}", values, array.unit, array.on_points)
    raise Trouble(f"there is no field '{name}'; there are {', '.join(names(grid))}")


def limits(values, share=1.0):
    """Range of the colours: the middle 100 - 2 `share` per cent; symmetric about 0 where both signs matter."""
    finite = values[np.isfinite(values)]
    if not len(finite):
        return 0.0, 1.0, False
    low, high = np.percentile(finite, [share, 100 - share])
    if low == high:
        low, high = finite.min(), finite.max()
    signed = low < 0 < high and min(-low, high) > 0.05 * max(-low, high)
    if signed:
        high = max(-low, high)
        low = -high
    elif 0 <= low < 0.5 * high:
        low = 0.0
    elif 0.5 * low < high <= 0:
        high = 0.0
    if low == high:
        low, high = low - 0.5, high + 0.5
    return float(low), float(high), bool(signed)
