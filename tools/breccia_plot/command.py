"""The command line of tools/plot."""
import argparse
import pathlib
import sys

from . import sheets, study, style
from .run_folder import RunFolder
from .trouble import Trouble


def arguments(words):
    parser = argparse.ArgumentParser(
        prog="plot",
        description="Draws a run: frames with cracks, histories, the energy ledger and a summary, as PNG. Of a folder of "
        "`breccia study`: error against seconds and element-steps, as study.png.",
        epilog="Ends with status 2 and a message where there is nothing to draw.",
    )
    parser.add_argument("folder", metavar="RUN_FOLDER", help="folder that `breccia run` or `breccia study` wrote")
    parser.add_argument("--frame", default="last", metavar="N|last|all", help="frames to draw (default: last)")
    parser.add_argument(
        "--field", metavar="NAME",
        help="what colours the mesh: an array of the frame, its component (velocity.x), von_mises, sigma_1, "
        "sigma_3 or pressure (default: von_mises, else the speed, else whatever there is)",
    )
    parser.add_argument(
        "--without", type=int, nargs="+", default=[], metavar="N",
        help="bodies to leave out, by their number in the array `body`",
    )
    parser.add_argument(
        "--forces", action="store_true",
        help="also draw the contacts as lines between fragments, as wide as their forces (forces_NNNNNN.png)",
    )
    parser.add_argument("-o", "--output", metavar="DIR", help="folder of the pictures (default: RUN_FOLDER/pictures)")
    return parser.parse_args(words)


def draw(options):
    path = pathlib.Path(options.folder)
    found = study.read(path)
    if found is not None:
        study.draw(found, (pathlib.Path(options.output) if options.output else path) / "study.png")
        return
    run = RunFolder(options.folder, options.without)
    output = pathlib.Path(options.output) if options.output else run.path / "pictures"
    if len(next(iter(run.history.values()), [])) > 1 and "time" in run.history:
        sheets.draw_histories(run, output / "histories.png")
        sheets.draw_ledger(run, output / "ledger.png")
    sheets.draw_catalogue(run, output / "catalogue.png")
    numbers = run.chosen(options.frame)
    limits = sheets.common_limits(run, numbers, options.field) if len(numbers) > 1 else None
    for number in numbers:
        sheets.draw_frame(run, number, options.field, output / f"frame_{number:06d}.png", limits)
        if options.forces:
            sheets.draw_forces(run, number, output / f"forces_{number:06d}.png")
    sheets.draw_summary(run, numbers[-1], options.field, output / "summary.png")


def main(words):
    options = arguments(words)
    style.set_up()
    try:
        draw(options)
    except (Trouble, OSError) as trouble:
        print(f"plot: {trouble}", file=sys.stderr)
        return 2
    return 0
