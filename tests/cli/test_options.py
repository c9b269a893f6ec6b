"""Every option of the command line does something: each test fails where its option is read and then ignored."""
import json
import os
import subprocess
import tempfile
import time
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
QUADLINE = os.environ.get("QUADLINE", os.path.join(ROOT, "build", "release", "quadline"))
MANY_CELLS = os.path.join(ROOT, "models", "structures", "annulus.json")
PLATE = {"name": "plate", "size": 1, "outer": [[0, 0], [12, 0], [12, 8], [0, 8]],
         "holes": [{"center": [9, 5], "radius": 1.5}], "lines": [{"name": "stiffener", "path": [[1, 2.3], [8, 3.1]]}]}
GRADED = {"size": 1, "outer": [[0, 0], [16, 0], [16, 16], [0, 16]],
          "points": [{"name": "fine", "at": [8, 8], "size": 0.1}]}
# The end of the line stops 0.01 before the edge of the plate.
NEAR = {"size": 1, "outer": [[0, 0], [8, 0], [8, 6], [0, 6]], "lines": [{"name": "near", "path": [[2, 3], [7.99, 3]]}]}
# So flat that no quad in it is convex in double precision; with a tolerance that does not make it a line.
NEEDLE = {"size": 1, "outer": [[0, 0], [10, 0], [10, 1e-7]]}
NEEDLE_APART = ("--tolerance", "1e-13")
TRIANGLES = "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 1, 1\n*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 2, 4, 3\n"


class Options(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = self._folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def put(self, name, content):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return self.path(name)

    def run_it(self, *arguments, code=0):
        done = subprocess.run([QUADLINE, *arguments], capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def json_of(self, *arguments, code=0):
        return json.loads(self.run_it(*arguments, "--json", code=code).stdout)

    def mesh(self, model, *arguments):
        """The report on a model that is given as a dictionary or as a file."""
        return self.json_of("mesh", model if isinstance(model, str) else self.put("model.json", model), *arguments)


class Mesh(Options):
    def quads(self, model, *arguments):
        return self.mesh(model, *arguments)["counts"]["quads"]

    def edges_on(self, name, *arguments):
        return next(line["edges"] for line in self.mesh(PLATE, *arguments)["lines"] if line["name"] == name)

    def test_size(self):
        self.assertGreater(self.quads(PLATE, "--size", "0.5"), 2 * self.quads(PLATE))

    def test_growth(self):
        slow, usual, fast = (self.mesh(GRADED, "--growth", growth) for growth in ("1.1", "1.3", "2"))
        self.assertGreater(slow["counts"]["quads"], 1.5 * usual["counts"]["quads"])
        self.assertLess(fast["counts"]["quads"], usual["counts"]["quads"])
        self.assertEqual([report["options"]["growth"] for report in (slow, usual, fast)], [1.1, 1.3, 2])

    def test_edges_per_circle(self):
        self.assertGreaterEqual(self.edges_on("hole-1", "--edges-per-circle", "40"), 30)  # usually 12
        self.assertLess(self.edges_on("hole-1"), 20)

    def test_tolerance(self):
        apart, joined = self.mesh(NEAR), self.mesh(NEAR, "--tolerance", "0.05")
        self.assertEqual((apart["counts"]["vertices"], joined["counts"]["vertices"]), (6, 6))
        self.assertEqual((apart["counts"]["curves"], joined["counts"]["curves"]), (5, 6))  # the edge is cut in two
        self.assertEqual(joined["tolerance"], 0.05)
        self.assertIn("joined", joined["findings"][0]["text"])

    def quads_beside_the_line(self, sides):
        """Quads that touch the line once the front has gone round one time."""
        folder = self.path(sides)
        self.mesh(PLATE, "--triangles", "delaunay", "--lines", sides, "--stages", folder)
        first = next(name for name in os.listdir(folder) if name.endswith("first-layer.vtu"))
        lines = self.json_of("check", os.path.join(folder, first))["lines"]
        return next(line["quads"] for line in lines if line["name"] == "stiffener")

    def test_lines(self):
        two_sided = self.quads_beside_the_line("two-sided")
        self.assertGreaterEqual(two_sided, 2 * 7)  # 7 edges
        self.assertLessEqual(self.quads_beside_the_line("one-sided"), two_sided * 2 / 3)

    def test_triangles(self):
        fields = {}
        for triangles in ("delaunay", "front", "both"):
            report = self.mesh(PLATE, "--triangles", triangles, "--stages", self.path(triangles))
            self.assertEqual("retries" in [use["stage"] for use in report["stages"]], triangles == "both")
            with open(self.path(triangles + "/02-field-points.vtu"), "rb") as file:
                fields[triangles] = file.read()
        self.assertNotEqual(fields["delaunay"], fields["front"])
        self.assertEqual(fields["both"], fields["front"])  # those come first

    def test_method(self):
        raw = {}
        for method, stage in (("layout", "grid"), ("qmorph", "qmorph"), ("merge", "pair"), ("split", "halve")):
            report = self.mesh(PLATE, "--method", method)
            self.assertEqual(report["options"]["method"], method)
            bare = self.mesh({key: PLATE[key] for key in PLATE if key != "lines"}, "--method", method)
            by = {"layout": "grids", "qmorph": "qmorph"}.get(method, "halved")
            self.assertEqual({key: share["cells"] for key, share in bare["cells"].items() if share["cells"]}, {by: 1})
            self.assertEqual(bare["cells"][by]["quads"], bare["counts"]["quads"])
            self.assertIn(stage, [use["stage"] for use in report["stages"]])
            raw[method] = report["quality"]["before_smoothing"]["irregular_nodes"] / report["counts"]["nodes"]
        self.assertGreater(raw["split"], 2 * raw["merge"])  # a node in the middle of every triangle

    def most_threads(self, *arguments):
        """Threads that the program is seen to have at once."""
        words = [QUADLINE, "mesh", MANY_CELLS, "--size", "40", "--report", self.path("r.json"), *arguments]
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
        most = 0
        while process.poll() is None:
            try:
                most = max(most, len(os.listdir("/proc/%d/task" % process.pid)))
            except FileNotFoundError:
                pass  # it has just ended
            time.sleep(0.002)
        self.assertEqual(process.returncode, 0)
        with open(self.path("r.json"), encoding="utf-8") as file:
            return most, json.load(file)["options"]["threads"]

    def test_threads(self):
        for threads in (1, 3):
            self.assertEqual(self.most_threads("--threads", str(threads)), (threads, threads))

    def test_max_quads(self):
        out = self.path("a.vtu")
        plate = self.put("plate.json", PLATE)
        self.assertIn("more than 10:", self.run_it("mesh", plate, "-o", out, "--max-quads", "10", code=2).stderr)
        self.assertFalse(os.path.exists(out))
        self.run_it("mesh", plate, "-o", out, "--max-quads", "1000")

    def test_stages(self):
        self.run_it("mesh", self.put("plate.json", PLATE), "--stages", self.path("stages"))
        names = [os.path.splitext(name)[0][3:] for name in sorted(os.listdir(self.path("stages")))]
        self.assertEqual(names[::2], ["triangulation", "field-points", "first-layer", "half-way", "before-smoothing",
                                      "clean-up", "smoothed"])
        self.assertEqual(names[::2], names[1::2])  # a picture and a mesh of each

    def test_report_and_json(self):
        done = self.run_it("mesh", self.put("plate.json", PLATE), "--report", self.path("r.json"), "--json")
        with open(self.path("r.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file), json.loads(done.stdout))

    def test_quiet(self):
        again = dict(PLATE, lines=PLATE["lines"] * 2)  # which is worth a note
        words = ["mesh", self.put("plate.json", again), "-o", self.path("a.vtu")]
        loud, quiet = self.run_it(*words), self.run_it(*words, "--quiet")
        self.assertIn("plate: ", loud.stdout)
        self.assertIn("note: ", loud.stderr)
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))

    def test_criteria(self):
        plate = dict(PLATE, holes=[])  # nodes on arcs stay, whatever the limits
        limits = self.put("limits.json", {"max_aspect": 1.5})
        self.run_it("mesh", self.put("plate.json", plate), "-o", self.path("a.msh"))
        without = self.json_of("check", self.path("a.msh"), "--criteria", limits)["criteria"]["failing"]
        self.assertLess(self.mesh(plate, "--criteria", limits)["criteria"]["failing"], without / 2)  # nodes were moved

    def test_fall_backs(self):
        """No option, but what helps where the mesh as asked breaks the promise."""
        report = self.mesh(dict(NEEDLE, outer=[[0, 0], [10, 0], [10, 1e-4]]), *NEEDLE_APART)
        self.assertTrue(report["ok"])
        self.assertRegex(report["findings"][0]["text"],
                         r"\Aa cell of region 'domain' is meshed .*, because as asked a quad is ")

    def test_keep_bad(self):
        words = ["mesh", self.put("needle.json", NEEDLE), *NEEDLE_APART, "-o", self.path("a.vtu"),
                 "--report", self.path("r.json")]
        done = self.run_it(*words, code=3)
        self.assertIn("no valid mesh: ", done.stderr)
        self.assertEqual(os.listdir(self.folder), ["needle.json"])
        self.run_it(*words, "--keep-bad", code=3)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.vtu", "needle.json", "r.json"])
        with open(self.path("r.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertFalse(report["ok"])
        self.assertGreater(report["counts"]["quads"], 0)
        self.assertFalse(self.json_of("check", self.path("a.vtu"), code=3)["valid"])


class Check(Options):
    def setUp(self):
        super().setUp()
        self.near, self.out = self.put("near.json", NEAR), self.path("a.msh")

    def test_model(self):
        self.run_it("mesh", self.near, "-o", self.out)
        self.run_it("check", self.out)
        self.run_it("check", self.out, "--model", self.near)
        self.run_it("check", self.out, "--model", self.put("plate.json", PLATE), code=3)

    def test_all_quad(self):
        triangles = self.put("t.inp", TRIANGLES)
        self.run_it("check", triangles)
        self.run_it("check", triangles, "--all-quad", code=3)

    def test_tolerance(self):
        self.run_it("mesh", self.near, "-o", self.out, "--tolerance", "0.05")
        self.run_it("check", self.out, "--model", self.near, "--tolerance", "0.05")
        self.run_it("check", self.out, "--model", self.near, code=3)

    def test_criteria_and_json(self):
        self.run_it("mesh", self.near, "-o", self.out)
        limits = self.put("limits.json", {"max_edge": 0.1})
        quads = self.json_of("check", self.out)["quality"]["quads"]
        self.assertEqual(self.json_of("check", self.out, "--criteria", limits)["criteria"]["failing"], quads)
        self.assertIn("%d quads fail" % quads, self.run_it("check", self.out, "--criteria", limits).stdout)


class Info(Options):
    def test_size_and_json(self):
        plate = self.put("plate.json", PLATE)
        usual, fine = self.json_of("info", plate), self.json_of("info", plate, "--size", "0.5")
        self.assertEqual((usual["size"], fine["size"]), (1, 0.5))
        self.assertGreater(fine["expected_quads"], 2 * usual["expected_quads"])
        self.assertIn("  size: 0.5\n", self.run_it("info", plate, "--size", "0.5").stdout)

    def test_tolerance(self):
        near = self.put("near.json", NEAR)
        self.assertEqual(self.json_of("info", near)["curves"], 5)
        joined = self.json_of("info", near, "--tolerance", "0.05")
        self.assertEqual((joined["curves"], joined["tolerance"]), (6, 0.05))


class Draw(Options):
    def test_output_shows_the_mesh(self):
        self.run_it("mesh", self.put("plate.json", PLATE), "-o", self.path("a.vtu"), "--quiet")
        self.run_it("draw", self.path("a.vtu"), "-o", self.path("a.svg"))
        self.run_it("draw", self.put("t.inp", TRIANGLES), "-o", self.path("t.svg"))
        with open(self.path("t.svg"), encoding="utf-8") as file:
            self.assertIn(">0 quads, 2 triangles, 4 nodes<", file.read())
        with open(self.path("a.svg"), encoding="utf-8") as file:
            self.assertIn('<path class="lines"', file.read())


if __name__ == "__main__":
    unittest.main()
