# SPDX-License-Identifier: LGPL-2.1-or-later
"""What programs made of the parts of a library, as printed text."""

import sys
from collections import Counter
from contextlib import contextmanager

from ..core.foreign_text import printable
from .terminal_table import TableColumn, category_style, print_table

MOST_REASONS = 10
"""Most rows of the table of parts without a mesh; --json lists all."""


@contextmanager
def labelling_progress():
    """For a ``with`` block: a function that shows the number of documents done, where a person sees it."""
    shown = sys.stderr.isatty()

    def report(done, total):
        if shown:
            sys.stderr.write(f"\rLabelled {done} of {total} documents")
            sys.stderr.flush()

    try:
        yield report
    finally:
        if shown:
            sys.stderr.write("\r\033[K")


def print_labelling(labels, labels_file):
    """Print how many parts are in trouble, why some have no figures, and what foretells it: of AutomaticLabels, and the file
    that they were written to, if one was.
    """
    counts = Counter(result.category for result in labels.results)
    listed = ", ".join(f"{counts[category]} {category}" for category in ("thin", "thin_features", "normal"))
    program = printable(labels.labelling.person)
    print(f"{len(labels.results)} parts labelled by {program} in {labels.seconds:.0f} s: {listed}.")
    _print_failed([result for result in labels.results if result.figures["reason"]])
    print()
    if labels.quantities:
        print_table(sys.stdout, _QUANTITY_COLUMNS, lambda: labels.quantities)
    else:
        print("No quantity can foretell trouble: all of the parts have it, or none.")
    if labels_file is not None:
        print(f"{len(labels.results)} labels were written to {printable(labels_file)}.")
    for failure in labels.failures:
        print(f"thinpart: {printable(failure['file'])}: {printable(failure['message'])}", file=sys.stderr)


def _print_failed(failed):
    if failed:
        print()
        print_table(sys.stdout, (
            TableColumn("No mesh, or refused", lambda result: result.file,
                        style=lambda result: category_style(result.category)),
            TableColumn("Part", lambda result: result.part),
            TableColumn("Why", lambda result: result.figures["reason"]),
        ), lambda: failed[:MOST_REASONS])
    if len(failed) > MOST_REASONS:
        print(f"... and {len(failed) - MOST_REASONS} more; --json lists all.")


_QUANTITY_COLUMNS = (
    TableColumn("Quantity", lambda row: row.symbol),
    TableColumn("Trouble where", lambda row: "low" if row.is_low else "high"),
    TableColumn("Area under ROC, 95 %", lambda row: f"{row.area:.2f} ({row.low:.2f} to {row.high:.2f})"),
    TableColumn("Parts", lambda row: f"{row.troubled} and {row.others}", True),
    TableColumn("Meaning", lambda row: row.meaning),
)
