#!/usr/bin/env python3
"""Each launch, fence, region and labelled allocation of kernels/ and src/ is named, and the name begins breccia::"""

import re

import tree

# Calls whose first argument is the label.
LABELLED = re.compile(
    r"\b(parallel_for|parallel_reduce|parallel_scan|fence|ScopedRegion(?:\s+\w+)?|pushRegion)\s*\(([^,;]*)"
)
# Inside a team the pattern is a nested loop, not a launch: no label is asked for.
NESTED = re.compile(r"\b(TeamThreadRange|ThreadVectorRange|TeamVectorRange|TeamThreadMDRange)\b")
ALLOCATION = re.compile(r"\bview_alloc\s*\(([^;]*?)\)\s*[,;)}]", re.S)
# A label made elsewhere is passed on under a name that says so: label, task.label, force_label(...).
NAMED = re.compile(r"[\w.:>-]*label\w*(\(.*)?$")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)


def good(argument):
    argument = argument.strip()
    literal = re.search(r'"([^"]*)"', argument)
    if literal:
        return literal.group(1).startswith("breccia::")
    return bool(NAMED.match(argument))


def check(root):
    for path in tree.files(root, ("kernels", "src"), tree.CPP):
        code = COMMENT.sub(tree.blank, tree.text(root, path))
        for match in LABELLED.finditer(code):
            call, argument = match.groups()
            if NESTED.search(argument) or good(argument):
                continue
            before = code[: match.start()].rstrip()
            # The declaration of a function of that name is not a call.
            if re.search(r"\b(void|auto|class|struct)$", before):
                continue
            line = before.count("\n") + 1
            shown = " ".join(argument.split())
            yield f'{path}:{line}: {call.split()[0]}({shown}...): the first argument must be "breccia::..."'
        for match in ALLOCATION.finditer(code):
            literal = re.search(r'"([^"]*)"', match.group(1))
            if literal and not literal.group(1).startswith("breccia::"):
                line = code.count("\n", 0, match.start()) + 1
                yield f'{path}:{line}: the allocation "{literal.group(1)}" must be named "breccia::..."'


if __name__ == "__main__":
    tree.main(check, __doc__)
