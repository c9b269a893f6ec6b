#!/usr/bin/env python3
"""Checks the docs against the tree: sources named in brackets stand in the bibliography, links and their anchors hold,
files named in backticks are there, lines keep the width, and tables that programs make say by which version."""
import fnmatch
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
BIBLIOGRAPHY = "docs/bibliography.bib"
NOTES = "docs/notes/"  # dated records: the files that they name need not be there any more
FOLDERS = ("include", "src", "io", "cli", "docs", "examples", "models", "tests", "benchmarks", "schema", "scripts")
COLUMNS = 130  # lines are shorter, but for rows of tables
KEY = re.compile(r"\b[A-Z][A-Za-z]+(?:19|20)\d\d\b")
BRACKETS = re.compile(r"\[([^\][]*)\](?!\()")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)|<img src=\"([^\"]*)\"")
CODE = re.compile(r"`([^`\s][^`]*)`")
# `src/cells/fallback.hpp`, `src/domain/size/`, `tests/unit/*_test.cpp`; `geom/curve.hpp`; `curve.cpp`.
PATH = re.compile(r"(?:%s)/[\w./*-]*" % "|".join(FOLDERS))
SOURCE = re.compile(r"[\w./-]+\.(?:cpp|hpp|py)")
PAGE = re.compile(r"\bdocs/[\w/-]+\.md\b")
BASES = ("", "src", "include")


def all_files():
    for folder in FOLDERS:
        for here, _, names in sorted(os.walk(os.path.join(ROOT, folder))):
            yield from (os.path.relpath(os.path.join(here, name), ROOT) for name in sorted(names))
    yield from (name for name in sorted(os.listdir(ROOT)) if os.path.isfile(os.path.join(ROOT, name)))


FILES = list(all_files())
NAMES = {os.path.basename(path) for path in FILES}


def files(endings):
    return (path for path in FILES if path.endswith(endings))


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as f:
        return f.read()


def lines(path):
    return enumerate(read(path).splitlines(), 1)


def missing_keys():
    known = set(re.findall(r"^@\w+\{(\w+),", read(BIBLIOGRAPHY), re.M))
    for path in files((".hpp", ".cpp", ".md")):
        for number, line in lines(path):
            for inside in BRACKETS.findall(line):
                for key in KEY.findall(inside):
                    if key not in known:
                        yield "%s:%d: [%s] is not in %s" % (path, number, key, BIBLIOGRAPHY)


def anchors(path):
    """What links may name after '#': the headings, in lower case, without marks and with dashes for blanks."""
    for heading in re.findall(r"^#+ (.*)$", read(path), re.M):
        yield re.sub(r"[^\w\- ]", "", re.sub(r"\]\([^)]*\)", "", heading).lower()).strip().replace(" ", "-")


def broken_links():
    for path in files((".md",)):
        for number, line in lines(path):
            for target, anchor, image in LINK.findall(line):
                if "://" in target or target.startswith("mailto:"):
                    continue
                there = os.path.normpath(os.path.join(os.path.dirname(path), target or image)) if target or image else path
                if not os.path.exists(os.path.join(ROOT, there)):
                    yield "%s:%d: %s is not there" % (path, number, target or image)
                elif anchor and anchor not in anchors(there):
                    yield "%s:%d: %s has no heading #%s" % (path, number, there, anchor)


def is_there(name):
    if PATH.fullmatch(name):
        if os.path.exists(os.path.join(ROOT, name)):
            return True
        return any(fnmatch.fnmatch(path, name) for path in FILES)
    if SOURCE.fullmatch(name):
        return name in NAMES or any(os.path.exists(os.path.join(ROOT, base, name)) for base in BASES)
    return True


def missing_files():
    for path in files((".md",)):
        if path.startswith(NOTES):
            continue
        for number, line in lines(path):
            for name in CODE.findall(line):
                if not is_there(name.split()[0]):
                    yield "%s:%d: `%s` is not there" % (path, number, name)


def missing_pages():
    """Pages that comments and messages of the code name."""
    for path in files((".hpp", ".cpp", ".py", "Makefile")):
        for number, line in lines(path):
            for name in PAGE.findall(line):
                if not os.path.exists(os.path.join(ROOT, name)):
                    yield "%s:%d: %s is not there" % (path, number, name)


def wide_lines():
    for path in files((".md",)):
        for number, line in lines(path):
            if len(line) >= COLUMNS and not line.startswith("|"):
                yield "%s:%d: %d columns, not below %d" % (path, number, len(line), COLUMNS)


def tables_without_version():
    for path in files((".md",)):
        for part in re.findall(r"<!-- .*made by .*-->\s*(.*)", read(path)):
            if not re.match(r"Made by `[^`]+` with Quadline [\d.]+, \d{4}-\d\d-\d\d\.$", part):
                yield "%s: '%s' does not say with which version it was made" % (path, part[:40])


def main():
    wrong = [*missing_keys(), *broken_links(), *missing_files(), *missing_pages(), *wide_lines(),
             *tables_without_version()]
    print("\n".join(wrong) or "sources, links, files, widths and tables of the docs hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
