# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was learned from labels, as printed text."""

import sys

from ..core.foreign_text import printable
from .terminal_table import TableColumn, category_style, print_table

MOST_ROWS = 20
"""Most parts in the printed table of those that people disagree about; --json lists all."""


def print_learned(learned, output):
    """Print labels, changes and scores of a LearnedProfile, and where it was written, if it was."""
    _print_labels(learned)
    _print_changes(learned)
    _print_scores(learned)
    _print_end(learned, output)


def _print_labels(learned):
    counts = ", ".join(f"{count} {category}" for category, count in learned.counts.items())
    print(f"{sum(learned.counts.values())} labelled parts: {counts}; by {printable(', '.join(learned.people))}.")
    pairs = learned.disagreement.pairs
    if pairs.total:
        print(f"Two answers to the same part differ in {_share(pairs)}.")
    different = learned.disagreement.parts
    if different:
        print()
        print_table(sys.stdout, (
            TableColumn("Disagreement", lambda part: part["file"]),
            TableColumn("Part", lambda part: part["part"]),
            TableColumn("Answers", lambda part: ", ".join(f"{person}: {category}"
                                                          for person, category in part["answers"].items())),
        ), lambda: different[:MOST_ROWS])
    if len(different) > MOST_ROWS:
        print(f"... and {len(different) - MOST_ROWS} more; --json lists all.")


def _print_changes(learned):
    print()
    print_table(sys.stdout, (
        TableColumn("Category", lambda row: row.category, style=lambda row: category_style(row.category)),
        TableColumn("Criterion", lambda row: row.criterion),
        TableColumn(f"In {learned.start}", lambda row: row.before),
        TableColumn("Learned", lambda row: "left out" if row.after is None else
                    "as before" if row.after == row.before else row.after),
    ), lambda: learned.changes)


def _print_scores(learned):
    rows = [(learned.start, learned.before), ("learned", learned.after)]
    print()
    print_table(sys.stdout, (
        TableColumn("Agreement with labels, 95 % interval", lambda row: row[0]),
        TableColumn("Sure labels", lambda row: _share(row[1].sure)),
        TableColumn("All, either answer", lambda row: _share(row[1].either)),
        TableColumn("Error of probabilities", lambda row: "none stated" if row[1].calibration_error is None else
                    f"{row[1].calibration_error:.3f}"),
    ), lambda: rows)
    for title, scores in rows:
        verdicts = list(next(iter(scores.confusion.values())))
        print()
        print_table(sys.stdout, (
            TableColumn(f"Label, and verdict of {title}", lambda row: row[0], style=lambda row: category_style(row[0])),
            *(TableColumn(verdict, lambda row, verdict=verdict: row[1][verdict], True) for verdict in verdicts),
        ), lambda scores=scores: scores.confusion.items())


def _print_end(learned, output):
    print()
    what = "folders or groups" if learned.left_out == "folders" else "parts, since all are in one folder"
    print(f"The figures of the learned profile are from {learned.folds} profiles, each learned without some {what}, and "
          "tried on those.")
    if not learned.is_better:
        print(f"On these it agrees with the labels no better than {learned.start} does: keep {learned.start}, or label more "
              "parts.")
    print("Nothing was written: -o FILE writes the profile." if output is None else printable(output))


def _share(share):
    if not share.total:
        return "none"
    return (f"{share.count} of {share.total}, {100 * share.count / share.total:.0f} % "
            f"({100 * share.low:.0f} to {100 * share.high:.0f})")
