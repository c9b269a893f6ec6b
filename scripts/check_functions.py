#!/usr/bin/env python3
"""Checks that functions fit a screen: no more than 60 lines, but those named below with a reason."""
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
FOLDERS = ("include", "src", "io", "cli")
MOST_LINES = 60
# These take an operation in one piece: what it needs is found and judged before anything is changed.
ALLOWED = {("src/stages/qmorph/closure.cpp", "Morph::close_loop"), ("src/stages/qmorph/seam.cpp", "Morph::seam")}

NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#[^\n]*', re.S | re.M)
SCOPE = re.compile(r"\b(?:namespace|class|struct|union|enum)\b(?!.*\))|extern\s*$", re.S)
NAME = re.compile(r"([\w:~]+|operator\S+)\s*\(")


def functions(text):
    """Name, first line and number of lines of every function that stands in no other one."""
    text = NOISE.sub(lambda noise: "\n" * noise.group().count("\n") or " ", text)
    open_braces = []  # (header, offset of the header, whether it is a scope of declarations)
    start = 0
    for at, mark in ((match.start(), match.group()) for match in re.finditer("[{};]", text)):
        if mark == "{":
            header = text[start:at]
            open_braces.append((header, start, bool(SCOPE.search(header))))
        elif mark == "}" and open_braces:
            header, begin, is_scope = open_braces.pop()
            name = NAME.search(header)
            if name and not is_scope and all(outer for _, _, outer in open_braces):
                first = text.count("\n", 0, begin + len(header) - len(header.lstrip())) + 1
                yield name.group(1), first, text.count("\n", 0, at) + 2 - first
        start = at + 1


def main():
    n = 0
    too_long = []
    for folder in FOLDERS:
        for here, _, names in sorted(os.walk(os.path.join(ROOT, folder))):
            for path in sorted(os.path.join(here, name) for name in names if name.endswith((".hpp", ".cpp"))):
                with open(path, encoding="utf-8") as source:
                    text = source.read()
                short = os.path.relpath(path, ROOT)
                for name, first, lines in functions(text):
                    n += 1
                    if lines > MOST_LINES and (short, name) not in ALLOWED:
                        too_long.append("%s:%d: %s has %d lines, more than %d" % (short, first, name, lines, MOST_LINES))
    print("\n".join(too_long) if too_long else "%d functions fit a screen" % n)
    return 1 if too_long or not n else 0


if __name__ == "__main__":
    sys.exit(main())
