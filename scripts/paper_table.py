#!/usr/bin/env python3
"""Meshes the models of models/paper and sets their figures beside Table 3 of Lee, Kim, Cho and Kim (2003).

    paper_table.py [QUADLINE]

Prints the table, and writes it, with the pictures, to docs/paper-table.md, docs/images/ and the marked part of README.md.
The figures beside the paper's are those of Q-Morph; those of the default, and pictures of its meshes, come last.
"""
import json
import os
import subprocess
import sys
import tempfile

from marked_page import made_by, write_between

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
BEGIN, END = "<!-- paper table: made by `make paper` -->\n", "<!-- end of the paper table -->\n"

# Mean beta of the paper's meshes, before and after its smoothing (Table 3); none for Fig. 20.
PAPER = {"fig16": (0.534, 0.654), "fig17": (0.563, 0.736), "fig18": (0.523, 0.721), "fig19": (0.417, 0.65), "fig20": None}
WHAT = {
    "fig16": "two holes, a line",
    "fig17": "two holes, no line",
    "fig18": "a hole, six lines",
    "fig19": "bulkhead, 20 lines",
    "fig20": "bulkhead, 80 lines",
}
COLUMNS = ("model", "paper: beta before smoothing", "after", "Q-Morph: beta before", "after", "quads", "least SJ", "mean SJ",
           "irregular nodes", "by default: beta", "quads", "least SJ", "mean SJ", "irregular nodes")


def mesh(quadline, name, method, picture):
    """The report of the run."""
    model = os.path.join(ROOT, "models", "paper", name + ".json")
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        done = subprocess.run([quadline, "mesh", model, "--method", method, "-o", picture, "--report", report, "--quiet"])
        if done.returncode != 0:
            sys.exit("paper_table: %s failed with exit code %d" % (name, done.returncode))
        with open(report, encoding="utf-8") as f:
            return json.load(f)


def reports(quadline, name, picture):
    """By Q-Morph and by default; the picture is of the latter."""
    return [mesh(quadline, name, method, picture) for method in ("qmorph", "layout")]


def figures(quality):
    return ["**%.3f**" % quality["beta_mean"], str(quality["quads"]), "%.2f" % quality["scaled_jacobian"]["min"],
            "%.3f" % quality["scaled_jacobian"]["mean"],
            "%d (%.1f %%)" % (quality["irregular_nodes"], 100 * quality["irregular_nodes"] / quality["nodes"])]


def row(name, runs):
    qmorph, default = (run["quality"] for run in runs)
    paper = ["%.3f" % beta for beta in PAPER[name]] if PAPER[name] else ["–", "–"]
    return ["Fig. %s: %s" % (name[3:], WHAT[name]), *paper, "%.3f" % qmorph["before_smoothing"]["beta_mean"],
            *figures(qmorph["after_smoothing"]), *figures(default["after_smoothing"])]


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def markdown(rows):
    return line(COLUMNS) + "|" + "---|" * len(COLUMNS) + "\n" + "".join(map(line, rows))


def pictures(folder):
    width = {"fig16": 32, "fig17": 32, "fig18": 32, "fig19": 48, "fig20": 48}
    rows = ['<img src="%s/%s.svg" width="%d%%" alt="Fig. %s: %s">' % (folder, name, width[name], name[3:], what)
            for name, what in WHAT.items()]
    return "\n" + "\n".join(rows) + "\n"


def main():
    quadline = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release", "quadline"))
    images = os.path.join(ROOT, "docs", "images")
    os.makedirs(images, exist_ok=True)
    runs = {name: reports(quadline, name, os.path.join(images, name + ".svg")) for name in PAPER}
    table = markdown([row(name, runs[name]) for name in PAPER])
    print(table, end="")
    for n, method in enumerate(("Q-Morph", "default")):
        print("\nseconds, %s: " % method + ", ".join("%s %.2f" % (name, both[n]["seconds"]) for name, both in runs.items()))

    made = made_by("make paper", quadline)
    page = """# The paper's Table 3, and ours

""" + made + """
Beta is the distortion coefficient of [Lee2003], equations (1) and (2), its mean the
geometric one; SJ is the scaled Jacobian. "Before smoothing" is the mesh as Q-Morph leaves it. The figures beside the
paper's are those of its method, `--method qmorph`; the last columns and the pictures are of the default, which makes
[grids](grids.md) where they suit. The paper does not publish the coordinates of its models: these are made after its
descriptions, so the figures compare meshers on similar models, not on the same. Table 3 has no figures of Fig. 20;
those of Fig. 19 are its goal.

""" + table + pictures("images")
    with open(os.path.join(ROOT, "docs", "paper-table.md"), "w", encoding="utf-8") as f:
        f.write(page)
    write_between("README.md", BEGIN, END, "\n" + made + "\n" + table + pictures("docs/images") + "\n")


if __name__ == "__main__":
    main()
