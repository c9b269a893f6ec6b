"""Circles that ask for edges and rings: the program holds them exactly, in every format, by every method that a user may choose."""
import json
import math
import unittest

from test_command_line import CommandLine

BOLTS = [([30, 40], 8, 16, 2, 4), ([90, 40], 10, 24, 1, 9)]
MODEL = {
    "size": 8,
    "outer": [[0, 0], [120, 0], [120, 80], [0, 80]],
    "holes": [{"center": c, "radius": r, "edges": n, "rings": rings, "ring_width": w} for c, r, n, rings, w in BOLTS],
}


class Rings(CommandLine):
    def nodes(self, *options):
        done = self.run_it("mesh", self.put("m.json", MODEL), "-o", self.path("a.json"), "--json", *options)
        self.assert_done(done)
        self.assertEqual(json.loads(done.stdout)["findings"], [])
        return json.loads(self.read("a.json"))["points"]

    def assert_rings(self, points):
        for (x, y), radius, edges, rings, width in BOLTS:
            rays = []
            for ring in range(rings + 1):
                near = [p for p in points if abs(math.hypot(p[0] - x, p[1] - y) - radius - ring * width) < 1e-9]
                rays.append(sorted(math.atan2(p[1] - y, p[0] - x) % (2 * math.pi - 1e-9) for p in near))
            self.assertEqual([len(angles) for angles in rays], [edges] * (rings + 1))
            for angles in rays[1:]:
                self.assertLess(max(abs(a - b) for a, b in zip(angles, rays[0])), 1e-9)

    def test_two_holes_by_every_method(self):
        for method in ("layout", "qmorph", "merge", "split"):
            with self.subTest(method=method):
                self.assert_rings(self.nodes("--method", method))

    def test_neither_threads_nor_criteria_change_them(self):
        for options in (["--threads", "1"], ["--threads", "4"], ["--criteria", "growth"], ["--size", "3"], ["--size", "20"]):
            with self.subTest(options=options):
                self.assert_rings(self.nodes(*options))

    def test_no_format_names_what_the_model_does_not(self):
        self.assert_done(self.run_it("mesh", self.put("m.json", MODEL), "-o", self.path("a.msh"), "--quiet"))
        names = self.read("a.msh").decode().split("$PhysicalNames\n")[1].split("$EndPhysicalNames")[0].splitlines()[1:]
        self.assertEqual(sorted(line.split('"')[1] for line in names), ["domain", "hole-1", "hole-2", "outer-1"])

    def test_info_counts_what_the_model_holds(self):
        plain = dict(MODEL, holes=[{"center": c, "radius": r} for c, r, *_ in BOLTS])
        facts = [json.loads(self.run_it("info", self.put("m.json", m), "--json").stdout) for m in (MODEL, plain)]
        self.assertEqual(*[{key: fact[key] for key in ("cells", "curves", "vertices")} for fact in facts])


class RingsOfOneHole(CommandLine):
    PLATE = [[0, 0], [400, 0], [400, 300], [0, 300]]

    def mesh_of(self, circle, *options, outer=None):
        model = self.put("plate.json", json.dumps({"size": 20, "outer": outer or self.PLATE, "holes": [circle]}))
        done = self.run_it("mesh", model, "-o", self.path("out.json"), "--json", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(self.read("out.json")), json.loads(done.stdout)

    def rays_at(self, mesh, circle, k):
        """Angles of the nodes on the k-th ring's outer edge, in parts of the turn."""
        x, y = circle["center"]
        r = circle["radius"] + k * circle["ring_width"]
        return sorted((math.atan2(p[1] - y, p[0] - x) + 1e-9) % (2 * math.pi) for p in mesh["points"]
                      if abs(math.hypot(p[0] - x, p[1] - y) - r) < 1e-9 * r)

    def test_they_may_stand_beside_the_path(self):
        circle = {"center": [200, 150], "radius": 30}
        washer = {"rings": 2, "ring_width": 9, "edges": 24}
        beside, inside = self.mesh_of(dict(washer, path=circle))[0], self.mesh_of(dict(circle, **washer))[0]
        self.assertEqual(beside["points"], inside["points"])

    def test_rings_are_held(self):
        circle = {"center": [200, 150], "radius": 30, "rings": 2, "ring_width": 9, "edges": 24}
        for outer in (None, [[0, 0], [400, 0], [430, 200], [200, 350], [0, 300]]):
            for options in ([], ["--method", "qmorph"], ["--method", "merge"]):
                mesh, report = self.mesh_of(circle, *options, outer=outer)
                rays = [self.rays_at(mesh, circle, k) for k in range(3)]
                self.assertEqual([len(r) for r in rays], [24] * 3, options)
                for ring in rays[1:]:
                    for a, b in zip(ring, rays[0]):
                        self.assertAlmostEqual(a, b, 9)
                between = [p for p in mesh["points"] if 30.1 < math.dist(p, (200, 150)) < 47.9 and
                           abs(math.dist(p, (200, 150)) - 39) > 0.1]
                self.assertEqual(between, [])
                self.assertEqual(report["findings"], [])

    def test_edges_that_are_no_multiple_of_four(self):
        circle = {"center": [200, 150], "radius": 30, "ring_width": 9, "edges": 22}
        mesh, _ = self.mesh_of(circle)
        self.assertEqual([len(self.rays_at(mesh, circle, k)) for k in range(2)], [22, 22])

    def test_rings_without_room_are_told(self):
        circle = {"center": [45, 150], "radius": 30, "rings": 2, "ring_width": 9, "edges": 24}
        mesh, report = self.mesh_of(circle)
        self.assertEqual([len(self.rays_at(mesh, circle, k)) for k in range(3)], [24, 24, 0])
        self.assertEqual(len(report["findings"]), 1)
        finding = report["findings"][0]
        self.assertIn("'hole-1' gets 1 of 2 rings: 'outer-1' is in the way", json.dumps(finding))
        self.assertIn("/holes/0", json.dumps(finding))


if __name__ == "__main__":
    unittest.main()
