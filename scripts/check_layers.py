#!/usr/bin/env python3
"""Checks the arrows of ARCHITECTURE.md: which folder may include which, and what the core keeps off.

With the folder of the core's objects (build/.../CMakeFiles/quadline_core.dir) it looks at these as well: a symbol used must follow the arrows too
(a header may declare in one folder what another defines), and no folders may need each other in a circle.
domain/, domain/arrange and domain/size are one layer. No function of libm is called that is not exact: others differ
between machines, see docs/determinism.md.
"""
import collections
import os
import re
import subprocess
import sys

ROOT = os.environ.get("QUADLINE_ROOT") or os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
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
    "src/domain": {PUBLIC, "src/base", "src/geom", "src/search", "src/quality"},  # the edges of a flat mesh
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


# Of libm; the exact ones (sqrt, floor, ceil, trunc, round, lround, ldexp, frexp, fabs, fmin, fmax, copysign) are not here.
INEXACT = """sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 exp10 expm1 log log2 log10 log1p pow
fmod remainder hypot cbrt fma erf erfc tgamma lgamma sincos""".split()
CALL = re.compile(r"(?:\bstd::|(?<![\w:.>~]))(%s)[fl]?\s*\(" % "|".join(INEXACT))
SYMBOL = re.compile(r"^(?:__)?(%s)[fl]?(?:_finite)?(?:@.*)?$" % "|".join(INEXACT))
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)


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


def may_use(here, there):
    rule = "src/stages" if here.startswith("src/stages/") else here
    if there in ALLOWED[rule] | {here}:
        return True
    return there.startswith("src/stages/") and "src/stages" in ALLOWED[rule] and rule != "src/stages"


def check_includes(path, uses):
    """The wrong includes of a file; adds to `uses` which folder needs which, and where."""
    here = folder_of(path)
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
            uses[here].setdefault(there, "%s:%d includes %s" % (path, number, name))
            if not may_use(here, there):
                yield "%s:%d: %s may not include %s" % (path, number, here, there)


def check_calls(path):
    """The calls of inexact functions of libm in a file of the core."""
    if folder_of(path) in ("io", "cli"):
        return
    with open(os.path.join(ROOT, path), encoding="utf-8") as source:
        text = COMMENT.sub(lambda m: "\n" * m.group().count("\n"), source.read())
    for number, line in enumerate(text.split("\n"), 1):
        for match in CALL.finditer(line):
            yield "%s:%d calls %s, which differs between machines; see src/base/elementary.hpp" % (path, number, match.group(1))


def symbols(objects):
    """Of each source whose object lies in the folder: the symbols it defines, and those it uses."""
    for here, _, names in sorted(os.walk(objects)):
        for name in sorted(n for n in names if n.endswith(".cpp.o")):
            path = os.path.join(here, name)
            source = os.path.relpath(path, objects)[:-len(".o")]
            if not os.path.exists(os.path.join(ROOT, source)):  # left from an older tree
                continue
            out = subprocess.run(["nm", "-P", path], check=True, capture_output=True, text=True).stdout
            kinds = [line.split()[:2] for line in out.splitlines()]
            yield source, {s for s, kind in kinds if kind in "TDBR"}, {s for s, kind in kinds if kind == "U"}


def check_objects(folder, uses):
    """The wrong uses of symbols; adds to `uses` like check_includes."""
    objects = list(symbols(folder))
    if not objects:
        yield "%s: there are no objects" % folder
    owner = {symbol: source for source, defines, _ in objects for symbol in defines}
    for source, _, needs in objects:
        here = folder_of(source)
        for symbol in sorted(needs):
            match = SYMBOL.match(symbol)
            if match:
                yield "%s calls %s of libm, by its object" % (source, match.group(1))
            if symbol not in owner:
                continue
            there = folder_of(owner[symbol])
            uses[here].setdefault(there, "%s uses %s of %s" % (source, symbol, owner[symbol]))
            if not may_use(here, there):
                yield "%s uses %s of %s: %s may not use %s" % (source, symbol, owner[symbol], here, there)


def circles(uses):
    """The folders that need each other, one line for each circle found."""
    state, path = {}, []

    def visit(folder):
        state[folder] = "open"
        path.append(folder)
        for there in sorted(uses.get(folder, {})):
            if there == folder:
                continue
            if state.get(there) == "open":
                ring = path[path.index(there):] + [there]
                yield "a circle: " + "; ".join(uses[a][b] for a, b in zip(ring, ring[1:]))
            elif there not in state:
                yield from visit(there)
        path.pop()
        state[folder] = "done"

    for folder in sorted(uses):
        if folder not in state:
            yield from visit(folder)


def sources():
    for folder in ("include", "src", "io", "cli"):
        for here, _, names in sorted(os.walk(os.path.join(ROOT, folder))):
            yield from (os.path.relpath(os.path.join(here, n), ROOT) for n in sorted(names) if n.endswith((".hpp", ".cpp")))


def main():
    files, uses = list(sources()), collections.defaultdict(dict)
    wrong = [w for f in files for w in check_includes(f, uses)] + [w for f in files for w in check_calls(f)]
    for folder in sys.argv[1:]:
        wrong += check_objects(folder, uses)
    wrong += circles(uses)
    print("\n".join(wrong) or "%d files keep the layers" % len(files))
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
