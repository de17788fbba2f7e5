#!/usr/bin/env python3
"""Every relative link of every Markdown page leads to a file."""

import re
import urllib.parse

import tree

CODE = re.compile(r"^(```|~~~).*?^\1|`[^`\n]*`", re.S | re.M)
LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)|^\[[^\]]+\]:\s*(\S+)", re.M)


def check(root):
    for path in tree.files(root, suffixes=(".md",)):
        page = CODE.sub(tree.blank, tree.text(root, path))
        for match in LINK.finditer(page):
            link = match.group(1) or match.group(2)
            if re.match(r"[a-z]+:|#|//", link):
                continue
            target = urllib.parse.unquote(link.split("#")[0])
            if not (root / path.parent / target).exists():
                line = page.count("\n", 0, match.start()) + 1
                yield f"{path}:{line}: {link} does not exist"


if __name__ == "__main__":
    tree.main(check, __doc__)
