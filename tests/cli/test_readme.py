"""The models that README shows mesh as they stand there."""
import json
import os
import re
import unittest

from test_command_line import ROOT, CommandLine


class Readme(CommandLine):
    def models(self):
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
            blocks = re.findall(r"^    \{\n(?:^     .*\n)+^    \}\n", file.read(), re.MULTILINE)
        return {model["name"]: model for model in map(json.loads, blocks)}

    def test_every_model_meshes(self):
        self.assertEqual(sorted(self.models()), ["bracket", "plate"])
        for name, model in self.models().items():
            file, mesh = self.put(name + ".json", model), self.path(name + ".msh")
            done = self.run_it("mesh", file, "-o", mesh)
            self.assert_done(done)
            self.assertEqual(done.stderr, "")
            self.assert_done(self.run_it("check", mesh, "--model", file, "--all-quad"))

    def test_they_are_the_examples(self):
        for name, model in self.models().items():
            with open(os.path.join(ROOT, "examples", name, name + ".json"), encoding="utf-8") as file:
                self.assertEqual(json.load(file), model)

    def test_the_names_of_the_bracket_are_in_the_mesh(self):
        path = os.path.join(ROOT, "examples", "bracket", "bracket.json")
        self.assert_done(self.run_it("mesh", path, "-o", self.path("a.json"), "--quiet"))
        mesh = json.loads(self.read("a.json"))
        text = json.dumps(mesh)
        for name in ("foot", "eye", "weld", "bead", "bolt"):
            self.assertIn('"' + name + '"', text)

    def test_its_sizes_count(self):
        model = self.models()["bracket"]
        def expected(model):
            return json.loads(self.run_it("info", self.put("m.json", model), "--json").stdout)["expected_quads"]
        for kind in ("lines", "regions"):
            plain = dict(model, **{kind: [{key: value for key, value in item.items() if key != "size"} for item in model[kind]]})
            self.assertLess(expected(plain), expected(model), kind)


if __name__ == "__main__":
    unittest.main()
