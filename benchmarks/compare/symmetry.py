#!/usr/bin/env python3
"""Meshes each model as it is, mirrored, and turned by 90 and 30 degrees; prints how far the figures spread, and how symmetric
the meshes of symmetric models are.

    symmetry.py [QUADLINE]
"""
import glob
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy as np
from scipy.spatial import cKDTree

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tests", "judge"))
import meshjudge  # noqa: E402
from meshread import read_mesh  # noqa: E402

QUADLINE = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release", "quadline")
C, S = math.cos(math.radians(30)), math.sin(math.radians(30))
MOVES = {"as it is": ((1, 0), (0, 1)), "mirrored": ((-1, 0), (0, 1)), "turned by 90": ((0, -1), (1, 0)),
         "turned by 30": ((C, -S), (S, C))}
FIGURES = (("beta_mean", "%.3f"), ("sj_mean", "%.3f"), ("sj_min", "%.2f"), ("irregular", "%.4f"), ("quads", "%d"))
# Models that are their own mirror images: about the middle of the box, left to right (x) or top to bottom (y).
SYMMETRIC = (("annulus", "x"), ("annulus", "y"), ("deck-hatch", "x"), ("deck-hatch", "y"), ("perforated-8x8", "x"),
             ("web-frame", "x"), ("gusset", "x"))
NEAR = 0.1  # of the edges at a node


def moved(value, m):
    """A model, or a part of one, with all its points moved."""
    if isinstance(value, dict):
        return {key: moved(part, m) for key, part in value.items()}
    if isinstance(value, list):
        if len(value) == 2 and all(isinstance(x, (int, float)) for x in value):
            return [row[0] * value[0] + row[1] * value[1] for row in m]
        return [moved(part, m) for part in value]
    return value


def mesh(model, folder):
    file, out = os.path.join(folder, "model.json"), os.path.join(folder, "mesh.msh")
    with open(file, "w", encoding="utf-8") as stream:
        json.dump(model, stream)
    subprocess.run([QUADLINE, "mesh", file, "-o", out, "--quiet"], check=True)
    return file, out


def figures(model, folder):
    report = meshjudge.judge_file(*mesh(model, folder))
    assert report["valid"], report["problems"]
    return dict(report["quality"], quads=report["counts"]["quads"])


def share_of_twins(model, axis, folder):
    """Of the nodes, the share whose mirror image is a node too."""
    result = read_mesh(mesh(model, folder)[1])
    points, quads = np.asarray(result.points)[:, :2], np.asarray(result.quads)
    ends = np.concatenate([quads[:, [i, (i + 1) % 4]] for i in range(4)])
    length = np.hypot(*(points[ends[:, 0]] - points[ends[:, 1]]).T)
    shortest = np.full(len(points), np.inf)
    np.minimum.at(shortest, ends.ravel(), np.repeat(length, 2))
    images = points.copy()
    k = "xy".index(axis)
    images[:, k] = points[:, k].min() + points[:, k].max() - points[:, k]
    distance, _ = cKDTree(points).query(images)
    return float(np.mean(distance < NEAR * shortest))


def main():
    files = sorted(glob.glob(os.path.join(ROOT, "models", "paper", "*.json")) +
                   glob.glob(os.path.join(ROOT, "models", "structures", "*.json")))
    models = {}
    for file in files:
        with open(file, encoding="utf-8") as stream:
            models[os.path.splitext(os.path.basename(file))[0]] = json.load(stream)
    with tempfile.TemporaryDirectory() as folder:
        means = {name: {key: 0.0 for key, _ in FIGURES} for name in MOVES}
        widest = {key: (0.0, "") for key, _ in FIGURES}
        for name, model in models.items():
            rows = {move: figures(moved(model, m), folder) for move, m in MOVES.items()}
            for key, _ in FIGURES:
                values = [row[key] for row in rows.values()]
                widest[key] = max(widest[key], (max(values) - min(values), name))
                for move, row in rows.items():
                    means[move][key] += row[key] / len(models)
        print("| mean of %d models | beta | mean SJ | least SJ | irregular | quads |\n|---|---|---|---|---|---|" % len(models))
        for move, row in means.items():
            print("| %s | %s |" % (move, " | ".join(form % row[key] for key, form in FIGURES)))
        print("| widest spread on one model | %s |" %
              " | ".join("%s (%s)" % (form % widest[key][0], widest[key][1]) for key, form in FIGURES))
        print("\n| symmetric model | mirror image of nodes that are nodes |\n|---|---|")
        for name, axis in SYMMETRIC:
            print("| %s, in %s | %.0f %% |" % (name, axis, 100 * share_of_twins(models[name], axis, folder)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
