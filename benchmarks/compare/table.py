"""The figures of both programs beside each other: the best of Gmsh's modes, and what is lost to them."""
import textwrap

# Figure of the judge: heading, whether more is better, how it is written. Order of the table's columns.
FIGURES = {
    "beta_mean": ("beta", True, "%.3f"),
    "sj_mean": ("mean SJ", True, "%.3f"),
    "sj_min": ("least SJ", True, "%.3f"),
    "irregular": ("irregular", False, "%.2f %%"),
    "angle_min": ("least angle", True, "%.0f"),
    "angle_max": ("greatest angle", False, "%.0f"),
}
NEAR_SIZE = (0.75, 1.33)  # median edge over the target size: a mesh outside is no answer to the question asked


def is_fair(row):
    """A valid mesh of quads alone, at about the size asked for."""
    low, high = NEAR_SIZE
    return bool(row.get("valid")) and row["triangles"] == 0 and low <= row["size_ratio_p50"] <= high


def best_of(rows):
    """Figure by figure the best of the fair rows; {} where there are none."""
    fair = [row for row in rows if is_fair(row)]
    return {key: (max if more else min)(row[key] for row in fair) for key, (_, more, _) in FIGURES.items()} if fair else {}


def is_lost(key, ours, best):
    return ours < best - 1e-9 if FIGURES[key][1] else ours > best + 1e-9


def lost(ours, best):
    """The figures of a model in which Gmsh's best is better than ours."""
    return [key for key in best if is_lost(key, ours[key], best[key])]


def text(key, value):
    value = 100 * value if key == "irregular" else value
    return FIGURES[key][2] % value


def row_of(ours, gmsh_rows):
    """One line of the table."""
    best = best_of(gmsh_rows)
    cells = [ours["model"], str(ours["quads"])]
    for key in FIGURES:
        theirs = "(%s)" % text(key, best[key]) if best else "(-)"
        figure = text(key, ours[key])
        cells.append("%s %s" % ("**%s**" % figure if key in best and is_lost(key, ours[key], best[key]) else figure, theirs))
    cells.append("%.2f..%.2f" % (ours["size_ratio_p5"], ours["size_ratio_p95"]))
    fastest = min((row["seconds"] for row in gmsh_rows if is_fair(row)), default=None)
    cells.append("%.2f (%s)" % (ours["seconds"], "-" if fastest is None else "%.2f" % fastest))
    return "| " + " | ".join(cells) + " |"


def table(ours, gmsh):
    """@param ours rows of Quadline, one a model. @param gmsh rows of Gmsh by model."""
    heads = ["model", "quads"] + [head for head, _, _ in FIGURES.values()] + ["edge / size, 5..95 %", "seconds"]
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    lines += [row_of(row, gmsh.get(row["model"], [])) for row in ours]
    means = ["**mean**", str(sum(row["quads"] for row in ours) // len(ours))]
    means += [text(key, sum(row[key] for row in ours) / len(ours)) for key in FIGURES]
    lines.append("| " + " | ".join(means + ["", ""]) + " |")
    return "\n".join(lines)


def summary(ours, gmsh):
    """How many comparisons there are, and which are lost."""
    n, names = 0, []
    for row in ours:
        best = best_of(gmsh.get(row["model"], []))
        n += len(best)
        names += ["%s, %s: %s against %s" % (row["model"], FIGURES[key][0], text(key, row[key]), text(key, best[key]))
                  for key in lost(row, best)]
    without = [row["model"] for row in ours if not best_of(gmsh.get(row["model"], []))]
    lines = ["%d of %d comparisons are lost%s" % (len(names), n, ":" if names else ".")] + ["- " + name for name in names]
    if without:
        none = "No mode of Gmsh gives a valid all-quad mesh at the size asked for on %s." % ", ".join(without)
        lines.append("\n" + textwrap.fill(none, 118, break_on_hyphens=False))
    return "\n".join(lines)
