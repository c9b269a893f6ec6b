#!/usr/bin/env python3
"""scripts/check_layers.py fails where it should: on small made-up trees."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts/check_layers.py")


class CheckLayers(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.root)
        self.write("src/base/base.hpp", "int base();\n")
        self.write("src/geom/geom.hpp", '#include "base/base.hpp"\nint geom();\n')

    def write(self, path, text):
        full = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, "w", encoding="utf-8") as out:
            out.write(text)
        return full

    def compile(self, path, text):
        source = self.write(path, text)
        target = os.path.join(self.root, "objects", path + ".o")
        os.makedirs(os.path.dirname(target), exist_ok=True)
        subprocess.run(["c++", "-c", "-fno-builtin", source, "-o", target], check=True)

    def check(self, *arguments):
        done = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True,
                              env={**os.environ, "QUADLINE_ROOT": self.root})
        return done.returncode, done.stdout + done.stderr

    def check_objects(self):
        return self.check(os.path.join(self.root, "objects"))

    def assert_wrong(self, answer, text):
        self.assertEqual(answer[0], 1, answer[1])
        self.assertIn(text, answer[1])

    def test_a_tree_that_keeps_the_layers_passes(self):
        self.assertEqual(self.check(), (0, "2 files keep the layers\n"))

    def test_an_include_against_the_arrows_fails(self):
        self.write("src/topo/topo.cpp", '#include "geom/geom.hpp"\n')
        self.assert_wrong(self.check(), "src/topo may not include src/geom")

    def test_includes_in_a_circle_fail(self):
        self.write("src/base/base.hpp", '#include "geom/geom.hpp"\n')
        self.assert_wrong(self.check(), "a circle: src/base/base.hpp:1 includes geom/geom.hpp; src/geom/geom.hpp:1")

    def test_calls_of_inexact_functions_fail(self):
        for call in ("std::sin(x)", "atan2(y, x)", "std::pow (x, 2)", "std::fmodf(x, 2)"):
            self.write("src/geom/geom.cpp", "double f(double x, double y) { return %s; }\n" % call)
            self.assert_wrong(self.check(), "src/geom/geom.cpp:1 calls ")

    def test_exact_functions_comments_and_names_that_only_look_like_calls_pass(self):
        self.write("src/geom/geom.cpp", "// std::sin(x)\ndouble f(double x) { return std::sqrt(x) + quadline::sine(x) + "
                   "a.log(x) + std::floor(x) + cosine(x); } const char* t = \"exp(x)\";\n")
        self.assertEqual(self.check()[0], 0)

    def test_an_object_that_calls_libm_fails(self):
        self.compile("src/geom/geom.cpp", "#define WAVE cos\nextern \"C\" double WAVE(double);\n"
                     "double wave(double x) { return (WAVE)(x); }\n")
        self.assertEqual(self.check()[0], 0)
        self.assert_wrong(self.check_objects(), "src/geom/geom.cpp calls cos of libm")

    def test_a_symbol_used_against_the_arrows_fails(self):
        self.compile("src/geom/geom.cpp", "int geom() { return 1; }\n")
        self.compile("src/base/base.cpp", "int geom();\nint base() { return geom(); }\n")
        self.assertEqual(self.check()[0], 0)
        self.assert_wrong(self.check_objects(), "src/base may not use src/geom")

    def test_a_circle_of_an_include_and_a_symbol_fails(self):
        self.compile("src/geom/geom.cpp", "int geom() { return 1; }\n")
        self.compile("src/base/base.cpp", "int geom();\nint base() { return geom(); }\n")
        self.assert_wrong(self.check_objects(), "a circle: ")

    def test_objects_that_are_not_there_fail(self):
        self.assert_wrong(self.check_objects(), "there are no objects")


if __name__ == "__main__":
    unittest.main()
