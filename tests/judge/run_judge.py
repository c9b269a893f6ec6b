#!/usr/bin/env python3
"""Meshes every model of models/paper and models/structures, judges each mesh, and prints the table of figures.

    run_judge.py [--update]

The judge shares no code with the mesher: it looks at the .msh file, and for names at the .json file. What each model
must reach stands in bounds.json, a little below what was reached when it was written; --update writes it anew.
"""
import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile

import meshjudge
import names

HERE = os.path.dirname(os.path.abspath(__file__))
MODELS = os.path.normpath(os.path.join(HERE, "..", "..", "models"))
QUADLINE = os.environ.get("QUADLINE", os.path.join(HERE, "..", "..", "build", "release", "quadline"))
BOUNDS = os.path.join(HERE, "bounds.json")

# Floors that hold on every model, whatever bounds.json says. The paper's mean betas are 0.65 to 0.74. Where the input's
# own angles allow less than the least Jacobian, the floor is what they allow.
LEAST_BETA = 0.75
LEAST_JACOBIAN = 0.2

# Figure: how far the bound stands from what was reached, below zero for a floor and above for a ceiling. The mean beta
# before smoothing is what the front makes; clean-up and smoothing mend so much that the others hardly show its loss.
MARGINS = {"beta before smoothing": -0.02, "beta": -0.02, "least SJ": -0.03, "irregular %": 0.6}


def mesh(model, folder, seconds=120):
    """Runs Quadline on a model: what came of it, the mesh file and the report file, which may not be there. Beside the
    mesh file stands the same mesh as .json, for its names."""
    name = os.path.splitext(os.path.basename(model))[0]
    out, same, report = (os.path.join(folder, name + ending) for ending in (".msh", ".json", "-report.json"))
    done = subprocess.run([QUADLINE, "mesh", model, "-o", out, "-o", same, "--report", report, "--quiet"],
                          capture_output=True, text=True, timeout=seconds)
    return done, out, report


def judge(model, out):
    """The judge's report on a mesh; what is wrong with its names counts as a problem of it."""
    report, judged = meshjudge.judge_file(model, out, None, True, True, True)
    if report["valid"]:
        report["problems"] += names.wrong_names(judged, os.path.splitext(out)[0] + ".json")
        report["valid"] = not report["problems"]
    return report


def what_is_wrong(judged):
    if not judged["valid"]:
        return "invalid: " + ", ".join(judged["problems"])
    quality = judged["quality"]
    if quality["beta_mean"] < LEAST_BETA:
        return "mean beta %.3f below %.2f" % (quality["beta_mean"], LEAST_BETA)
    least = min(LEAST_JACOBIAN, judged["sharp"]["sj_bound"])
    if quality["sj_min"] < least:
        return "scaled Jacobian %.3f below %.2f" % (quality["sj_min"], least)
    return None


def beyond_bounds(figures, bounds):
    """The first figure that is beyond its bound, in words; None where none is."""
    if bounds is None:
        return "bounds.json has no bounds for it: see --update"
    for name, margin in MARGINS.items():
        if (figures[name] - bounds[name]) * margin > 0:
            return "%s is %.4f, %s %.4f" % (name, figures[name], "below" if margin < 0 else "above", bounds[name])
    return None


def corners_differ(report, judged):
    """The report and the judge find the same bound on the least scaled Jacobian."""
    ours, sharp = report["corners"], judged["sharp"]
    pairs = [(ours["sj_bound"], sharp["sj_bound"])]
    if ours["sj_min_over_bound"] is not None and sharp["sj_min_over_bound"] is not None:
        pairs.append((ours["sj_min_over_bound"], sharp["sj_min_over_bound"]))
    if any(abs(a - b) > 1e-5 for a, b in pairs):
        return "bound on the scaled Jacobian, bound reached: report and judge differ: %s" % pairs
    return None


def row(model, folder):
    """A row of the table, the figures that have bounds, and what is wrong (None: nothing)."""
    done, out, report_file = mesh(model, folder)
    if done.returncode != 0:
        return None, None, "exit code %d: %s" % (done.returncode, done.stderr.strip())
    judged = judge(model, out)
    if not judged.get("quality"):
        return None, None, what_is_wrong(judged)
    with open(report_file, encoding="utf-8") as f:
        report = json.load(f)
    q = judged["quality"]
    figures = {"beta before smoothing": report["quality"]["before_smoothing"]["beta_mean"], "beta": q["beta_mean"],
               "least SJ": q["sj_min"], "irregular %": 100 * q["irregular"]}
    cells = ("%d" % judged["counts"]["quads"], "%.3f" % figures["beta before smoothing"],
             "%.3f" % figures["beta"], "%.3f" % figures["least SJ"], "%.3f" % q["sj_mean"],
             "%.0f to %.0f" % (q["angle_min"], q["angle_max"]), "%.1f" % figures["irregular %"],
             "%.2f" % report["seconds"])
    return cells, figures, what_is_wrong(judged) or corners_differ(report, judged)


def main():
    arguments = argparse.ArgumentParser(description="Meshes and judges the models that should come out well.")
    arguments.add_argument("--update", action="store_true", help="write bounds.json after what is reached now")
    update = arguments.parse_args().update
    with open(BOUNDS, encoding="utf-8") as f:
        bounds = json.load(f)
    failed, reached = 0, {}
    print("| model | quads | beta before smoothing | after | least SJ | mean SJ | angles | irregular % | seconds |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for kind in ("paper", "structures"):
            for model in sorted(glob.glob(os.path.join(MODELS, kind, "*.json"))):
                cells, figures, wrong = row(model, folder)
                name = os.path.splitext(os.path.basename(model))[0]
                reached[name] = figures
                if cells:
                    print("| %s |" % " | ".join((name, *cells)))
                if not wrong and not update:
                    wrong = beyond_bounds(figures, bounds.get(name))
                if wrong:
                    print("| %s | FAILED: %s |" % (name, wrong))
                    failed += 1
    if update and not failed:
        rows = ['"%s": %s' % (name, json.dumps({key: round(figures[key] + by, 4) for key, by in MARGINS.items()}))
                for name, figures in reached.items()]
        with open(BOUNDS, "w", encoding="utf-8") as f:
            f.write("{\n" + ",\n".join(rows) + "\n}\n")
    elif bounds.keys() - reached.keys():
        print("FAILED: bounds.json knows models that are gone: " + ", ".join(sorted(bounds.keys() - reached.keys())))
        failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
