"""Fractures that lie where none can be, or whose laws do not fit."""

from cases import Case
from scenes import PLANE

FRACTURES = PLANE + """
[[fractures]]
name  = "flaw"
body  = "block"
kind  = "closed"
lines = [[[0, "5 mm"], ["20 mm", "5 mm"]]]

[fractures.friction]
law            = "slip_weakening"
coefficient    = 0.6
dynamic        = 0.4
weakening_slip = "1 mm"

[[fractures.patch]]
lower       = [0, 0]
upper       = ["5 mm", "10 mm"]
coefficient = 0.3
"""

LINES = 'lines = [[[0, "5 mm"], ["20 mm", "5 mm"]]]'
LAW = FRACTURES[FRACTURES.index("[fractures.friction]"):FRACTURES.index("[[fractures.patch]]")]
PATCH = FRACTURES[FRACTURES.index("[[fractures.patch]]"):]
BLOCK_MESH = ('shape    = { rectangle = { corner = [0, 0], size = ["20 mm", "10 mm"] } }\n'
              'mesh     = { generator = "structured", size = "5 mm" }')
GMSH = BLOCK_MESH.replace('generator = "structured", size = "5 mm"', 'size = "2 mm"')


def with_lines(*lines):
    """A mesh by Gmsh, with these lines in mm."""
    return [(BLOCK_MESH, GMSH), (LINES, f"lines = {[list(map(list, line)) for line in lines]}")]


PLACES = [
    Case("fracture beside the faces of a grid", base=FRACTURES,
         edit=[(LINES, LINES.replace("5 mm", "4 mm"))],
         says=['fracture "flaw", piece 0', "only 0 of 0.02 lie on faces of this mesh", "let Gmsh mesh"]),
    Case("fracture that leaves a grid", base=FRACTURES, edit=[(LINES, LINES.replace('[0, "5', '["-5 mm", "5'))],
         says=["only 0.02 of 0.025 lie on faces"]),
    Case("fracture outside of its body", base=FRACTURES,
         edit=with_lines([(0.03, 0.0), (0.04, 0.01)]), says=["does not run through it", "move it into the body"]),
    Case("fractures that cross at a sliver", base=FRACTURES,
         edit=with_lines([(0.002, 0.005), (0.018, 0.005)], [(0.002, 0.0046), (0.018, 0.0054)]),
         says=['body "block"', 'piece 1 from (0.002, 0.0046', "meets it at 2.86", "smaller elements"]),
    Case("fractures that coincide", base=FRACTURES,
         edit=with_lines([(0.002, 0.005), (0.018, 0.005)], [(0.006, 0.005), (0.012, 0.005)]),
         says=["coincides with it"]),
    Case("fracture that ends beside another", base=FRACTURES,
         edit=with_lines([(0.002, 0.005), (0.018, 0.005)], [(0.01, 0.0051), (0.01, 0.008)]),
         says=["ends 0.0001 m beside it", "let one end at the other"]),
    Case("fracture that ends below the surface", base=FRACTURES,
         edit=with_lines([(0.0001, 0.005), (0.018, 0.005)]),
         says=["ends 0.0001 m beside it, at (0.0001, 0.005, 0) m", "let it end on the surface"]),
    Case("fracture without length", base=FRACTURES, edit=with_lines([(0.01, 0.005), (0.01, 0.005)]),
         says=["has no extent", "two different points"]),
    Case("fracture in no body", base=FRACTURES, edit=[('body  = "block"', 'body  = "blok"')],
         at='"blok"', says=["blok", "Did you mean 'block'"]),
    Case("no file of fractures", base=FRACTURES, edit=[(LINES, 'file = "none.csv"')],
         says=["none.csv: the file cannot be read"]),
    Case("file of fractures with words", base=FRACTURES,
         edit=[(LINES, 'file = "a.csv"')], files={"a.csv": "0, 0\n1, x\n"},
         says=["a.csv:2", '"x" is not a number']),
    Case("grains smaller than elements", base=FRACTURES,
         edit=[(BLOCK_MESH, GMSH), (LINES, 'grains = { size = "3 mm" }')],
         says=["grains of 0.003 m cannot be made of elements of 0.002 m", "at most half the size"]),
    Case("set of fractures without room", base=FRACTURES,
         edit=[(BLOCK_MESH, GMSH), (LINES, 'set = { number = 500, shortest = "5 mm", longest = "5 mm" }')],
         says=["random fractures there is no room for more", "ask for fewer"]),
]

LAWS = [
    Case("closed fracture without friction", base=FRACTURES, edit=[(LAW, ""), (PATCH, "")],
         says=["fractures.flaw.friction: is missing", "add [fractures.friction]"]),
    Case("open fracture with friction", base=FRACTURES, edit=[('"closed"', '"open"'), (PATCH, "")],
         at="[fractures.friction]", says=['is for kind = "closed"']),
    Case("healed fracture without strength", base=FRACTURES,
         edit=[('"closed"', '"healed"'), (LAW, ""), (PATCH, "")],
         says=["fractures.flaw.law: is missing: the strength of healed fractures"]),
    Case("patch of an open fracture", base=FRACTURES, edit=[('"closed"', '"open"'), (LAW, "")],
         says=["only a closed fracture has patches"]),
    Case("friction out of range", base=FRACTURES, edit=[("coefficient    = 0.6", "coefficient    = -0.6")],
         at="coefficient    =", says=["fractures.flaw.friction.coefficient", "from 0 to 10"]),
    Case("friction that grows", base=FRACTURES, edit=[("dynamic        = 0.4", "dynamic        = 0.7")],
         at="dynamic        =", says=["0.7 is above coefficient = 0.6"]),
    Case("weakening over no slip", base=FRACTURES, edit=[('weakening_slip = "1 mm"', "")],
         says=["fractures.flaw.friction.weakening_slip: is missing; slip_weakening needs it"]),
    Case("rate and state without its numbers", base=FRACTURES, edit=[('"slip_weakening"', '"ageing"')],
         says=["friction.a: is missing; ageing needs it", "friction.b: is missing", "friction.state_slip",
               'friction.weakening_slip: is not a number of law = "ageing"']),
    Case("stress of a fault with too few components", base=FRACTURES,
         edit=[("coefficient    = 0.6", 'coefficient    = 0.6\nstress = [0, "-1 MPa"]')], at="stress =",
         says=["2 components", "[xx, yy, zz, xy]"]),
    Case("patch upside down", base=FRACTURES, edit=[('upper       = ["5 mm", "10 mm"]', 'upper = [-1, 1]')],
         at="upper = [-1", says=["is below lower along x"]),
    Case("fracture in two ways", base=FRACTURES, edit=[(LINES, LINES + '\nfile = "a.csv"')],
         says=["lines and file exclude each other"]),
    Case("fracture nowhere", base=FRACTURES, edit=[(LINES, "")],
         says=["needs one of lines, file, disc, set, planes, grains"]),
    Case("lengths upside down", base=FRACTURES,
         edit=[(LINES, 'set = { number = 2, shortest = "5 mm", longest = "2 mm" }')],
         says=["set.shortest: is longer than the longest"]),
]

CASES = PLACES + LAWS
