"""Pages, or parts of pages, that a program writes. Each begins with a line that says by what it was made, and when."""
import datetime
import os
import subprocess

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))


def made_by(command, quadline):
    """The first line of what `command` makes with the program `quadline`."""
    version = subprocess.run([quadline, "--version"], capture_output=True, text=True, check=True).stdout.split()[-1]
    return "Made by `%s` with Quadline %s, %s.\n" % (command, version, datetime.date.today().isoformat())


def write_between(page, begin, end, text):
    """Puts the text between two marks of a page, given by its path in the repository; the rest of it stays."""
    path = os.path.join(ROOT, page)
    with open(path, encoding="utf-8") as file:
        head, begun, rest = file.read().partition(begin)
    _, closed, tail = rest.partition(end)
    if not (begun and closed):
        raise SystemExit("%s lacks the lines %s and %s" % (page, begin.strip(), end.strip()))
    with open(path, "w", encoding="utf-8") as file:
        file.write(head + begin + text + end + tail)
