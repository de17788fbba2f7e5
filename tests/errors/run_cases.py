#!/usr/bin/env python3
"""Runs a table of wrong inputs through the executable: run_cases.py EXECUTABLE TABLE [PART OF A NAME]"""

import importlib
import os
import sys

import cases
import scenes


def right_scenes():
    """The scenes that are spoilt must be right before, or the cases prove nothing."""
    for name, text in scenes.ALL.items():
        yield cases.Case(name=f"right scene {name}", says=[], base=text, status=0)


def main(executable, table, part=""):
    executable = os.path.abspath(executable)
    wrong = [case for case in importlib.import_module(table).CASES if part in case.name]
    names = [case.name for case in wrong]
    if len(set(names)) != len(names):
        sys.exit("two cases have the same name")
    if not wrong:
        sys.exit(f"no case of {table} has '{part}' in its name")
    bad = 0
    for case in [*right_scenes(), *wrong]:
        found = cases.run(executable, case)
        bad += bool(found)
        print("ok  " if not found else "BAD ", case.name, flush=True)
        for fault in found:
            print("      " + fault.replace("\n", "\n      "))
    print(f"{len(wrong)} cases, {bad} bad")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
