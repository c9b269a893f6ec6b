#!/usr/bin/env python3
"""Every model of models/hard ends within seconds with a valid mesh, or with exit code 2 or 3 and one clear line."""
import glob
import os
import subprocess
import sys
import tempfile

import meshjudge
from run_judge import MODELS, QUADLINE

SECONDS = 30


def run(model, folder):
    out = os.path.join(folder, os.path.basename(model) + ".msh")
    try:
        done = subprocess.run([QUADLINE, "mesh", model, "-o", out, "--quiet"], capture_output=True, text=True,
                              timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return False, "hangs"
    if done.returncode in (2, 3):
        lines = done.stderr.strip().splitlines()
        clear = len(lines) == 1 and not os.path.exists(out)
        return clear, "exit %d: %s" % (done.returncode, done.stderr.strip()[:200])
    if done.returncode != 0:
        return False, "exit %d: %s" % (done.returncode, done.stderr.strip()[:200])
    report = meshjudge.judge_file(model, out, None, True, True)
    if not report["valid"]:
        return False, "invalid: " + ", ".join(report["problems"])
    q = report["quality"]
    return True, "%d quads, beta %.3f, least SJ %.3f" % (report["counts"]["quads"], q["beta_mean"], q["sj_min"])


def main():
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for model in sorted(glob.glob(os.path.join(MODELS, "hard", "*.json"))):
            good, what = run(model, folder)
            print("%-6s %-18s %s" % ("ok" if good else "FAILED", os.path.splitext(os.path.basename(model))[0], what))
            failed += not good
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
