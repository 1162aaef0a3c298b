#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of the paper's figures: what it says of them, and what the profiles `paper` and `calibrated` say.

    /usr/bin/python3 benchmarks/paper_examples.py            # the table, as Markdown
    /usr/bin/python3 benchmarks/paper_examples.py --write    # into docs/method.md

The samples are made after what the text of the paper says of its figures: Giannini, Petton, Pernot, TMCE 2012.
"""

import argparse
import json
import os
import re
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

import thinpart_workbench as thinpart  # noqa: E402
from benchmarks.places import RESULTS  # noqa: E402
from benchmarks.table_text import MISSING, Table, markdown  # noqa: E402
from thinpart_workbench.core.judging.criteria import load_profile  # noqa: E402
from thinpart_workbench.core.judging.paper_verdict import paper_sentence  # noqa: E402
from thinpart_workbench.core.judging.verdict_sentence import verdict_sentence  # noqa: E402

DOCUMENT = ROOT / "docs" / "method.md"
SAMPLES = ROOT / "resources" / "samples"

SOLVED = RESULTS / "2026-11-25-paper-examples.json"
"""What benchmarks/solver_truth.py found of those samples that are not thin as a whole."""

KNOWN, TROUBLE = 0.02, 0.04
"""Change from one reference mesh to the next up to which an error is known; and the error from which a mesh is no good."""

_MARK = re.compile(r"<!-- paper examples -->\n.*?<!-- end of paper examples -->", re.DOTALL)


class Example(NamedTuple):
    """A figure of the paper: the sample that stands for it, what the text says, and the category and criteria that it names.

    ``category`` is empty where the text names none.
    """

    figure: str
    sample: str
    says: str
    category: str
    criteria: tuple = ()


EXAMPLES = (
    Example("1", "endless_screw", "endless screw, thin at the end of its thread and around the chamfer", "thin_features"),
    Example("1", "worm_run_out", "the same, with a thread that runs out", "thin_features"),
    Example("2.b", "gear_thin_teeth", "gear teeth, found by faces that are not parallel", "thin_features", (7,)),
    Example("2.b", "spur_gear_on_hub", "the same, with involute teeth", "thin_features", (7,)),
    Example("3.a", "tube", "a globally thin object", "thin"),
    Example("3.b", "wedge", "a part much thinner than the rest, between faces that are not parallel", "thin_features"),
    Example("3.c", "block", "a normal object", "normal"),
    Example("6.a", "cuboid_with_rib", "a cuboid with a rib: V/VBB 0.74, three distances inside", ""),
    Example("6.b", "pipe_bend", "a very curved part, nearly all of its box empty", "thin", (3,)),
    Example("7.a", "plate_with_openings", "a plate; its openings leave less than 80 % of the box", "thin", (1, 2)),
    Example("7.b", "bent_sheet_bracket", "extended in its box, with no volume", "thin", (3,)),
    Example("7.c", "nearly_square_dish", "low, about as long as wide, thin walls over most of the surface", "thin", (2, 4)),
    Example("8.a", "thin_walled_casting", "no particular volume, nearly constant thickness", "thin", (3,)),
    Example("8.b", "solid_casting", "of similar shape, but only some features are thin", "thin_features"),
    Example("9.a", "ribbed_block", "a wall below 5 % of the diagonal", "thin_features", (5,)),
    Example("9.b", "flange", "a wall of 5 to 29 % of the diagonal beside a thick body", "thin_features", (6,)),
)

_WORDS = {"thin_features": "thin features", "": "no category"}


def main(arguments=None):
    """Print or write; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--write", action="store_true", help=f"put the table into {DOCUMENT.relative_to(ROOT)}")
    options = parser.parse_args(arguments)
    table = example_table(sample_records())
    if options.write:
        DOCUMENT.write_text(with_table(DOCUMENT.read_text(encoding="utf-8"), table), encoding="utf-8")
    else:
        print(markdown(table))
    return 0


def sample_records():
    """Records of the samples by `calibrated`, which have the verdict of `paper` too: dict of PartRecord by name."""
    files = sorted({SAMPLES / f"{example.sample}.step" for example in EXAMPLES})
    return {Path(parts.file).stem: parts[0].record for parts in thinpart.classify_files(files, "calibrated")}


def example_table(records):
    """The table of all examples: Table.

    Parameters
    ----------
    records : dict of PartRecord
        See `sample_records`.
    """
    solved = json.loads(SOLVED.read_text(encoding="utf-8"))["solved"]
    return Table("The paper's examples", ["figure", "sample", "the paper", "`paper`", "`calibrated`", "automatic mesh",
                                         "where they differ"],
                 [_row(example, records[example.sample], solved.get(example.sample)) for example in EXAMPLES])


def _row(example, record, solved):
    stated = _verdict(example.category, example.criteria)
    return [example.figure, f"`{example.sample}`", f"{example.says}: {stated}", _verdict(**record["paper"]),
            _verdict(record["category"], record["criteria"]), _mesh(solved), _difference(record, solved)]


def _verdict(category, criteria):
    word = _WORDS.get(category, category)
    return f"{word} ({', '.join(map(str, criteria))})" if criteria else word


def _mesh(solved):
    """How far the automatic mesh is off, by the solver."""
    if solved is None:
        return MISSING
    refused = "refused, " if solved["is_tangled"] else ""
    if solved["error"] is None:
        return f"{refused}untangled too"
    about = "" if solved["change"] is not None and solved["change"] <= KNOWN else "about "
    return f"{refused}{'untangled ' if refused else ''}{about}{100 * solved['error']:.1f} % off"


def _difference(record, solved):
    """What the paper found, what `calibrated` says of it, and the solver of a normal part; empty where they agree."""
    found = paper_sentence(record, load_profile("calibrated"))
    if not found:
        return ""
    figures = found.fields["figures"]
    sentences = [f"`paper`: {figures}.", f"`calibrated`: {verdict_sentence(record)}"]
    if solved and record["category"] == "normal":
        if solved["error"] is None or solved["error"] > TROUBLE:
            sentences.append("The solver bears out `paper`.")
        elif not solved["is_tangled"]:
            sentences.append("The solver bears out `calibrated`.")
    return " ".join(sentences).replace("\u00a0", " ")


def with_table(text, table):
    """The document with a Table between its two comments: str."""
    content = f"<!-- paper examples -->\n\n{markdown(table)}\n\n<!-- end of paper examples -->"
    return _MARK.sub(lambda found: content, text)


if __name__ == "__main__":
    sys.exit(main())
