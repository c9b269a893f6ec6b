#!/usr/bin/env python3
"""Meshes the models of models/hard and prints a table: how each ended, and what was mended or found.

    hard_table.py [QUADLINE]

Writes it to the marked part of docs/robustness.md too.
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

from marked_page import made_by, write_between

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
PAGE = "docs/robustness.md"
BEGIN, END = "<!-- hard models: made by `make hard` -->\n", "<!-- end of the hard models -->\n"
SECONDS = 120


def found(findings):
    """The first two findings with their places, and how many more there are."""
    texts = ["%s at (%g, %g)" % (f["text"], *f["at"]) if f["at"] else f["text"] for f in findings]
    more = ["and %d more" % (len(texts) - 2)] if len(texts) > 2 else []
    return "; ".join(texts[:2] + more) or "–"


def row(quadline, model):
    name = os.path.splitext(os.path.basename(model))[0]
    with tempfile.TemporaryDirectory() as folder:
        out, report_file = os.path.join(folder, "mesh.msh"), os.path.join(folder, "report.json")
        try:
            done = subprocess.run([quadline, "mesh", model, "-o", out, "--report", report_file, "--quiet"],
                                  capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return [name, "none after %d s" % SECONDS, "–", "–", ""]
        if not os.path.exists(report_file):  # the input is refused
            return [name, str(done.returncode), "–", "–", done.stderr.strip()]
        with open(report_file, encoding="utf-8") as f:
            report = json.load(f)
    if done.returncode != 0:
        return [name, str(done.returncode), "–", "–", report["failure"]["reason"] + "; " + found(report["findings"])]
    after = report["quality"]["after_smoothing"]
    return [name, "0", str(after["quads"]), "%.3f" % after["scaled_jacobian"]["min"], found(report["findings"])]


def main():
    quadline = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release", "quadline"))
    rows = [row(quadline, model) for model in sorted(glob.glob(os.path.join(ROOT, "models", "hard", "*.json")))]
    lines = ["| model | exit code | quads | least scaled Jacobian | mended or found |", "|---|---|---|---|---|"]
    table = "\n".join(lines + ["| " + " | ".join(cells) + " |" for cells in rows]) + "\n"
    print(table, end="")
    write_between(PAGE, BEGIN, END, "\n" + made_by("make hard", quadline) + "\n" + table + "\n")


if __name__ == "__main__":
    main()
