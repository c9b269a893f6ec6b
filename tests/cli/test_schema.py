"""The published schemas and the readers agree on what a model is, and what criteria are."""
import glob
import json
import os
import subprocess
import tempfile
import unittest

import jsonschema

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
QUADLINE = os.environ.get("QUADLINE", os.path.join(ROOT, "build", "release", "quadline"))
SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3]]
CIRCLE = {"center": [1, 1], "radius": 0.5}
ARC = [[0, 0], {"to": [1, 1], "via": [1, 0]}]

RIGHT = [
    {"outer": SQUARE},
    {"outer": CIRCLE},
    {"outer": [SQUARE, {"center": [9, 9], "radius": 1}]},
    {"outer": [SQUARE], "holes": [CIRCLE], "lines": [], "points": [], "regions": []},
    {"$schema": "model.schema.json", "x-note": [1, {}], "name": "a", "about": "b", "units": "mm", "outer": SQUARE},
    {"outer": SQUARE, "lines": [{"path": ARC}, {"name": "a", "path": CIRCLE, "size": 0.1, "x-id": 7}]},
    {"outer": SQUARE, "points": [{"at": [1, 1]}], "regions": [{"name": "r", "at": [2, 2], "size": 0.5}]},
]
RIGHT += [{"outer": SQUARE, "holes": [dict(CIRCLE, **keys)], "lines": [{"path": dict(CIRCLE, **keys)}]}
          for keys in ({"edges": 4}, {"edges": 24.0, "rings": 2, "ring_width": 0.1}, {"rings": 100}, {"ring_width": 0.1})]
RIGHT += [{"outer": dict(CIRCLE, edges=24)}]
RIGHT += [{"outer": SQUARE, "holes": [dict(keys, path=CIRCLE)]}
          for keys in ({}, {"edges": 24, "rings": 2, "ring_width": 0.1, "x-id": 1}, {"rings": 1})]
RIGHT += [{"outer": SQUARE, "holes": [{"path": ARC}]}]
WRONG_HOLES = [{"outer": SQUARE, "holes": [dict(keys, path=CIRCLE)]}
               for keys in ({"edges": 23}, {"rings": 0}, {"ring": 1}, {"center": [1, 1]})]
WRONG_HOLES += [{"outer": SQUARE, "holes": [{"path": dict(CIRCLE, rings=2)}]}]
WRONG = [
    [],
    {},
    {"outer": []},
    {"outer": [0, 0]},
    {"outer": [[0, 0]]},
    {"outer": [SQUARE, 7]},
    {"outer": [{"to": [1, 1], "via": [1, 0]}, [0, 0]]},
    {"outer": SQUARE, "size": 0},
    {"outer": SQUARE, "size": "1"},
    {"outer": SQUARE, "name": 1},
    {"outer": SQUARE, "hole": []},
    {"outer": SQUARE, "holes": SQUARE},
    {"outer": SQUARE, "holes": [{"center": [1, 1]}]},
    {"outer": SQUARE, "holes": [{"center": [1, 1], "radius": -1}]},
    {"outer": SQUARE, "holes": [{"center": [1, 1], "radius": 1, "name": "a"}]},
    {"outer": SQUARE, "lines": [{"name": "a"}]},
    {"outer": SQUARE, "lines": [[[0, 0], [1, 1]]]},
    {"outer": SQUARE, "lines": [{"path": [[0, 0], {"to": [1, 1]}]}]},
    {"outer": SQUARE, "lines": [{"path": [[0, 0], [1, 1, 1]]}]},
    {"outer": SQUARE, "points": [{"name": "a"}]},
    {"outer": SQUARE, "points": [{"at": [1]}]},
    {"outer": SQUARE, "regions": [{"at": [1, True]}]},
]

WRONG += [{"outer": SQUARE, "holes": [dict(CIRCLE, **keys)]}
          for keys in ({"edges": 3}, {"edges": 23}, {"edges": 2}, {"edges": 0}, {"edges": -8}, {"edges": 24.5},
                       {"edges": 1000002}, {"edges": 1e300}, {"edges": "24"}, {"edges": None}, {"rings": 0}, {"rings": -1},
                       {"rings": 1.5}, {"rings": 101}, {"rings": [2]}, {"ring_width": 0}, {"ring_width": -9},
                       {"ring_width": "9"}, {"ring": 2})]
WRONG += WRONG_HOLES
WRONG += [
    {"outer": dict(CIRCLE, rings=1)},
    {"outer": [SQUARE, dict(CIRCLE, ring_width=0.1)]},
    {"outer": SQUARE, "holes": [{"path": ARC, "rings": 2}]},
    {"outer": SQUARE, "lines": [{"path": CIRCLE, "rings": 2}]},
]

RIGHT_CRITERIA = [
    {},
    {"$schema": "criteria.schema.json", "x-note": ["of the yard"], "max_aspect": 1},
    {"min_angle_deg": 0, "max_angle_deg": 360, "max_aspect": 4, "min_scaled_jacobian": -1, "min_jacobian_ratio": 1,
     "max_skew_deg": 90, "max_taper": 0.5, "min_beta": 0.3, "max_growth": 1.5, "min_edge": 0, "max_edge": 1e9,
     "min_edge_to_size": 0.2, "max_edge_to_size": 2},
]
WRONG_CRITERIA = [
    ([], "expected an object of limits"),
    ({"max_aspct": 2}, "/max_aspct: unknown limit 'max_aspct': did you mean 'max_aspect'?"),
    ({"max_aspect": 0.9}, "/max_aspect: expected a number of 1 or more"),
    ({"max_aspect": "3"}, "/max_aspect: expected a number"),
    ({"max_aspect": None}, "/max_aspect: expected a number"),
    ({"max_growth": [1.5]}, "/max_growth: expected a number"),
    ({"max_growth": 0}, "/max_growth: expected a number of 1 or more"),
    ({"min_angle_deg": -1}, "/min_angle_deg: expected a number from 0 to 360"),
    ({"max_angle_deg": 361}, "/max_angle_deg: expected a number from 0 to 360"),
    ({"min_scaled_jacobian": 1.5}, "/min_scaled_jacobian: expected a number from -1 to 1"),
    ({"min_jacobian_ratio": -2}, "/min_jacobian_ratio: expected a number from -1 to 1"),
    ({"max_skew_deg": 91}, "/max_skew_deg: expected a number from 0 to 90"),
    ({"max_taper": -0.1}, "/max_taper: expected a number of 0 or more"),
    ({"min_beta": 2}, "/min_beta: expected a number from 0 to 1"),
    ({"min_edge": -1}, "/min_edge: expected a number of 0 or more"),
    ({"max_edge": -1}, "/max_edge: expected a number of 0 or more"),
    ({"min_edge_to_size": -1}, "/min_edge_to_size: expected a number of 0 or more"),
    ({"max_edge_to_size": True}, "/max_edge_to_size: expected a number"),
]


def published(name):
    with open(os.path.join(ROOT, "schema", name), encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.schema = published("model.schema.json")

    def info(self, model):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "m.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(model, file)
            return subprocess.run([QUADLINE, "info", path, "--size", "1"], capture_output=True, text=True, timeout=60)

    def test_both_take_what_is_right(self):
        for model in RIGHT:
            with self.subTest(model=model):
                self.assertTrue(self.schema.is_valid(model))
                self.assertEqual(self.info(model).returncode, 0, self.info(model).stderr)

    def test_both_refuse_what_is_wrong(self):
        for model in WRONG:
            with self.subTest(model=model):
                self.assertFalse(self.schema.is_valid(model))
                done = self.info(model)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(done.stderr.count("\n"), 1)

    def test_it_takes_every_model_here(self):
        models = glob.glob(os.path.join(ROOT, "models", "*", "*.json"))
        models += glob.glob(os.path.join(ROOT, "examples", "*", "*.json"))
        self.assertGreater(len(models), 30)
        for path in models:
            with self.subTest(model=os.path.basename(path)), open(path, encoding="utf-8") as file:
                self.schema.validate(json.load(file))


class CriteriaSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.schema = published("criteria.schema.json")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.criteria, self.model = (os.path.join(folder.name, name) for name in ("c.json", "m.json"))
        self.put(self.model, {"outer": SQUARE, "size": 1})

    def put(self, path, content):
        with open(path, "w", encoding="utf-8") as file:
            json.dump(content, file)

    def mesh(self, criteria):
        self.put(self.criteria, criteria)
        return subprocess.run([QUADLINE, "mesh", self.model, "--criteria", self.criteria, "--json"],
                              capture_output=True, text=True, timeout=60)

    def test_both_take_what_is_right(self):
        for criteria in RIGHT_CRITERIA:
            with self.subTest(criteria=criteria):
                self.assertTrue(self.schema.is_valid(criteria))
                done = self.mesh(criteria)
                self.assertEqual(done.returncode, 0, done.stderr)
                told = {limit["name"]: limit["limit"] for limit in json.loads(done.stdout)["criteria"]["limits"]}
                self.assertEqual(told, {k: v for k, v in criteria.items() if k[:2] != "x-" and k[0] != "$"})

    def test_both_refuse_what_is_wrong_and_say_where(self):
        for criteria, message in WRONG_CRITERIA:
            with self.subTest(criteria=criteria):
                self.assertFalse(self.schema.is_valid(criteria))
                done = self.mesh(criteria)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertEqual(done.stderr, "quadline: %s: %s\n" % (self.criteria, message))

    def test_the_schema_knows_every_limit(self):
        limits = {name for name in self.schema.schema["properties"] if name[0] != "$"}
        self.assertEqual(limits, set(RIGHT_CRITERIA[2]))


if __name__ == "__main__":
    unittest.main()
