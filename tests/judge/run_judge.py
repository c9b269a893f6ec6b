#!/usr/bin/env python3
"""Meshes every model of models/paper and models/structures, judges each mesh, and prints the table of figures.

The judge shares no code with the mesher; it looks at the .msh file alone.
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

import meshjudge

HERE = os.path.dirname(os.path.abspath(__file__))
MODELS = os.path.normpath(os.path.join(HERE, "..", "..", "models"))
QUADLINE = os.environ.get("QUADLINE", os.path.join(HERE, "..", "..", "build", "release", "quadline"))

# Floors that hold on every model. The paper's mean betas are 0.65 to 0.74. Where the input's own angles allow less than
# the least Jacobian, the floor is what they allow.
LEAST_BETA = 0.75
LEAST_JACOBIAN = 0.2


def mesh(model, folder, seconds=120):
    """Runs Quadline on a model: what came of it, the mesh file and the report file, which may not be there."""
    name = os.path.splitext(os.path.basename(model))[0]
    out, report = (os.path.join(folder, name + ending) for ending in (".msh", "-report.json"))
    done = subprocess.run([QUADLINE, "mesh", model, "-o", out, "--report", report, "--quiet"], capture_output=True,
                          text=True, timeout=seconds)
    return done, out, report


def judge(model, out):
    return meshjudge.judge_file(model, out, None, True, True)


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
    """A row of the table, and what is wrong (None: nothing)."""
    done, out, report_file = mesh(model, folder)
    if done.returncode != 0:
        return None, "exit code %d: %s" % (done.returncode, done.stderr.strip())
    judged = judge(model, out)
    if not judged.get("quality"):
        return None, what_is_wrong(judged)
    with open(report_file, encoding="utf-8") as f:
        report = json.load(f)
    q = judged["quality"]
    cells = ("%d" % judged["counts"]["quads"], "%.3f" % report["quality"]["before_smoothing"]["beta_mean"],
             "%.3f" % q["beta_mean"], "%.3f" % q["sj_min"], "%.3f" % q["sj_mean"],
             "%.0f to %.0f" % (q["angle_min"], q["angle_max"]), "%.1f" % (100 * q["irregular"]),
             "%.2f" % report["seconds"])
    return cells, what_is_wrong(judged) or corners_differ(report, judged)


def main():
    failed = 0
    print("| model | quads | beta before smoothing | after | least SJ | mean SJ | angles | irregular % | seconds |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for kind in ("paper", "structures"):
            for model in sorted(glob.glob(os.path.join(MODELS, kind, "*.json"))):
                cells, wrong = row(model, folder)
                name = os.path.splitext(os.path.basename(model))[0]
                if cells:
                    print("| %s |" % " | ".join((name, *cells)))
                if wrong:
                    print("| %s | FAILED: %s |" % (name, wrong))
                    failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
