#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make the sample parts that are bundled with ThinPart.

    /usr/bin/python3 make_samples.py [--out DIR] [--only NAME ...]

Every part is built from FreeCAD objects, checked, and saved as NAME.FCStd (parametric, or a computed
shape where parametric objects would be fragile) and NAME.step. `samples.json` lists what each part shows
and how the `paper` profile is expected to classify it. The package sample_parts has the parts.

Dates and random identifiers are taken out after saving, so that the same FreeCAD makes the same files
again. What remains to differ in a .FCStd file is the last digit of a solved sketch and, from FreeCAD 1.0
on, the objects' numbers, to which the names of faces and edges refer. The bundled files were made by
FreeCAD 0.20, so that it and all later versions open them.
"""

import argparse
import json
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, os.fspath(HERE.parents[1]))

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad  # noqa: E402

load_freecad()  # before anything imports Part

from sample_parts.making import make  # noqa: E402
from sample_parts.table import SAMPLES  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description="Make the sample parts bundled with ThinPart.")
    parser.add_argument("--out", default=HERE, type=Path, metavar="DIR", help="default: beside this script")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="default: all the samples")
    options = parser.parse_args()
    unknown = set(options.only or ()) - {sample.name for sample in SAMPLES}
    if unknown:
        parser.error(f"no such sample: {', '.join(sorted(unknown))}")
    options.out.mkdir(parents=True, exist_ok=True)

    for sample in SAMPLES:
        if options.only and sample.name not in options.only:
            continue
        shape, fcstd_size, step_size = make(sample, os.fspath(options.out))
        print(f"{sample.name:20} {len(shape.Faces):3} faces  {shape.Volume:9.0f} mm3  "
              f"FCStd {fcstd_size // 1000:4} kB  STEP {step_size // 1000:4} kB")
    if not options.only:
        listing = json.dumps([sample.content() for sample in SAMPLES], indent=2)
        (options.out / "samples.json").write_text(listing + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
