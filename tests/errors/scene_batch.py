"""Sweeps that vary what is not there, or draw what has no sense. Nothing is written before they are refused."""

import scenes
from cases import Case

VARY = 'key    = "run.step_factor"\nvalues = [0.8, 0.4]'
DRAW = 'key = "material.granite.density"\ndistribution = "normal"\nmean = "2600 kg/m3"\nstd_deviation = "50 kg/m3"'
SAMPLING = "[batch.sampling]\nsamples = 3"
SWEEP = scenes.PLANE + f"""
[batch]
collect = ["peak(top.ux)"]
[[batch.vary]]
{VARY}
[[batch.uncertain]]
{DRAW}
{SAMPLING}
"""
COMMAND = ["batch", "scene.toml"]


def sweep(name, says, old, new, at="", **more):
    return Case(name, base=SWEEP, edit=[(old, new)], at=at, says=says, command=COMMAND, **more)


# These are rules between keys: `breccia check` says them too.
RULES = [
    Case("sweep of nothing", base=scenes.PLANE + "[batch]\n", at="[batch]",
         says=["batch: nothing is varied", "docs/batch.md"]),
    Case("sweep with an empty list", base=SWEEP, edit=[("[0.8, 0.4]", "[]")], at="values = []",
         says=["values: the list is empty"]),
    Case("sweep with a value twice", base=SWEEP, edit=[("[0.8, 0.4]", "[0.8, 0.8]")], at="values = ",
         says=["the value 0.8 stands there twice"]),
    Case("sweep that draws without a number of samples", base=SWEEP, edit=[(SAMPLING, "")], at="[[batch.uncertain]]",
         says=["how many samples are drawn is not said", "[batch.sampling]"]),
    Case("sweep with samples of nothing", base=SWEEP, edit=[(f"[[batch.uncertain]]\n{DRAW}\n", "")],
         at="[batch.sampling]", says=["nothing is drawn at random"]),
    Case("sweep of lists that do not match", base=SWEEP,
         edit=[(VARY, VARY + '\ntogether = "a"\n[[batch.vary]]\nkey = "run.seed"\nvalues = [1, 2, 3]\ntogether = "a"')],
         at="[1, 2, 3]", says=["has 3 values, 'run.step_factor' has 2; they go together"]),
    Case("sweep that collects what is no formula", base=SWEEP, edit=[('["peak(top.ux)"]', '["peak(top.ux"]')], at="collect",
         says=["batch.collect: a ')' is missing"]),
    Case("sweep with a key that does not exist", base=SWEEP, edit=[("samples = 3", "sample = 3")], at="sample = 3",
         says=["batch.sampling.sample: no such key. Did you mean 'samples'?"]),
    Case("sweep with a distribution that does not exist", base=SWEEP, edit=[('"normal"', '"gauss"')], at='"gauss"',
         says=['"gauss" is not known.', "choices: uniform, loguniform, normal, lognormal, weibull"]),
]

PLANS = [
    Case("sweep of a scene without [batch]", command=COMMAND,
         says=["scene.toml: the scene has no [batch]", "docs/batch.md"]),
    Case("sweep of nothing at all", command=["batch"], says=["SWEEP is required"]),
    Case("sweep file that is a scene as well", command=["batch", "other.toml"],
         files={"other.toml": '[batch]\nscene = "scene.toml"\n[run]\ndimension = 2\n'},
         says=["other.toml:3: run: batch.scene names another file"]),
    sweep("key varied that does not exist",
          ["run.step_facter: no such key. Did you mean 'step_factor'?", "variant 0000 ("],
          "run.step_factor", "run.step_facter", at="run.step_facter"),
    sweep("knob varied that does not exist", ["no knob 'step facter'. Did you mean 'step factor'?"],
          "run.step_factor", "step facter", at="step facter"),
    sweep("value of another unit", ['run.step_factor: "1 m" is a length'], "[0.8, 0.4]", '[0.8, "1 m"]', at="values"),
    sweep("value out of range", ["run.step_factor: 1.5 is out of range"], "[0.8, 0.4]", "[0.8, 1.5]", at="values"),
    sweep("section varied that is not there", ["'fracture.*.alpha' fits nothing in this scene"], "run.step_factor", "fracture.*.alpha", at="fracture.*"),
    sweep("key varied twice", ["batch: material.granite.density is varied twice"], "run.step_factor",
          "material.granite.density", at='key    = "material.granite.density"'),
    sweep("samples of another unit", ["material.granite.density: ", "is a length"], DRAW,
          DRAW.replace("kg/m3", "mm"), at="material.granite.density"),
    sweep("parameters of different units", ['std_deviation: "50 m" is a length, mean is a density'],
          'std_deviation = "50 kg/m3"', 'std_deviation = "50 m"', at="50 m"),
    sweep("parameter that is no quantity", ["mean: "], 'mean = "2600 kg/m3"', 'mean = "2600 kgg/m3"', at="kgg"),
    sweep("distribution without a parameter", ["mean is missing", "has mean and std_deviation"],
          'mean = "2600 kg/m3"\n', "", at="[[batch.uncertain]]"),
    sweep("distribution with a parameter of another", ["scale: does not belong to the normal distribution"],
          DRAW, DRAW + '\nscale = "1 kg/m3"', at="scale"),
    sweep("deviation of zero", ["std_deviation: 0 is not above 0"], 'std_deviation = "50 kg/m3"',
          'std_deviation = "0 kg/m3"', at="std_deviation"),
    sweep("bounds the wrong way round", ["upper_bound: is not above lower_bound"], DRAW,
          'key = "material.granite.density"\ndistribution = "uniform"\nlower_bound = 1100\nupper_bound = 900',
          at="upper_bound"),
    sweep("bounds that leave nothing", ["the bounds leave nothing of the distribution"], DRAW,
          DRAW + '\nupper_bound = "1 kg/m3"', at="upper_bound"),
    sweep("sample out of range", ["density: ", "out of range"], DRAW,
          'key = "material.granite.density"\ndistribution = "uniform"\nlower_bound = -20\nupper_bound = -10',
          at="material.granite.density"),
    sweep("too many variants", ["more than 100000 variants"], "samples = 3", "samples = 60000", at="[batch]"),
    Case("variant that is not there", base=SWEEP, command=[*COMMAND, "--variant", "6"],
         says=["--variant: there is no variant 6: the sweep has 6, counted from 0"]),
    Case("dry run of nothing", base=SWEEP, command=[*COMMAND, "--dry-run"], says=["--dry-run belongs to --slurm"]),
    Case("two things at once", base=SWEEP, command=[*COMMAND, "--slurm", "--collect"], says=["command line: "]),
]

CASES = RULES + PLANS
