"""Scenes whose keys are right one by one, and that cannot be run all the same."""

from cases import Case
from scenes import EFFECTS, SPACE

BLOCK = 'shape    = { rectangle = { corner = [0, 0], size = ["20 mm", "10 mm"] } }'
BLOCK_MESH = 'mesh     = { generator = "structured", size = "5 mm" }'
PLATE = 'shape.rectangle = { corner = ["40 mm", 0], size = ["20 mm", "10 mm"] }'
PLANE_OF_FOOT = "plane = { point = [0, 0], normal = [0, 1] }"
FIXED = 'fixed = ["free", 0]'
POINT = 'point = ["10 mm", "9 mm"]'
DURATION = 'duration  = "10 us"'
GMSH_MESH = 'mesh = { size = "5 mm" }'


def end_with(text):
    """Adds text at the end of EFFECTS."""
    return [("[contact]\nfriction = 0.3\n", "[contact]\nfriction = 0.3\n" + text)]


def from_file(name):
    return [(BLOCK, f'shape = {{ file = "{name}" }}'), (BLOCK_MESH, GMSH_MESH)]


PLACES = [
    Case("boundary on a region that is not there",
         edit=[('where    = "plate"', 'where    = "plat"')], at='"plat"',
         says=["no body or region is called 'plat'. Did you mean 'plate'?", "block.left"]),
    Case("boundary on a plane beside everything",
         edit=[(PLANE_OF_FOOT, "plane = { point = [0, 1], normal = [0, 1] }")], at="[0, 1], n",
         says=["boundary.foot.plane: no node of the mesh lies there", "prints the extent"]),
    Case("boundary in an empty box",
         edit=[(PLANE_OF_FOOT, "box = { lower = [1, 1], upper = [2, 2] }")], at="box",
         says=["boundary.foot.box: no node of the mesh lies there"]),
    Case("pressure where there is no surface",
         edit=[(PLANE_OF_FOOT, 'box = { lower = ["9 mm", "4 mm"], upper = ["11 mm", "6 mm"] }'),
               (FIXED, 'pressure = "1 MPa"'), ('reaction = "foot"', 'reaction = "plate"')],
         says=["boundary.foot: a traction or pressure needs free faces and none lies there"]),
    Case("two boundaries that disagree",
         edit=[(PLANE_OF_FOOT, 'where = "plate"'), (FIXED, 'velocity = ["1 m/s", "free"]')],
         says=["component x of node", "is prescribed twice, with different values",
               "the one at scene.toml:35"]),
    Case("sensor outside of the bodies", edit=[(POINT, 'point = ["30 mm", 0]')], at="30 mm",
         says=["sensor.top.point: the point lies in no body"]),
    Case("sensor on a surface that is not there", edit=[(POINT, 'surface = "block.topp"')],
         at="topp", says=["no body or region is called 'block.topp'. Did you mean 'block.top'?"]),
    Case("reaction of what moves freely", edit=[('reaction = "foot"', 'reaction = "block.top"')],
         at="block.top", says=["nothing holds or moves 'block.top', so it has no reaction"]),
    Case("bodies in one another", edit=[(PLATE, PLATE.replace("40 mm", "15 mm"))],
         says=["block", "plate", "overlap"]),
    Case("one body twice", edit=[(PLATE, PLATE.replace('["40 mm", 0]', "[0, 0]"))],
         says=["block", "plate", "overlap"]),
    Case("step that is not stable", edit=[(DURATION, DURATION + '\nstep = "5 us"')], at="step =",
         says=["run.step: a step of 5e-06 s is not stable: the limit of this mesh is"]),
]

EFFECT_KEYS = [
    Case("friction that falls over no speed", base=EFFECTS,
         edit=end_with('law = "static_dynamic"\ndynamic = 0.2\n'),
         says=["contact.weakening_speed: is missing; static_dynamic needs it"]),
    Case("friction that grows in contact", base=EFFECTS,
         edit=end_with('law = "slip_weakening"\ndynamic = 0.5\nweakening_slip = "1 mm"\n'), at="dynamic =",
         says=["contact.dynamic: 0.5 is above friction = 0.3", "what weakens slides with less friction"]),
    Case("number of another law of friction", base=EFFECTS,
         edit=end_with('dynamic = 0.2\nreference_speed = "1 mm/s"\n'), at="dynamic =",
         says=['contact.dynamic: is not a number of law = "coulomb"', "contact.reference_speed: is not a number",
               "choose the law that it belongs to, or leave it out"]),
    Case("rate and state of contact without its numbers", base=EFFECTS, edit=end_with('law = "ageing"\na = 0.01\n'),
         says=["contact.b: is missing; ageing needs it", "contact.state_slip: is missing"]),
    Case("law of friction without friction", base=EFFECTS,
         edit=end_with('[[contact.pair]]\nbetween = ["steel"]\nfriction = 0.0\nlaw = "slip_law"\n'
                       'a = 0.01\nb = 0.02\nstate_slip = "1 um"\n'), at="friction = 0.0",
         says=["friction: is zero; slip_law starts from it", "give the friction coefficient at rest"]),
    Case("law of friction of no name", base=EFFECTS, edit=end_with('law = "slip_weakning"\n'), at="slip_weakning",
         says=["Did you mean 'slip_weakening'?"]),
    Case("fracture of what is not there", base=EFFECTS,
         edit=[("[fracture.granite]", "[fracture.granit]")], at="[fracture.granit]",
         says=["fracture.granit: no material 'granit' in this scene. Did you mean 'granite'?"]),
    Case("fracture key misspelt", base=EFFECTS, edit=[("tensile_strength", "tensile_strenght")],
         at="strenght", says=["Did you mean 'tensile_strength' [Pa]?",
                              "fracture.granite.tensile_strength: is missing (pressure)"]),
    Case("fracture without cohesion", base=EFFECTS, edit=[('cohesion         = "24 MPa"', "")],
         at="[fracture.granite]", says=["fracture.granite.cohesion: is missing"]),
    Case("alpha above one", base=EFFECTS, edit=[("= 0.95", "= 1.5")], at="= 1.5",
         says=["fracture.granite.alpha: 1.5 is out of range; allowed: from 0 to 1"]),
    Case("strengths that scatter too far", base=EFFECTS, edit=[("= 0.95", "= 0.95\nscatter = 0.5")],
         at="= 0.5", says=["fracture.granite.scatter: 0.5 is out of range; allowed: from 1 to 1000"]),
    Case("correlation of what does not scatter", base=EFFECTS,
         edit=[("= 0.95", '= 0.95\ncorrelation = "5 mm"')], at="correlation",
         says=["fracture.granite.correlation: strengths that do not scatter have no correlation"]),
    Case("correlation over no length", base=EFFECTS,
         edit=[("= 0.95", "= 0.95\nscatter = 5\ncorrelation = 0")], at="correlation",
         says=["allowed: above 0 m"]),
    Case("rate of faces that are there from the start", base=EFFECTS,
         edit=[("= 0.95", '= 0\nrate_reference = "30 1/s"')], at="rate_reference",
         says=["rate_reference: with alpha = 0 faces are interfaces before anything moves"]),
    Case("strength that grows faster than the rate", base=EFFECTS,
         edit=[("= 0.95", '= 0.95\nrate_reference = "30 1/s"\nrate_exponent = 1.5')], at="= 1.5",
         says=["1.5 is out of range; allowed: above 0 and at most 1"]),
    Case("rate that makes weak", base=EFFECTS,
         edit=[("= 0.95", '= 0.95\nrate_reference = "30 1/s"\nrate_limit = 0.5')], at="= 0.5",
         says=["0.5 is out of range; allowed: from 1 to 100"]),
    Case("negative strength", base=EFFECTS, edit=[('"8 MPa"', '"-8 MPa"')], at="-8",
         says=['"-8 MPa" (-8000000 Pa) is out of range; allowed: at least 0 Pa']),
    Case("fracture energy per volume", base=EFFECTS, edit=[('"50 J/m2"', '"50 J/m3"')],
         at="J/m3", says=['"50 J/m3" is a pressure; an energy per area, e.g. "50 J/m2"']),
    Case("friction angle without a unit", base=EFFECTS, edit=[('"50 deg"', '"50"')], at='"50"',
         says=['"50" has no unit; an angle, e.g. "50 deg", is wanted', "taken in rad"]),
    Case("friction angle in degrees as a number", base=EFFECTS, edit=[('"50 deg"', "50")],
         at="= 50", says=["50 rad is out of range; allowed: at least 0 deg and below 85.9"]),
    Case("energy below what the mesh stores", base=EFFECTS, edit=[('"50 J/m2"', '"0.01 J/m2"')],
         at="0.01", says=["0.01 J/m2 is less than an interface stores at its peak on this mesh"]),
    Case("softening of another code", base=EFFECTS,
         edit=[("= 0.95", '= 0.95\nsoftening = "exponential"')], at="exponential",
         says=['"exponential" is not known', "choices: linear, z_curve"]),
    Case("interface of one material", base=EFFECTS,
         edit=end_with('[[interface]]\nbetween = ["granite", "granite"]\n'
                       "tensile_strength = 1\ncohesion = 1\nenergy_tension = 1\n"
                       "energy_shear = 1\n"), at="between",
         says=['"granite" is named twice']),
    Case("interface with what is not there", base=EFFECTS,
         edit=end_with('[[interface]]\nbetween = ["granite", "mortar"]\n'), at="between",
         says=["no material 'mortar' in this scene", "material names: granite, steel"]),
    Case("contact key misspelt", base=EFFECTS, edit=[("friction = 0.3", "fricton = 0.3")],
         at="fricton", says=["contact.fricton: no such key. Did you mean 'friction'?"]),
    Case("negative friction", base=EFFECTS, edit=[("friction = 0.3", "friction = -0.3")],
         at="-0.3", says=["-0.3 is out of range; allowed: at least 0"]),
    Case("contact pair of nothing", base=EFFECTS,
         edit=end_with("[[contact.pair]]\nbetween = []\nfriction = 0.1\n"), at="between",
         says=["a pair has two materials"]),
    Case("contact pair of one twice", base=EFFECTS,
         edit=end_with('[[contact.pair]]\nbetween = ["steel", "steel"]\nfriction = 0.1\n'), at="between",
         says=['"steel" is named twice']),
    Case("contact pair with what is not there", base=EFFECTS,
         edit=end_with('[[contact.pair]]\nbetween = ["steel", "ice"]\nfriction = 0.1\n'),
         at="between", says=["no material 'ice' in this scene"]),
    Case("emissions without reach", base=EFFECTS, edit=[('history = "1 us"', 'history = "1 us"\nemission_reach = 0')],
         at="emission_reach", says=["output.emission_reach: 0 m is out of range; allowed: above 0 m"]),
    Case("norm of what is not there", base=EFFECTS,
         edit=end_with('[[norm]]\nname = "n"\nfields = ["stress.xy", "stres.xx"]\n'), at='"stres.xx"',
         says=["this run has no field 'stres.xx'", "Did you mean 'stress.xx'?"]),
    Case("norm with a formula too few", base=EFFECTS,
         edit=end_with('[[norm]]\nname = "n"\nfields = ["stress.xy", "stress.xx"]\nexact = ["x"]\n'), at='exact = ["x"]',
         says=["1 formulas for 2 fields", "give one for each"]),
    Case("norm of a body that is not there", base=EFFECTS,
         edit=end_with('[[norm]]\nname = "n"\nfields = ["stress.xy"]\nbody = "blok"\n'), at='body = "blok"',
         says=["there is no body 'blok'"]),
    Case("norm against what has no meaning", base=EFFECTS,
         edit=end_with('[[norm]]\nname = "n"\nfields = ["stress.xy"]\nexact = ["2 * r"]\n'), at="2 * r",
         says=["'r'", "formulas speak of x, y, z and time"]),
    Case("check of what is not there", base=EFFECTS,
         edit=end_with('[[check]]\nname = "c"\nvalue = "2 * final(res_3)"\nreference = "1"\ntolerance = 1\n'),
         at="2 * final(res_3)", says=["this run has no 'res_3'", "Did you mean 'res_1'?"]),
    Case("check against a share of zero", base=EFFECTS,
         edit=end_with('[[check]]\nname = "c"\nvalue = "res_2"\nreference = "0"\ntolerance = "1 %"\n'),
         at='tolerance = "1 %"', says=["a share of a reference of 0 allows nothing", "unit of the value"]),
]

FILES = [
    Case("mesh file that is not there", edit=from_file("disc.msh"), at="disc.msh",
         says=["there is no file", "disc.msh"]),
    Case("mesh file that is damaged", edit=from_file("disc.msh"),
         files={"disc.msh": "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n"},
         says=["disc.msh"]),
    Case("mesh file of another kind", edit=from_file("disc.stl"), files={"disc.stl": "solid\n"},
         says=["disc.stl"]),
    Case("native mesh that is none", edit=from_file("disc.h5"), files={"disc.h5": b"no HDF5"},
         says=["disc.h5"]),
    Case("outline that crosses itself",
         edit=[(BLOCK, "shape = { polygon = { points = [[0, 0], [1, 1], [1, 0], [0, 1]] } }"),
               (BLOCK_MESH, 'mesh = { size = "500 mm" }')], says=["block", "cross"]),
]

OUTPUT = [
    Case("output where a file is", command=["run", "scene.toml", "--output", "data"],
         files={"data": "precious"}, says=["data"]),
    Case("output below a file", command=["run", "scene.toml", "--output", "data/run"],
         files={"data": "precious"}, says=["data"]),
    Case("output that is there", command=["run", "scene.toml", "--output", "data"],
         files={"data/report.json": "{}"}, says=["data", "--overwrite", "--restart"]),
    Case("restart of nothing", command=["run", "scene.toml", "--restart"], says=["restart"]),
    Case("restart without a checkpoint",
         command=["run", "scene.toml", "--restart", "--output", "data"],
         files={"data/report.json": "{}"}, says=["checkpoint"]),
    Case("restart from a damaged checkpoint",
         command=["run", "scene.toml", "--restart", "--output", "data"],
         files={"data/report.json": "{}", "data/checkpoint.h5": b"\x89HDF\r\n\x1a\n" + b"0" * 99},
         says=["checkpoint.h5"]),
    Case("mesh into a folder that is not there",
         command=["mesh", "scene.toml", "-o", "nowhere/mesh.h5"], says=["nowhere"]),
    Case("mesh of an unknown kind", command=["mesh", "scene.toml", "-o", "mesh.xyz"],
         says=["mesh.xyz: a mesh is written in Breccia's own format, named .h5"]),
]

CASES = PLACES + EFFECT_KEYS + FILES + OUTPUT
