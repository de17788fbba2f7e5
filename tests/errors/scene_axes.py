"""Directions of materials: fields of mesh files that do not say what is asked of them."""

from cases import Case

PLANE = """\
[run]
dimension = 2
duration  = "1 us"

[[body]]
name     = "rock"
material = "shale"
shape    = { file = "rock.msh" }

[material.shale]
density = 2420
transversely_isotropic = { young = 4e10, young_axis = 2e10, poisson = 0.2, poisson_axis = 0.1, shear_axis = 1e10 }

[[axes]]
field = "bedding"
"""

SPACE = PLANE.replace("dimension = 2", "dimension = 3")

SQUARE = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
2
7 2 2 1 1 1 2 3
9 2 2 1 1 1 3 4
$EndElements
"""

CORNER = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
$EndNodes
$Elements
1
7 4 2 1 1 1 2 3 4
$EndElements
"""


def data(components, rows, name="bedding"):
    return (f'$ElementData\n1\n"{name}"\n1\n0\n3\n0\n{components}\n{len(rows)}\n' + "".join(r + "\n" for r in rows)
            + "$EndElementData\n")


def plane(name, field, says):
    return Case(name, base=PLANE, files={"rock.msh": SQUARE + field}, at='field = "bedding"', says=says)


def space(name, field, says):
    return Case(name, base=SPACE, files={"rock.msh": CORNER + field}, at='field = "bedding"', says=says)


def damaged(name, field, says):
    return Case(name, base=PLANE, files={"rock.msh": SQUARE + field}, says=["rock.msh:", *says])


CASES = [
    plane("file without fields", "", ['no mesh file has a field "bedding" of elements', "$ElementData"]),
    plane("field of another name", data(1, ["7 10", "9 20"], "beding"),
          ['no mesh file has a field "bedding" of elements', "there are: beding"]),
    plane("two components", data(2, ["7 1 0", "9 1 0"]),
          ['"bedding" has 2 components', "1 is an angle in degrees from x towards y"]),
    plane("axes of space in the plane", data(9, ["7 1 0 0 0 1 0 0 0 1"]), ['"bedding" has 9 components']),
    plane("element without value", data(1, ["7 10"]),
          ['in "bedding" the element at (0.333333, 0.666667) has no value', "give one to every element there"]),
    plane("direction out of the plane", data(3, ["7 0 0 1", "9 1 0 0"]),
          ["the element at (0.666667, 0.333333) has no direction in the plane"]),
    space("angle in space", data(1, ["7 10"]),
          ['"bedding" has 1 components', "3 are the direction of the third axis"]),
    space("direction of length zero", data(3, ["7 0 0 0"]),
          ["the element at (0.25, 0.25, 0.25) has a direction of length zero"]),
    space("axes that are skew", data(9, ["7 1 0 0 0 1 0 0.2 0 1"]), ["no right-handed axes at right angles"]),
    space("axes that are left-handed", data(9, ["7 1 0 0 0 1 0 0 0 -1"]), ["no right-handed axes"]),
    Case("angle and field", base=PLANE.replace('field = "bedding"', 'field = "bedding"\nangle = 1'),
         files={"rock.msh": SQUARE + data(1, ["7 1", "9 1"])}, says=["angle and field exclude each other"]),
    damaged("value of no element", data(1, ["7 1", "8 1"]), ["a value for element 8, which does not exist"]),
    damaged("two values for an element", data(1, ["7 1", "7 2"]), ["the field has two values for this element"]),
    damaged("value that is no number", data(1, ["7 nan", "9 2"]), ["the value is no finite number"]),
    damaged("field given twice", data(1, ["7 1", "9 2"]) * 2, ['the field "bedding" is given twice']),
    damaged("field that is cut short", data(1, ["7 1"]).split("7 1")[0], ["ends too early"]),
]
