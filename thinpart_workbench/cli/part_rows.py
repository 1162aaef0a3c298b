"""Part records as rows of a table for people, and of a CSV file."""

import csv
import io
import os
from dataclasses import dataclass

from ..storage.atomic_file import write_atomically

_COLOURS = {"thin": "red", "thin_features": "yellow", "normal": "green", "unknown": "magenta"}


@dataclass(frozen=True)
class Column:
    """A column of the table.

    Attributes
    ----------
    title : str
    value : callable
        From a part record to a text.
    right : bool
        Whether numbers line up on the right.
    """

    title: str
    value: object
    right: bool = False


def _box(part):
    return " x ".join(f"{side:.4g}" for side in part["descriptors"]["box_mm"])


def _ratio(part):
    value = part["descriptors"]["volume_ratio"]
    return "-" if value is None else f"{value:.3f}"


def _thinnest(part):
    value = part["descriptors"]["thickness_mm"]["min"]
    return "-" if value is None else f"{value:.4g}"


def _name(part):
    count = f" ({part['instances']}x)" if part["instances"] > 1 else ""
    return part["label"] + count


def _category(part):
    return part["category"] + (" (borderline)" if part["borderline"] else "")


TABLE = (
    Column("Part", _name),
    Column("Category", _category),
    Column("Criteria", lambda part: ", ".join(map(str, part["criteria"])) or "none"),
    Column("D1 x D2 x D3 mm", _box, right=True),
    Column("V/VBB", _ratio, right=True),
    Column("Thinnest mm", _thinnest, right=True),
)

CSV_COLUMNS = {
    "part": lambda part: part["name"],
    "label": lambda part: part["label"],
    "instances": lambda part: part["instances"],
    "category": lambda part: part["category"],
    "criteria": lambda part: " ".join(map(str, part["criteria"])),
    "margin": lambda part: part["margin"],
    "borderline": lambda part: int(part["borderline"]),
    "d1_mm": lambda part: part["descriptors"]["box_mm"][0],
    "d2_mm": lambda part: part["descriptors"]["box_mm"][1],
    "d3_mm": lambda part: part["descriptors"]["box_mm"][2],
    "volume_mm3": lambda part: part["descriptors"]["volume_mm3"],
    "area_mm2": lambda part: part["descriptors"]["area_mm2"],
    "volume_ratio": lambda part: part["descriptors"]["volume_ratio"],
    "thinnest_mm": lambda part: part["descriptors"]["thickness_mm"]["min"],
    "median_mm": lambda part: part["descriptors"]["thickness_mm"]["median"],
    "error_bound_mm": lambda part: part["descriptors"]["thickness_mm"]["error_bound"],
    "triangles": lambda part: part["triangles"],
    "warnings": lambda part: " ".join(part["warnings"]),
}


FIRST_COLUMNS = b"file,part,label"
"""How every table that was written starts; what starts otherwise is not overwritten."""


def print_table(outcomes, stream, tree):
    """Print a row per part and per failure.

    Parameters
    ----------
    outcomes : list of dict
        From `analyse_files`.
    stream : text stream
    tree : str or Path
        Folder that holds all files: they are named by their places in it.
    """
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    console = Console(file=stream, highlight=False)
    if not console.is_terminal:
        # A file or a pipe has no width to fit into; cut cells would lose what was asked for.
        console = Console(file=stream, highlight=False, width=220)
    table = Table(box=None, pad_edge=False, header_style="bold")
    several = len({outcome["file"] for outcome in outcomes}) > 1
    if several:
        table.add_column("File", overflow="fold")
    for column in TABLE:
        table.add_column(column.title, justify="right" if column.right else "left",
                         overflow="fold")
    for outcome in outcomes:
        start = [escape(_place(outcome, tree))] if several else []
        for part in outcome.get("parts", ()):
            colour = _COLOURS.get(part["category"], "cyan")
            cells = [escape(column.value(part)) for column in TABLE]
            cells[1] = f"[{colour}]{cells[1]}[/{colour}]"
            table.add_row(*start, *cells)
        for error in _errors(outcome):
            name = error.get("label") or ("" if several else _place(outcome, tree))
            table.add_row(*start, escape(name), f"[bold red]failed: {error['kind']}[/bold red]")
    console.print(table)
    for outcome in outcomes:
        for part in outcome.get("parts", ()):
            whose = f"{_place(outcome, tree)}: {part['label']}" if several else part["label"]
            for text in [part["reason"], *part["warnings"]]:
                if text:
                    console.print(f"{escape(whose)}: {escape(text)}", style="dim")


def _place(outcome, tree):
    return os.path.relpath(outcome["file"], tree)


def _errors(outcome):
    return [outcome["error"]] if "error" in outcome else outcome["failures"]


def write_csv(outcomes, path, tree):
    """Write a row per part and per failure to a CSV file; files are named as in `print_table`."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(["file", *CSV_COLUMNS, "error_kind", "error"])
    for outcome in outcomes:
        place = _place(outcome, tree)
        for part in outcome.get("parts", ()):
            writer.writerow(
                [place, *(value(part) for value in CSV_COLUMNS.values()), "", ""]
            )
        for error in _errors(outcome):
            named = [error.get("part") or "", error.get("label") or ""]
            blank = [""] * (len(CSV_COLUMNS) - len(named))
            writer.writerow([place, *named, *blank, error["kind"], error["message"]])
    write_atomically(path, text.getvalue().encode("utf-8", "backslashreplace"))
