# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart demo``: classify the bundled samples."""

from pathlib import Path

from . import classify

SAMPLES = Path(__file__).resolve().parents[3] / "resources" / "samples"


def add_arguments(parser):
    """Declare no options."""


def run(options):
    """Classify the bundled FreeCAD documents without writing any files."""
    import argparse

    parser = argparse.ArgumentParser()
    classify.add_arguments(parser)
    documents = [str(path) for path in sorted(SAMPLES.glob("*.FCStd"))]
    return classify.run(parser.parse_args([*documents, "--no-info"]))
