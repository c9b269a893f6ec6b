"""The command line as users meet it: exit codes, messages, what is written and what is not."""
import json
import os
import pty
import re
import resource
import select
import signal
import subprocess
import tempfile
import time
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
QUADLINE = os.environ.get("QUADLINE", os.path.join(ROOT, "build", "release", "quadline"))
PLATE = {
    "name": "plate",
    "units": "mm",
    "size": 1,
    "outer": [[0, 0], [12, 0], [12, 8], [0, 8]],
    "holes": [{"center": [9, 5], "radius": 1.5}],
    "lines": [{"name": "stiffener", "path": [[0, 2], [8, 2]]}],
    "points": [{"name": "load", "at": [3, 5]}],
    "regions": [{"name": "panel", "at": [1, 1]}],
}
POLY = "4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"
# Two quads that were not joined, as meshio writes them.
SEAM = """*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 1, 0, 0
6, 2, 0, 0
7, 2, 1, 0
8, 1, 1, 0
*ELEMENT, TYPE=S4
1, 1, 2, 3, 4
2, 5, 6, 7, 8
"""


class CommandLine(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = self._folder.name
        self.plate = self.put("plate.json", PLATE)

    def path(self, name):
        return os.path.join(self.folder, name)

    def put(self, name, content):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_it(self, *arguments, **keywords):
        return subprocess.run([QUADLINE, *arguments], capture_output=True, text=True, timeout=120, **keywords)

    def assert_done(self, done, code=0):
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)

    def assert_fails(self, code, message, *arguments, **keywords):
        """Ends with the code, prints nothing but this one line, and leaves the folder as it was."""
        before = sorted(os.listdir(self.folder))
        done = self.run_it(*arguments, **keywords)
        self.assert_done(done, code)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr, "quadline: " + message + "\n")
        self.assertEqual(sorted(os.listdir(self.folder)), before)


class Usage(CommandLine):
    def test_help_that_nobody_gets(self):
        for words in (["--help"], ["mesh", "--help"], ["--version"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([QUADLINE] + words, stdout=full, stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(done.returncode, 4, words)
            self.assertIn(b"standard output cannot be written", done.stderr)

    def test_version_and_help(self):
        done = self.run_it("--version")
        self.assert_done(done)
        self.assertRegex(done.stdout, r"\Aquadline \d+\.\d+\.\d+\n\Z")
        for arguments in (["--help"], ["mesh", "--help"], ["check", "-h"], ["info", "--help"], ["draw", "--help"]):
            done = self.run_it(*arguments)
            self.assert_done(done)
            self.assertIn("Usage:", done.stdout)
            self.assertEqual(done.stderr, "")

    def test_wrong_command_lines_are_told_in_one_line(self):
        out = self.path("a.vtu")
        for arguments in ([], ["frobnicate"], ["mesh"], ["mesh", self.plate, "-o"], ["check"], ["draw", "a.vtu"],
                          ["mesh", self.plate, "-o", out, "--frobnicate"], ["mesh", self.plate, self.plate, "-o", out],
                          ["mesh", self.plate, "-o", out, "--size"], ["info"], ["mesh", self.plate, "check"]):
            with self.subTest(arguments=arguments):
                done = self.run_it(*arguments)
                self.assert_done(done, 2)
                self.assertEqual(done.stdout, "")
                self.assertRegex(done.stderr, r"\Aquadline: [^\n]+\n\Z")
                self.assertFalse(os.path.exists(out))

    def test_numbers_and_choices(self):
        base = ["mesh", self.plate, "-o", self.path("a.vtu")]
        for option, text, expected in [
                ("--size", "abc", "a length above 0"), ("--size", "0", "a length above 0"),
                ("--size", "nan", "a length above 0"), ("--size", "inf", "a length above 0"),
                ("--size", "1e999", "a length above 0"), ("--size", "1,5", "a length above 0"),
                ("--growth", "1", "a number above 1 and up to 1e+06"), ("--edges-per-circle", "3", "a number from 4 to 10000"),
                ("--threads", "0", "a whole number from 1 to 1024"), ("--threads", "1.5", "a whole number from 1 to 1024"),
                ("--lines", "both", "'one-sided' or 'two-sided'"), ("--triangles", "x", "'delaunay', 'front' or 'both'"),
                ("--method", "paving", "'layout', 'qmorph', 'merge' or 'split'"), ("--tolerance", "0", "a length above 0"),
                ("--max-quads", "0.5", "a number from 1 to 1e+09")]:
            with self.subTest(option=option, text=text):
                self.assert_fails(2, "%s: expected %s, found '%s'" % (option, expected, text), *base, option, text)
        self.assert_fails(2, "--size: expected a length above 0, found '-1'", *base, "--size=-1")

    def test_outputs_are_checked_before_the_work(self):
        a = self.path("a.xyz")
        self.assert_fails(2, a + ": the format '.xyz' is unknown: use .vtu, .msh, .inp, .svg or .json",
                          "mesh", self.plate, "-o", a)
        self.assert_fails(2, "expected a file to write: give -o FILE", "mesh", self.plate)
        self.assert_fails(2, self.plate + ": would overwrite what is read from it: choose another name", "mesh", self.plate, "-o", self.plate)
        b = self.path("b.vtu")
        self.assert_fails(2, b + ": is given twice", "mesh", self.plate, "-o", b, "-o", b)
        self.assert_fails(2, os.path.relpath(b) + ": is given twice", "mesh", self.plate, "-o", b, "-o", os.path.relpath(b))
        limits = self.path("limits.json")
        self.assert_fails(2, limits + ": would overwrite what is read from it: choose another name", "mesh", self.plate, "-o", b, "--criteria", limits,
                          "--report", limits)
        poly, node = self.path("a.poly"), self.path("a.node")
        self.assert_fails(2, node + ": would overwrite what is read from it: choose another name", "mesh", poly, "--report", node)
        picture = self.path("a.svg")
        self.assert_fails(2, picture + ": would overwrite what is read from it: choose another name", "draw", picture, "-o", picture)
        self.assert_fails(2, "/dev/fd/1: is given twice", "mesh", self.plate, "-o", "vtu:/dev/stdout", "-o", "msh:/dev/fd/1")
        self.assert_fails(2, "vtu:: no file is named behind the format", "mesh", self.plate, "-o", "vtu:")
        self.assert_fails(2, "the name of a file to write is empty", "mesh", self.plate, "-o", "")
        self.assert_fails(2, "--criteria: expected a name, found nothing: see 'quadline mesh --help'", "mesh", self.plate, "-o", b, "--criteria", "")
        self.assert_fails(2, b + ": is no picture: use .svg", "draw", b, "-o", b)
        png = self.path("b.png")
        self.assert_fails(2, png + ": is no picture: use .svg", "draw", b, "-o", png)
        self.assert_fails(2, "/dev/stdout: the format '' is unknown: use .vtu, .msh, .inp, .svg or .json, or name the "
                          "format: vtu:/dev/stdout", "mesh", self.plate, "-o", "/dev/stdout")
        self.assert_fails(2, "standard output takes a file already: give --report FILE instead of --json",
                          "mesh", self.plate, "-o", "vtu:/dev/stdout", "--json")

    def test_what_is_missing_is_named_with_the_command_that_lacks_it(self):
        self.assert_fails(2, "MODEL is required: see 'quadline mesh --help'", "mesh")
        self.assert_fails(2, "MESH is required: see 'quadline check --help'", "check")

    def test_slips_of_the_pen_are_named(self):
        for words, message in [(["mesh", self.plate, "--sise", "3"], "unknown option '--sise': did you mean '--size'?"),
                               (["mesh", self.plate, "--quite"], "unknown option '--quite': did you mean '--quiet'?"),
                               (["check", "a.vtu", "--modle=m"], "unknown option '--modle': did you mean '--model'?"),
                               (["info", self.plate, "--colour"], "unknown option '--colour': see 'quadline info --help'"),
                               (["mehs"], "unknown command 'mehs': did you mean 'mesh'?"),
                               (["frobnicate"], "unknown command 'frobnicate': see 'quadline --help'")]:
            with self.subTest(words=words):
                self.assert_fails(2, message, *words)


class Mesh(CommandLine):
    def test_writes_every_file_asked_for_and_a_table(self):
        names = ["a.vtu", "a.msh", "a.inp", "a.svg", "a.json"]
        outputs = [word for name in names for word in ("-o", self.path(name))]
        done = self.run_it("mesh", *outputs, self.plate)
        self.assert_done(done)
        self.assertEqual(done.stderr, "")
        self.assertRegex(done.stdout, r"\Aplate: \d+ quads, \d+ nodes, \d+\.\d\d s\n")
        self.assertRegex(done.stdout, r"\non 1 line: (\d+) edges, (\d+) nodes\n")
        self.assertRegex(done.stdout, r"\ncells: 1 by Q-Morph \(\d+ quads\)\n")
        for word in ("beta, mean", "scaled Jacobian, least", "least angle", "edge length / size, median", "irregular nodes"):
            self.assertIn(word, done.stdout)
        for name in names:
            self.assertIn("written: " + self.path(name) + "\n", done.stdout)
            self.assertGreater(len(self.read(name)), 1000)
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(names + ["plate.json"]))

    def test_quiet_says_nothing(self):
        done = self.run_it("mesh", self.plate, "-o", self.path("a.vtu"), "--quiet")
        self.assert_done(done)
        self.assertEqual(done.stdout + done.stderr, "")

    def test_same_bytes_whatever_the_threads(self):
        many_cells = os.path.join(ROOT, "models", "structures", "annulus.json")
        for threads in ("1", "2", "7"):
            self.assert_done(self.run_it("mesh", many_cells, "--threads", threads, "-o", self.path(threads + ".vtu"),
                                         "-o", self.path(threads + ".inp")))
        self.assertEqual(self.read("1.vtu"), self.read("2.vtu"))
        self.assertEqual(self.read("1.vtu"), self.read("7.vtu"))
        self.assertEqual(self.read("1.inp"), self.read("7.inp"))

    def test_check_accepts_what_mesh_wrote(self):
        # also where no node of a circle lies just east of its centre
        for model in (self.put("hole.json", {"size": 1, "outer": [[0, 0], [12, 0], [12, 12], [0, 12]],
                                             "holes": [{"center": [6, 6], "radius": 1.5}]}),
                      self.put("ring.json", {"size": 1, "outer": {"center": [0, 0], "radius": 9},
                                             "holes": [{"center": [0, 0], "radius": 5, "edges": 36, "rings": 2}]})):
            mesh = self.path("mesh.msh")
            self.assert_done(self.run_it("mesh", model, "-o", mesh, "--quiet"))
            self.assert_done(self.run_it("check", mesh, "--model", model))

    def test_size_overrides_that_of_the_model(self):
        def count(*arguments):
            done = self.run_it("mesh", self.plate, "--json", *arguments)
            self.assert_done(done)
            return json.loads(done.stdout)["counts"]["quads"]
        self.assertGreater(count("--size", "0.5"), 2 * count())

    def test_methods(self):
        for method, stage in [("layout", "grid"), ("qmorph", "qmorph"), ("merge", "pair"), ("split", "halve")]:
            with self.subTest(method=method):
                out = self.path(method + ".json")
                done = self.run_it("mesh", self.plate, "-o", out, "--method", method, "--json")
                self.assert_done(done)
                report = json.loads(done.stdout)
                self.assertEqual(report["options"]["method"], method)
                self.assertIn(stage, [use["stage"] for use in report["stages"]])
                self.assert_done(self.run_it("check", out, "--model", self.plate, "--all-quad"))

    def test_report(self):
        report_file = self.path("r.json")
        done = self.run_it("mesh", self.plate, "-o", self.path("a.vtu"), "--report", report_file, "--json")
        self.assert_done(done)
        report = json.loads(done.stdout)
        self.assertEqual(report, json.loads(self.read("r.json")))
        self.assertTrue(report["ok"])
        self.assertIsNone(report["failure"])
        self.assertEqual(report["model"], {"file": self.plate, "name": "plate", "units": "mm"})
        self.assertEqual(report["options"]["size"], 1)
        self.assertEqual(report["files"], [self.path("a.vtu")])
        self.assertEqual(report["counts"]["triangles"], 0)
        self.assertGreater(report["tolerance"], 0)
        for when in ("before_smoothing", "after_smoothing"):
            quality = report["quality"][when]
            self.assertLessEqual(quality["scaled_jacobian"]["min"], quality["scaled_jacobian"]["p5"])
        self.assertIn(quality["verdict"], ("excellent", "good"))
        self.assertEqual([(line["name"], line["kind"]) for line in report["lines"]],
                         [("outer-1", "outer"), ("hole-1", "hole"), ("stiffener", "line")])
        for line in report["lines"]:
            self.assertGreater(line["edges"], 0)
            self.assertLessEqual(line["edge_to_size"]["min"], line["edge_to_size"]["mean"])
        self.assertEqual([quad["value"] for quad in report["worst"]], sorted(quad["value"] for quad in report["worst"]))
        self.assertEqual(len(report["worst"]), 5)
        self.assertEqual(report["worst"][0]["scaled_jacobian"], report["quality"]["after_smoothing"]["scaled_jacobian"]["min"])
        self.assertEqual(report["corners"]["forced"], [])  # a rectangle
        checked = json.loads(self.run_it("check", self.path("a.vtu"), "--model", self.plate, "--json").stdout)
        self.assertEqual(checked["quality"], report["quality"]["after_smoothing"])  # by the same sizes
        self.assertNotIn("edge_to_size", json.loads(self.run_it("check", self.path("a.vtu"), "--json").stdout)["quality"])
        self.assertEqual(sum(share["quads"] for share in report["cells"].values()), report["counts"]["quads"])
        self.assertEqual(sum(share["cells"] for share in report["cells"].values()), report["counts"]["cells"])
        counts = report["qmorph"]  # every quad of the normal step has two side edges and a top edge
        self.assertGreater(counts["steps"], 0)
        self.assertEqual(counts["steps"], sum(counts["states"].values()))
        self.assertEqual(2 * counts["steps"], sum(counts["side_edges"].values()))
        self.assertEqual(counts["steps"], sum(counts["top_edges"].values()))
        self.assertEqual(counts["completion"]["triangles"], 0)
        stages = [stage["stage"] for stage in report["stages"]]
        self.assertEqual([stages[0], stages[-1]], ["read", "write"])
        self.assertIn("qmorph", stages)
        peaks = [stage["peak_memory_bytes"] for stage in report["stages"]]
        self.assertEqual(peaks, sorted(peaks))
        self.assertGreater(peaks[0], 1e5)
        self.assertEqual(report["peak_memory_bytes"], peaks[-1])
        self.assertLessEqual(sum(stage["seconds"] for stage in report["stages"]), report["seconds"])

    def test_stages(self):
        self.assert_done(self.run_it("mesh", self.plate, "--stages", self.path("new/stages")))
        files = sorted(os.listdir(self.path("new/stages")))
        stages = ("triangulation", "field-points", "first-layer", "half-way", "before-smoothing", "clean-up", "smoothed")
        self.assertEqual(files, ["%02d-%s.%s" % (i + 1, stage, ending)
                                 for i, stage in enumerate(stages) for ending in ("svg", "vtu")])
        done = self.run_it("check", self.path("new/stages/01-triangulation.vtu"))
        self.assert_done(done)
        self.assertIn(" 0 quads, ", done.stdout)

    def test_findings_are_lines_on_standard_error(self):
        model = dict(PLATE, lines=PLATE["lines"] + [{"name": "again", "path": [[8, 2], [0, 2]]}])
        file = self.put("twice.json", model)
        done = self.run_it("mesh", file, "-o", self.path("a.vtu"))
        self.assert_done(done)
        self.assertRegex(done.stderr, r"\Aquadline: [^\n]*twice\.json: /lines/1/path: note: [^\n]+ at \([^\n]*\)\n\Z")
        done = self.run_it("mesh", file, "-o", self.path("a.vtu"), "--quiet")
        self.assertEqual(done.stderr, "")

    def test_what_the_mesh_lacks_is_told_even_when_quiet(self):
        gone = {"lines": [{"name": "a", "path": [[20, 1], [21, 1]]}]}
        trimmed = {"lines": [{"name": "a", "path": [[1 / 3, 2], [3, -2]]}]}
        over_edge = {"holes": [{"center": [12, 4], "radius": 1}]}
        for change, words in [(gone, r"/lines/0/path: warning: line 'a' lies outside the domain: dropped at \(20, 1\)"),
                              (trimmed, r"/lines/0/path: warning: line 'a' leaves the domain: trimmed at \(\S+, \S+\)"),
                              (over_edge, r"/holes/0: warning: 'hole-1' reaches over another loop: [^\n]+ at \(\S+, \S+\)"),
                              ({"points": [{"name": "p", "at": [9, 5]}]}, r"/points/0: warning: point 'p' [^\n]+ at \(9, 5\)"),
                              ({"regions": [{"name": "r", "at": [9, 5]}]}, r"/regions/0: warning: region 'r' [^\n]+")]:
            with self.subTest(change=change):
                file = self.put("m.json", dict(PLATE, **change))
                done = self.run_it("mesh", file, "-o", self.path("a.vtu"), "--quiet")
                self.assert_done(done)
                self.assertEqual(done.stdout, "")
                self.assertRegex(done.stderr, r"\Aquadline: [^\n]*m\.json: " + words + r"\n\Z")
                self.assertTrue(json.loads(self.run_it("info", file, "--json").stdout)["findings"][0]["loss"])

    def test_places_are_told_with_nine_digits(self):
        file = self.put("m.json", dict(PLATE, points=[{"name": "p", "at": [12.123456789012345, 1 / 3]}]))
        done = self.run_it("mesh", file, "--json")
        self.assertIn(" at (12.1234568, 0.333333333)\n", done.stderr)
        self.assertEqual(json.loads(done.stdout)["findings"][0]["at"], [12.123456789012345, 1 / 3])

    def test_a_loop_that_crosses_itself_is_told_where(self):
        bow = [[1, 1], [5, 5], [5, 1], [1, 5]]  # its two halves cancel out: no area all in all
        for model, place, name in [({"size": 1, "outer": bow}, "/outer", "outer-1"),
                                   (dict(PLATE, holes=[bow]), "/holes/0", "hole-1")]:
            file = self.put("bow.json", model)
            self.assert_fails(2, file + ": " + place + ": loop '" + name + "' crosses itself: give its points in order "
                              "round it at (3, 3)", "mesh", file, "--json")

    def test_the_size_overrides_the_areas_of_a_poly(self):
        file = self.put("areas.poly", POLY + "1\n1 2 1.5 7 0.01\n")
        def count(size):
            return json.loads(self.run_it("info", file, "--size", size, "--json").stdout)["expected_quads"]
        self.assertAlmostEqual(count("1"), 12, 6)
        done = self.run_it("mesh", file, "--size", "1", "--json")
        self.assertLess(json.loads(done.stdout)["counts"]["quads"], 30)

    def test_poly_needs_a_size(self):
        file = self.put("square.poly", POLY)
        out = self.path("a.vtu")
        self.assert_fails(2, file + ": the model gives no target size: give --size H", "mesh", file, "-o", out)
        self.assert_done(self.run_it("mesh", file, "-o", out, "--size", "0.5"))
        self.assert_done(self.run_it("check", out, "--model", file))

    def test_absurd_sizes_are_refused(self):
        out = self.path("a.vtu")
        done = self.run_it("mesh", self.plate, "-o", out, "--size", "1e-6")
        self.assert_done(done, 2)
        self.assertRegex(done.stderr, r"about [89]\.\de\+13 quads are expected, more than 5e\+07: [^\n]+\n\Z")
        self.assertEqual(self.run_it("mesh", self.plate, "-o", out, "--max-quads", "10").returncode, 2)
        line = dict(PLATE, lines=[{"name": "a", "path": [[0, 2], [8, 2]], "size": 1e-9}])
        self.assertEqual(self.run_it("mesh", self.put("fine.json", line), "-o", out).returncode, 2)
        self.assertFalse(os.path.exists(out))


class WrongInput(CommandLine):
    def test_the_message_names_file_and_path(self):
        out = self.path("a.vtu")
        for name, content, message in [
                ("a.json", "", "the file is empty"),
                ("b.json", "{\"outer\": [[0, 0],", "line 1, column 19: no valid JSON: unexpected end of input"),
                ("c.json", dict(PLATE, outer=[[0, 0], [1, "x"], [1, 1]]), "/outer/1/1: expected a number, found the text 'x'"),
                ("d.json", dict(PLATE, linse=[]), "/linse: unknown key 'linse': did you mean 'lines'?"),
                ("e.poly", "4 2\n1 0\n", "line 2: expected the y coordinate, found the end of the line")]:
            with self.subTest(name=name):
                file = self.put(name, content)
                for command in (["mesh", file, "-o", out], ["info", file]):
                    done = self.run_it(*command)
                    self.assert_done(done, 2)
                    self.assertTrue(done.stderr.startswith("quadline: " + file + ": " + message), done.stderr)
                    self.assertEqual(done.stderr.count("\n"), 1)
        self.assertFalse(os.path.exists(out))

    def test_files_that_cannot_be_read(self):
        gone = self.path("gone.json")
        self.assert_fails(2, gone + ": cannot be read: No such file or directory", "info", gone)
        folder = self.path("folder.json")
        os.mkdir(folder)
        self.assert_fails(2, folder + ": cannot be read: Is a directory", "info", folder)
        self.assert_fails(2, folder + ": cannot be read: Is a directory", "check", folder)
        self.assertEqual(self.run_it("check", self.plate).returncode, 2)  # a model is no mesh

    def test_geometry_that_cannot_be_mended_names_a_place(self):
        flat = self.put("flat.json", {"size": 1, "outer": [[0, 0], [1, 0], [2, 0]]})
        done = self.run_it("mesh", flat, "-o", self.path("a.vtu"))
        self.assert_done(done, 2)
        self.assertRegex(done.stderr, r"\Aquadline: [^\n]+flat\.json: /outer[^\n]*: [^\n]+\n\Z")


class Writing(CommandLine):
    def test_what_stood_there_stays_where_writing_fails(self):
        self.put("a.vtu", "old")

        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
        done = self.run_it("mesh", self.plate, "-o", self.path("a.vtu"), preexec_fn=small_files)
        self.assert_done(done, 4)
        self.assertEqual(done.stderr, "quadline: " + self.path("a.vtu") + ": cannot be written: File too large\n")
        self.assertEqual(self.read("a.vtu"), b"old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.vtu", "plate.json"])

    def test_places_that_cannot_be_written_are_found_before_the_work(self):
        out = self.path("none/a.vtu")
        self.assert_fails(4, out + ": cannot be written: its folder does not exist", "mesh", self.plate, "-o", out)
        os.mkdir(self.path("b.vtu"))
        self.assert_fails(4, self.path("b.vtu") + ": cannot be written: it is a folder",
                          "mesh", self.plate, "-o", self.path("a.vtu"), "-o", self.path("b.vtu"))
        done = self.run_it("mesh", self.plate, "--stages", self.plate)
        self.assert_done(done, 4)

    def test_full_disk(self):
        self.assert_fails(4, "/dev/full: cannot be written: No space left on device",
                          "mesh", self.plate, "--report", "/dev/full", "--quiet")
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([QUADLINE, "info", self.plate], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assert_done(subprocess.CompletedProcess([], done.returncode, "", done.stderr), 4)
        self.assertIn("standard output cannot be written: No space left on device", done.stderr)


class Interrupts(CommandLine):
    def interrupted(self, sign):
        self.put("a.vtu", "old")
        process = subprocess.Popen([QUADLINE, "mesh", self.plate, "--size", "0.008", "-o", self.path("a.vtu"),
                                    "--report", self.path("r.json")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(0.7)
        self.assertIsNone(process.poll(), "the work was over before it could be interrupted")
        process.send_signal(sign)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertEqual((out, err), ("", "quadline: interrupted\n"))
        self.assertEqual(self.read("a.vtu"), b"old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.vtu", "plate.json"])

    def test_interrupt_leaves_nothing_half_written(self):
        self.interrupted(signal.SIGINT)

    def test_terminate_does_too(self):
        self.interrupted(signal.SIGTERM)

    def test_reading_from_a_silent_pipe_ends_too(self):
        pipe = self.path("pipe.json")
        os.mkfifo(pipe)
        process = subprocess.Popen([QUADLINE, "info", pipe], stderr=subprocess.PIPE, text=True)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=20)[1], "quadline: interrupted\n")
        self.assertEqual(process.returncode, 130)


class Progress(CommandLine):
    def on_terminal(self, *arguments):
        """What the program writes to a terminal."""
        master, slave = pty.openpty()
        process = subprocess.Popen([QUADLINE, *arguments], stdout=subprocess.DEVNULL, stderr=slave,
                                   env=dict(os.environ, TERM="xterm"))
        os.close(slave)
        shown = b""
        while select.select([master], [], [], 120)[0]:
            try:
                piece = os.read(master, 4096)
            except OSError:  # the other end was closed
                break
            if not piece:
                break
            shown += piece
        os.close(master)
        self.assertEqual(process.wait(timeout=120), 0)
        return shown.decode()

    def test_a_bar_on_a_terminal_only(self):
        work = ["mesh", self.plate, "--size", "0.07", "-o", self.path("a.vtu")]
        shown = self.on_terminal(*work)
        self.assertRegex(shown, r"\r\x1b\[K\[#*\.*\] +\d+ %  [a-z -]+  \d+\.\d s")
        self.assertTrue(shown.endswith("\r\x1b[K"), "the bar is wiped away")
        self.assertEqual(self.on_terminal(*work, "--quiet"), "")
        self.assertEqual(self.run_it(*work).stderr, "")


class LocalSizes(CommandLine):
    def test_check_counts_as_mesh_does(self):
        fine = dict(PLATE, lines=[dict(PLATE["lines"][0], size=0.1)])
        model, out = self.put("fine.json", fine), self.path("a.msh")
        limits = self.put("limits.json", {"min_edge_to_size": 0.5, "max_growth": 3})
        meshed = json.loads(self.run_it("mesh", model, "-o", out, "--criteria", limits, "--json").stdout)["criteria"]
        checked = json.loads(self.run_it("check", out, "--model", model, "--criteria", limits, "--json").stdout)["criteria"]
        self.assertEqual(checked, meshed)
        coarse = json.loads(self.run_it("check", out, "--model", self.plate, "--criteria", limits, "--json").stdout)["criteria"]
        self.assertGreater(coarse["failing"], 10 * meshed["failing"])  # by the size of the plate, 1


class Corners(CommandLine):
    def test_a_sharp_corner_is_told_with_what_it_allows(self):
        model = self.put("wedge.json", {"size": 1, "outer": [[0, 0], [12, 0], [12, 12 * 3 ** -0.5]]})
        done = self.run_it("mesh", model, "-o", self.path("a.msh"), "--json")
        self.assert_told(json.loads(done.stdout)["corners"])
        checked = json.loads(self.run_it("check", self.path("a.msh"), "--model", model, "--json").stdout)
        self.assert_told(checked["corners"])
        self.assertIn("allow a least scaled Jacobian of 0.500", self.run_it("mesh", model, "-o", self.path("b.msh")).stdout)
        self.assertNotIn("corners", json.loads(self.run_it("check", self.path("a.msh"), "--json").stdout))

    def assert_told(self, corners):
        (corner,) = corners["forced"]  # that of 60 degrees is not among them
        self.assertEqual([corner["at"], corner["quads"]], [[0, 0], 1])
        self.assertAlmostEqual(corner["angle_deg"], 30, 9)
        self.assertAlmostEqual(corner["sj_bound"], 0.5, 9)
        self.assertAlmostEqual(corners["sj_bound"], 0.5, 9)
        self.assertAlmostEqual(corners["sj_min_over_bound"], corners["sj_min"] / corners["sj_bound"], 9)


class Check(CommandLine):
    def test_a_mesh_of_ours_is_valid(self):
        out = self.path("a.msh")
        self.assert_done(self.run_it("mesh", self.plate, "-o", out, "--quiet"))
        done = self.run_it("check", out, "--model", self.plate, "--all-quad")
        self.assert_done(done)
        self.assertIn("valid: yes\nagainst the model: kept: " + self.plate + "\n", done.stdout)
        self.assertNotIn("against the model", self.run_it("check", out).stdout)
        for word in ("beta", "scaled Jacobian", "least angle", "edge length", "irregular nodes"):
            self.assertIn(word, done.stdout)
        done = self.run_it("check", out, "--criteria", "csr-fine", "--json")
        criteria = json.loads(done.stdout)["criteria"]
        self.assertEqual({limit["name"]: limit["limit"] for limit in criteria["limits"]},
                         {"min_angle_deg": 45, "max_angle_deg": 135, "max_aspect": 3})
        self.assertEqual(criteria["failing"], 0)
        self.assertIn("csr-fine: 0 quads fail", self.run_it("check", out, "--criteria", "csr-fine").stdout)
        self.assert_fails(2, "no criteria are called 'fine-csr': use csr-fine, hypermesh-10mm, growth or a .json file", "check", out, "--criteria", "fine-csr")
        limits = self.path("limits.json")
        for text, message in (('{"max_aspct": 2}', "/max_aspct: unknown limit 'max_aspct': did you mean 'max_aspect'?"),
                              ('{"min_edge": "1"}', "/min_edge: expected a number"),
                              ('{"min_edge": 2, "max_edge": 1}',
                               "/min_edge: is above 'max_edge': nothing can keep both"),
                              ("[1]", "expected an object of limits")):
            with open(limits, "w", encoding="utf-8") as file:
                file.write(text)
            self.assert_fails(2, limits + ": " + message, "check", out, "--criteria", limits)
            self.assert_fails(2, limits + ": " + message, "mesh", self.plate, "-o", self.path("no.vtu"),
                              "--criteria", limits)
        with open(limits, "w", encoding="utf-8") as file:
            file.write('{"max_edge_to_size": 0.1}')
        quads = json.loads(self.run_it("check", out, "--json").stdout)["quality"]["quads"]
        checked = json.loads(self.run_it("check", out, "--criteria", limits, "--json").stdout)["criteria"]
        self.assertEqual([checked["limits"][0]["checked"], checked["failing"]], [False, 0])  # of no known size
        with_size = ("check", out, "--criteria", limits, "--model", self.plate, "--json")
        self.assertEqual(json.loads(self.run_it(*with_size).stdout)["criteria"]["failing"], quads)
        done = self.run_it("mesh", self.plate, "--criteria", limits, "--json")
        self.assertEqual(done.returncode, 0)  # valid all the same
        told = json.loads(done.stdout)["criteria"]
        self.assertEqual([told["name"], told["failing"], len(told["limits"][0]["worst"])], [limits, quads, 5])
        done = self.run_it("check", out, "--model", self.plate, "--json")
        self.assert_done(done)
        verdict = json.loads(done.stdout)
        self.assertTrue(verdict["valid"])
        self.assertEqual(verdict["model"], {"file": self.plate, "kept": True, "broken": None})
        self.assertEqual({fault["count"] for fault in verdict["faults"]}, {0})

    def test_a_mesh_that_misses_a_line_is_not_what_the_model_asks_for(self):
        out = self.path("a.msh")
        self.assert_done(self.run_it("mesh", self.plate, "-o", out, "--quiet"))
        more = dict(PLATE, lines=PLATE["lines"] + [{"name": "other", "path": [[2, 3.1], [7, 7.3]]}])
        done = self.run_it("check", out, "--model", self.put("more.json", more))
        self.assert_done(done, 3)
        self.assertIn("valid: no\n", done.stdout)
        self.assertRegex(done.stdout, r"  - against the model: [^\n]+ at \(")

    def test_faults_are_named_with_a_place(self):
        done = self.run_it("check", self.put("seam.inp", SEAM))
        self.assert_done(done, 3)
        self.assertIn("  - 2 nodes at the place of another, the first at (1, 0)\n", done.stdout)
        verdict = json.loads(self.run_it("check", self.path("seam.inp"), "--json").stdout)
        self.assertFalse(verdict["valid"])
        self.assertEqual([fault["count"] for fault in verdict["faults"] if fault["count"]], [2])

    def test_triangles_count_only_where_quads_are_asked_for(self):
        mesh = self.put("t.inp", "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 1, 1\n*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 2, 4, 3\n")
        self.assert_done(self.run_it("check", mesh))
        done = self.run_it("check", mesh, "--all-quad")
        self.assert_done(done, 3)
        self.assertIn("not all elements are quads", done.stdout)


class InfoAndDraw(CommandLine):
    def test_info_tells_what_the_model_holds(self):
        done = self.run_it("info", self.plate)
        self.assert_done(done)
        for line in ("size: 1 mm", "outer loops: 1", "holes: 1", "lines: 1", "points: 1", "regions: 1", "cells: 1",
                     "mended: 0 findings"):
            self.assertIn("  " + line + "\n", done.stdout)
        info = json.loads(self.run_it("info", self.plate, "--json").stdout)
        self.assertTrue(info["ok"])
        self.assertAlmostEqual(info["area"], 12 * 8 - 3.14159265358979 * 1.5 ** 2, 6)
        self.assertEqual(info["box"], [[0, 0], [12, 8]])
        self.assertTrue(50 < info["expected_quads"] < 150)

    def test_info_tells_what_is_wrong(self):
        file = self.put("wrong.json", dict(PLATE, holes=[{"center": [1, 1]}]))
        self.assert_fails(2, file + ": /holes/0: 'radius' is missing", "info", file)
        done = self.run_it("info", file, "--json")
        self.assert_done(done, 2)
        info = json.loads(done.stdout)
        self.assertFalse(info["ok"])
        self.assertEqual(info["place"], "/holes/0")

    def test_draw(self):
        self.assert_done(self.run_it("mesh", self.plate, "-o", self.path("a.vtu"), "--quiet"))
        done = self.run_it("draw", self.path("a.vtu"), "-o", self.path("a.svg"))
        self.assert_done(done)
        self.assertIn(b"<svg", self.read("a.svg"))
        self.assertEqual(done.stdout + done.stderr, "")


if __name__ == "__main__":
    unittest.main()
