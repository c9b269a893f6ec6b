"""Meshes an example with Quadline, solves its job with CalculiX and reads the results.

CalculiX's exit code says little: 0 also for a missing file and for a model that floats away. So its output is searched
for errors, the results must be there, and the tests bound them.
"""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
QUADLINE = pathlib.Path(os.environ.get("QUADLINE", ROOT / "build" / "release" / "quadline")).resolve()


class ExampleTest(unittest.TestCase):
    """Runs examples/<name> once for all tests of the class, in a folder of its own."""

    name = None

    @classmethod
    def setUpClass(cls):
        if cls.name is None:
            raise unittest.SkipTest("no example of its own")
        cls.folder = tempfile.TemporaryDirectory(prefix="quadline-")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        example = ROOT / "examples" / cls.name
        shutil.copy(example / "job.inp", cls.path)
        subprocess.run([QUADLINE, "mesh", example / (cls.name + ".json"), "-o", cls.path / "mesh.inp"],
                       check=True, timeout=120)
        run = subprocess.run(["ccx", "job"], cwd=cls.path, timeout=240, text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, env=dict(os.environ, OMP_NUM_THREADS="1"))
        if "*ERROR" in run.stdout or not (cls.path / "job.dat").is_file():
            raise AssertionError("CalculiX failed:\n" + run.stdout[-2000:])

    def printed(self, what, node_set):
        """The first row of numbers under the title `what ... for set NODE_SET` in job.dat."""
        lines = iter((self.path / "job.dat").read_text().splitlines())
        for line in lines:
            if what in line and "for set %s " % node_set.upper() in line:
                for row in lines:
                    if row.strip():
                        return [float(word) for word in row.split()]
        self.fail("job.dat has no %s for %s" % (what, node_set))

    def nodal_stresses(self):
        """(x, y) -> (sxx, syy, szz, sxy, syz, szx) at the nodes, from job.frd (columns of 12 characters)."""
        points, stresses, target = {}, {}, None
        for line in (self.path / "job.frd").read_text().splitlines():
            if line.startswith("    2C"):
                target = points
            elif line.startswith(" -4  STRESS"):
                target = stresses
            elif line.startswith((" -3", " -4")):
                target = None
            elif line.startswith(" -1") and target is not None:
                target[int(line[3:13])] = [float(line[i:i + 12]) for i in range(13, len(line.rstrip()), 12)]
        return {tuple(points[node][:2]): stress for node, stress in stresses.items()}
