#!/usr/bin/env python3
"""A README.md with some text stands in each folder of sources, each test area and each example."""

import tree

SOURCES = tree.CPP + (".py",)


def check(root):
    needed = set()
    for path in tree.files(root, ("kernels", "src", "tests", "perf", "examples")):
        if path.parts[0] in ("kernels", "src") and path.name.endswith(SOURCES):
            needed.add(path.parent)
        elif path.parts[0] in ("tests", "perf") and len(path.parts) > 2 and path.name.endswith(SOURCES):
            needed.add(path.parents[-3])
        elif path.parts[0] == "examples" and path.name == "scene.toml":
            needed.add(path.parent)
    for folder in sorted(needed):
        readme = root / folder / "README.md"
        if not readme.is_file():
            yield f"{folder}: no README.md"
        elif len(readme.read_text(encoding="utf-8").split()) < 10:
            yield f"{folder}/README.md: says nothing (fewer than ten words)"


if __name__ == "__main__":
    tree.main(check, __doc__)
