#!/usr/bin/env python3
"""Breaks one line of the program at a time and sees whether the tests notice.

    mutants.py [--only PATTERN]... [--list]

The breakages stand in tests/mutants/*.json, a list for each area:

    {"name": "a wedge is a gap", "file": "src/domain/size/gaps.cpp", "old": "...", "new": "...",
     "tests": ["test_unit_domain_size Gaps.*", "tests/cli/test_command_line.py"]}

`old` must stand exactly once in the file. A test is a gtest program of the build, or a script that gets that build's
program by the variable QUADLINE; after a space, what of it to run: a gtest filter, or names for unittest. The tests must
pass on the sources as they are. All is done in a copy under build/mutants, built without optimisation.

For each breakage: "caught" where a test fails or hangs, "SURVIVED" where none does. Exit code 1 where one survived or
could not be tried, 2 where a list is wrong.
"""
import argparse
import fnmatch
import json
import os
import subprocess
import sys
import time

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
LISTS = os.path.join(ROOT, "tests", "mutants")
COPY = os.path.join(ROOT, "build", "mutants")
BUILD = os.path.join(COPY, "build", "debug")
KEYS = {"name", "file", "old", "new", "tests"}


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, content):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(content)


def read_lists():
    """All breakages and what is wrong with them."""
    mutants, errors = [], []
    for name in sorted(os.listdir(LISTS)):
        if not name.endswith(".json"):
            continue
        for m in json.loads(read(os.path.join(LISTS, name))):
            where = "%s: '%s'" % (name, m.get("name", "?"))
            path = os.path.join(ROOT, m.get("file", "?"))
            if set(m) != KEYS or not m["tests"]:
                errors.append("%s: needs name, file, old, new and tests" % where)
            elif m["name"] in {other["name"] for other in mutants}:
                errors.append("%s: stands there twice" % where)
            elif not os.path.isfile(path):
                errors.append("%s: there is no %s" % (where, m["file"]))
            elif read(path).count(m["old"].encode()) != 1 or m["old"] == m["new"]:
                errors.append("%s: `%s` stands %d times in %s" %
                              (where, m["old"], read(path).count(m["old"].encode()), m["file"]))
            else:
                mutants.append(m)
    return mutants, errors


def update_copy():
    """Makes the copy the same as what git knows or would take; what is the same keeps its time, for the build."""
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                           stdout=subprocess.PIPE, check=True).stdout.decode().split("\0")
    names = {name for name in names if os.path.isfile(os.path.join(ROOT, name))}
    for folder, folders, files in os.walk(COPY):
        if folder == COPY and "build" in folders:
            folders.remove("build")
        for file in files:
            path = os.path.join(folder, file)
            if os.path.relpath(path, COPY) not in names:
                os.remove(path)
    for name in names:
        source, target = os.path.join(ROOT, name), os.path.join(COPY, name)
        if not os.path.isfile(target) or read(target) != read(source):
            write(target, read(source))
            os.chmod(target, os.stat(source).st_mode)


def build(targets):
    """Whether the targets could be built; what was said."""
    command = ["cmake", "--build", BUILD, "--target"] + sorted(targets)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    return done.returncode == 0, done.stdout


def target_of(test):
    name = test.split(" ")[0]
    return "quadline" if name.endswith(".py") else name


def run(test, limit_s):
    """What of the test failed, empty where nothing did; and how long it took."""
    name, _, part = test.partition(" ")
    environment = dict(os.environ, QUADLINE=os.path.join(BUILD, "quadline"), PYTHONDONTWRITEBYTECODE="1")
    if name.endswith(".py"):
        command = [sys.executable, name] + part.split()
    else:
        command = [os.path.join(BUILD, "tests", name), "--gtest_brief=1"] + (["--gtest_filter=" + part] if part else [])
    begin = time.monotonic()
    try:
        done = subprocess.run(command, cwd=COPY, env=environment, timeout=limit_s, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace")
    except subprocess.TimeoutExpired:
        return "it hangs", limit_s
    elapsed_s = time.monotonic() - begin
    if not name.endswith(".py") and " 0 tests ran" in done.stdout.replace("from 0 test suites ", ""):
        return "no test of that name", elapsed_s
    if done.returncode == 0:
        return "", elapsed_s
    marks = ("[  FAILED  ] ", "FAIL: ", "ERROR: ")
    failed = [line.split(mark, 1)[1] for line in done.stdout.splitlines() for mark in marks if line.startswith(mark)]
    return (failed[0].split(" (")[0].split(",")[0] if failed else "exit code %d" % done.returncode), elapsed_s


def try_mutant(m, limits):
    """What becomes of the breakage: a word, and the reason."""
    path = os.path.join(COPY, m["file"])
    whole = read(path)
    write(path, whole.replace(m["old"].encode(), m["new"].encode()))
    try:
        built, said = build({target_of(test) for test in m["tests"]})
        if not built:
            return "NOT BUILT", said
        for test in m["tests"]:
            failed, _ = run(test, limits[test])
            if failed:
                return "caught", "%s: %s" % (test.split(" ")[0], failed)
        return "SURVIVED", ", ".join(m["tests"])
    finally:
        write(path, whole)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--only", action="append", metavar="PATTERN",
                        help="those whose name or file matches, such as '*gap*'; may be given again")
    parser.add_argument("--list", action="store_true", help="name them, and check that they still apply")
    arguments = parser.parse_args()

    mutants, errors = read_lists()
    if errors:
        print("\n".join(errors), file=sys.stderr)
        return 2
    if arguments.only:
        mutants = [m for m in mutants for pattern in arguments.only[:]
                   if fnmatch.fnmatch(m["name"], pattern) or fnmatch.fnmatch(m["file"], pattern)]
    if arguments.list:
        for m in mutants:
            print("%-45s %s" % (m["file"], m["name"]))
        print("%d breakages" % len(mutants))
        return 0

    update_copy()
    if not os.path.isfile(os.path.join(BUILD, "build.ninja")):
        # What is broken may leave something unused: warnings are no errors here.
        subprocess.run(["cmake", "--preset", "debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DQUADLINE_WERROR=OFF"], cwd=COPY,
                       stdout=subprocess.DEVNULL, check=True)
    tests = sorted({test for m in mutants for test in m["tests"]})
    built, said = build({target_of(test) for test in tests})
    if not built:
        print("the sources as they are do not build:\n" + said, file=sys.stderr)
        return 2
    limits = {}
    for test in tests:
        failed, elapsed_s = run(test, 600)
        if failed:
            print("fails on the sources as they are: %s: %s" % (test, failed), file=sys.stderr)
            return 2
        limits[test] = 30 + 10 * elapsed_s
    results = []
    for m in mutants:
        result, reason = try_mutant(m, limits)
        results.append(result)
        print("%-9s %s: %s (%s)" % (result, m["file"], m["name"], reason), flush=True)
    print("%d of %d caught" % (results.count("caught"), len(results)))
    return 0 if results.count("caught") == len(results) else 1


if __name__ == "__main__":
    os.nice(5)
    sys.exit(main())
