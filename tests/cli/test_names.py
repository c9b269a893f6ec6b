"""Names as the program shows them: on one line, nothing that steers a terminal, and short in tables; JSON has them whole."""
import json
import unittest

from test_command_line import CommandLine

LONG = "stiffener of the third frame, starboard side, " + "x" * 75
WIDE = "Längsträger-" * 12


def plate(*names, outside=()):
    lines = [{"name": name, "path": [[0, i + 1], [12, i + 1]]} for i, name in enumerate(names)]
    lines += [{"name": name, "path": [[20, 1], [30, 1]]} for name in outside]
    return {"size": 1, "outer": [[0, 0], [12, 0], [12, 8], [0, 8]], "lines": lines}


class Names(CommandLine):
    def table(self, *names):
        out = self.path("names.msh.json")
        done = self.run_it("mesh", self.put("names.json", plate(*names)), "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        for text in (done.stdout, self.run_it("check", out).stdout):
            rows = text.split("line, the worst first")[1].splitlines()
            yield text, rows[1:1 + len(names)]

    def test_control_characters_are_escaped_in_the_line_table(self):
        for text, rows in self.table("a\nb", "red \x1b[31m", "tab\there"):
            self.assertNotIn("\x1b", text)
            self.assertNotIn("\t", text)
            self.assertEqual(sorted(row.split("   ")[0].strip() for row in rows), ["a\\nb", "red \\x1b[31m", "tab\\there"])

    def test_long_names_are_shortened_in_the_middle_by_characters(self):
        for text, rows in self.table(LONG, WIDE, "short"):
            self.assertLess(max(map(len, rows)), 150)
            names = [row[2:34] for row in rows]
            self.assertIn(LONG[:16] + "\u2026" + LONG[-15:], names)
            self.assertIn(WIDE[:16] + "\u2026" + WIDE[-15:], names)
            self.assertEqual(len({row.index("..") for row in rows}), 1, "columns stand below each other:\n" + text)

    def test_findings_are_one_line_each_with_names_escaped(self):
        model = self.put("names.json", plate(outside=["a\n\x1b[2J"]))
        for done in (self.run_it("mesh", model, "-o", self.path("m.json")), self.run_it("info", model)):
            said = done.stdout + done.stderr
            self.assertIn("line 'a\\n\\x1b[2J' lies outside the domain", said)
            self.assertNotIn("\x1b", said)

    def test_json_has_names_whole(self):
        report = json.loads(self.run_it("mesh", self.put("names.json", plate(LONG, "a\nb")), "--json").stdout)
        names = [line["name"] for line in report["lines"]]
        self.assertIn(LONG, names)
        self.assertIn("a\nb", names)
        self.assertTrue(any("off_normal_deg" in line for line in report["lines"]))


if __name__ == "__main__":
    unittest.main()
