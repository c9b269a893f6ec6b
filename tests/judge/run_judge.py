#!/usr/bin/env python3
"""Meshes every model of models/paper and models/structures and judges each mesh; prints the table of figures."""
import glob
import os
import subprocess
import sys
import tempfile
import time

import meshjudge

HERE = os.path.dirname(os.path.abspath(__file__))
MODELS = os.path.join(HERE, "..", "..", "models")
QUADLINE = os.environ.get("QUADLINE", os.path.join(HERE, "..", "..", "build", "release", "quadline"))

# Floors that the project holds on every model: the paper's betas are 0.65 to 0.74, and 0.75 is expected of each.
LEAST_BETA = 0.75
LEAST_JACOBIAN = 0.2


def run(model, folder):
    """The judge's report on the mesh of a model, the seconds it took, and what is wrong (or None)."""
    out = os.path.join(folder, os.path.basename(model) + ".msh")
    start = time.perf_counter()
    done = subprocess.run([QUADLINE, "mesh", model, "-o", out, "--quiet"], capture_output=True, text=True, timeout=120)
    seconds = time.perf_counter() - start
    if done.returncode != 0:
        return None, seconds, "exit code %d: %s" % (done.returncode, done.stderr.strip())
    report = meshjudge.judge_file(model, out, None, True, True)
    if not report["valid"]:
        return report, seconds, "invalid: " + ", ".join(report["problems"])
    quality, bound = report["quality"], report["sharp"]["sj_bound"]
    if quality["beta_mean"] < LEAST_BETA:
        return report, seconds, "mean beta %.3f below %.2f" % (quality["beta_mean"], LEAST_BETA)
    if quality["sj_min"] < min(LEAST_JACOBIAN, bound):
        return report, seconds, "scaled Jacobian %.3f below %.2f" % (quality["sj_min"], LEAST_JACOBIAN)
    return report, seconds, None


def main():
    failed = 0
    print("| model | quads | beta | least SJ | mean SJ | angles | irregular % | seconds |")
    print("|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for model in sorted(glob.glob(os.path.join(MODELS, "paper", "*.json"))) + \
                sorted(glob.glob(os.path.join(MODELS, "structures", "*.json"))):
            report, seconds, wrong = run(model, folder)
            name = os.path.splitext(os.path.basename(model))[0]
            if report and report.get("quality"):
                q = report["quality"]
                print("| %s | %d | %.4f | %.3f | %.4f | %.0f..%.0f | %.2f | %.2f |" % (
                    name, report["counts"]["quads"], q["beta_mean"], q["sj_min"], q["sj_mean"], q["angle_min"],
                    q["angle_max"], 100 * q["irregular"], seconds))
            if wrong:
                print("| %s | FAILED: %s |" % (name, wrong))
                failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
