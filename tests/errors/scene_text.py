"""Files that are no scenes, options that make no sense, command lines that cannot be read."""

import os

from cases import Case

DURATION = 'duration  = "10 us"'


def without_rights(folder):
    os.chmod(folder / "scene.toml", 0)


TEXT = [
    Case("quotes forgotten", edit=[(DURATION, "duration  = 10 us")], at="10 us",
         says=["this is not TOML", 'written in quotes: "3 mm"']),
    Case("quote not closed", edit=[(DURATION, 'duration  = "10 us')], at="10 us",
         says=["this is not TOML"]),
    Case("bracket not closed", edit=[("[run]", "[run")], at="[run", says=["this is not TOML"]),
    Case("key twice", edit=[(DURATION, DURATION + "\nduration = 3")], at="duration = 3",
         says=["this is not TOML", "already exists"]),
    Case("section twice", edit=[("[gravity]", "[run]\n#second\n[gravity]")],
         says=["this is not TOML"]),
    Case("date", edit=[(DURATION, "duration  = 2020-01-01")], at="2020",
         says=["dates and times have no meaning in a scene"]),
    Case("file that is no text", command=["check", "data.toml"], files={"data.toml": b"a\0b"},
         says=["data.toml: this is not a text file"]),
    Case("text that is not UTF-8", command=["check", "data.toml"],
         files={"data.toml": b'title = "\xff\xfe"\n'}, says=["data.toml:1: this is not TOML"]),
    Case("scene that is not there", command=["check", "nowhere.toml"],
         says=["nowhere.toml: no such scene", "a folder with a scene.toml"]),
    Case("scene without its ending", command=["check", "scene"],
         says=["no such scene. Did you mean 'scene.toml'?"]),
    Case("folder without a scene", command=["check", "empty"], files={"empty/x": ""},
         says=["empty: the folder holds no scene.toml"]),
]

OPTIONS = [
    Case("--set without a value", options=["--set", "run.duration"],
         says=["--set: 'run.duration' is not key=value", "for example: --set run.duration=2ms"]),
    Case("--set of nothing", options=["--set", "=3"], says=["is not key=value"]),
    Case("--set into a body that is not there", options=["--set", "body.blok.mesh.size=1"],
         says=["the list has no element 'blok'. Did you mean 'block'?",
               "elements: block, plate (or 0 to 1)"]),
    Case("--set into a value", options=["--set", "title.x=1"],
         says=['there is the text "a block on a plate" above it, not a section']),
    Case("--set to a wrong unit", options=["--set", "run.duration=3 m"],
         says=['--set: run.duration: "3 m" is a length; a time']),
    Case("--set with a broken path", options=["--set", "run..duration=1"],
         says=["'run..duration' is not a path of keys"]),
]

COMMAND_LINE = [
    Case("no verb", command=[""], says=["command line"]),
    Case("unknown verb", command=["rnu", "scene.toml"], says=["command line", "breccia --help"]),
    Case("no scene", command=["check"], says=["command line", "SCENE is required"]),
    Case("unknown option", command=["run", "scene.toml", "--fast"], says=["--fast"]),
    Case("no threads", command=["run", "scene.toml", "--threads", "0"], says=["--threads"]),
    Case("threads that are no number", command=["run", "scene.toml", "--threads", "two"],
         says=["--threads"]),
    Case("mesh without a file to write", command=["mesh", "scene.toml"],
         says=["--output is required"]),
    Case("overwrite and restart", command=["run", "scene.toml", "--overwrite", "--restart"],
         says=["--overwrite and --restart exclude each other"]),
    Case("help on nothing", command=["help", "densty"],
         says=["no key or section 'densty'. Did you mean 'density'?"]),
    Case("help on a misspelt key", command=["help", "run.duratoin"],
         says=["Did you mean 'run.duration'?"]),
    Case("wrong scene for run", command=["run", "scene.toml"],
         edit=[(DURATION, 'duration = "1 m"')], at="1 m\"", says=["is a length; a time"]),
    Case("wrong scene for mesh", command=["mesh", "scene.toml", "-o", "mesh.h5"],
         edit=[(DURATION, 'duration = "1 m"')], at="1 m\"", says=["is a length; a time"]),
]

UNREADABLE = [
    Case("scene without rights to read it", prepare=without_rights, says=["cannot be read"]),
]

# The administrator may read everything.
CASES = TEXT + OPTIONS + COMMAND_LINE + (UNREADABLE if os.geteuid() != 0 else [])
