"""How Gmsh did with the parts of a library, as printed text."""

import sys
from collections import Counter
from contextlib import contextmanager

from ..core.foreign_text import printable
from .terminal_table import TableColumn, category_style, print_table

MOST_REASONS = 10
"""Most rows of the table of parts without a mesh; --json lists all."""


@contextmanager
def meshing_progress():
    """For a ``with`` block: a function that shows the number of documents done, where a person sees it."""
    shown = sys.stderr.isatty()

    def report(done, total):
        if shown:
            sys.stderr.write(f"\rMeshed {done} of {total} documents")
            sys.stderr.flush()

    try:
        yield report
    finally:
        if shown:
            sys.stderr.write("\r\033[K")


def print_meshing(meshing, labels_file):
    """Print how many parts are in trouble, why some have no mesh, and what foretells it: of a Meshing, and the file
    of its labels, if one was written.
    """
    counts = Counter(result.category for result in meshing.results)
    listed = ", ".join(f"{counts[category]} {category}" for category in ("thin", "thin_features", "normal"))
    print(f"{len(meshing.results)} parts meshed by {printable(meshing.person)} in {meshing.seconds:.0f} s: {listed}.")
    _print_unmeshed([result for result in meshing.results if result.trouble_share is None])
    print()
    if meshing.quantities:
        print_table(sys.stdout, _QUANTITY_COLUMNS, lambda: meshing.quantities)
    else:
        print("No quantity can foretell trouble: all of the parts have it, or none.")
    if labels_file is not None:
        print(f"{len(meshing.results)} labels were written to {printable(labels_file)}.")
    for failure in meshing.failures:
        print(f"thinpart: {printable(failure['file'])}: {printable(failure['message'])}", file=sys.stderr)


def _print_unmeshed(unmeshed):
    if unmeshed:
        print()
        print_table(sys.stdout, (
            TableColumn("No mesh", lambda result: result.file, style=lambda result: category_style(result.category)),
            TableColumn("Part", lambda result: result.part),
            TableColumn("Why", lambda result: result.reason),
        ), lambda: unmeshed[:MOST_REASONS])
    if len(unmeshed) > MOST_REASONS:
        print(f"... and {len(unmeshed) - MOST_REASONS} more; --json lists all.")


_QUANTITY_COLUMNS = (
    TableColumn("Quantity", lambda row: row.symbol),
    TableColumn("Trouble where", lambda row: "low" if row.is_low else "high"),
    TableColumn("Area under ROC, 95 %", lambda row: f"{row.area:.2f} ({row.low:.2f} to {row.high:.2f})"),
    TableColumn("Parts", lambda row: f"{row.troubled} and {row.others}", True),
    TableColumn("Meaning", lambda row: row.meaning),
)
