#!/usr/bin/env python3
"""Reads every #include and refuses those that look upwards or enter a third-party library by the wrong door."""

import re

import tree

KERNEL = {"base": set(), "point": {"base"}, "loops": {"base", "point"}}
BELOW_S3 = {"base", "core", "fields", "mesh"}
SOURCE = {
    "core": {"base"},
    "fields": {"base", "core"},
    "mesh": {"base", "core", "fields"},
    "comm": BELOW_S3 | {"loops"},  # rows are packed on the device
    "io": BELOW_S3,
    # Materials hold the parameters of laws; stress_view.hpp fills a view of a loop.
    "step": BELOW_S3 | {"point", "loops"},
}
MODULE = BELOW_S3 | {"step", "point", "loops"}
SCENE = MODULE | {"comm", "io", "modules"}
JOBS = SCENE | {"scene"}
MANY = JOBS | {"jobs"}  # rooms that run many scenes
ALLOWED = {**KERNEL, **SOURCE, "scene": SCENE, "jobs": JOBS, "study": MANY, "batch": MANY, "app": MANY | {"study", "batch"}}

# Who may include what from outside: pattern of the header, pattern of the files that may.
DOORS = [
    (r"mpi\.h$", r"src/core/world|src/comm/"),
    (r"(hdf5(_hl)?|H5\w*)\.h$", r"src/io/"),
    (r"metis\.h$", r"src/comm/"),
    (r"omp\.h$", r"src/mesh/gmsh_"),  # Gmsh changes the number of threads behind our back
    (r"gmsh(c)?\.h(_cwrap)?$", r"src/mesh/"),
    (r"toml(\.hpp|11?/|/)", r"src/io/"),
    (r"CLI/", r"src/app/"),
    (r"(unsupported/)?Eigen/", r"src/"),
    (r"(fmt|spdlog)/", r"src/"),
    (r"Kokkos_\w+\.hpp$", r"kernels/|src/"),
    (r"(unistd|fcntl|signal|spawn|termios|dirent|fenv|poll)\.h$|sys/\w+\.h$", r"src/"),
]
STANDARD = re.compile(r"[a-z_0-9]+$")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
# A law is a pure function at a point: these words belong to the loops above it.
NOT_IN_A_LAW = re.compile(r"\b(View\s*<|parallel_(for|reduce|scan)|throw\b|RangePolicy|TeamPolicy)")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)


def room(path):
    """(floor, module or None) of a file: src/modules/solid/x.hpp -> ("modules", "solid")."""
    parts = path.parts
    if parts[0] in ("kernels", "src") and len(parts) > 2:
        return parts[1], parts[2] if parts[1] == "modules" else None
    return None, None


def own_target(root, include, path):
    """(floor, module) that a quoted include reaches, None if there is no such file."""
    parts = include.split("/")
    for top in ("kernels", "src"):
        if (root / top / include).is_file() or (root / top / (include + ".in")).is_file():
            return parts[0], parts[1] if parts[0] == "modules" else None
    for top in ("tests", "perf"):
        if (root / top / include).is_file() or (root / path.parent / include).is_file():
            return top, None
    return None


def check_own(root, path, include):
    target = own_target(root, include, path)
    if path.parts[0] in ("tests", "perf"):
        if target is None:
            yield f'"{include}" is not a file under kernels/, src/ or {path.parts[0]}/'
        return
    floor, module = room(path)
    if target is None:
        yield f'"{include}" is not a file under kernels/ or src/ (includes start at these folders)'
    elif target[0] in ("tests", "perf"):
        yield f'"{include}": nothing includes {target[0]}/ (and includes start at kernels/ or src/)'
    elif floor == "modules":
        if target[0] == "modules" and target[1] != module:
            yield f'"{include}": modules never include each other; meet through a field'
        elif target[0] not in MODULE | {"modules"}:
            yield f'"{include}": a module must not see {target[0]}'
    elif target[0] != floor and target[0] not in ALLOWED.get(floor, set()):
        yield f'"{include}": {floor} must not see {target[0]}'


def check_foreign(path, include):
    if path.parts[0] in ("tests", "perf") or STANDARD.match(include):
        return
    if include.split("/")[0] in set(ALLOWED) | {"modules"}:
        yield f"<{include}>: our own headers are included with quotes"
        return
    for header, door in DOORS:
        if re.match(header, include):
            if not re.match(door, str(path)):
                yield f"<{include}>: its door is {door.replace('|', ' or ')}"
            return
    yield f"<{include}>: no door is known for this library (cmake/lint/floors.py)"


def check(root):
    for path in tree.files(root, ("kernels", "src", "tests", "perf"), tree.CPP):
        code = COMMENT.sub(tree.blank, tree.text(root, path))
        for match in INCLUDE.finditer(code):
            line = code.count("\n", 0, match.start(1)) + 1
            if match.group(1) == '"':
                complaints = check_own(root, path, match.group(2))
            else:
                complaints = check_foreign(path, match.group(2))
            for complaint in complaints:
                yield f"{path}:{line}: {complaint}"
        if path.parts[:2] == ("kernels", "point"):
            for match in NOT_IN_A_LAW.finditer(code):
                line = code.count("\n", 0, match.start()) + 1
                yield f"{path}:{line}: '{match.group(1)}' does not belong in a law"


if __name__ == "__main__":
    tree.main(check, __doc__)
