# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child process: FreeCAD writes the solids as files, in several sizes and formats."""

import os
from pathlib import Path

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

from .child_process import serve
from .solids import make_solid

SIZES = {"casting": (None,), "shell": (None,), "gear": (12, 60, 240), "plate": (3, 8, 14), "heat_sink": (10, 50, 200),
         "studs": (1, 3, 6)}
"""By family, how many of what makes it large: see `solids.FAMILIES`. Each is written as STEP."""

OTHER_FORMATS = {family: (".FCStd", ".brep") for family in SIZES}
OTHER_FORMATS["heat_sink"] += (".iges",)
"""Of each family's first size. FreeCAD writes loose faces into IGES; those of the other families do not close any more."""

LARGE = ("studs", 14)
"""About a million triangles at 0.1 % of the diagonal and 5 degrees."""


def made_files(quick):
    """Which files there are: list of (name, family, size), the smallest only where it has to be quick."""
    files = []
    for family, sizes in SIZES.items():
        files += [(f"{family}_{size or 1}.step", family, size) for size in (sizes[:1] if quick else sizes)]
    for family in ("heat_sink",) if quick else SIZES:
        files += [(f"{family}_in_another_format{ending}", family, SIZES[family][0]) for ending in OTHER_FORMATS[family]]
    return files


def family_of(file):
    """The family of a made file."""
    return next(family for family in SIZES if Path(file).name.startswith(family))


def write(folder, files):
    """Write those that are not there yet.

    Parameters
    ----------
    folder : str
    files : list of (name, family, size)

    Returns
    -------
    dict
        Empty.
    """
    load_freecad()
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, family, size in files:
        if not (folder / name).is_file():
            unfinished = folder / f"unfinished{Path(name).suffix}"
            _write(make_solid(family, *([size] if size else [])), unfinished)
            os.replace(unfinished, folder / name)
    return {}


def _write(shape, file):
    import FreeCAD

    if file.suffix != ".FCStd":
        {".step": shape.exportStep, ".brep": shape.exportBrep, ".iges": shape.exportIges}[file.suffix](str(file))
        return
    document = FreeCAD.newDocument("made", hidden=True)
    document.addObject("Part::Feature", "Part").Shape = shape
    document.saveAs(str(file))
    FreeCAD.closeDocument(document.Name)


if __name__ == "__main__":
    serve({"write": write})
