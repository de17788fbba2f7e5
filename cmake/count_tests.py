#!/usr/bin/env python3
"""Prints 'N passed, N failed' (and skipped ones) from a JUnit file of ctest; fails if a test failed or none ran."""

import sys
import xml.etree.ElementTree as xml


def count(path):
    passed, failed, skipped = [], [], []
    for case in xml.parse(path).getroot().iter("testcase"):
        status = case.get("status")
        # A skipped test has a <skipped> element and the status notrun; one whose program is missing is a failure.
        skip = case.find("skipped")
        if status == "run":
            passed.append(case.get("name"))
        elif status == "disabled" or (
            status == "notrun" and skip is not None and "SKIP" in skip.get("message", "").upper()
        ):
            skipped.append(case.get("name"))
        else:
            failed.append(case.get("name"))
    return passed, failed, skipped


def main():
    passed, failed, skipped = count(sys.argv[1])
    for name in failed:
        print(f"failed: {name}")
    tail = f", {len(skipped)} skipped" if skipped else ""
    print(f"{len(passed)} passed, {len(failed)} failed{tail}")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
