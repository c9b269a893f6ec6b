"""The published schema and the reader agree on what a model is."""
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


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(ROOT, "schema", "model.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        jsonschema.Draft202012Validator.check_schema(schema)
        cls.schema = jsonschema.Draft202012Validator(schema)

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


if __name__ == "__main__":
    unittest.main()
