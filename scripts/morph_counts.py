#!/usr/bin/env python3
"""Sums what Q-Morph does on models, out of the report's key "qmorph", as a table.

    morph_counts.py [--write] [QUADLINE [OPTION...]]

Meshes the models of models/paper with the options, by default `--method qmorph --triangles delaunay`, the paper's. --write
also puts the table into the marked part of docs/notes/2026-12-01-q-morph.md.
"""
import glob
import json
import os
import subprocess
import sys

from marked_page import made_by, write_between

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
PAGE = os.path.join(ROOT, "docs", "notes", "2026-12-01-q-morph.md")
BEGIN, END = "<!-- counts: made by scripts/morph_counts.py -->\n", "<!-- end of the counts -->\n"

# The parts of the key, and what the table says of them; {} is the name within the part.
PARTS = {
    "triangles": "triangles at the start",
    "steps": "quads of the normal step",
    "states": "with states {}",
    "side_edges": "side edge: {}",
    "top_edges": "top edge: {}",
    "seams": "seam",
    "transition_seams": "transition seam",
    "transition_splits": "transition split",
    "closures": "closure {}",
    "completion": "{} of completion",
    "refused": "step refused: {}",
}


def counts_of(quadline, model, options):
    done = subprocess.run([quadline, "mesh", model, "--json", *options], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("morph_counts: %s failed with exit code %d" % (model, done.returncode))
    rows = {}
    for part, counts in json.loads(done.stdout)["qmorph"].items():
        for name, n in counts.items() if isinstance(counts, dict) else [("", counts)]:
            rows[PARTS[part].format(name.replace("_", " "))] = n
    return rows


def main(arguments):
    write = arguments[:1] == ["--write"]
    rest = arguments[write:]
    quadline = rest[0] if rest else os.path.join(ROOT, "build", "release", "quadline")
    options = rest[1:] or ["--method", "qmorph", "--triangles", "delaunay"]
    models = sorted(glob.glob(os.path.join(ROOT, "models", "paper", "*.json")))
    columns = [counts_of(quadline, model, options) for model in models]
    names = [os.path.splitext(os.path.basename(model))[0] for model in models]
    table = "| operation | %s | all |\n|%s\n" % (" | ".join(names), "---|" * (len(names) + 2))
    for row in columns[0]:
        numbers = [column[row] for column in columns]
        table += "| %s | %s |\n" % (row, " | ".join(str(n) for n in [*numbers, sum(numbers)]))
    print(table, end="")
    if write:
        write_between(PAGE, BEGIN, END, made_by("scripts/morph_counts.py", quadline) + "\n" + table)


if __name__ == "__main__":
    main(sys.argv[1:])
