"""Whether a mesh keeps the names of its model: those of curves, points and regions, as the mesh JSON has them.

What should bear a name is found from the model and the judged mesh alone: the mesh edges that the judge found along the
pieces of each curve, the node at each point, and the quads that can be reached from the mark of a region without
crossing a curve.
"""
import json

import numpy as np

UNNAMED = "domain"      # the region of cells that no mark names
SAME_PLACE = 1e-12      # of the model's diagonal: what two files may differ by in writing a coordinate


def edges_of_curves(judge):
    """(name, kind) -> the mesh edges along that curve of the model, as pairs of nodes in order of number."""
    arr, match = judge.arr, judge.match
    along = {}                                          # edge of the arrangement -> its mesh edges
    for c, chain in enumerate(arr.chains):
        here = match.of_chain[c]
        middle = 0.5 * (match.sa[here] + match.sb[here])
        if chain.closed:
            middle = middle % chain.length
        for k, _, offset in chain.steps:
            on = (middle >= offset) & (middle < offset + arr.edges[k].piece.length)
            along[k] = {tuple(sorted(pair)) for pair in zip(match.a[here][on].tolist(), match.b[here][on].tolist())}
    model, curves = judge.model, {}
    named = [("outer", i, "outer-%d" % (i + 1)) for i in range(len(model.outers))]
    named += [("hole", i, "hole-%d" % (i + 1)) for i in range(len(model.holes))]
    named += [("line", i, line.name) for i, line in enumerate(model.lines)]
    for kind, i, name in named:
        edges = set().union(*(along[k] for k in arr.owned[kind, i]))
        if edges:                                       # else it lies outside the domain
            curves.setdefault((name, kind), set()).update(edges)
    return curves


def regions_of_quads(judge):
    """Quad as a set of nodes -> the names that it may bear: those of the marks in its cell. A mark on a curve may be in
    any of the cells there."""
    _, cell = judge.topo.components(judge.match.on_curve)
    corners = judge.xy[judge.quads]
    names = {}
    for region in judge.model.regions:
        side = np.roll(corners, -1, 1) - corners
        to_mark = region.at - corners
        inside = (side[..., 0] * to_mark[..., 1] - side[..., 1] * to_mark[..., 0] >= 0).all(1)
        cells = set(cell[:len(corners)][inside].tolist())
        for c in cells:
            names.setdefault(c, set() if len(cells) == 1 else {UNNAMED}).add(region.name)
    return {frozenset(quad): names.get(cell[i], {UNNAMED}) for i, quad in enumerate(judge.quads.tolist())}


def wrong_names(judge, mesh_file):
    """What is wrong with the names in a mesh JSON, which holds the mesh that was judged; empty where all are right."""
    with open(mesh_file, encoding="utf-8") as file:
        mesh = json.load(file)
    points = np.array(mesh["points"]) - judge.model.origin
    off, node = judge.tree.query(points)                # the judged mesh may number its nodes in another order
    if (len(points) != len(judge.xy) or off.max() > SAME_PLACE * judge.model.diag
            or len(set(node.tolist())) != len(node)):
        return ["the .json has other nodes than the mesh that was judged"]
    wrong = []
    expected = edges_of_curves(judge)
    found = {(c["name"], c["kind"]): {tuple(sorted(node[edge].tolist())) for edge in c["edges"]}
             for c in mesh["curves"] if c["edges"]}
    for name, kind in sorted(expected.keys() | found.keys()):
        ours, theirs = expected.get((name, kind), set()), found.get((name, kind), set())
        if ours != theirs:
            wrong.append("%s '%s' has %d edges, %d of them its own, in place of %d"
                         % (kind, name, len(theirs), len(ours & theirs), len(ours)))
    sets = {s["name"]: s["nodes"] for s in mesh["node_sets"]}
    for point in judge.model.points:
        nodes = sets.get(point.name, [])
        if judge.model.contains(point.at).all() and not (
                len(nodes) == 1 and np.hypot(*(points[nodes[0]] - point.at)) <= judge.tol):
            wrong.append("point '%s' has no node of its own" % point.name)
    allowed = regions_of_quads(judge)
    bearing = {mesh["regions"][region] for region in mesh["quad_region"]}
    wrong += ["no quad bears the name '%s'" % name
              for name in sorted(set().union(*allowed.values()) - bearing - {UNNAMED})]
    astray = sum(mesh["regions"][region] not in allowed.get(frozenset(node[quad].tolist()), ())
                 for quad, region in zip(mesh["quads"], mesh["quad_region"]))
    if astray or len(mesh["quads"]) != len(allowed):
        wrong.append("%d of %d quads bear the name of another region" % (astray, len(mesh["quads"])))
    return wrong
