"""The table that compares Quadline with Gmsh: what counts as fair, as best, as lost."""
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "benchmarks", "compare"))
import table  # noqa: E402


def row(**changes):
    plain = {"model": "plate", "valid": True, "triangles": 0, "quads": 100, "seconds": 0.1, "beta_mean": 0.8, "sj_mean": 0.95,
             "sj_min": 0.6, "irregular": 0.03, "angle_min": 50.0, "angle_max": 130.0, "size_ratio_p5": 0.7,
             "size_ratio_p50": 1.0, "size_ratio_p95": 1.3}
    return dict(plain, **changes)


class Table(unittest.TestCase):
    def test_only_valid_all_quad_meshes_of_the_size_asked_for_are_fair(self):
        self.assertTrue(table.is_fair(row()))
        for change in ({"valid": False}, {"triangles": 1}, {"size_ratio_p50": 0.5}, {"size_ratio_p50": 1.5}):
            self.assertFalse(table.is_fair(row(**change)), change)
        self.assertFalse(table.is_fair({"valid": False, "error": "crash"}))

    def test_best_is_figure_by_figure(self):
        best = table.best_of([row(beta_mean=0.9, irregular=0.05), row(irregular=0.01), row(beta_mean=1.0, valid=False)])
        self.assertEqual((best["beta_mean"], best["irregular"]), (0.9, 0.01))
        self.assertEqual(table.best_of([row(valid=False)]), {})

    def test_lost_is_what_is_worse_in_either_sense(self):
        best = table.best_of([row(beta_mean=0.7, irregular=0.02, angle_max=120.0)])
        self.assertEqual(table.lost(row(), best), ["irregular", "angle_max"])

    def test_a_row_marks_what_is_lost(self):
        line = table.row_of(row(), [row(beta_mean=0.85, irregular=0.04)])
        self.assertIn("| **0.800** (0.850) |", line)
        self.assertIn("| 3.00 % (4.00 %) |", line)
        self.assertIn("| 0.950 (-) |", table.row_of(row(), []))

    def test_summary_names_the_lost(self):
        rows = [row(), row(model="rib")]
        text = table.summary(rows, {"plate": [row(beta_mean=0.85)]})
        self.assertIn("1 of 6 comparisons are lost", text)
        self.assertIn("plate, beta: 0.800 against 0.850", text)
        self.assertIn("on rib", text)

    def test_table_has_a_line_for_each_model_and_the_mean(self):
        lines = table.table([row(), row(model="rib", beta_mean=0.9)], {}).splitlines()
        self.assertEqual(len(lines), 5)
        self.assertIn("0.850", lines[-1])


if __name__ == "__main__":
    unittest.main()
