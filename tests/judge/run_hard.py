#!/usr/bin/env python3
"""Meshes every model of models/hard, judges each mesh, and holds how it ended against what stands in hard.json.

    run_hard.py [--update]

hard.json has for each model its exit code and what is told on standard error, line by line, and where there is a mesh
the least and most quads, the least mean beta and the least scaled Jacobian, with some room. --update writes it anew
after what is reached now. Whatever stands there, a model ends within seconds with a valid mesh, or with exit code 2 or
3 and one line.
"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

from run_judge import MODELS, judge, mesh

SECONDS = int(os.environ.get("HANG_SECONDS", "20"))  # the sanitizers take four to five times as long
EXPECTED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "hard.json")
ROOM = {"quads": 0.1, "beta": 0.03, "least SJ": 0.03}  # of the quads a share; the scaled Jacobian stays above 0


def told(model, errors):
    """The lines on standard error, without the file and the place."""
    prefix = re.compile(r"quadline: (%s: )?" % re.escape(model))
    return [re.sub(r" at \([^()]*\)$", "", prefix.sub("", line, count=1)) for line in errors.strip().splitlines()]


def run(model, folder):
    """How it ended: the exit code, what it told, its mesh's figures if there is one; and what is wrong in any case."""
    try:
        done, out, _ = mesh(model, folder, SECONDS)
    except subprocess.TimeoutExpired:
        return {}, "still runs after %d s" % SECONDS
    end = {"exit": done.returncode, "told": told(model, done.stderr)}
    if done.returncode != 0:
        clear = len(end["told"]) == 1 and not os.path.exists(out)
        return end, None if done.returncode in (2, 3) and clear else "no clear end"
    judged = judge(model, out)
    if not judged["valid"]:
        return end, "invalid: " + ", ".join(judged["problems"])
    q = judged["quality"]
    return {**end, "quads": judged["counts"]["quads"], "beta": q["beta_mean"], "least SJ": q["sj_min"]}, None


def expectation(end):
    """The row of hard.json after how a model ended."""
    if end["exit"] != 0:
        return end
    room = ROOM["quads"] * end["quads"]
    return {"exit": 0, "told": end["told"], "quads": [round(end["quads"] - room), round(end["quads"] + room)],
            "beta": round(end["beta"] - ROOM["beta"], 3),
            "least SJ": round(max(end["least SJ"] - ROOM["least SJ"], end["least SJ"] / 2), 6)}


def differs(end, expected):
    """The first thing that is not as expected, in words; None where nothing is."""
    if expected is None:
        return "hard.json does not know it: see --update"
    for what in ("exit", "told"):
        if end[what] != expected[what]:
            return "%s: expected %s, found %s" % (what, expected[what], end[what])
    if end["exit"] != 0:
        return None
    if not expected["quads"][0] <= end["quads"] <= expected["quads"][1]:
        return "%d quads, expected %d to %d" % (end["quads"], *expected["quads"])
    for what in ("beta", "least SJ"):
        if end[what] < expected[what]:
            return "%s is %.4f, below %.4f" % (what, end[what], expected[what])
    return None


def words(end):
    if end.get("exit") == 0 and "quads" in end:
        return "%d quads, beta %.3f, least SJ %.3f" % (end["quads"], end["beta"], end["least SJ"])
    return "exit code %s: %s" % (end.get("exit"), "; ".join(end.get("told", []))[:200])


def main():
    arguments = argparse.ArgumentParser(description="Meshes and judges the hard models.")
    arguments.add_argument("--update", action="store_true", help="write hard.json after how they end now")
    update = arguments.parse_args().update
    with open(EXPECTED, encoding="utf-8") as f:
        expected = json.load(f)
    failed, ends = 0, {}
    with tempfile.TemporaryDirectory() as folder:
        for model in sorted(glob.glob(os.path.join(MODELS, "hard", "*.json"))):
            name = os.path.splitext(os.path.basename(model))[0]
            ends[name], wrong = run(model, folder)
            if not wrong and not update:
                wrong = differs(ends[name], expected.get(name))
            print("%-6s %-18s %s" % ("FAILED" if wrong else "ok", name, wrong or words(ends[name])))
            failed += wrong is not None
    if update and not failed:
        rows = ['"%s": %s' % (name, json.dumps(expectation(end))) for name, end in ends.items()]
        with open(EXPECTED, "w", encoding="utf-8") as f:
            f.write("{\n" + ",\n".join(rows) + "\n}\n")
    elif expected.keys() - ends.keys():
        print("FAILED: hard.json knows models that are gone: " + ", ".join(sorted(expected.keys() - ends.keys())))
        failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
