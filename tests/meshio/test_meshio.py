"""meshio reads what Quadline writes, groups included; Quadline reads what meshio writes.

The mesh as Quadline holds it is its .json file; the other formats are compared with it.
"""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import meshio
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
QUADLINE = pathlib.Path(os.environ.get("QUADLINE", ROOT / "build" / "release" / "quadline")).resolve()

# A plate with a hole; a line through it, a line that runs along it and goes on, a line along the edge, two regions.
MODEL = {
    "name": "groups", "about": "names of every kind, lines that share edges", "units": "mm", "size": 12.0,
    "outer": [[0, 0], [160, 0], [160, 100], [0, 100]],
    "holes": [{"center": [120, 70], "radius": 12}],
    "lines": [{"name": "stringer 1", "path": [[0, 40], [160, 40]]},
              {"name": "doubler", "path": [[60, 40], [160, 40]]},
              {"name": "edge-bar", "path": [[160, 0], [160, 100]]}],
    "points": [{"name": "lug", "at": [50, 70]}, {"name": "corner", "at": [0, 0]}],
    "regions": [{"name": "lower plate", "at": [20, 20]}, {"name": "upper plate", "at": [20, 80]}],
}


def edges_of(pairs):
    """A set of edges, whatever their direction."""
    return {tuple(sorted(map(int, pair))) for pair in pairs}


def quads_of(quads):
    """A set of quads, whatever the node they start with."""
    return {tuple(np.roll(quad, -int(np.argmin(quad)))) for quad in np.asarray(quads, int)}


def in_inp(name):
    return name.replace(" ", "_")


class Meshio(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="quadline-")
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        (cls.path / "model.json").write_text(json.dumps(MODEL))
        files = [cls.path / ("mesh" + ending) for ending in (".json", ".vtu", ".msh", ".inp")]
        command = [QUADLINE, "mesh", cls.path / "model.json"]
        for file in files:
            command += ["-o", file]
        subprocess.run(command, check=True, timeout=120)
        cls.mesh = json.loads(files[0].read_text())
        cls.points = np.array(cls.mesh["points"])

    def region(self, r):
        return quads_of([q for q, of in zip(self.mesh["quads"], self.mesh["quad_region"]) if of == r])

    def node_of(self, points):
        """Index in our mesh of every point, by its coordinates, which come back exactly."""
        index = {tuple(point): i for i, point in enumerate(self.points)}
        return np.array([index[tuple(point[:2])] for point in points])

    def test_the_model_has_every_kind_of_group(self):
        self.assertEqual({curve["kind"] for curve in self.mesh["curves"]}, {"outer", "hole", "line"})
        self.assertEqual([len(s["nodes"]) for s in self.mesh["node_sets"]], [1, 1])
        self.assertLessEqual({"lower plate", "upper plate"}, set(self.mesh["regions"]))
        lines = {curve["name"]: edges_of(curve["edges"]) for curve in self.mesh["curves"]}
        self.assertTrue(lines["doubler"] < lines["stringer 1"])
        self.assertTrue(lines["edge-bar"] < lines["outer-1"])

    def test_vtu(self):
        read = meshio.read(self.path / "mesh.vtu")
        np.testing.assert_array_equal(read.points[:, :2], self.points)
        self.assertFalse(read.points[:, 2].any())
        blocks = {block.type: i for i, block in enumerate(read.cells)}
        quads = read.cells[blocks["quad"]].data
        np.testing.assert_array_equal(quads, self.mesh["quads"])
        np.testing.assert_array_equal(read.cell_data["region"][blocks["quad"]], self.mesh["quad_region"])
        for name in ("beta", "scaled_jacobian"):
            values = read.cell_data[name][blocks["quad"]]
            self.assertTrue(np.all((values > 0) & (values <= 1 + 1e-6)), name)
        lines, of_curve = read.cells[blocks["line"]].data, read.cell_data["curve"][blocks["line"]]
        for i, curve in enumerate(self.mesh["curves"]):
            self.assertEqual(read.field_data["%s/%s" % (curve["kind"], curve["name"])], [i])
            np.testing.assert_array_equal(lines[of_curve == i], curve["edges"])
        for i, name in enumerate(self.mesh["regions"]):
            self.assertEqual(read.field_data["region/" + name], [i])
        vertices, of_point = read.cells[blocks["vertex"]].data, read.cell_data["point"][blocks["vertex"]]
        for i, node_set in enumerate(self.mesh["node_sets"]):
            self.assertEqual(read.field_data["point/" + node_set["name"]], [i])
            np.testing.assert_array_equal(vertices[of_point == i].ravel(), node_set["nodes"])

    def test_msh(self):
        read = meshio.read(self.path / "mesh.msh")
        self.assertEqual(len(read.points), len(self.points))
        node = self.node_of(read.points)

        def members(name, kind):
            chosen = [node[block.data[cells]] for block, cells in zip(read.cells, read.cell_sets[name])
                      if block.type == kind]
            return np.concatenate(chosen) if chosen else np.zeros((0, 2), int)

        for r, name in enumerate(self.mesh["regions"]):
            self.assertEqual(quads_of(members(name, "quad")), self.region(r))
            self.assertEqual(list(read.field_data[name]), [r + 1, 2])
        for curve in self.mesh["curves"]:
            self.assertEqual(edges_of(members(curve["name"], "line")), edges_of(curve["edges"]))
        for node_set in self.mesh["node_sets"]:
            self.assertEqual(members(node_set["name"], "vertex").ravel().tolist(), node_set["nodes"])
        self.assertEqual(sum(len(block.data) for block in read.cells if block.type == "quad"), len(self.mesh["quads"]))

    def test_inp(self):
        read = meshio.read(self.path / "mesh.inp")
        np.testing.assert_allclose(read.points[:, :2], self.points, rtol=1e-13, atol=1e-13)

        def members(name, kind):
            chosen = [block.data[cells] for block, cells in zip(read.cells, read.cell_sets[name]) if block.type == kind]
            return np.concatenate(chosen)

        self.assertEqual(quads_of(members("QUADS", "quad")), quads_of(self.mesh["quads"]))
        for r, name in enumerate(self.mesh["regions"]):
            if self.region(r):
                self.assertEqual(quads_of(members(in_inp(name), "quad")), self.region(r))
                nodes = {node for quad in self.region(r) for node in quad}
                self.assertEqual(set(read.point_sets[in_inp(name)]), nodes)
        all_lines = set()
        for curve in self.mesh["curves"]:
            edges, name = edges_of(curve["edges"]), in_inp(curve["name"])
            self.assertEqual(set(read.point_sets[name]), {node for edge in edges for node in edge})
            if curve["kind"] == "line":
                self.assertEqual(edges_of(members(name, "line")), edges)
                all_lines |= edges
        self.assertEqual(edges_of(members("LINES", "line")), all_lines)
        n_beams = sum(len(block.data) for block in read.cells if block.type == "line")
        self.assertEqual(n_beams, len(all_lines), "an edge of two lines is one beam")
        for node_set in self.mesh["node_sets"]:
            self.assertEqual(read.point_sets[in_inp(node_set["name"])].tolist(), node_set["nodes"])

    def test_quadline_reads_what_meshio_writes(self):
        points = np.column_stack([self.points, np.zeros(len(self.points))])
        quads = np.array(self.mesh["quads"])
        cells = [("quad", quads[1:]), ("triangle", [quads[0, [0, 1, 2]], quads[0, [0, 2, 3]]])]
        plain = meshio.Mesh(points, cells)
        # MSH 4.1 asks for the entities that nodes and elements lie on: the quads on surface 1, the triangles on 2.
        tags = [np.full(len(data), i + 1) for i, (_, data) in enumerate(cells)]
        with_entities = meshio.Mesh(points, cells, point_data={"gmsh:dim_tags": np.tile([2, 1], (len(points), 1))},
                                    cell_data={"gmsh:geometrical": tags, "gmsh:physical": tags})
        for name, options in {
            "text.vtu": {"binary": False}, "base64.vtu": {"binary": True, "compression": None},
            "zlib.vtu": {"binary": True, "compression": "zlib"}, "binary22.msh": {"file_format": "gmsh22"},
            "text22.msh": {"file_format": "gmsh22", "binary": False}, "binary41.msh": {"file_format": "gmsh"},
            "text41.msh": {"file_format": "gmsh", "binary": False}, "plain.inp": {},
        }.items():
            file = self.path / name
            (with_entities if "41" in name else plain).write(file, **options)
            for command in (["check", file], ["draw", file, "-o", self.path / "mesh.svg"]):
                run = subprocess.run([QUADLINE, *command], timeout=60, text=True, capture_output=True)
                self.assertEqual(run.returncode, 0, "%s %s: %s" % (command[0], name, run.stderr))
                if command[0] == "check":
                    self.assertIn(str(len(quads) - 1), run.stdout, name)


if __name__ == "__main__":
    unittest.main()
