"""--tolerance: what it joins, where it is told, what it refuses."""
import json
import os
import subprocess
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
QUADLINE = os.environ.get("QUADLINE", os.path.join(ROOT, "build", "release", "quadline"))
MODEL = os.path.join(ROOT, "models", "hard", "near-end-0.1h.json")  # three ends 4 mm off other curves; size 40


def run(*arguments):
    return subprocess.run([QUADLINE, *arguments], capture_output=True, text=True, check=False)


class Tolerance(unittest.TestCase):
    def mesh(self, folder, *options):
        mesh, report = os.path.join(folder, "out.vtu"), os.path.join(folder, "report.json")
        done = run("mesh", MODEL, "-o", mesh, "--report", report, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            return mesh, json.load(file)

    def test_joins_and_tells(self):
        with tempfile.TemporaryDirectory() as folder:
            _, apart = self.mesh(folder)
            mesh, joined = self.mesh(folder, "--tolerance", "9")
            self.assertNotIn("tolerance", apart["options"])
            self.assertEqual(joined["options"]["tolerance"], 9)
            self.assertEqual(joined["tolerance"], 9)
            told = [f["at"] for f in joined["findings"] if "joined, 4 apart" in f["text"]]
            self.assertCountEqual(told, [[606, 400], [200, 596], [600, 124]])
            self.assertEqual([f for f in apart["findings"] if "joined" in f["text"]], [])
            self.assertGreater(joined["counts"]["cells"], 0)
            # The mesh fits the model with the same tolerance, and only with it.
            self.assertEqual(run("check", mesh, "--model", MODEL, "--tolerance", "9").returncode, 0)
            self.assertEqual(run("check", mesh, "--model", MODEL).returncode, 3)

    def test_refuses(self):
        for value, message in (("0", "a length above 0"), ("-1", "a length above 0"), ("x", "a length above 0"),
                               ("11", "more than a quarter of the least size")):
            done = run("info", MODEL, "--tolerance", value)
            self.assertEqual(done.returncode, 2, value)
            self.assertIn(message, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
