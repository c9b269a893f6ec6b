#!/usr/bin/env python3
"""Checks that every source named in comments and docs stands in the bibliography, and that links between docs hold."""
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
BIBLIOGRAPHY = "docs/bibliography.bib"
FOLDERS = ("include", "src", "io", "draw", "cli", "docs", "examples", "models", "tests", "benchmarks", "schema")
KEY = re.compile(r"\b[A-Z][A-Za-z]+(?:19|20)\d\d\b")
BRACKETS = re.compile(r"\[([^\][]*)\](?!\()")
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)")


def files(endings):
    for folder in FOLDERS:
        for here, _, names in sorted(os.walk(os.path.join(ROOT, folder))):
            yield from (os.path.relpath(os.path.join(here, n), ROOT) for n in sorted(names) if n.endswith(endings))
    yield from (name for name in sorted(os.listdir(ROOT)) if name.endswith(endings))


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as f:
        return f.read()


def missing_keys():
    known = set(re.findall(r"^@\w+\{(\w+),", read(BIBLIOGRAPHY), re.M))
    for path in files((".hpp", ".cpp", ".md")):
        for number, line in enumerate(read(path).splitlines(), 1):
            for inside in BRACKETS.findall(line):
                for key in KEY.findall(inside):
                    if key not in known:
                        yield "%s:%d: [%s] is not in %s" % (path, number, key, BIBLIOGRAPHY)


def broken_links():
    for path in files((".md",)):
        for number, line in enumerate(read(path).splitlines(), 1):
            for target in LINK.findall(line):
                if "://" in target or target.startswith("mailto:"):
                    continue
                if not os.path.exists(os.path.join(ROOT, os.path.dirname(path), target)):
                    yield "%s:%d: %s is not there" % (path, number, target)


def main():
    wrong = [*missing_keys(), *broken_links()]
    print("\n".join(wrong) or "all sources are in the bibliography, all links hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
