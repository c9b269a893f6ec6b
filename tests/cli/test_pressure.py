"""The program under pressure: no memory, no room, no rights, closed pipes, signals, two runs at once."""
import os
import resource
import shutil
import signal
import subprocess
import unittest

from test_command_line import PLATE, QUADLINE, CommandLine

NO_MEMORY = "quadline: not enough memory: a mesh with a larger size takes less\n"
INTERRUPTED = "quadline: interrupted\n"
NOBODY = 65534


class Pressure(CommandLine):
    def start(self, *arguments, **keywords):
        process = subprocess.Popen([QUADLINE, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **keywords)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        return process

    def assert_interrupted(self, process, sign):
        process.send_signal(sign)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out, err), (130, "", INTERRUPTED))

    def assert_no_temporaries(self):
        for folder, _, files in os.walk(self.folder):
            self.assertEqual([name for name in files if name.startswith(".quadline")], [], folder)


class Memory(Pressure):
    def limited(self, limit, *arguments):
        def limit_memory():
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        return self.run_it(*arguments, preexec_fn=limit_memory)

    def least_to_start(self):
        for limit in range(2 << 20, 64 << 20, 1 << 18):
            try:
                if self.limited(limit, "--version").returncode == 0:
                    return limit
            except OSError:  # not even the loader could start
                pass
        return self.fail("does not start in 64 MB")

    def assert_runs_out_well(self, step, *arguments):
        """More and more memory, until it is enough: one line and 3 until then, and nothing is touched."""
        limit = self.least_to_start()
        before = {name: self.read(name) for name in os.listdir(self.folder)}
        times = 0
        while True:
            done = self.limited(limit, *arguments)
            if done.returncode == 0:
                break
            self.assertEqual((done.returncode, done.stdout, done.stderr), (3, "", NO_MEMORY), "with %d bytes" % limit)
            self.assertEqual({name: self.read(name) for name in os.listdir(self.folder)}, before)
            times += 1
            limit += step
        self.assertGreater(times, 5)

    def test_every_command_ends_in_one_line(self):
        # Reading, each stage, and writing run out in turn.
        self.put("a.msh", "old")
        self.assert_runs_out_well(300 << 10, "mesh", self.plate, "--size", "0.07", "--quiet", "-o", self.path("a.msh"),
                                  "--report", self.path("r.json"))
        self.assert_done(self.run_it("check", self.path("a.msh")))
        self.assert_runs_out_well(500 << 10, "check", self.path("a.msh"), "--model", self.plate)
        self.assert_runs_out_well(500 << 10, "draw", self.path("a.msh"), "-o", self.path("a.svg"))


class Room(Pressure):
    def test_a_full_disk_keeps_the_old_file(self):
        room = self.path("room")
        os.mkdir(room)
        if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", room],
                                               capture_output=True).returncode != 0:
            self.skipTest("no right to mount a small disk")
        self.addCleanup(subprocess.run, ["umount", "-l", room])
        out = os.path.join(room, "a.msh")
        self.assert_done(self.run_it("mesh", self.plate, "-o", out, "--quiet"))
        old = self.read("room/a.msh")
        full = " cannot be written: No space left on device\n"
        self.assertGreater(64 << 10, len(old))
        done = self.run_it("mesh", self.plate, "--size", "0.1", "-o", out)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (4, "", "quadline: " + out + ":" + full))
        self.assertEqual(os.listdir(room), ["a.msh"])
        self.assertEqual(self.read("room/a.msh"), old)
        done = self.run_it("mesh", self.plate, "--size", "0.1", "--stages", os.path.join(room, "stages"))
        self.assertEqual(done.returncode, 4)
        self.assertRegex(done.stderr, r"\Aquadline: [^\n]+\.(svg|vtu):" + full + r"\Z")
        self.assert_no_temporaries()

    def test_a_file_that_may_not_grow_leaves_no_half(self):
        for limit in (0, 1, 4096, 20000):  # bytes
            for name in ("a.vtu", "a.msh", "a.inp", "a.svg", "a.json"):
                def limit_files(limit=limit):
                    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
                out = self.path(name)
                done = self.run_it("mesh", self.plate, "--size", "0.3", "-o", out, preexec_fn=limit_files)
                self.assertEqual((done.returncode, done.stdout, done.stderr),
                                 (4, "", "quadline: " + out + ": cannot be written: File too large\n"))
                self.assertEqual(os.listdir(self.folder), ["plate.json"])


class Rights(Pressure):
    def setUp(self):
        super().setUp()
        self.program = shutil.copy(QUADLINE, self.path("program"))  # where a user without rights reaches it
        os.chmod(self.folder, 0o755)
        os.mkdir(self.path("locked"))
        self.put("locked/a.vtu", "old")
        os.chmod(self.path("locked"), 0o555)
        self.addCleanup(os.chmod, self.path("locked"), 0o755)

    def assert_refused(self, out, reason, *arguments):
        def give_up_rights():
            if os.geteuid() == 0:
                os.setgid(NOBODY)
                os.setuid(NOBODY)
        done = subprocess.run([self.program, "mesh", self.plate, *arguments], capture_output=True, text=True, timeout=60,
                              preexec_fn=give_up_rights)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (4, "", "quadline: " + out + ": " + reason + "\n"))
        self.assertEqual(os.listdir(self.path("locked")), ["a.vtu"])
        self.assertEqual(self.read("locked/a.vtu"), b"old")

    def test_a_folder_that_may_not_be_written(self):
        for name in ("locked/new.vtu", "locked/a.vtu"):
            self.assert_refused(self.path(name), "cannot be written: Permission denied", "-o", self.path(name))
        stages = self.path("locked/stages")
        self.assert_refused(stages, "cannot be made: Permission denied", "--stages", stages)

    def test_a_folder_for_the_stages_that_may_not_be_written(self):
        def give_up_rights():
            if os.geteuid() == 0:
                os.setgid(NOBODY)
                os.setuid(NOBODY)
        done = subprocess.run([self.program, "mesh", self.plate, "--stages", self.path("locked")], capture_output=True,
                              text=True, timeout=60, preexec_fn=give_up_rights)
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        self.assertRegex(done.stderr, r"\Aquadline: [^\n]+/01-triangulation\.svg: cannot be written: Permission denied\n\Z")
        self.assertEqual(os.listdir(self.path("locked")), ["a.vtu"])

    def test_a_file_that_may_only_be_read(self):
        os.mkdir(self.path("open"))
        os.chmod(self.path("open"), 0o777)
        self.put("open/a.vtu", "old")
        os.chmod(self.path("open/a.vtu"), 0o444)
        self.assert_refused(self.path("open/a.vtu"), "cannot be written: Permission denied", "-o", self.path("open/a.vtu"))
        self.assertEqual(self.read("open/a.vtu"), b"old")


class Streams(Pressure):
    def test_a_reader_that_leaves(self):
        """As `quadline mesh ... -o svg:/dev/stdout | head -c 10`."""
        for arguments in (["mesh", self.plate, "--size", "0.1", "-o", "svg:/dev/stdout"], ["mesh", self.plate, "--json"]):
            with self.subTest(arguments=arguments):
                ends = os.pipe()
                os.close(ends[0])
                done = subprocess.run([QUADLINE, *arguments], stdout=ends[1], stderr=subprocess.PIPE, text=True, timeout=60)
                os.close(ends[1])
                self.assertEqual(done.returncode, 4)
                self.assertRegex(done.stderr, r"\Aquadline: [^\n]+ cannot be written: Broken pipe\n\Z")

    def test_nobody_hears_the_complaint(self):
        ends = os.pipe()
        os.close(ends[0])
        self.addCleanup(os.close, ends[1])
        done = subprocess.run([QUADLINE, "mesh", "none.json", "-o", "a.vtu"], stderr=ends[1], timeout=60, cwd=self.folder)
        self.assertEqual(done.returncode, 2)

    def test_words_do_not_run_into_the_mesh(self):
        """What is opened while standard output or error is closed could take its place."""
        note = self.put("twice.json", dict(PLATE, lines=PLATE["lines"] * 2))
        whole = self.path("whole.inp")
        self.assert_done(self.run_it("mesh", note, "-o", whole, "--stages", self.path("stages")))
        for closed, code in (("2>&-", 0), ("<&-", 0), (">&-", 4), ("<&- >&- 2>&-", 4)):
            with self.subTest(closed=closed):
                done = subprocess.run(["sh", "-c", '"$0" "$@" ' + closed, QUADLINE, "mesh", note, "-o", self.path("a.inp"),
                                       "--stages", self.path("other")], capture_output=True, timeout=60)
                self.assertEqual(done.returncode, code)
                self.assertEqual(self.read("a.inp"), self.read("whole.inp"))
                for name in os.listdir(self.path("stages")):
                    self.assertEqual(self.read("other/" + name), self.read("stages/" + name), name)

    def test_a_mesh_on_standard_output_is_alone_there(self):
        self.assert_done(self.run_it("mesh", self.plate, "-o", self.path("a.msh")))
        done = self.run_it("mesh", self.plate, "-o", "msh:/dev/stdout")
        self.assert_done(done)
        self.assertEqual(done.stdout.encode(), self.read("a.msh"))
        with open(self.path("log"), "ab") as log:
            log.write(b"before\n")
            log.flush()
            subprocess.run([QUADLINE, "mesh", self.plate, "-o", "msh:/dev/stdout"], stdout=log, check=True, timeout=60)
        self.assertEqual(self.read("log"), b"before\n" + self.read("a.msh"))


class Signals(Pressure):
    def until(self, process, stage, folder):
        """Waits until the snapshot of a stage is there."""
        while not any(stage in name for name in os.listdir(folder) if name.endswith(".vtu") and not name.startswith(".")):
            self.assertIsNone(process.poll(), "over before stage " + stage)

    def test_in_every_stage(self):
        stages = ("triangulation", "field-points", "before-smoothing", "clean-up", "smoothed")
        # The last output waits for a reader that does not come, so that no run is over before the signal is there.
        os.mkfifo(self.path("pipe.inp"))
        for stage in stages:
            for sign in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(stage=stage, sign=sign):
                    shutil.rmtree(self.path("stages"), ignore_errors=True)
                    os.mkdir(self.path("stages"))
                    process = self.start("mesh", self.plate, "--size", "0.1", "--stages", self.path("stages"),
                                         "-o", self.path("pipe.inp"), "--report", self.path("r.json"))
                    self.until(process, stage, self.path("stages"))
                    self.assert_interrupted(process, sign)
                    self.assertFalse(os.path.exists(self.path("r.json")))
                    self.assert_no_temporaries()
                    for name in os.listdir(self.path("stages")):
                        if name.endswith(".vtu"):
                            self.assertIn(self.run_it("check", self.path("stages/" + name)).returncode, (0, 3), name)

    def test_before_anything_is_read(self):
        os.mkfifo(self.path("pipe.json"))
        for sign in (signal.SIGINT, signal.SIGTERM):
            process = self.start("mesh", self.path("pipe.json"), "-o", self.path("a.vtu"))
            with open(self.path("pipe.json"), "w", encoding="utf-8") as pipe:  # comes back when it reads
                pipe.write("{")
                pipe.flush()
                self.assert_interrupted(process, sign)
            self.assertEqual(sorted(os.listdir(self.folder)), ["pipe.json", "plate.json"])

    def test_while_it_writes(self):
        """The reader takes a little and then waits, with more to come than a pipe holds."""
        self.put("a.vtu", "old")
        os.mkfifo(self.path("pipe.inp"))
        for sign in (signal.SIGINT, signal.SIGTERM):
            process = self.start("mesh", self.plate, "--size", "0.1", "-o", self.path("pipe.inp"), "-o", self.path("a.vtu"))
            with open(self.path("pipe.inp"), "rb") as pipe:
                self.assertEqual(len(pipe.read(10)), 10)
                self.assert_interrupted(process, sign)
            self.assertEqual(self.read("a.vtu"), b"old")
            self.assert_no_temporaries()


class Together(Pressure):
    def test_two_runs_write_one_file(self):
        """One of the two meshes stands there at last, and at every moment a whole one."""
        wanted = []
        for size in ("0.2", "0.21"):
            self.assert_done(self.run_it("mesh", self.plate, "--size", size, "-o", self.path(size + ".msh")))
            wanted.append(self.read(size + ".msh"))
        for _ in range(10):
            both = [self.start("mesh", self.plate, "--size", size, "-o", self.path("a.msh")) for size in ("0.2", "0.21")]
            while any(process.poll() is None for process in both):
                if os.path.exists(self.path("a.msh")):
                    self.assertIn(self.read("a.msh"), wanted)
            self.assertEqual([process.returncode for process in both], [0, 0])
            self.assertIn(self.read("a.msh"), wanted)
            self.assert_no_temporaries()


if __name__ == "__main__":
    unittest.main()
