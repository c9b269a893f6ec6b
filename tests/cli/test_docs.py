"""What the docs say of the program, held against it."""
import json
import os
import re
import sys
import unittest

from test_command_line import QUADLINE, ROOT, CommandLine

sys.path.append(os.path.join(ROOT, "scripts"))
import paper_table  # noqa: E402


def page(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


def keys(item):
    """All keys in a JSON document."""
    if isinstance(item, dict):
        for key, value in item.items():
            yield key
            yield from keys(value)
    elif isinstance(item, list):
        for value in item:
            yield from keys(value)


class Docs(CommandLine):
    def test_the_command_line_is_described(self):
        told = page("docs", "command-line.md")
        for command in ("mesh", "check", "info", "draw"):
            for option in set(re.findall(r"--[a-z][a-z-]+", self.run_it(command, "--help").stdout)) - {"--help", "--output"}:
                self.assertIn("`" + option, told, command)

    def test_no_option_is_told_that_is_none(self):
        helps = "".join(self.run_it(command, "--help").stdout for command in ("mesh", "check", "info", "draw"))
        for name in ("README.md", os.path.join("docs", "command-line.md")):
            for option in re.findall(r"^\| `(--[a-z-]+)", page(name), re.MULTILINE):
                self.assertIn(option, helps, name)

    def test_every_key_of_the_report_is_described(self):
        report = self.run_it("mesh", self.plate, "--json", "--criteria", "csr-fine")
        self.assert_done(report)
        told = page("docs", "command-line.md")
        for key in set(keys(json.loads(report.stdout))):
            self.assertTrue("`%s`" % key in told or '"%s"' % key in told, key)

    def test_the_papers_table_is_of_this_program(self):
        for name in paper_table.PAPER:
            runs = paper_table.reports(QUADLINE, name, self.path(name + ".svg"))
            row = paper_table.line(paper_table.row(name, runs))
            for path in (("README.md",), ("docs", "paper-table.md")):
                self.assertIn(row, page(*path), "run 'make paper'")


if __name__ == "__main__":
    unittest.main()
