#!/usr/bin/env python3
"""Meshes models/paper and models/structures with Quadline and with Gmsh's quad modes, judges all meshes alike, and writes the
marked part of docs/quality.md, with pictures.

    compare.py [--quadline FILE] [--no-docs]

Gmsh's rows are kept in build/compare, by model, version and mode, so that the next run meshes with Quadline alone.
"""
import argparse
import glob
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path[:0] = [os.path.join(ROOT, "tests", "judge"), os.path.join(ROOT, "scripts")]
import meshjudge  # noqa: E402
import table  # noqa: E402
from marked_page import made_by, write_between  # noqa: E402

KEPT = os.path.join(ROOT, "build", "compare")
DOC = "docs/quality.md"
PICTURES = ("fig16", "fig18", "fig19", "web-frame", "doubler-loop", "y-junctions")
BEGIN, END = "<!-- made by `make compare` -->\n", "<!-- end of what `make compare` makes -->\n"
# Mesh.Algorithm: 6 frontal, 8 frontal for quads, 9 packing of parallelograms, 11 quasi-structured.
# Mesh.RecombinationAlgorithm: 1 blossom, 2 simple for all quads, 3 blossom for all quads.
MODES = [(algorithm, recombination) for algorithm in (6, 8, 9, 11) for recombination in (1, 2, 3)]
LIMIT_S = 120


def judged(model, mesh, seconds):
    """The judge's figures in one row."""
    report = meshjudge.judge_file(model, mesh, None, False, True)
    row = {"model": os.path.splitext(os.path.basename(model))[0], "valid": report["valid"], "seconds": seconds}
    row.update(report["counts"])
    row.update(report.get("quality") or {})
    return row


def ours(quadline, model, mesh):
    start = time.perf_counter()
    subprocess.run([quadline, "mesh", model, "-o", mesh, "--quiet"], check=True, timeout=LIMIT_S)
    return judged(model, mesh, time.perf_counter() - start)


def gmsh_version():
    """The version of Gmsh's Python module; None where there is none."""
    done = subprocess.run([sys.executable, "-c", "import gmsh; print(gmsh.__version__)"], capture_output=True, text=True)
    return done.stdout.strip() if done.returncode == 0 else None


def gmsh_row(model, mesh, mode):
    script = os.path.join(ROOT, "benchmarks", "compare", "gmsh_mesh.py")
    try:
        done = subprocess.run([sys.executable, script, model, mesh, *map(str, mode)], capture_output=True, text=True,
                              timeout=LIMIT_S)
    except subprocess.TimeoutExpired:
        return {"valid": False, "error": "no end after %d s" % LIMIT_S}
    answer = json.loads(done.stdout) if done.stdout.startswith("{") else {"error": "crash: exit code %d" % done.returncode}
    if "error" in answer:
        return {"valid": False, "error": answer["error"]}
    try:
        return judged(model, mesh, answer["seconds"])
    except meshjudge.Unreadable as error:
        return {"valid": False, "error": str(error)}


def gmsh_rows(model, version):
    """The rows of all modes, from the last run where nothing has changed, and the mesh of the best beta."""
    with open(model, "rb") as file:
        key = hashlib.sha256(file.read()).hexdigest()[:16]
    name = os.path.splitext(os.path.basename(model))[0]
    rows = []
    for mode in MODES:
        stem = os.path.join(KEPT, "%s-%s-%s-%d-%d" % (name, key, version, *mode))
        if not os.path.exists(stem + ".json"):
            row = gmsh_row(model, stem + ".msh", mode)
            with open(stem + ".json", "w", encoding="utf-8") as file:
                json.dump(row, file)
        with open(stem + ".json", encoding="utf-8") as file:
            rows.append(dict(json.load(file), mode="%d/%d" % mode, mesh=stem + ".msh"))
    return rows


def draw(quadline, mesh, name):
    subprocess.run([quadline, "draw", mesh, "-o", os.path.join(ROOT, "docs", "images", name)], check=True)


def pictures(quadline, model, mesh, rows):
    """Both meshes beside each other; Gmsh's is that of the best mean beta."""
    name = os.path.splitext(os.path.basename(model))[0]
    draw(quadline, mesh, "compare-%s-quadline.svg" % name)
    fair = [row for row in rows if table.is_fair(row)] or [row for row in rows if row.get("valid")]
    if not fair:
        return "| ![%s, Quadline](images/compare-%s-quadline.svg) | no valid mesh |" % (name, name)
    best = max(fair, key=lambda row: row["beta_mean"])
    draw(quadline, best["mesh"], "compare-%s-gmsh.svg" % name)
    return ("| ![%s, Quadline](images/compare-%s-quadline.svg) | ![%s, Gmsh %s](images/compare-%s-gmsh.svg) |" %
            (name, name, name, best["mode"], name))


def main():
    parser = argparse.ArgumentParser(description="Compare Quadline with Gmsh.")
    parser.add_argument("--quadline", default=os.path.join(ROOT, "build", "release", "quadline"))
    parser.add_argument("--no-docs", action="store_true", help="print the table only")
    arguments = parser.parse_args()
    version = gmsh_version()
    if version is None:
        print("compare: Gmsh's Python module is missing (pip install gmsh): Quadline's figures alone", file=sys.stderr)
    os.makedirs(KEPT, exist_ok=True)
    rows, gmsh, shown = [], {}, []
    with tempfile.TemporaryDirectory() as folder:
        for model in sorted(glob.glob(os.path.join(ROOT, "models", "paper", "*.json"))) + sorted(
                glob.glob(os.path.join(ROOT, "models", "structures", "*.json"))):
            name = os.path.splitext(os.path.basename(model))[0]
            mesh = os.path.join(folder, name + ".msh")
            rows.append(ours(arguments.quadline, model, mesh))
            gmsh[name] = gmsh_rows(model, version) if version else []
            print("%s: done" % name, file=sys.stderr)
            if name in PICTURES and version and not arguments.no_docs:
                shown.append(pictures(arguments.quadline, model, mesh, gmsh[name]))
    text = table.table(rows, gmsh) + "\n\n" + (table.summary(rows, gmsh) + "\n" if version else "")
    print(text)
    if version and not arguments.no_docs:
        made = made_by("make compare", arguments.quadline) + "Gmsh %s.\n" % version
        write_between(DOC, BEGIN, END, made + "\n" + text + "\n| Quadline | Gmsh, the mode with the best beta |\n|---|---|\n" +
                      "\n".join(shown) + "\n")
    return 0 if all(row["valid"] for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
