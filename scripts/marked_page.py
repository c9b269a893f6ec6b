"""Pages with a part that a program writes."""


def write_between(page, begin, end, text):
    """Puts the text between two marks of a page; the rest of it stays."""
    with open(page, encoding="utf-8") as file:
        head, rest = file.read().split(begin)
    with open(page, "w", encoding="utf-8") as file:
        file.write(head + begin + text + end + rest.split(end)[1])
