#!/usr/bin/env python3
"""Checks the arrows of ARCHITECTURE.md: which folder may include which, and what the core keeps off."""
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
INCLUDE = re.compile(r'^\s*#include\s+(["<])([^">]+)[">]')
PUBLIC = "include/quadline"
BELOW_STAGES = {PUBLIC, "src/base", "src/geom", "src/search", "src/topo", "src/mesh", "src/domain", "src/quality"}
ALLOWED = {
    PUBLIC: {PUBLIC},
    "src/base": {PUBLIC},
    "src/geom": {PUBLIC, "src/base"},
    "src/search": {PUBLIC, "src/base", "src/geom"},
    "src/quality": {PUBLIC, "src/base", "src/geom", "src/search"},
    "src/topo": {PUBLIC, "src/base"},
    "src/mesh": {PUBLIC, "src/base", "src/geom", "src/search", "src/topo"},
    "src/domain": {PUBLIC, "src/base", "src/geom", "src/search"},
    "src/stages": BELOW_STAGES,
    "src/cells": BELOW_STAGES | {"src/stages"},
    "src/inspect": BELOW_STAGES | {"src/stages"},
    "src": BELOW_STAGES | {"src/stages", "src/cells", "src/inspect"},
    "io": {PUBLIC, "src/base", "src/geom", "src/search", "src/quality", "io"},
    "cli": {PUBLIC, "io", "cli"},
}
THIRD_PARTY = {"nlohmann", "CLI", "pugixml.hpp", "libdeflate.h"}
# The core prints nothing, opens nothing, draws no numbers from <random>, and compiles where these are missing.
NOT_IN_CORE = {"iostream", "fstream", "cstdio", "filesystem", "random", "format", "expected", "ranges", "thread", "mutex"}


def folder_of(path):
    parts = path.split("/")
    if path.startswith(PUBLIC + "/io/"):  # the public doors of io, which open files
        return "io"
    if path.startswith(PUBLIC):
        return PUBLIC
    if parts[0] == "src" and len(parts) > 2:
        return "/".join(parts[:3]) if parts[1] == "stages" else "/".join(parts[:2])
    return parts[0]


def resolve(name):
    for base in ("include", "src", ""):
        if os.path.exists(os.path.join(ROOT, base, name)):
            return os.path.join(base, name) if base else name
    return None


def check(path):
    here = folder_of(path)
    rule = "src/stages" if here.startswith("src/stages/") else here
    with open(os.path.join(ROOT, path), encoding="utf-8") as source:
        for number, line in enumerate(source, 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            name = match.group(2)
            if "../" in name:
                yield "%s:%d includes upwards: %s" % (path, number, name)
            if match.group(1) == "<":
                core = here not in ("io", "cli")
                if core and (name.split("/")[0] in THIRD_PARTY or name in NOT_IN_CORE):
                    yield "%s:%d: the core may not include <%s>" % (path, number, name)
                continue
            target = resolve(name)
            if target is None:
                yield "%s:%d: %s is not there" % (path, number, name)
                continue
            there = folder_of(target)
            allowed = ALLOWED[rule] | {here}
            if there in allowed or (there.startswith("src/stages/") and "src/stages" in ALLOWED[rule] and rule != "src/stages"):
                continue
            yield "%s:%d: %s may not include %s" % (path, number, here, there)


def sources():
    for folder in ("include", "src", "io", "cli"):
        for here, _, names in sorted(os.walk(os.path.join(ROOT, folder))):
            yield from (os.path.relpath(os.path.join(here, n), ROOT) for n in sorted(names) if n.endswith((".hpp", ".cpp")))


def main():
    files = list(sources())
    wrong = [w for f in files for w in check(f)]
    print("\n".join(wrong) or "%d files keep the layers" % len(files))
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
