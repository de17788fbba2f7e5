"""Problems with a known answer, as scenes for any kind and size of element.

A case is a function of the element and the number of divisions that gives the scene and the files beside it; the scene has one
[[check]], whose value and reference are compared. Nothing else knows what the problem is.
"""
import dataclasses
import math
from typing import Callable

COMPOSITE = {"tri6c", "tet10c"}


@dataclasses.dataclass
class Case:
    name: str
    title: str
    scene: Callable  # (element, divisions) -> (text, {file name: text})
    ladder: dict  # element -> divisions, coarse to fine
    width: float  # of what is divided, m: element size = width / divisions


def grid(nx, ny, place, second):
    """MSH text of a mapped grid of triangles; second order with mid-edge nodes on the map."""
    tag = lambda i, j: 1 + i + j * (2 * nx + 1)
    step = 1 if second else 2
    nodes = [
        f"{tag(i, j)} {x:.17g} {y:.17g} 0"
        for j in range(0, 2 * ny + 1, step)
        for i in range(0, 2 * nx + 1, step)
        for x, y in [place(i / (2 * nx), j / (2 * ny))]
    ]
    elements = []

    def add(group, *corner):
        ids = [tag(*c) for c in corner]
        pairs = zip(corner, corner[1:] + corner[:1]) if len(corner) == 3 else [corner]
        if second:
            ids += [tag((a[0] + b[0]) // 2, (a[1] + b[1]) // 2) for a, b in pairs]
        kind = {(2, False): 1, (2, True): 8, (3, False): 2, (3, True): 9}[len(corner), second]
        elements.append(f"{len(elements) + 1} {kind} 2 {group} {group} " + " ".join(map(str, ids)))

    for j in range(0, 2 * ny, 2):
        add(2, (0, j), (0, j + 2))
        add(3, (2 * nx, j), (2 * nx, j + 2))
    for i in range(0, 2 * nx, 2):
        add(4, (i, 0), (i + 2, 0))
        add(5, (i, 2 * ny), (i + 2, 2 * ny))
    for j in range(0, 2 * ny, 2):
        for i in range(0, 2 * nx, 2):
            add(1, (i, j), (i + 2, j), (i + 2, j + 2))
            add(1, (i, j), (i + 2, j + 2), (i, j + 2))
    names = '$PhysicalNames\n5\n2 1 "body"\n1 2 "left"\n1 3 "right"\n1 4 "bottom"\n1 5 "top"\n$EndPhysicalNames\n'
    return (
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names
        + f"$Nodes\n{len(nodes)}\n" + "\n".join(nodes) + "\n$EndNodes\n"
        + f"$Elements\n{len(elements)}\n" + "\n".join(elements) + "\n$EndElements\n"
    )


def head(title, dimension, run, shape, mesh, material):
    return f"""title = "{title}"
reference = "perf/accuracy"
expected = "the value of its check"
[run]
dimension = {dimension}
{run}
[[body]]
name = "b"
material = "m"
{shape}
mesh = {{ {mesh} }}
[material.m]
{material}
[output]
frames = 0
"""


def check(value, reference):
    return f'[[check]]\nname = "value"\nvalue = "{value}"\nreference = "{reference}"\ntolerance = "1000 %"\n'


def cook(element, n):
    """V-014: 48 by 44 and 16 mm, nu = 0.4999; `n` triangles along a side, as composites half as many."""
    place = lambda s, t: (0.048 * s, 0.044 * s * (1 - t) + (0.044 + 0.016 * s) * t)
    cells = n // 2 if element in COMPOSITE else n
    text = head("Cook's membrane", 2, 'duration = 100\nrest = { tolerance = 1e-3 }', 'shape = { file = "m.msh" }',
                f'element = "{element}"', "density = 1000\nelastic = { young = 240.565e6, poisson = 0.4999 }")
    text += '[[boundary]]\nwhere = "b.left"\nfixed = [0, 0]\n[[boundary]]\nwhere = "b.right"\ntraction = [0, 62500]\n'
    text += '[[sensor]]\nname = "s"\npoint = [0.048, 0.052]\n' + check("final(s.uy)", "76.95 um")
    return text, {"m.msh": grid(cells, cells, place, element in COMPOSITE)}


def ring(element, n):
    """V-015: a quarter of a ring from 1 to 2 m under pressure inside, nu = 0.3; `n` through the wall."""
    place = lambda s, t: ((1 + s) * math.cos(0.5 * math.pi * t), (1 + s) * math.sin(0.5 * math.pi * t))
    cells = n // 2 if element in COMPOSITE else n
    text = head("Lame's ring", 2, 'duration = 1e4\nrest = { method = "local", tolerance = 3e-4 }', 'shape = { file = "m.msh" }',
                f'element = "{element}"', "density = 1000\nelastic = { young = 1000, poisson = 0.3 }")
    text += '[[boundary]]\nwhere = "b.left"\npressure = 0.001\n[[boundary]]\nwhere = "b.bottom"\nfixed = ["free", 0]\n'
    text += '[[boundary]]\nwhere = "b.top"\nfixed = [0, "free"]\n[[sensor]]\nname = "s"\npoint = [1, 0]\n'
    return text + check("final(s.ux)", "1.906667e-6 m"), {"m.msh": grid(cells, cells, place, element in COMPOSITE)}


def cantilever(element, n):
    """A-2.4: 4 by 1 by 1 m, one end held, the other sheared, nu = 0; `n` tetrahedra across."""
    n = n // 2 if element in COMPOSITE else n
    text = head("Cantilever in space", 3, 'duration = 1e4\nrest = { method = "local", tolerance = 1e-3 }',
                "shape = { box = { corner = [0, 0, 0], size = [4, 1, 1] } }",
                f'element = "{element}", generator = "structured", cells = [{4 * n}, {n}, {n}]',
                "density = 1000\nelastic = { young = 1e6, poisson = 0 }")
    text += '[[boundary]]\nwhere = "b.left"\nfixed = [0, 0, 0]\n'
    text += '[[boundary]]\nwhere = "b.right"\ntraction = [0, -100, 0]\n[[sensor]]\nname = "s"\nsurface = "b.right"\n'
    return text + check("-final(s.uy)", f"{CANTILEVER} m"), {}


# Timoshenko's beam, P L^3 / (3 E I) + 6 P L / (5 G A); without Poisson's effect the held end disturbs it by less than 0.1 %.
CANTILEVER = 0.0256 + 0.00096


def taylor(element, n):
    """V-017: copper, 227 m/s; `n` elements to the length of 32.4 mm along an edge. The foot after 80 us."""
    text = head("Taylor bar", 3, 'duration = "80 us"',
                'shape = { cylinder = { centre = [0, 0, 0], axis = [0, 0, 1], diameter = 0.0064, length = 0.0324 } }\n'
                "velocity = [0, 0, -227]", f'element = "{element}", size = {0.0324 / n:.6g}',
                'density = 8930\nelastic = { young = "117 GPa", poisson = 0.35 }\n'
                'j2 = { yield = "400 MPa", hardening = "100 MPa" }')
    text += '[[boundary]]\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\nfixed = ["free", "free", 0]\n'
    text += '[[sensor]]\nname = "s"\npoint = ["3.199 mm", 0, 0]\n'
    return text + check("3.199 mm + final(s.ux)", "7.226 mm"), {}


CASES = [
    Case("cook", "Cook's membrane, nu 0.4999: rise of the side", cook,
         {"tri3": [8, 16, 32, 64], "tri6c": [4, 8, 16, 32, 64]}, 0.048),
    Case("ring", "Lame's ring, nu 0.3: widening inside", ring,
         {"tri3": [4, 8, 16, 32, 64], "tri6c": [4, 8, 16, 32, 64]}, 1.0),
    Case("cantilever", "Cantilever in space, nu 0: deflection", cantilever,
         {"tet4": [2, 4, 8, 12], "tet10c": [2, 4, 6, 8]}, 1.0),
    Case("taylor", "Taylor bar, copper: radius of the foot", taylor,
         {"tet4": [20, 27, 40], "tet10c": [9, 13, 20]}, 0.0324),
]
