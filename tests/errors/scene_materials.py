"""Laws of materials: inelastic laws, equations of state, and what must hold between them."""

from cases import Case
from scenes import EFFECTS

GRANITE = 'elastic = { young = "60 GPa", poisson = 0.25 }'
TENSILE = 'tensile_strength = "8 MPa"'


def granite(text, **more):
    """The right scene with more keys of the granite."""
    return {"edit": [(GRANITE, GRANITE + "\n" + text)], **more}



MC = 'cohesion = "20 MPa", friction_angle = "40 deg"'
HOLMQUIST = ('hel_stress = "2 GPa", hel_pressure = "1.4 GPa", intact = 0.9, intact_power = 0.6, '
             'fractured = {fractured}, fractured_power = 0.6, tension = "{tension}", '
             'ductility = 0.005, ductility_power = 1')
MG = 'c0 = "3940 m/s", s = 1.489, gruneisen = 1.99'
TILLOTSON = ('a = 0.5, b = 1.63, bulk = "75.2 GPa", bulk2 = "65 GPa", energy = "5 MJ/kg", '
             'energy_begin = "{begin} MJ/kg", energy_end = "13.9 MJ/kg"')

LAWS = [
    Case("two laws of yielding", **granite('j2.yield = "1 MPa"\nmohr_coulomb = { ' + MC + " }"),
         says=["material.granite: j2 and mohr_coulomb exclude each other"]),
    Case("no yield stress", **granite("j2 = {}"), at="j2 =",
         says=["material.granite.j2.yield: is missing (pressure)"]),
    Case("negative yield stress", **granite('j2.yield = "-1 MPa"'), at="j2.yield",
         says=["out of range; allowed: above 0 Pa"]),
    Case("softening metal", **granite('j2 = { yield = "1 MPa", hardening = "-1 MPa" }'),
         at="j2 =", says=["material.granite.j2.hardening", "allowed: at least 0 Pa"]),
    Case("hardening exponent", **granite('j2 = { yield = "1 MPa", exponent = 2 }'), at="j2 =",
         says=["2 is out of range; allowed: above 0 and at most 1"]),
    Case("melting below room",
         **granite('johnson_cook = { yield = "1 MPa", melting = "200 K" }'), at="melting",
         says=["material.granite.johnson_cook.melting: is not above the temperature `room`"]),
    Case("molten at the start",
         **granite('johnson_cook = { yield = "1 MPa", melting = "900 K", start = "950 K" }'),
         at="melting", says=["johnson_cook.start: the material is molten at the start"]),
    Case("heat capacity of another unit",
         **granite('johnson_cook = { yield = "1 MPa", heat_capacity = "383 J" }'), at="383",
         says=['"383 J" is an energy; a heat capacity per mass, e.g. "383 J/(kg.K)"']),
    Case("friction angle without degrees",
         **granite('mohr_coulomb = { cohesion = "1 MPa", friction_angle = "0.5" }'),
         at="friction_angle = \"0.5\"", says=["an angle, e.g."]),
    Case("dilation above friction",
         **granite("drucker_prager = { " + MC + ', dilation_angle = "41 deg" }'), at="dilation",
         says=["dilation_angle: is above friction_angle", "give energy away"]),
    Case("cut-off above the tip of the cone",
         **granite("drucker_prager = { " + MC + ', tension_cutoff = "24 MPa" }'), at="cutoff",
         says=["drucker_prager.tension_cutoff: cohesion and friction let go at", "2383"]),
    Case("cut-off above the tip of the pyramid",
         **granite("mohr_coulomb = { " + MC + ', tension_cutoff = "24 MPa" }'), at="cutoff",
         says=["the cut-off would never be reached"]),
    Case("residual without its strain",
         **granite("mohr_coulomb = { " + MC + ', residual_cohesion = "1 MPa" }'), at="residual",
         says=["residual_cohesion and residual_strain belong together"]),
    Case("softening like a cliff",
         **granite("drucker_prager = { " + MC +
                   ', residual_cohesion = "1 MPa", residual_strain = 1e-6 }'), at="residual",
         says=["residual_strain: cohesion falls faster than the elastic stress can"]),
    Case("pyramid that softens like a cliff",
         **granite("mohr_coulomb = { " + MC +
                   ', residual_cohesion = "1 MPa", residual_strain = 1e-6 }'), at="residual",
         says=["residual_strain: cohesion falls faster than the elastic stress can"]),
    Case("cone of no kind", **granite("drucker_prager = { " + MC + ', fit = "outer" }'),
         at="outer", says=["choices: compression, extension, plane_strain"]),
    Case("crushed stronger than intact",
         **granite("holmquist = { " + HOLMQUIST.format(fractured=1, tension="0.2 GPa") + " }"),
         at="holmquist", says=["fractured: the crushed material is stronger than the intact one"]),
]

EOS = [
    Case("two equations of state",
         **granite("eos.mie_gruneisen = { " + MG + " }\neos.linear = {}"),
         says=["material.granite.eos: linear and mie_gruneisen exclude each other"]),
    Case("no equation of state", **granite("eos = {}"), at="eos = {}",
         says=["material.granite.eos: needs one of linear, mie_gruneisen, tillotson, ideal_gas"]),
    Case("no sound", **granite('eos.mie_gruneisen = { c0 = "0 m/s", s = 1 }'), at="c0 =",
         says=["c0", "allowed: above 0 m/s"]),
    Case("spall of no strength", **granite("eos.mie_gruneisen = { " + MG + ", spall = 0 }"),
         at="spall", says=["spall", "allowed: above 0 Pa"]),
    Case("vapour before it boils",
         **granite("eos.tillotson = { " + TILLOTSON.format(begin=14) + " }"), at="tillotson",
         says=["tillotson.energy_end: is not above energy_begin"]),
    Case("energy of another unit",
         **granite("eos.tillotson = { " +
                   TILLOTSON.format(begin=3).replace("5 MJ/kg", "5 MJ") + " }"), at="tillotson",
         says=['"5 MJ" is an energy; an energy per mass, e.g. "5 MJ/kg"']),
    Case("equation with a hole",
         **granite('eos.jwl = { a = "371 GPa", b = "3 GPa", r1 = 0.1, r2 = 0.95, omega = 0.3, '
                   'energy = "7 GPa" }'),
         says=["material.granite.eos: pressure falls as the material is compressed to 2650 kg/m3"]),
    Case("gas without pressure", **granite('eos.ideal_gas = { gamma = 1.4, pressure = 0 }'),
         at="gamma", says=["ideal_gas.pressure", "allowed: above 0 Pa"]),
    Case("pores that close before they begin",
         **granite("eos.mie_gruneisen = { " + MG + " }\n"
                   'eos.pores = { distension = 1.2, begin = "2 GPa", end = "1 GPa" }'),
         at="distension", says=["pores.end: is not above `begin`"]),
    Case("pores of less than nothing",
         **granite("eos.mie_gruneisen = { " + MG + " }\n"
                   'eos.pores = { distension = 0.9, begin = "1 MPa", end = "1 GPa" }'),
         at="distension", says=["0.9 is out of range; allowed: above 1 and at most 10"]),
    Case("pores of a gas",
         **granite('eos.ideal_gas = { gamma = 1.4, pressure = "1 bar" }\n'
                   'eos.pores = { distension = 1.2, begin = "1 MPa", end = "1 GPa" }'),
         at="distension", says=["eos.pores: pores are for solids"]),
    Case("one number of viscosity", **granite("bulk_viscosity = [1.5]"), at="bulk_viscosity",
         says=["wants two numbers, quadratic and linear"]),
    Case("viscosity that drives", **granite("bulk_viscosity = [1.5, -0.1]"), at="bulk_viscosity",
         says=["-0.1 is out of range"]),
]

TOGETHER = [
    Case("yielding in plane stress",
         edit=[('plane     = "strain"', 'plane = "stress"'),
               (GRANITE, GRANITE + '\nj2.yield = "1 MPa"')],
         says=["material.granite.j2: laws of yielding are for plane strain"]),
    Case("equation of state in plane stress",
         edit=[('plane     = "strain"', 'plane = "stress"'),
               (GRANITE, GRANITE + "\neos.linear = {}")],
         says=["material.granite.eos: equations of state are for plane strain"]),
    Case("bulk that yields before faces open", base=EFFECTS,
         **granite("mohr_coulomb = { " + MC + ', tension_cutoff = "7 MPa" }'), at=TENSILE,
         says=["fracture.granite.tensile_strength: the bulk of granite yields in simple tension "
               "at 7", "the faces would never open"]),
    Case("cone that yields before faces open", base=EFFECTS,
         **granite("drucker_prager = { " + MC + ', tension_cutoff = "2 MPa" }'), at=TENSILE,
         says=["yields in simple tension at 6", "the faces would never open"]),
    Case("ceramic that breaks before faces open", base=EFFECTS,
         **granite("holmquist = { " + HOLMQUIST.format(fractured=0.3, tension="2 MPa") + " }"),
         at=TENSILE, says=["yields in simple tension at", "the faces would never open"]),
    Case("spall before faces open", base=EFFECTS,
         **granite("eos.mie_gruneisen = { " + MG + ', spall = "2 MPa" }'), at=TENSILE,
         says=["bears a mean tension of 2", "(eos.mie_gruneisen.spall)"]),
]

LAYERED = ('transversely_isotropic = { young = "40 GPa", young_axis = "25 GPa", poisson = 0.2, '
           'poisson_axis = 0.15, shear_axis = "12 GPa" }')
STIFFNESS = "stiffness.constants = [%s]"
ISOTROPIC = "31e9, 4e9, 14e9, 0, 0, 0, 22e9, 4e9, 0, 0, 0, 31e9, 0, 0, 0, 6e9, 0, 0, 9e9, 0, 6e9"


def instead(text):
    """The right scene with other elastic constants."""
    return {"edit": [(GRANITE, text)]}


DIRECTIONS = [
    Case("two kinds of elasticity", **granite(LAYERED), says=["exclude each other"]),
    Case("contraction that gives energy",
         **instead(LAYERED.replace("0.15", "0.7")), at="transversely",
         says=["a strain would give energy: the leading minor of order 3"]),
    Case("two moduli", **instead('orthotropic = { young = ["1 GPa", "2 GPa"], '
                                 'poisson = [0, 0, 0], shear = ["1 GPa", "1 GPa", "1 GPa"] }'),
         at="orthotropic", says=["young: 2 numbers; three are wanted"]),
    Case("twenty constants", **instead(STIFFNESS % ISOTROPIC.rsplit(",", 1)[0]), at="stiffness",
         says=["20 numbers; a stiffness has 21", "rows of the upper triangle"]),
    Case("negative second minor", **instead(STIFFNESS % ISOTROPIC.replace("22e9", "0.1e9")),
         at="stiffness", says=["the leading minor of order 2 of the stiffness is not positive"]),
    Case("a plane that shears out of itself",
         **instead(STIFFNESS % ISOTROPIC.replace("14e9, 0", "14e9, 1e9")), at="stiffness",
         says=["C14 would shear the plane out of itself"]),
    Case("layers that yield", **instead(LAYERED + '\nj2.yield = "1 MPa"'), at="j2",
         says=["material.granite.j2: needs a material that is alike in all directions"]),
]

CASES = LAWS + EOS + TOGETHER + DIRECTIONS
