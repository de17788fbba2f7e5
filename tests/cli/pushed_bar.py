"""A free bar of some elements that a push sets in motion: its momentum is known, its waves are not resolved."""

SCENE = """\
title     = "pushed bar"
reference = "momentum"
expected  = "v = p t / (rho L)"
[run]
dimension = 2
duration  = "20 us"
[[body]]
name     = "bar"
material = "steel"
shape    = { rectangle = { corner = [0, 0], size = ["20 mm", "5 mm"] } }
mesh     = { generator = "structured", cells = [4, 1] }
[material.steel]
density = "8000 kg/m3"
elastic = { young = "200 GPa", poisson = 0 }
[[boundary]]
where    = "bar.left"
traction = ["8 MPa", 0]
ramp     = "20 us"
[[sensor]]
name  = "middle"
point = ["10 mm", "2 mm"]
[[sensor]]
name    = "all"
surface = "bar"
[output]
frames  = 0
history = "0.5 us"
[[check]]
name      = "speed"
value     = "final(all.vx)"
reference = "0.5 * 8 MPa * 20 us / (8000 kg/m3 * 20 mm)"
tolerance = "50 %"
"""
