"""Bad input: every model is either meshed, with a finding where something was mended, or refused in one line that says what and where."""
import base64
import json
import random
import struct
import unittest
import zlib

from test_command_line import POLY, CommandLine

PLATE = [[0, 0], [12, 0], [12, 8], [0, 8]]
FAR = 1e15


def plate(**more):
    return dict({"size": 1, "outer": PLATE}, **more)


def circle(x, y, radius, **asked):
    return dict({"center": [x, y], "radius": radius}, **asked)


# What is meshed, and the finding that goes with it; "": none.
TAKEN = {
    "open loop": ({"size": 1, "outer": PLATE}, ""),
    "closed loop": ({"size": 1, "outer": PLATE + PLATE[:1]}, ""),
    "clockwise loop": ({"size": 1, "outer": PLATE[::-1]}, ""),
    "repeated points": ({"size": 1, "outer": PLATE[:2] + PLATE[1:]}, "note: 'outer-1' has 1 repeated point: dropped at (12, 0)"),
    "a hole twice": (plate(holes=[circle(6, 4, 2)] * 2), "note: 'hole-2' runs along 'hole-1': one curve for both"),
    "a hole in a hole": (plate(holes=[circle(6, 4, 3), circle(6, 4, 1)]), "warning: 'hole-2' lies in another hole"),
    "a hole that touches the edge": (plate(holes=[[[0, 2], [3, 1], [3, 3]]]), "note: 'hole-1' touches 'outer-1' at (0, 2)"),
    "a hole over the edge": (plate(holes=[circle(12, 4, 1)]), "warning: 'hole-1' reaches over another loop"),
    "a line outside": (plate(lines=[{"path": [[20, 1], [30, 1]]}]), "warning: line 'line-1' lies outside the domain: dropped"),
    "a line that leaves": (plate(lines=[{"path": [[6, 4], [6, 9]]}]), "warning: line 'line-1' leaves the domain: trimmed at (6, "),
    "a line without length": (plate(lines=[{"path": [[2, 2], [2, 2]]}]), "warning: 'line-1' has no length: dropped at (2, 2)"),
    "a line twice": (plate(lines=[{"path": [[2, 2], [5, 2]]}] * 2), "note: 'line-2' runs along 'line-1'"),
    "a point outside": (plate(points=[{"name": "p", "at": [20, 1]}]), "warning: point 'p' lies outside the domain: dropped at (20, 1)"),
    "a point twice": (plate(points=[{"name": "p", "at": [3, 3]}] * 2), "note: the name 'p' is given twice"),
    "a region outside": (plate(regions=[{"name": "r", "at": [20, 1]}]), "warning: region 'r' lies outside the domain: ignored"),
    "rings that fit": (plate(holes=[circle(6, 4, 1, rings=2, ring_width=0.5, edges=16)]), ""),
    "rings at an edge": (plate(holes=[circle(2, 4, 1, rings=2, ring_width=0.5)]), "/holes/0: warning: 'hole-1' gets 1 of 2 rings: 'outer-1' is in the way; ask for fewer or thinner rings, or move it; a third of their width stays free at (0, 4)"),
    "rings on a line": (plate(holes=[circle(6, 4, 1, rings=1)], lines=[{"name": "a", "path": [[0, 4], [5, 4]]}]), "/holes/0: warning: 'hole-1' gets no rings: 'a' is in the way; ask for fewer or thinner rings, or move it; a third of their width stays free at (5, 4)"),
    "rings beside rings": (plate(holes=[circle(4, 4, 1, ring_width=1), circle(7.5, 4, 1, ring_width=1)]), "/holes/1: warning: 'hole-2' gets no rings: the rings of 'hole-1' are in the way"),
    "rings beyond all": (plate(holes=[circle(6, 4, 1, ring_width=1e60)]), "/holes/0: warning: 'hole-1' gets no rings: 'outer-1' is in the way"),
    "rings like a hair": (plate(holes=[circle(6, 4, 1, ring_width=1e-300)]), "/holes/0: warning: 'hole-1' gets no rings: they are hardly wider than the tolerance"),
    "edges of a hole over the edge": (plate(holes=[circle(12, 4, 1, edges=16)]), "/holes/0: warning: 'hole-1' gets no edges or rings of its own: it does not lie in the domain as a whole at (13, 4)"),
    "denormal detail": ({"size": 1, "outer": [[0, 0], [12, 5e-324], [12, 8], [0, 8]]}, ""),
    "a size beyond the model": (plate(size=1e300), ""),
    "empty lists": (plate(holes=[], lines=[], points=[], regions=[]), ""),
}
# What is refused, and how.
REFUSED = {
    "crossed loop": ({"size": 1, "outer": [[0, 0], [4, 4], [4, 0], [0, 4]]}, "/outer: loop 'outer-1' crosses itself: give its points in order round it at (2, 2)"),
    "crossed hole": (plate(holes=[[[1, 1], [5, 5], [5, 1], [1, 6]]]), "/holes/0: loop 'hole-1' crosses itself: give its points in order"),
    "a loop twice": ({"size": 1, "outer": [PLATE, PLATE]}, "/outer/1: loops 'outer-1' and 'outer-2' overlap: make one loop of them at ("),
    "a loop in a loop": ({"size": 1, "outer": [PLATE, [[1, 1], [2, 1], [2, 2]]]}, "/outer/1: loop 'outer-2' lies inside another outer loop"),
    "a loop without area": ({"size": 1, "outer": [[0, 0], [1, 1], [2, 2]]}, "/outer: loop 'outer-1' has no area: it needs three distinct points, in order round it at (0, 0)"),
    "a loop there and back": ({"size": 1, "outer": [[0, 0], [4, 0], [4, 4], [4, 0]]}, "/outer: loop 'outer-1' has no area"),
    "a loop that is a point": ({"size": 1, "outer": [[1, 1]] * 4}, "/outer: the outer loop has no area: it needs three distinct points"),
    "a hole without area": (plate(holes=[[[1, 1], [2, 2], [3, 3]]]), "/holes/0: loop 'hole-1' has no area"),
    "a hole outside": (plate(holes=[circle(50, 5, 1)]), "/holes/0: loop 'hole-1' lies outside every outer loop: move it inside, or take it out at (51, 5)"),
    "nothing but hole": (plate(holes=[PLATE]), "/outer: nothing is left of the domain: the holes cover it all at (0, 0)"),
    "huge coordinates": ({"size": 1, "outer": [[0, 0], [1e300, 0], [1e300, 1e300]]}, "/outer/1: a coordinate is larger than 1e60: use other units at (1e+300, 0)"),
    "a huge circle": ({"size": 1, "outer": circle(0, 0, 1e300)}, "/outer: the radius of a circle is larger than 1e60: use other units at (0, 0)"),
    "denormal coordinates": ({"size": 1, "outer": [[0, 0], [1e-310, 0], [1e-310, 1e-310]]}, "/outer: the outer loop has no area"),
    "far from the origin": ({"size": 1, "outer": [[FAR + x, FAR + y] for x, y in PLATE]}, "/outer: the domain is too small for its distance from the origin: move it nearer at (1e+15, 1e+15)"),
    "a point far off": (plate(points=[{"at": [1e9, 0]}]), "/points/0: a point lies ten thousand times farther off than the domain is large: check its coordinates at (1e+09, 0)"),
    "an arc without shape": (plate(lines=[{"path": [[1, 1], {"to": [1, 1], "via": [2, 2]}]}]), "/lines/0/path/1: an arc ends where it starts: give a circle, or two arcs at (1, 1)"),
    "a size too small for the coordinates": (plate(points=[{"name": "p", "at": [6, 4], "size": 1e-300}]), "/points/0: the size of point 'p' is too small beside the coordinates: give 1.1e-11 at least"),
    "a size of zero": (plate(size=0), "/size: expected a length above 0, found the number 0"),
    "a negative size": (plate(lines=[{"path": [[1, 1], [2, 2]], "size": -1}]), "/lines/0/size: expected a length above 0, found the number -1"),
    "a denormal size": (plate(size=5e-324), "/size: the size of the model is too small beside the coordinates: give 1.1e-11 at least"),
    "a hole in a billion quads": (plate(size=3.1e-4, holes=[{"center": [5, 3], "radius": 1}]), "about 9.7e+08 quads are expected, more than 5e+07: choose a larger size, or raise --max-quads"),
    "a billion quads": (plate(size=3.1e-4), "about 1e+09 quads are expected, more than 5e+07: choose a larger size, or raise --max-quads"),
    "no size": ({"outer": PLATE}, "the model gives no target size: give --size H"),
    "a radius of zero": (plate(holes=[circle(5, 5, 0)]), "/holes/0/radius: expected a length above 0, found the number 0"),
    "a ring without width": (plate(holes=[circle(5, 4, 1, ring_width=0)]), "/holes/0/ring_width: expected a length above 0, found the number 0"),
    "a negative ring": (plate(holes=[circle(5, 4, 1, ring_width=-9)]), "/holes/0/ring_width: expected a length above 0, found the number -9"),
    "a huge ring": (plate(holes=[circle(5, 4, 1, ring_width=1e300)]), "/holes/0: the width of a ring is not a positive number up to 1e60 at (5, 4)"),
    "no rings": (plate(holes=[circle(5, 4, 1, rings=0)]), "/holes/0/rings: expected a whole number from 1 to 100, found the number 0"),
    "half a ring": (plate(holes=[circle(5, 4, 1, rings=1.5)]), "/holes/0/rings: expected a whole number from 1 to 100, found the number 1.5"),
    "rings without end": (plate(holes=[circle(5, 4, 1, rings=1e300)]), "/holes/0/rings: expected a whole number from 1 to 100, found the number 1e+300"),
    "odd edges": (plate(holes=[circle(5, 4, 1, edges=23)]), "/holes/0/edges: expected an even number from 4 to 1000000, found the number 23"),
    "two edges": (plate(holes=[circle(5, 4, 1, edges=2)]), "/holes/0/edges: expected an even number from 4 to 1000000, found the number 2"),
    "edges of a billion": (plate(holes=[circle(5, 4, 1, edges=1e9)]), "/holes/0/edges: expected an even number from 4 to 1000000, found the number 1e+09"),
    "edges in words": (plate(holes=[circle(5, 4, 1, edges="24")]), "/holes/0/edges: expected a number, found the text '24'"),
    "rings of a million edges": (plate(holes=[circle(5, 4, 1, edges=1000000, rings=100)]), "/holes/0: the rings alone need more quads than allowed: ask for fewer, or raise --max-quads at (5, 4)"),
    "rings round the domain": ({"size": 1, "outer": circle(5, 4, 4, rings=1)}, "/outer/rings: rings lie round holes and round lines: take it out"),
    "rings beside the path": (plate(lines=[{"path": circle(5, 4, 1), "rings": 1}]), "/lines/0/rings: this key belongs to the circle: move it into 'path'"),
    "null": (plate(holes=None), "/holes: expected a list [...], found nothing (null)"),
    "a text for a number": ({"size": 1, "outer": [[0, "0"], [1, 0], [1, 1]]}, "/outer/0/1: expected a number, found the text '0'"),
    "three coordinates": ({"size": 1, "outer": [[0, 0, 0], [1, 0, 0], [1, 1, 0]]}, "/outer/0: expected a point [x, y], found a list of 3"),
    "a list": ([plate()], "expected a model {...}, found a list of 1"),
}
SQUARE = b'"outer": [[0, 0], [4, 0], [4, 3], [0, 3]]'
BYTES = {
    "empty": (b"", "the file is empty"),
    "blank": (b" \r\n\t", "the file is empty"),
    "cut short": (b'{"size": 1, ' + SQUARE[:-3], "line 1, column "),
    "NaN": (b'{"size": NaN, ' + SQUARE + b"}", "line 1, column 10: no valid JSON: invalid literal"),
    "Infinity": (b'{"size": -Infinity, ' + SQUARE + b"}", "line 1, column 11: no valid JSON: "),
    "beyond a double": (b'{"size": 1e400, ' + SQUARE + b"}", "/size: the number 1e400 is too large"),
    "deep lists": (b'{"outer": ' + b"[" * 100000, "lists or objects nested more than 64 deep"),
    "deep objects": (b'{"x-a":' * 100000, "lists or objects nested more than 64 deep"),
    "a key twice": (b'{"size": 1, "size": 2, ' + SQUARE + b"}", "/size: the key 'size' stands twice in this object: take one out"),
    "Latin 1": (b'{"size": 1, "name": "\xe9", ' + SQUARE + b"}", "line 1, column 23: no valid JSON: invalid string: ill-formed UTF-8 byte"),
    "UTF-16": ('{"size": 1}'.encode("utf-16"), "is UTF-16: save it as UTF-8"),
    "two documents": (b'{"size": 1, ' + SQUARE + b"}{}", "line 1, column "),
}
HEAD = "# a square\r\n\n 4 2 1 1 # two dimensions, an attribute, a marker\n"
VERTICES = [(0, 0), (4, 0), (4, 3), (0, 3)]


def poly(first=1, tail="0\n", head="4 2 0 0\n", more=""):
    text = head + "".join("%d %g %g%s\n" % (i + first, x, y, more) for i, (x, y) in enumerate(VERTICES))
    return text + "4 0\n" + "".join("%d %d %d\n" % (i + first, i + first, (i + 1) % 4 + first) for i in range(4)) + tail


POLY_TAKEN = {
    "from one": poly(), "from zero": poly(first=0), "from seven": poly(first=7), "with a byte order mark": "\ufeff" + poly(),
    "comments, attributes and markers": poly(head=HEAD, more=" 2.5 7 # corner"), "CRLF": poly().replace("\n", "\r\n"),
    "regions": poly(tail="0\n1\n1 1 1 7 0.5\n"), "no end of line": poly().rstrip("\n"),
}
POLY_REFUSED = {
    "empty": ("", "expected the number of vertices, found the end of the file"),
    "a missing point": (poly().replace("3 3 4", "3 3 9"), "line 9: there is no vertex 9: they go from 1 to 4"),
    "a point below the first": (poly().replace("3 3 4", "3 0 4"), "line 9: there is no vertex 0: they go from 1 to 4"),
    "a gap": (poly().replace("3 4 3\n", "5 4 3\n"), "line 4: vertices must be numbered without gaps: expected vertex 3"),
    "cut short": (poly()[:30], "line 5: expected the y coordinate, found the end of the line"),
    "three dimensions": (poly(head="4 3 0 0\n"), "line 1: the dimension must be 2"),
    "NaN": (poly().replace("2 4 0", "2 nan 0"), "line 3: the x coordinate is not a finite number"),
    "infinity": (poly().replace("2 4 0", "2 inf 0"), "line 3: the x coordinate is not a finite number"),
    "beyond a double": (poly().replace("2 4 0", "2 1e400 0"), "line 3: expected the x coordinate, found '1e400'"),
    "a count that lies": (poly(head="4000000000 2 0 0\n"), "line 1: too many vertices"),
    "a negative count": (poly(head="-4 2 0 0\n"), "line 1: the number of vertices is negative"),
    "words": (poly().replace("2 4 0", "2 four 0"), "line 3: expected the x coordinate, found 'four'"),
    "more than it says": (poly(tail="0\n0\n9 9\n"), "line 13: expected the end of the file after 0 regions"),
    "no loop": ("2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 2\n0\n", "the segments close no loop that is not a hole: nothing is left to mesh"),
}


class BadInput(CommandLine):
    def put_bytes(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)
        return self.path(name)

    def assert_refused(self, file, message):
        done = self.run_it("mesh", file, *(["--size", "1"] if file.endswith(".poly") else []), "-o", self.path("a.vtu"))
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr[:500])
        start = "quadline: " + file + ": "
        self.assertTrue(done.stderr.startswith(start), done.stderr[:500])
        self.assertIn(message, done.stderr[len(start):])
        self.assertEqual(done.stderr.find("\n"), len(done.stderr) - 1)
        self.assertLess(len(done.stderr), len(start) + 600)

    def test_models_that_are_mended(self):
        for name, (model, finding) in TAKEN.items():
            with self.subTest(name=name):
                file = self.put("m.json", model)
                done = self.run_it("mesh", file, "-o", self.path("a.vtu"))
                self.assert_done(done)
                self.assertEqual(done.stderr == "", finding == "", done.stderr)
                self.assertIn(finding, done.stderr)
                checked = self.run_it("check", self.path("a.vtu"), "--model", file)
                self.assert_done(checked)

    def test_models_that_are_refused(self):
        for name, (model, message) in REFUSED.items():
            with self.subTest(name=name):
                self.assert_refused(self.put("m.json", model), message)

    def test_files_that_are_no_model(self):
        for name, (content, message) in BYTES.items():
            with self.subTest(name=name):
                self.assert_refused(self.put_bytes("m.json", content), message)

    def test_large_noise(self):
        noise = random.Random(1).randbytes(3 << 20)
        brackets = bytes(random.Random(2).choices(b'[]{}",:0123456789eE.-+ \n', k=3 << 20))
        for content in (noise, brackets, b'{"outer": [' + brackets):
            for name in ("m.json", "m.poly"):
                self.assert_refused(self.put_bytes(name, content), "")
        for name in ("m.vtu", "m.msh", "m.inp", "m.vtk"):
            done = self.run_it("check", self.put_bytes(name, noise))
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1))

    def test_every_cut_of_a_model_is_refused(self):
        whole = json.dumps(plate(lines=[{"name": "a", "path": [[1, 1], {"to": [3, 1], "via": [2, 2]}]}])).encode()
        for n in range(0, len(whole), 7):
            self.assert_refused(self.put_bytes("m.json", whole[:n]), "")

    def test_line_ends_and_byte_order_marks(self):
        text = json.dumps(plate(), indent=1)
        for content in (text.replace("\n", "\r\n"), text.replace("\n", "\r"), "\ufeff" + text):
            self.assert_done(self.run_it("info", self.put_bytes("m.json", content.encode())))

    def test_poly(self):
        for name, text in POLY_TAKEN.items():
            with self.subTest(name=name):
                file = self.put_bytes("m.poly", text.encode())
                done = self.run_it("mesh", file, "--size", "1", "--json")
                self.assert_done(done)
                self.assertEqual(json.loads(done.stdout)["counts"]["quads"], 12)
        for name, (text, message) in POLY_REFUSED.items():
            with self.subTest(name=name):
                self.assert_refused(self.put_bytes("m.poly", text.encode()), message)
        self.assert_done(self.run_it("info", self.put("m.poly", POLY), "--size", "1"))

    def test_an_array_that_inflates_to_far_more_than_a_mesh(self):
        size = 1 << 26
        block = zlib.compress(bytes(size), 9)
        data = base64.b64encode(struct.pack("<4Q", 1, size, 0, len(block))) + base64.b64encode(block)
        vtu = b"""<VTKFile type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">
<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="0"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="binary">%s</DataArray></Points></Piece></UnstructuredGrid></VTKFile>""" % data
        done = self.run_it("check", self.put_bytes("bomb.vtu", vtu))
        self.assert_done(done, 2)
        self.assertIn("the arrays claim more bytes than a mesh of such a file can take", done.stderr)

    def test_the_estimate_counts_not_the_size(self):
        """--max-quads decides, whatever the size."""
        file = self.put("m.json", plate(size=0.05))
        self.assertIn("about 3.8e+04 quads are expected, more than 1000:",
                      self.run_it("mesh", file, "--json", "--max-quads", "1000").stderr)
        self.assert_done(self.run_it("mesh", file, "--json", "--max-quads", "4e4"))

    def test_the_estimate_knows_lines_strips_and_growth(self):
        across = [{"path": [[0.2 * i, 0], [0.2 * i, 8]]} for i in range(1, 60)]
        along = [{"path": [[0, 0.13 * i], [12, 0.13 * i]]} for i in range(1, 60)]
        fine = [{"path": [[1, 4], [11, 4]], "size": 1e-3}]
        for model, about, options in [
                (plate(size=100, lines=across + along), "3.6e+03", []),
                ({"size": 1, "outer": [[0, 0], [2e4, 0], [2e4, 0.02], [0, 0.02]]}, "2e+04", []),
                (plate(lines=fine), "1e+04", ["--growth", "1e6"]),
                (plate(points=[{"at": [6, 4], "size": 1e-9}]), "7.7e+09", ["--growth", "1.0001"])]:
            done = self.run_it("mesh", self.put("m.json", model), "--json", "--max-quads", "1000", *options)
            self.assert_done(done, 2)
            self.assertIn("about %s quads are expected, more than 1000:" % about, done.stderr)

    def test_what_the_estimate_does_not_see_is_refused_before_the_triangles(self):
        """A strip far thinner than the size: sizes follow its width."""
        strip = {"size": 1, "outer": [[0, 0], [2e3, 0], [2e3, 0.02], [0, 0.02]]}
        done = self.run_it("mesh", self.put("m.json", strip), "--json", "--max-quads", "3000")
        self.assert_done(done, 2)
        self.assertRegex(done.stderr, "at least [0-9]+ quads are needed, more than 3000: choose a larger size, or raise --max-quads")


if __name__ == "__main__":
    unittest.main()
