#!/usr/bin/env python3
"""Every source and header is named in the CMakeLists.txt of its floor, test area or benchmark folder."""

import re

import tree


def lists_above(root, path):
    """The CMakeLists.txt of the file's folder or of the nearest folder above it."""
    folder = path.parent
    while folder.parts:
        if (root / folder / "CMakeLists.txt").is_file():
            return folder
        folder = folder.parent
    return None


def check(root):
    for path in tree.files(root, ("kernels", "src", "tests", "perf"), (".cpp", ".hpp", ".cpp.in")):
        # The helpers of the tests are headers that every test sees; the two main programs belong to cmake/tests.cmake.
        in_tests = path.parts[0] in ("tests", "perf")
        if in_tests and (path.name.endswith(".hpp") or path.parts[1] == "harness"):
            continue
        folder = lists_above(root, path)
        if folder is None:
            yield f"{path}: no CMakeLists.txt in or above its folder"
            continue
        name = path.relative_to(folder)
        words = re.split(r"[\s()]+", tree.text(root, folder / "CMakeLists.txt"))
        if str(name) not in words:
            yield f"{path}: not named in {folder}/CMakeLists.txt"


if __name__ == "__main__":
    tree.main(check, __doc__)
