"""What a case is, and how one is run."""

import os
import pathlib
import subprocess
import tempfile
from dataclasses import dataclass, field
from typing import Callable

import scenes

TIME_LIMIT_SECONDS = 60


@dataclass
class Case:
    """One mistake. `edit` replaces texts of `base`; each must be there exactly once."""

    name: str
    says: list  # pieces of text, all of them on standard error
    edit: list = field(default_factory=list)  # [(old, new), ...]
    at: str = ""  # the message points to the line that has this text after the edit
    base: str = scenes.PLANE
    options: list = field(default_factory=list)  # after `breccia check scene.toml`
    command: list | None = None  # the whole command line instead
    files: dict = field(default_factory=dict)  # more files beside the scene: name to bytes or text
    prepare: Callable | None = None  # called with the folder when its files are there
    status: int = 2


def edited(case):
    text = case.base
    for old, new in case.edit:
        count = text.count(old)
        if count != 1:
            raise ValueError(f"{case.name}: '{old}' is {count} times in the scene, not once")
        text = text.replace(old, new)
    return text


def line_of(text, piece, name):
    lines = [i + 1 for i, line in enumerate(text.split("\n")) if piece in line]
    if len(lines) != 1:
        raise ValueError(f"{name}: '{piece}' is in lines {lines}, not in one")
    return lines[0]


def contents(folder):
    """Every file below the folder with its bytes; None for a folder or what cannot be read."""
    found = {}
    for path in sorted(folder.rglob("*")):
        readable = path.is_file() and os.access(path, os.R_OK)
        found[str(path.relative_to(folder))] = path.read_bytes() if readable else None
    return found


def put_files(folder, case, text):
    (folder / "scene.toml").write_text(text)
    for name, data in case.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
    if case.prepare:
        case.prepare(folder)


def faults(result, case, place):
    """What is not as it should be about the way the program ended."""
    if result.returncode != case.status:
        yield f"exit status {result.returncode}, not {case.status}"
    for piece in [place, *case.says]:
        if piece not in result.stderr:
            yield f"standard error lacks: {piece}"
    for word in ("internal error", "terminate called", "Traceback", "Segmentation"):
        if word in result.stderr:
            yield f"standard error has: {word}"
    if case.status == 2 and not result.stderr.startswith("error: "):
        yield "standard error does not begin with 'error: '"


def run(executable, case):
    """Runs one case in a folder of its own; a list of faults, empty when all is well."""
    text = edited(case)
    place = f"scene.toml:{line_of(text, case.at, case.name)}: " if case.at else ""
    with tempfile.TemporaryDirectory(prefix="breccia-error-") as name:
        folder = pathlib.Path(name)
        put_files(folder, case, text)
        before = contents(folder)
        command = [executable, *(case.command or ["check", "scene.toml", *case.options])]
        result = subprocess.run(command, cwd=folder, capture_output=True, text=True,
                                timeout=TIME_LIMIT_SECONDS, errors="replace")
        found = list(faults(result, case, place))
        if contents(folder) != before:
            found.append(f"files changed: {sorted(contents(folder))}, before {sorted(before)}")
        for path in folder.rglob("*"):
            os.chmod(path, 0o700)
    if found:
        found.append("it said:\n" + result.stderr)
    return found
