#!/usr/bin/env python3
"""The parts of benchmarks/compare/symmetry.py that need no mesher."""
import os
import sys
import unittest

import numpy as np

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "benchmarks", "compare"))
sys.path.insert(0, os.path.join(ROOT, "tests", "judge"))
import meshread  # noqa: E402
import planemodel  # noqa: E402
import symmetry  # noqa: E402


def symmetries(**parts):
    model = planemodel.Model(dict({"name": "m", "size": 1, "outer": [[0, 0], [6, 0], [6, 4], [0, 4]]}, **parts))
    return [name for name, matrix in symmetry.SYMMETRIES.items() if symmetry.has(model, matrix)]


class Moved(unittest.TestCase):
    def test_every_place_moves_and_nothing_else(self):
        model = {"name": "m", "size": 2, "outer": [[0, 0], {"to": [1, 0], "via": [1, 2]}],
                 "holes": [{"center": [3, 1], "radius": 5}]}
        self.assertEqual(symmetry.moved(model, symmetry.turn(90)),
                         {"name": "m", "size": 2, "outer": [[0, 0], {"to": [0, 1], "via": [-2, 1]}],
                          "holes": [{"center": [-1, 3], "radius": 5}]})


class Has(unittest.TestCase):
    def test_rectangle(self):
        self.assertEqual(symmetries(), ["mirror x", "mirror y", "half turn"])

    def test_hole_in_the_middle_keeps_all(self):
        self.assertEqual(symmetries(holes=[{"center": [3, 2], "radius": 1}]), ["mirror x", "mirror y", "half turn"])

    def test_two_holes_of_other_radii_break_one_mirror(self):
        holes = [{"center": [1.5, 2], "radius": 1}, {"center": [4.5, 2], "radius": 0.9}]
        self.assertEqual(symmetries(holes=holes), ["mirror y"])

    def test_line_breaks_what_does_not_keep_it(self):
        self.assertEqual(symmetries(lines=[{"name": "l", "path": [[3, 0], [3, 2]]}]), ["mirror x"])

    def test_point_breaks_what_does_not_keep_it(self):
        self.assertEqual(symmetries(points=[{"name": "p", "at": [1, 2]}]), ["mirror y"])

    def test_disk_and_square_have_their_turns(self):
        self.assertEqual(symmetries(outer={"center": [1, 1], "radius": 3}), list(symmetry.SYMMETRIES))
        self.assertEqual(symmetries(outer=[[0, 0], [4, 0], [4, 4], [0, 4]]), [s for s in symmetry.SYMMETRIES if s != "turn 30"])


class Shares(unittest.TestCase):
    def test_near_is_a_tenth_of_the_edge(self):
        points = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]])
        others = points + [[0, 0.09], [0, 0.11], [0, 0.19], [0, 0.5]]
        self.assertEqual(symmetry.share_in(points, np.array([1.0, 1.0, 2.0, 1.0]), others), 0.5)

    def test_mean_edges_of_a_rectangle(self):
        mesh = meshread.Mesh(np.array([[0.0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]]), np.array([[0, 1, 2, 3]]), [])
        self.assertTrue(np.allclose(symmetry.mean_edges(mesh), 1.5))


if __name__ == "__main__":
    unittest.main()
