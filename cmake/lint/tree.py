"""What the lints share: which files there are, and how a lint reports."""

import argparse
import os
import pathlib
import subprocess
import sys

CPP = (".hpp", ".cpp", ".hpp.in", ".cpp.in")
SKIPPED_FOLDERS = {".git", "build", "__pycache__"}


def files(root, folders=(), suffixes=()):
    """Files git knows or would take, as paths relative to root; a walk where there is no git."""
    command = ["git", "-C", str(root), "ls-files", "--cached", "--others", "--exclude-standard"]
    found = None
    if (root / ".git").exists():
        found = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")
    else:
        found = []
        for folder, inner, names in os.walk(root):
            inner[:] = [name for name in inner if name not in SKIPPED_FOLDERS]
            found += [os.path.relpath(os.path.join(folder, name), root) for name in names]
    for name in sorted(set(found)):
        path = pathlib.PurePosixPath(name)
        if not name or not (root / path).is_file():
            continue
        if folders and path.parts[0] not in folders:
            continue
        if suffixes and not name.endswith(tuple(suffixes)):
            continue
        yield path


def text(root, path):
    return (root / path).read_text(encoding="utf-8", errors="replace")


def blank(match):
    """Spaces instead of the match, so that line and column stay."""
    return "".join(character if character == "\n" else " " for character in match.group(0))


def main(check, description):
    """Runs check(root), which yields lines of complaint, and exits 1 if there were any."""
    parser = argparse.ArgumentParser(description=description)
    default = pathlib.Path(__file__).resolve().parents[2]
    parser.add_argument("--root", type=pathlib.Path, default=default)
    complaints = list(check(parser.parse_args().root.resolve()))
    for complaint in complaints:
        print(complaint)
    if complaints:
        print(f"{len(complaints)} complaint(s)")
    sys.exit(1 if complaints else 0)
