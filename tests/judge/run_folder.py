#!/usr/bin/env python3
"""Meshes every model of a folder, two at a time, and judges each mesh; prints what went wrong and how many were valid.

    run_folder.py FOLDER
"""
import concurrent.futures
import glob
import os
import subprocess
import sys
import tempfile

from run_judge import judge, mesh

SECONDS = 120


def run(model):
    """What came of one model: "valid", "no mesh", or what the judge objects to."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            done, out, _ = mesh(model, folder, SECONDS)
        except subprocess.TimeoutExpired:
            return "no end after %d s" % SECONDS
        if done.returncode == 3:
            return "no mesh"
        if done.returncode != 0:
            return "exit code %d" % done.returncode
        judged = judge(model, out)
        return "valid" if judged["valid"] else "invalid: " + ", ".join(judged["problems"])


def main():
    models = sorted(glob.glob(os.path.join(sys.argv[1], "*.json")))
    counts = {}
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        for model, outcome in zip(models, pool.map(run, models)):
            counts[outcome.split(":")[0]] = counts.get(outcome.split(":")[0], 0) + 1
            if outcome != "valid":
                print("%s: %s" % (os.path.basename(model), outcome), flush=True)
    print("%d models: %s" % (len(models), ", ".join("%d %s" % (n, what) for what, n in sorted(counts.items()))))
    return 0 if set(counts) <= {"valid", "no mesh"} else 1


if __name__ == "__main__":
    sys.exit(main())
