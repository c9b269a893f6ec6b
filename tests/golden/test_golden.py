#!/usr/bin/env python3
"""The meshes of a few models, byte for byte: their hashes stand in hashes.txt; see docs/determinism.md.

Runs the program that QUADLINE names, as the machine is and with the processor's FMA and AVX2 hidden from glibc (which
chooses its functions by them; elsewhere that changes nothing). `--update` writes the hashes that it gets.
"""
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "../..")
HASHES = os.path.join(HERE, "hashes.txt")
QUADLINE = os.path.abspath(os.environ.get("QUADLINE") or os.path.join(ROOT, "build/release/quadline"))
MODELS = {
    "paper": ["models/paper/fig16.json"],
    "arcs": ["models/paper/fig18.json"],
    "fall-back": ["models/hard/tangent-beside-arc.json"],
    "criteria": ["models/structures/gusset.json", "--criteria", "csr-fine"],
    "threads": ["models/structures/web-frame.json", "--threads", "4"],
    "far away": ["models/hard/offset-1e7.json"],
    "rings": ["models/layout/bolt-rings.json"],
    "graded": ["models/hard/size-jump-100.json"],
}
NO_FMA = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4"}


def mesh_hash(arguments, environment=()):
    with tempfile.TemporaryDirectory() as folder:
        mesh = os.path.join(folder, "mesh.json")
        # Quads beyond the criteria are an answer of their own (exit code); the mesh is written all the same.
        subprocess.run([QUADLINE, "mesh", *arguments, "-o", mesh, "--quiet"], cwd=ROOT, capture_output=True, check=False,
                       env={**os.environ, **dict(environment)})
        with open(mesh, "rb") as written:
            return hashlib.sha256(written.read()).hexdigest()


def stored():
    with open(HASHES, encoding="utf-8") as lines:
        return dict(reversed(line.rstrip("\n").split("  ", 1)) for line in lines)


class Golden(unittest.TestCase):
    def check(self, environment=()):
        hashes = stored()
        self.assertEqual(sorted(hashes), sorted(MODELS))
        for name, arguments in MODELS.items():
            with self.subTest(name):
                self.assertEqual(mesh_hash(arguments, environment), hashes[name])

    def test_meshes_are_the_same_bytes(self):
        self.check()

    def test_meshes_are_the_same_bytes_without_fma(self):
        self.check(NO_FMA)


if __name__ == "__main__":
    if "--update" in sys.argv:
        lines = ["%s  %s\n" % (mesh_hash(arguments), name) for name, arguments in MODELS.items()]
        with open(HASHES, "w", encoding="utf-8") as out:
            out.writelines(lines)
    else:
        unittest.main()
