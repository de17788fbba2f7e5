"""Right scenes that the cases spoil. They mesh without Gmsh, in no time."""

PLANE = """\
title     = "a block on a plate"
reference = "none"
expected  = "it stands"

[run]
dimension = 2
plane     = "strain"
duration  = "10 us"

[[body]]
name     = "block"
material = "granite"
shape    = { rectangle = { corner = [0, 0], size = ["20 mm", "10 mm"] } }
mesh     = { generator = "structured", size = "5 mm" }

[[body]]
name     = "plate"
material = "steel"
velocity = [0, "1 mm/s"]
shape.rectangle = { corner = ["40 mm", 0], size = ["20 mm", "10 mm"] }
mesh     = { generator = "structured", cells = [4, 2], pattern = "right" }

[material.granite]
density = "2650 kg/m3"
damping = 0.02
elastic = { young = "60 GPa", poisson = 0.25 }

[material.steel]
density = "7850 kg/m3"
elastic = { young = "210 GPa", poisson = 0.3 }

[gravity]
acceleration = [0, "-9.81 m/s2"]

[[boundary]]
name  = "foot"
plane = { point = [0, 0], normal = [0, 1] }
fixed = ["free", 0]

[[boundary]]
where    = "plate"
velocity = ["0.1 m/s", "free"]
ramp     = "1 us"

[[sensor]]
name  = "top"
point = ["10 mm", "9 mm"]

[[sensor]]
name     = "load"
reaction = "foot"

[output]
frames  = 2
history = "1 us"

[[check]]
name      = "drift"
value     = "peak(top.ux)"
reference = "0 mm"
tolerance = "1 mm"
"""

SPACE = """\
title     = "a bar"
reference = "none"
expected  = "it flies"

[run]
dimension = 3
duration  = "10 us"

[[body]]
name     = "bar"
material = "steel"
velocity = [0, 0, "1 m/s"]
shape    = { box = { corner = [0, 0, 0], size = ["20 mm", "10 mm", "10 mm"] } }
mesh     = { generator = "structured", size = "5 mm" }

[material.steel]
density = "7850 kg/m3"
elastic = { young = "210 GPa", poisson = 0.3 }
"""

EFFECTS = PLANE + """
[fracture.granite]
tensile_strength = "8 MPa"
cohesion         = "24 MPa"
friction_angle   = "50 deg"
energy_tension   = "50 J/m2"
energy_shear     = "500 J/m2"
alpha            = 0.95

[contact]
friction = 0.3
"""

ALL = {"PLANE": PLANE, "SPACE": SPACE, "EFFECTS": EFFECTS}
