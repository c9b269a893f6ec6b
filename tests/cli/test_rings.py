"""Rings that circles of the model ask for: as many, as wide, on common rays; or a line that says why not."""
import json
import math
import unittest

from test_command_line import CommandLine


class Rings(CommandLine):
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
