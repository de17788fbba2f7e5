"""Studies that can teach nothing, or that speak of what is not there."""

import scenes
from cases import Case

KNOB = 'key    = "run.step_factor"\nvalues = [0.8, 0.4]'
CHECK = 'check = "drift"\nscale = "1 um"'
STUDY = scenes.PLANE + f"""
[study]
[[study.knob]]
{KNOB}
[[study.quantity]]
{CHECK}
"""
COMMAND = ["study", "scene.toml"]


def study(name, says, old, new, at="", **more):
    return Case(name, base=STUDY, edit=[(old, new)], at=at, says=says, command=COMMAND, **more)


def quantity(name, says, new, at="", **more):
    return study(name, says, CHECK, new, at, **more)


# These are rules between keys: `breccia check` says them too.
RULES = [
    Case("study without a knob", base=STUDY, edit=[(f"[[study.knob]]\n{KNOB}\n", "")],
         at="[study]", says=["study: a study needs a [[study.knob]]"]),
    Case("study without a quantity", base=STUDY, edit=[(f"[[study.quantity]]\n{CHECK}\n", "")],
         at="[study]", says=["study: a study needs a [[study.quantity]]"]),
    Case("study with an empty ladder", base=STUDY, edit=[("[0.8, 0.4]", "[]")], at="values = []",
         says=["values: the ladder is empty", "give at least two values"]),
    Case("study with a ladder of one rung", base=STUDY, edit=[("[0.8, 0.4]", "[0.8]")],
         at="values = [0.8]", says=["values: a ladder of one rung"]),
    Case("study with fewer sizes than rungs", base=STUDY, edit=[(KNOB, KNOB + "\nsizes = [1]")],
         at="sizes = [1]", says=["there are not as many sizes as values"]),
    Case("study with a rung twice", base=STUDY, edit=[("[0.8, 0.4]", "[0.8, 0.8]")],
         at="values = ", says=["the value 0.8 stands there twice"]),
    Case("study of a check that is not there", base=STUDY, edit=[('check = "drift"', 'check = "drfit"')],
         at="drfit", says=["no [[check]] 'drfit' in this scene. Did you mean 'drift'?"]),
    Case("study of a value without a reference", base=STUDY,
         edit=[('check = "drift"', 'value = "peak(top.ux)"')], at='value = "peak(top.ux)"',
         says=["value: has no reference to be held against", '"finest"']),
    Case("study with a curve and no table", base=STUDY, edit=[('check = "drift"', 'curve = "top.ux"')],
         at='curve = "top.ux"', says=["a curve and a table go together"]),
    Case("study with parameters of nothing", base=STUDY,
         edit=[(CHECK, CHECK + "\nparameters = { velocity = 1 }")], at="parameters",
         says=["belong to a solution"]),
    Case("study with parameters that are no quantities", base=STUDY,
         edit=[(CHECK, CHECK + "\nparameters = { velocity = [1] }")], at="parameters",
         says=["velocity expects a number or a quantity"]),
    Case("study with two references", base=STUDY,
         edit=[(CHECK, CHECK + '\nreference = 1\nsolution = "bar.stress"')],
         says=["reference and solution exclude each other"]),
]

PLANS = [
    Case("study of a scene without [study]", command=COMMAND,
         says=["scene.toml: the scene has no [study]", "docs/study.md"]),
    Case("study of nothing", command=["study"], says=["SCENE is required"]),
    study("knob that does not exist", ["no knob 'step facter'. Did you mean 'step factor'?", "knobs: mesh size"],
          "run.step_factor", "step facter", at="step facter"),
    study("knob of a key that does not exist", ["run.step_facter: no such key. Did you mean 'step_factor'?",
                                                "the job 'step_facter 0.8' is no right scene"],
          "run.step_factor", "run.step_facter"),
    study("knob of an effect that is not there", ["'contact stiffness' fits nothing in this scene"],
          "run.step_factor", "contact stiffness", at="contact stiffness"),
    study("rung out of range", ["the job 'step_factor 1.5'", "1.5 is out of range"],
          "[0.8, 0.4]", "[0.8, 1.5]"),
    quantity("reference that has no value", ["reference: the reference cannot be evaluated", "not finite"],
             CHECK + '\nreference = "1 / 0"', at="1 / 0"),
    quantity("reference of zero", ["the reference is 0", "add scale"], 'check = "drift"', at='check = "drift"'),
    quantity("solution that is not known", ["no solution 'bar.stres'. Did you mean 'bar.stress'?"],
             'value = "peak(top.sxx)"\nsolution = "bar.stres"', at="bar.stres"),
    quantity("solution without a parameter", ["bar.stress needs the parameter 'velocity'",
                                              "parameters of bar.stress: velocity [m/s]"],
             'value = "peak(top.sxx)"\nsolution = "bar.stress"', at="bar.stress"),
    quantity("solution with a parameter of another unit", ["is a length; a velocity"],
             'value = "peak(top.sxx)"\nsolution = "bar.stress"\nparameters = { velocity = "1 m" }'),
    quantity("table that is not there", ["the table cannot be read"], 'curve = "top.ux"\ntable = "right.csv"'),
    quantity("table of one column", ["the table has not two columns"], 'curve = "top.ux"\ntable = "right.csv"',
             at="right.csv", files={"right.csv": "1\n2\n"}),
    quantity("table whose first column falls", ["its first column does not grow at 1"],
             'curve = "top.ux"\ntable = "right.csv"', at="right.csv", files={"right.csv": "2,0\n1,0\n"}),
    Case("study file that is a scene as well", command=["study", "other.toml"],
         files={"other.toml": '[study]\nscene = "scene.toml"\n[run]\ndimension = 2\n'},
         says=["other.toml:3: run: study.scene names another file"]),
]

CASES = RULES + PLANS
