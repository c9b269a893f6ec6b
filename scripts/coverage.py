#!/usr/bin/env python3
"""Prints which share of the lines the tests have reached, for each folder, and the files below a limit.

    coverage.py [BUILD]

BUILD (default: build/coverage) is a build of the coverage preset whose tests have run. The lines are gcov's, read by gcovr.
"""
import collections
import json
import os
import subprocess
import sys

from marked_page import made_by

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
LIMIT = 80  # percent


def lines_of_files(build):
    """For each source file: lines reached, and lines."""
    command = ["gcovr", "--root", ROOT, "--object-directory", build, "--json-summary"]
    for folder in ("src", "io", "cli", "include"):
        command += ["--filter", os.path.join(ROOT, folder) + "/"]
    try:
        done = subprocess.run(command + [build], stdout=subprocess.PIPE, text=True, check=True)
    except FileNotFoundError:
        sys.exit("coverage: gcovr is needed")
    except subprocess.CalledProcessError as error:
        sys.exit("coverage: gcovr ended with exit code %d" % error.returncode)
    return {f["filename"]: (f["line_covered"], f["line_total"]) for f in json.loads(done.stdout)["files"]
            if f["line_total"] > 0}


def percent(reached, lines):
    return "%.1f" % (100 * reached / lines)


def main():
    build = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "coverage"))
    files = lines_of_files(build)
    if not files:
        sys.exit("coverage: no counts in %s; build and test with the coverage preset first" % build)
    folders = collections.defaultdict(list)
    for name, counts in files.items():
        folders[os.path.dirname(name)].append(counts)
    rows = sorted(folders.items()) + [("all", list(files.values()))]

    print(made_by("make coverage", os.path.join(build, "quadline")))
    print("| folder | files | lines | reached % |\n|---|---|---|---|")
    for folder, counts in rows:
        reached, lines = map(sum, zip(*counts))
        print("| `%s` | %d | %d | %s |" % (folder, len(counts), lines, percent(reached, lines)))
    print("\nBelow %d %%:" % LIMIT)
    for name, (reached, lines) in sorted(files.items()):
        if 100 * reached < LIMIT * lines:
            print("- `%s`: %s %% of %d lines" % (name, percent(reached, lines), lines))


if __name__ == "__main__":
    main()
