#!/usr/bin/env python3
"""Every model of models/hard ends within seconds: with a valid mesh, or with exit code 2 or 3 and one clear line."""
import glob
import os
import subprocess
import sys
import tempfile

from run_judge import MODELS, judge, mesh

SECONDS = 20


def run(model, folder):
    """Whether it ended as it should, and how it ended."""
    try:
        done, out, _ = mesh(model, folder, SECONDS)
    except subprocess.TimeoutExpired:
        return False, "still runs after %d s" % SECONDS
    if done.returncode != 0:
        clear = len(done.stderr.strip().splitlines()) == 1 and not os.path.exists(out)
        return done.returncode in (2, 3) and clear, "exit code %d: %s" % (done.returncode, done.stderr.strip()[:200])
    judged = judge(model, out)
    if not judged["valid"]:
        return False, "invalid: " + ", ".join(judged["problems"])
    q = judged["quality"]
    return True, "%d quads, beta %.3f, least SJ %.3f" % (judged["counts"]["quads"], q["beta_mean"], q["sj_min"])


def main():
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for model in sorted(glob.glob(os.path.join(MODELS, "hard", "*.json"))):
            good, how = run(model, folder)
            print("%-6s %-18s %s" % ("ok" if good else "FAILED", os.path.splitext(os.path.basename(model))[0], how))
            failed += not good
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
