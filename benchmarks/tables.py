#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the tables of a results file, and puts them into the documents.

    python3 benchmarks/tables.py FILE               # every table, as text
    python3 benchmarks/tables.py FILE --markdown    # those of the documents, as Markdown
    python3 benchmarks/tables.py FILE --write       # into README.md and docs/performance.md
    python3 benchmarks/tables.py --write            # the same, from the files that the documents name

A document says between two comments where a table goes, and which results file it is from:

    <!-- benchmark rays: 2026-11-22.json -->
    <!-- end of benchmark -->

FILE gives those tables that were measured in it. Others stay as they are.
"""

import argparse
import json
import os
import re
import sys
from pathlib import Path

sys.path.insert(0, os.fspath(Path(__file__).resolve().parents[1]))

from benchmarks.children.child_process import ChildError
from benchmarks.places import RESULTS, ROOT
from benchmarks.result_tables import TABLES, mesh_tables, notes
from benchmarks.table_text import markdown, plain, titled

DOCUMENTS = ("README.md", "docs/performance.md", "docs/meshing.md")

NOT_MEASURED = "none"
"""In place of a results file."""

_MARK = re.compile(r"<!-- benchmark (?P<table>\w+): (?P<file>\S+) -->\n.*?<!-- end of benchmark -->", re.DOTALL)


def main(arguments=None):
    """Print or write; the exit status: 1 where there is no such results file."""
    options = _options(arguments)
    try:
        if options.write:
            for name in DOCUMENTS:
                document = ROOT / name
                text = document.read_text(encoding="utf-8")
                document.write_text(with_tables(text, options.results), encoding="utf-8")
        else:
            print(all_text(stored(options.results), options.markdown))
    except (ChildError, OSError) as error:
        print(f"benchmarks: {error}", file=sys.stderr)
        return 1
    return 0


def _options(arguments):
    parser = argparse.ArgumentParser(prog="benchmarks/tables.py", description=__doc__.partition("\n")[0])
    parser.add_argument("results", type=Path, nargs="?", metavar="FILE", help="results file of benchmarks/run.py")
    parser.add_argument("--markdown", action="store_true", help="print Markdown")
    parser.add_argument("--write", action="store_true", help=f"put the tables into {' and '.join(DOCUMENTS)}")
    options = parser.parse_args(arguments)
    if options.results is None and not options.write:
        parser.error("name a results file")
    return options


def stored(file):
    """The results in a file.

    Raises
    ------
    ChildError
        where it has none.
    OSError
    """
    try:
        results = json.loads(file.read_text(encoding="utf-8"))
    except ValueError:
        results = None
    if not isinstance(results, dict) or not results.keys() & {"meshes", "verdicts", "accuracy", "meshing"}:
        raise ChildError(f"{file} is no results file of this benchmark.")
    return results


def all_text(results, is_markdown=False):
    """All tables, str; of Markdown those that documents have."""
    if is_markdown:
        return "\n\n".join(f"### {titled(table, markdown)}" for of in TABLES.values() for table in of(results))
    tables = [*mesh_tables(results), *(table for of in TABLES.values() for table in of(results))]
    return "\n\n".join([*(titled(table, plain) for table in tables), *notes(results)])


def with_tables(text, file=None):
    """A document with its tables from results files.

    Parameters
    ----------
    text : str
    file : Path, optional
        In `RESULTS`; by default each table is from the file that it names.

    Returns
    -------
    str
    """
    def table(found):
        tables, name = [], found["file"]
        if file is not None:
            tables = TABLES[found["table"]](stored(file))
            if tables:
                name = file.name
        if not tables and name != NOT_MEASURED:
            tables = TABLES[found["table"]](stored(RESULTS / name))
        several = len(tables) > 1
        content = "\n\n".join((f"**{each.title}**\n\n" if several else "") + markdown(each) for each in tables)
        content = content or "Not measured yet: `python3 benchmarks/run.py`."
        return f"<!-- benchmark {found['table']}: {name} -->\n\n{content}\n\n<!-- end of benchmark -->"

    return _MARK.sub(table, text)


if __name__ == "__main__":
    sys.exit(main())
