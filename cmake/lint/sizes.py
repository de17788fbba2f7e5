#!/usr/bin/env python3
"""Files of kernels/ and src/ have at most 400 lines, their functions 60, their lines 100 columns."""

import re

import tree

FILE_LINES = 400
FUNCTION_LINES = 60
COLUMNS = 100

NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>[^(\s]*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*",
    re.S | re.M,
)
TEMPLATE = re.compile(r"^\s*template\s*<")
CONSTRUCTOR_LIST = re.compile(r"\)[^()]*?(?<!:):(?!:)")


def without_template(header):
    """The declaration behind its template<...> prefixes."""
    match = TEMPLATE.match(header)
    while match:
        depth, position = 1, match.end()
        while depth and position < len(header):
            depth += {"<": 1, ">": -1}.get(header[position], 0)
            position += 1
        header = header[position:]
        match = TEMPLATE.match(header)
    return header


def kind(header):
    """What the brace behind this text opens: scope (namespace, type), value (initialiser) or function."""
    header = without_template(header).strip()
    header = re.sub(r"\[\[.*?\]\]|alignas\s*\(.*?\)", " ", header).strip()
    if not header or re.match(r"(inline\s+)?(namespace|extern)\b", header):
        return "scope"
    if header.endswith(("=", ",", "(", "return")):
        return "value"
    if re.match(r"(typedef\s+)?(class|struct|union|enum)\b", header):
        return "scope"
    if "(" not in header:
        return "value"
    if CONSTRUCTOR_LIST.search(header) and not header.endswith((")", "}")):
        return "value"
    return "function"


def functions(code):
    """(first line, last line, name) of each function outside any other function."""
    code = NOISE.sub(tree.blank, code)
    stack, header, start, parens, line = [], "", None, 0, 1
    for character in code:
        if character == "\n":
            line += 1
        inside = any(entry[0] == "function" for entry in stack)
        if character == "{":
            opened = "inner" if inside else ("value" if parens else kind(header))
            stack.append((opened, start or line, header))
            if opened in ("scope", "function"):
                header, start = "", None
            continue
        if character == "}" and stack:
            opened, first, text = stack.pop()
            if opened == "function":
                name = re.findall(r"([\w:~]+|operator\S+)\s*\(", text)
                yield first, line, name[0] if name else "?"
            if opened in ("value",):
                header += "}"
            elif opened != "inner":
                header, start = "", None
            continue
        if inside:
            continue
        parens += {"(": 1, ")": -1}.get(character, 0)
        if character == ";" and parens == 0:
            header, start = "", None
            continue
        if start is None and not character.isspace():
            start = line
        header += character
        if header.strip() in ("public:", "private:", "protected:"):
            header, start = "", None


def check(root):
    for path in tree.files(root, ("kernels", "src"), tree.CPP):
        code = tree.text(root, path)
        lines = code.splitlines()
        if len(lines) > FILE_LINES:
            yield f"{path}: {len(lines)} lines, at most {FILE_LINES}"
        for number, line in enumerate(lines, 1):
            if len(line) > COLUMNS:
                yield f"{path}:{number}: {len(line)} columns, at most {COLUMNS}"
        for first, last, name in functions(code):
            if last - first + 1 > FUNCTION_LINES:
                yield f"{path}:{first}: {name} has {last - first + 1} lines, at most {FUNCTION_LINES}"


if __name__ == "__main__":
    tree.main(check, __doc__)
