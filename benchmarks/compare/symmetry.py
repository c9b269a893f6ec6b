#!/usr/bin/env python3
"""Meshes every model of models/paper and models/structures as it is, mirrored and turned, judges the meshes, and writes the
marked part of docs/symmetry.md: how far the figures and the nodes move, and how symmetric the meshes of symmetric models are.

    symmetry.py [--quadline FILE] [--no-docs]
"""
import argparse
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
sys.path[:0] = [os.path.join(ROOT, "tests", "judge"), os.path.join(ROOT, "scripts")]
import meshjudge  # noqa: E402
from marked_page import made_by, write_between  # noqa: E402
import meshread  # noqa: E402
import planemodel  # noqa: E402

DOC = "docs/symmetry.md"
BEGIN, END = "<!-- made by symmetry.py -->\n", "<!-- end of what symmetry.py makes -->\n"
NEAR = 0.1  # of the mean edge length at a node: as near as this, two nodes are the same
LIMIT_S = 120
FIGURES = {"beta_mean": ("beta", 1, "%.3f"), "sj_mean": ("mean SJ", 1, "%.3f"), "sj_min": ("least SJ", 1, "%.2f"),
           "irregular": ("irregular %", 100, "%.1f")}
MIRROR_X, MIRROR_Y = np.diag([-1.0, 1.0]), np.diag([1.0, -1.0])


def turn(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    matrix = np.array([[c, -s], [s, c]])
    return matrix if degrees % 90 else matrix.round()


MOVES = {"mirrored": MIRROR_X, "turned 90": turn(90), "turned 30": turn(30)}
# Of a model about the middle of its box.
SYMMETRIES = {"mirror x": MIRROR_X, "mirror y": MIRROR_Y, "diagonal": np.array([[0.0, 1.0], [1.0, 0.0]]),
              "half turn": turn(180), "quarter turn": turn(90), "turn 30": turn(30)}
# The simplest case, which none of the models is.
PLATE = {"name": "plate-with-hole", "size": 25, "outer": [[0, 0], [600, 0], [600, 400], [0, 400]],
         "holes": [{"center": [300, 200], "radius": 80}]}


def moved(item, matrix):
    """A part of a model under a linear map: every pair of numbers in it is a place."""
    if isinstance(item, dict):
        return {key: moved(value, matrix) for key, value in item.items()}
    if isinstance(item, list):
        is_place = len(item) == 2 and all(isinstance(x, (int, float)) for x in item)
        return (matrix @ item).tolist() if is_place else [moved(x, matrix) for x in item]
    return item


def middle(model):
    """The middle of the box round the model."""
    return (model.lo + model.hi) / 2


def pieces(model):
    """Ends and middle of every piece of a curve, and every point; of a whole circle its centre, and a place a radius off."""
    rows = [np.concatenate([point.at] * 3) for point in model.points]
    for path in model.outers + model.holes + [line.path for line in model.lines]:
        for piece in path.pieces:
            is_circle = np.allclose(piece.p, piece.q)
            rows.append(np.concatenate([piece.c, piece.c, piece.c + piece.r] if is_circle else
                                       [piece.p, piece.q, piece.point(piece.length / 2)]))
    return np.array(rows)


def has(model, matrix):
    """Whether the map about the middle takes every piece of the model to one of its pieces."""
    here, centre = pieces(model), middle(model)
    image = ((here.reshape(-1, 3, 2) - centre) @ matrix.T + centre).reshape(-1, 6)
    is_circle = np.all(here[:, :2] == here[:, 2:4], axis=1) & np.any(here[:, :2] != here[:, 4:], axis=1)
    image[is_circle, 4:] = image[is_circle, :2] + here[is_circle, 4:] - here[is_circle, :2]
    tree = cKDTree(np.concatenate([here, here[:, [2, 3, 0, 1, 4, 5]]]))
    return bool(np.all(tree.query(image)[0] < 1e-6 * model.diag))


def share_in(points, edge, others):
    """Share of the points that have another mesh's node within NEAR of their own edge length."""
    return float(np.mean(cKDTree(others).query(points)[0] < NEAR * edge))


def mean_edges(mesh):
    """Mean edge length at every node."""
    quads = np.asarray(mesh.quads)
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    length = np.linalg.norm(mesh.points[a] - mesh.points[b], axis=1)
    ends = np.concatenate([a, b])
    return np.bincount(ends, np.tile(length, 2)) / np.bincount(ends)


def meshed(quadline, text, folder):
    """The mesh of a model, and the judge's figures of it."""
    model, out = os.path.join(folder, "model.json"), os.path.join(folder, "mesh.msh")
    with open(model, "w", encoding="utf-8") as file:
        json.dump(text, file)
    subprocess.run([quadline, "mesh", model, "-o", out, "--quiet"], check=True, timeout=LIMIT_S)
    report = meshjudge.judge_file(model, out, None, True)
    if not report["valid"]:
        raise SystemExit("symmetry: the mesh of %s is not valid" % text["name"])
    return meshread.read_mesh(out), report["quality"]


def study(quadline, text, folder):
    """Figures as it is and moved, the share of nodes that stay, and the share that each symmetry of the model keeps."""
    mesh, figures = meshed(quadline, text, folder)
    model = planemodel.load(os.path.join(folder, "model.json"))
    points, edge = mesh.points[:, :2], mean_edges(mesh)
    row = {"model": text["name"], "figures": [figures], "stay": {}, "kept": {}}
    for name, matrix in MOVES.items():
        other, judged = meshed(quadline, moved(text, matrix), folder)
        row["figures"].append(judged)
        row["stay"][name] = share_in(points @ matrix.T, edge, other.points[:, :2])
    centre = middle(model)
    for name, matrix in SYMMETRIES.items():
        if has(model, matrix):
            row["kept"][name] = share_in((points - centre) @ matrix.T + centre, edge, points)
    return row


def spread_table(rows):
    heads = ["model"] + [head for head, _, _ in FIGURES.values()] + ["nodes that stay, %s" % name for name in MOVES]
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for row in rows:
        cells = [row["model"]]
        for key, (_, scale, form) in FIGURES.items():
            values = [scale * figures[key] for figures in row["figures"]]
            cells.append(form % min(values) + ".." + form % max(values))
        cells += ["%.0f %%" % (100 * share) for share in row["stay"].values()]
        lines.append("| " + " | ".join(cells) + " |")
    means = []
    for key, (_, scale, form) in FIGURES.items():
        spread = [scale * (max(values) - min(values)) for values in ([f[key] for f in row["figures"]] for row in rows)]
        means.append("%s (%s)" % (form % np.mean(spread), form % max(spread)))
    means += ["%.0f %%" % (100 * np.mean([row["stay"][name] for row in rows])) for name in MOVES]
    return "\n".join(lines + ["| **mean spread (greatest)** | " + " | ".join(means) + " |"])


def symmetry_table(rows):
    lines = ["| model | symmetry | nodes whose image is a node |", "|---|---|---|"]
    lines += ["| %s | %s | %.0f %% |" % (row["model"], name, 100 * share) for row in rows for name, share in row["kept"].items()]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description="Measure what mirroring and turning a model changes.")
    parser.add_argument("--quadline", default=os.path.join(ROOT, "build", "release", "quadline"))
    parser.add_argument("--no-docs", action="store_true", help="print the tables only")
    arguments = parser.parse_args()
    texts = []
    for folder in ("paper", "structures"):
        for file in sorted(glob.glob(os.path.join(ROOT, "models", folder, "*.json"))):
            with open(file, encoding="utf-8") as stream:
                texts.append(json.load(stream))
    with tempfile.TemporaryDirectory() as folder:
        rows = [study(arguments.quadline, text, folder) for text in texts]
        plate = study(arguments.quadline, PLATE, folder)
    text = "\n" + spread_table(rows) + "\n\n" + symmetry_table([plate] + rows) + "\n\n"
    print(text)
    if not arguments.no_docs:
        write_between(DOC, BEGIN, END, "\n" + made_by("make compare", arguments.quadline) + text)


if __name__ == "__main__":
    main()
