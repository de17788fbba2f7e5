#!/usr/bin/env python3
"""clang-format 14 would change nothing. Exit status 77 (skipped) where that version is not installed."""

import re
import shutil
import subprocess
import sys

import tree

MAJOR = 14


def formatter():
    for name in (f"clang-format-{MAJOR}", "clang-format"):
        program = shutil.which(name)
        if program:
            said = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
            if re.search(rf"version {MAJOR}\.", said):
                return program
    return None


def check(root):
    program = formatter()
    if program is None:
        print(f"skipped: clang-format {MAJOR} is not installed (other versions format differently)")
        sys.exit(77)
    paths = [str(path) for path in tree.files(root, ("kernels", "src", "tests", "perf"), (".hpp", ".cpp"))]
    for start in range(0, len(paths), 50):
        command = [program, "--dry-run", "-Werror", "--style=file", *paths[start : start + 50]]
        said = subprocess.run(command, cwd=root, capture_output=True, text=True).stderr
        named = sorted(set(re.findall(r"^([^:\n]+):\d+:\d+: error", said, re.M)))
        if said and not named:
            yield said.strip()
        yield from (f"{name}: not formatted (clang-format -i {name})" for name in named)


if __name__ == "__main__":
    tree.main(check, __doc__)
