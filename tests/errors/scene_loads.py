"""What acts on bodies, given wrongly: stress in the ground, rest, boundaries that absorb."""

from cases import Case
from scenes import EFFECTS

CHECK = '[[check]]\nname      = "drift"'


def add(text):
    """Puts a section before the check of PLANE."""
    return [(CHECK, text + CHECK)]


def stress(keys):
    return add(f"[[initial_stress]]\n{keys}\n")


GRANITE = 'elastic = { young = "60 GPa", poisson = 0.25 }'
FOUR = "stress = [-1, -2, -1, 0]"

STRESS = [
    Case("stress with three components", edit=stress("stress = [-1, -2, 0]"), at="[-1, -2, 0]",
         says=["initial_stress.0.stress: 3 components; a stress has 4 in the plane",
               "[xx, yy, zz, xy]"]),
    Case("stress without stress", edit=stress('where = "block"'),
         says=["initial_stress.0.stress: is missing"]),
    Case("stress that grows nowhere", edit=stress(FOUR + "\ngradient = [1, 1, 1, 0]"),
         at="gradient", says=["along which axis?", 'add axis = "y"']),
    Case("axis for nothing", edit=stress(FOUR + '\naxis = "y"'), at='axis = "y"',
         says=["nothing grows along it"]),
    Case("growth out of the plane",
         edit=stress(FOUR + '\ngradient = [1, 1, 1, 0]\naxis = "z"'), at='axis = "z"',
         says=["there is no z in the plane"]),
    Case("stress of a body that is not there", edit=stress(FOUR + '\nwhere = "blok"'),
         at='"blok"', says=["no body or region is called 'blok'. Did you mean 'block'?"]),
    Case("stress of a side", edit=stress(FOUR + '\nwhere = "block.top"'), at='"block.top"',
         says=["no element lies there", "a region with elements"]),
    Case("stress of an empty box",
         edit=stress(FOUR + '\nbox = { lower = [1, 1], upper = [2, 2] }'),
         says=["no node of the mesh lies there"]),
    Case("stress in plane stress",
         edit=stress(FOUR) + [('plane     = "strain"', 'plane = "stress"')],
         says=["initial_stress.0: initial stress is for plane strain"]),
    Case("stress where density sets the pressure",
         edit=stress(FOUR) + [(GRANITE, GRANITE + "\neos.linear = {}")],
         says=["the equation of state of granite sets its pressure from its density"]),
    Case("stress twice", edit=stress(FOUR + '\nwhere = "block"\n[[initial_stress]]\n' + FOUR),
         says=["is given a stress twice", "that of the one at scene.toml:"]),
]

DURATION = 'duration  = "10 us"'


def run(keys):
    return [(DURATION, DURATION + "\n" + keys)]


REST = [
    Case("rest by magic", edit=run('rest = { method = "magic" }'), at="magic",
         says=['"magic" is not known', "choices: kinetic, local"]),
    Case("rest that tolerates all", edit=run("rest = { tolerance = 1 }"), at="tolerance = 1 }",
         says=["1 is out of range; allowed: above 0 and below 1"]),
    Case("rest of all resistance", edit=run('rest = { method = "local", share = 1.5 }'),
         at="share", says=["1.5 is out of range; allowed: above 0 and below 1"]),
    Case("share without resistance", edit=run("rest = { share = 0.5 }"), at="share",
         says=["run.rest.share: is for the method \"local\""]),
    Case("rest after the run", edit=run('rest = { after = "1 ms" }'), at="after",
         says=["run.rest.after: 0.001 s is beyond the run (duration 1e-05 s)"]),
]

FIXED = 'fixed = ["free", 0]'
PLANE_OF_FOOT = "plane = { point = [0, 0], normal = [0, 1] }"
SIDE = '[[boundary]]\nwhere = "block.top"\n'

KINDS = [
    Case("waves let out twice", edit=add((SIDE + "non_reflecting = true\n") * 2),
         says=["lets waves out twice", "the one at scene.toml:"]),
    Case("input into a wall", edit=add(SIDE + "held = true\ninput = [0, 1]\n"), at="input",
         says=["comes in through a non-reflecting boundary only"]),
    Case("waves not let out", edit=add(SIDE + "non_reflecting = false\n"), at="non_ref",
         says=["false says nothing", "write true, or leave it out"]),
    Case("stress held that is not there", edit=add(SIDE + "held = true\n"), at="held =",
         says=["the scene has no [[initial_stress]] to hold"]),
    Case("ramp of what does not rise",
         edit=add(SIDE + 'non_reflecting = true\nramp = "3 us"\n'), at="3 us",
         says=["there is nothing here that could rise"]),
    Case("mirror without a plane", edit=add(SIDE + "symmetry = true\n"), at="symmetry",
         says=["needs a plane to mirror at"]),
    Case("mirror askew",
         edit=[(FIXED, "symmetry = true"), ("normal = [0, 1]", "normal = [1, 1]"),
               ('reaction = "foot"', 'reaction = "plate"')], at="normal = [1, 1]",
         says=["a mirror's normal must be along an axis"]),
    Case("mirror that is pushed through",
         edit=add('[[boundary]]\nplane = { point = [0, 0], normal = [0, 1] } # 2\n'
                  'velocity = ["free", "1 m/s"]\n') + [(FIXED, "symmetry = true")],
         says=["component y of node", "is prescribed twice, with different values"]),
    Case("waves let out inside",
         edit=add('[[boundary]]\nbox = { lower = ["9 mm", "4 mm"], upper = ["11 mm", "6 mm"] }\n'
                  "non_reflecting = true\n"),
         says=["free faces and none lies there"]),
    Case("gravity that rises at once",
         edit=[('[0, "-9.81 m/s2"]', '[0, "-9.81 m/s2"]\nramp = 0')], at="ramp = 0",
         says=["gravity.ramp: 0 s is out of range; allowed: above 0 s"]),
]

def excavate(keys):
    return add(f"[[excavate]]\n{keys}\n")


EXCAVATION = [
    Case("excavation of nothing named", edit=excavate('release = "1 us"'),
         says=["excavate.0: needs one of where, box"]),
    Case("excavation without a time", edit=excavate('where = "plate"'),
         says=["excavate.0.release: is missing"]),
    Case("excavation at once", edit=excavate('where = "plate"\nrelease = 0'), at="release = 0",
         says=["0 s is out of range; allowed: above 0 s"]),
    Case("excavation before the start",
         edit=excavate('where = "plate"\nrelease = 1\nat = -1'), at="at = -1",
         says=["-1 s is out of range"]),
    Case("excavation after the run",
         edit=excavate('where = "plate"\nrelease = "1 us"\nat = "1 ms"'), at="1 ms",
         says=["excavate.0.at: 0.001 s is beyond the run (duration 1e-05 s)"]),
    Case("excavation of a body that is not there",
         edit=excavate('where = "blok"\nrelease = "1 us"'), at='"blok"',
         says=["no body or region is called 'blok'. Did you mean 'block'?"]),
    Case("excavation of a side", edit=excavate('where = "block.top"\nrelease = "1 us"'),
         at='"block.top"', says=["no element lies there", "a region with elements"]),
    Case("excavation upside down",
         edit=excavate('box = { lower = [1, 1], upper = [0, 2] }\nrelease = "1 us"'),
         says=["0 m is below lower, 1 m, along x"]),
    Case("excavation of an empty box",
         edit=excavate('box = { lower = [1, 1], upper = [2, 2] }\nrelease = "1 us"'),
         says=["no node of the mesh lies there"]),
    Case("excavation of the same twice",
         edit=excavate('where = "block"\nrelease = "1 us"\n[[excavate]]\n'
                       'where = "block"\nrelease = "2 us"'),
         says=["is taken out twice", "that of the one at scene.toml:"]),
    Case("excavation of everything",
         edit=excavate('box = { lower = [-1, -1], upper = [1, 1] }\nrelease = "1 us"'),
         says=["the excavations leave nothing of the scene"]),
]

SPREADING = [
    Case("pressure on what cannot break",
         edit=add(SIDE + 'pressure = "1 MPa"\non_new_faces = true\n'), at="on_new",
         says=["nothing can break in this scene", "[fracture.NAME]"]),
    Case("source of a traction",
         edit=add(SIDE + "traction = [0, 1]\nsource = { point = [0, 0] }\n"), at="source",
         says=["boundary.2.source: is for a pressure"]),
    Case("source nowhere", edit=add(SIDE + "pressure = 1\nsource = { speed = 1 }\n"),
         says=["boundary.2.source.point: is missing"]),
    Case("source that never arrives",
         edit=add(SIDE + "pressure = 1\nsource = { point = [0, 0], speed = 0 }\n"), at="speed",
         says=["0 m/s is out of range; allowed: above 0 m/s"]),
    Case("decay that goes back",
         edit=add(SIDE + "pressure = 1\nsource = { point = [0, 0], decay = [[1, 1], [0, 1]] }\n"),
         at="decay", says=["boundary.2.source.decay"]),
]

MASS = [
    Case("mass scaling to no step", edit=run("mass_scaling = {}"),
         says=["run.mass_scaling.step: is missing"]),
    Case("mass scaling of a dynamic run", edit=run('mass_scaling = { step = "3 us" }'), at="3 us",
         says=["more mass; a dynamic run may take 5 %", "take at most", "quasi_static = true"]),
    Case("mass scaling of what breaks", base=EFFECTS, edit=run('mass_scaling = { step = "1 ns" }'),
         at="1 ns", says=["run.mass_scaling", "nodes that split take their mass anew"]),
]

RIGID_PLATE = ('name     = "plate"', 'name     = "plate"\nrigid    = true')
MOVED = 'velocity = ["0.1 m/s", "free"]'

RIGID = [
    Case("rigid perhaps", edit=[('name     = "plate"', 'name     = "plate"\nrigid = "yes"')],
         at='"yes"', says=["body.plate.rigid"]),
    Case("stretching what is rigid", edit=[(RIGID_PLATE[0], RIGID_PLATE[1] + "\nexpansion = 3")],
         at="expansion", says=["body.plate.expansion: a rigid body does not stretch"]),
    Case("turning what deforms", edit=[(MOVED, MOVED + "\nspin = 3")], at="spin = 3",
         says=["only a rigid body can be told how it turns", "rigid = true"]),
    Case("a pivot that is none", edit=[RIGID_PLATE, (MOVED, MOVED + "\npivot = false")], at="pivot",
         says=["false says nothing"]),
    Case("turning as given and freely",
         edit=[RIGID_PLATE, (MOVED, MOVED + "\npivot = true\nspin = 3")], says=["spin", "pivot"]),
    Case("turning what a pressure moves",
         edit=[RIGID_PLATE, (MOVED, 'pressure = "1 MPa"\nspin = 3')], at="spin = 3",
         says=["add `velocity` or `fixed`"]),
    Case("a rigid body held by its edge",
         edit=[RIGID_PLATE, ('where    = "plate"', 'where    = "plate.left"')], at="rigid",
         says=["a boundary moves or holds a part of 'plate' only", 'say where = "plate"']),
    Case("waves out of a rigid body",
         edit=[RIGID_PLATE, (MOVED + '\nramp     = "1 us"', "non_reflecting = true")], at="rigid",
         says=["lets waves out, but there are no waves in it"]),
    Case("digging in a rigid body", edit=[RIGID_PLATE] + add('[[excavate]]\nwhere = "plate"\n'
                                                            'release = "1 us"\n'),
         at="rigid", says=["an [[excavate]] reaches 'plate'"]),
    Case("rigid bodies resisting",
         edit=[RIGID_PLATE] + run('rest = { method = "local" }'), at='"local"',
         says=["rigid bodies know no local damping", '"kinetic"']),
]

CASES = RIGID + STRESS + REST + KINDS + EXCAVATION + SPREADING + MASS
