#!/usr/bin/env python3
"""Meshes a model (model v1 JSON) with Gmsh, as a careful user would: shapes cut by all lines and points, sizes handed over.

    gmsh_mesh.py MODEL.json OUT.msh ALGORITHM RECOMBINATION

Prints one JSON line, {"seconds": ...} or {"error": ...}. A process of its own for each mesh: Gmsh may crash.
"""
import json
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "judge"))
import planemodel  # noqa: E402

FULL_TURN = 6.28
GROWTH = 0.3  # of the size, per length, away from what asks for a smaller one


class Shape:
    """The model in Gmsh's geometry kernel."""

    def __init__(self, gmsh, model):
        self.gmsh, self.occ, self.model = gmsh, gmsh.model.occ, model
        self.points = {}
        self.tolerance = 1e-6 * max(model.outers[0].bbox()[1] - model.outers[0].bbox()[0])

    def point(self, p):
        key = tuple(round(float(x) / self.tolerance) for x in p)
        if key not in self.points:
            self.points[key] = self.occ.addPoint(float(p[0]), float(p[1]), 0.0)
        return self.points[key]

    def curves(self, path):
        tags = []
        for piece in path.pieces:
            if abs(piece.sweep) > FULL_TURN:
                tags.append(self.occ.addCircle(float(piece.c[0]), float(piece.c[1]), 0.0, float(piece.r)))
                continue
            a, b = self.point(piece.p), self.point(piece.q)
            if piece.is_arc:
                middle = self.occ.addPoint(*map(float, piece.point(piece.length / 2)), 0.0)
                tags.append(self.occ.addCircleArc(a, middle, b, center=False))
                self.occ.remove([(0, middle)])
            elif a != b:
                tags.append(self.occ.addLine(a, b))
        return tags

    def build(self):
        """The curves of every line and the point of every point constraint."""
        occ, model = self.occ, self.model
        faces = [(2, occ.addPlaneSurface([occ.addCurveLoop(self.curves(path))])) for path in model.outers]
        holes = [(2, occ.addPlaneSurface([occ.addCurveLoop(self.curves(path))])) for path in model.holes]
        if len(faces) > 1:
            faces, _ = occ.fragment(faces[:1], faces[1:])
        if holes:
            faces, _ = occ.cut([f for f in faces if f[0] == 2], holes)
        tools, owners = [], []
        for i, line in enumerate(model.lines):
            for tag in self.curves(line.path):
                tools.append((1, tag))
                owners.append(("line", i))
        for i, point in enumerate(model.points):
            tools.append((0, occ.addPoint(float(point.at[0]), float(point.at[1]), 0.0)))
            owners.append(("point", i))
        parts = {owner: [] for owner in owners}
        if tools:
            _, became = occ.fragment(faces, tools)
            for owner, tags in zip(owners, became[len(faces):]):
                parts[owner] += tags
        occ.synchronize()
        left = self.drop_outside()
        return {owner: [tag for tag in tags if tag in left] for owner, tags in parts.items()}

    def drop_outside(self):
        """Takes away what no face has, such as parts of lines in a hole; returns what is left."""
        model, faces = self.gmsh.model, self.gmsh.model.getEntities(2)
        inside = {tag for face in faces for tag in model.mesh.getEmbedded(*face)}
        curves = {(1, tag) for _, tag in model.getBoundary(faces, combined=False, oriented=False)}
        curves |= {tag for tag in inside if tag[0] == 1}
        points = set(model.getBoundary(list(curves), combined=False, oriented=False)) | {tag for tag in inside if tag[0] == 0}
        for dimension, keep in ((1, curves), (0, points)):
            model.removeEntities([tag for tag in model.getEntities(dimension) if tag not in keep])
        return curves | points


def hand_over_sizes(gmsh, model, parts):
    """The model's size everywhere; what has a size of its own holds there and grows away from it."""
    option, field = gmsh.option.setNumber, gmsh.model.mesh.field
    option("Mesh.MeshSizeFromPoints", 0)
    option("Mesh.MeshSizeFromCurvature", 0)
    asked = [(parts[("line", i)], "CurvesList", e.size) for i, e in enumerate(model.lines) if e.size]
    asked += [(parts[("point", i)], "PointsList", e.size) for i, e in enumerate(model.points) if e.size]
    sizes = [model.size] + [size for _, _, size in asked]
    option("Mesh.MeshSizeMin", 0.2 * min(sizes) if asked else model.size)
    option("Mesh.MeshSizeMax", max(sizes))
    if not asked:
        return
    option("Mesh.MeshSizeExtendFromBoundary", 0)
    fields = [field.add("MathEval")]
    field.setString(fields[0], "F", repr(model.size))
    for tags, name, size in asked:
        away = field.add("Distance")
        field.setNumbers(away, name, [tag for _, tag in tags])
        if name == "CurvesList":
            field.setNumber(away, "Sampling", 200)
        fields.append(field.add("MathEval"))
        field.setString(fields[-1], "F", "%r + %r*F%d" % (size, GROWTH, away))
    least = field.add("Min")
    field.setNumbers(least, "FieldsList", fields)
    field.setAsBackgroundMesh(least)


def turn_clockwise_faces(gmsh):
    """Gmsh orients a face by one element of it, and now and then by a wrong one."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    place = {int(tag): coordinates[3 * i:3 * i + 2] for i, tag in enumerate(tags)}
    for _, face in gmsh.model.getEntities(2):
        area = 0.0
        for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2, face)):
            n = {2: 3, 3: 4}[int(kind)]
            for first in range(0, len(nodes), n):
                p = [place[int(v)] for v in nodes[first:first + n]]
                area += sum(p[i - 1][0] * p[i][1] - p[i][0] * p[i - 1][1] for i in range(n))
        if area < 0:
            gmsh.model.mesh.reverse([(2, face)])


def mesh(gmsh, model_file, out, algorithm, recombination):
    model = planemodel.load(model_file)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("General.AbortOnError", 0)  # as its command line: goes on, and the judge looks at what comes out
    gmsh.model.add("model")
    hand_over_sizes(gmsh, model, Shape(gmsh, model).build())
    gmsh.option.setNumber("Mesh.Algorithm", algorithm)
    gmsh.option.setNumber("Mesh.RecombineAll", 1)
    gmsh.option.setNumber("Mesh.RecombinationAlgorithm", recombination)
    start = time.perf_counter()
    gmsh.model.mesh.generate(2)
    seconds = time.perf_counter() - start
    turn_clockwise_faces(gmsh)
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    gmsh.write(out)
    return seconds


def main():
    model, out, algorithm, recombination = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    import gmsh
    gmsh.initialize()
    try:
        print(json.dumps({"seconds": round(mesh(gmsh, model, out, algorithm, recombination), 4)}))
    except Exception as error:  # Gmsh's errors are bare Exceptions
        print(json.dumps({"error": str(error) or type(error).__name__}))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
