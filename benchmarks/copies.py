#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether copies of parts are found: turned, mirrored, scaled, as other triangles, in other formats.

    /usr/bin/python3 benchmarks/copies.py --parts FOLDER [--count 200] [--folder DIR] [--markdown]

Copies of some of the parts, each kind in turn, are classified beside all parts of FOLDER. `similar` has found one where its
original is among the ten most similar parts; `duplicates` where it names both in one group of the right kind. Different
parts that are called identical are counted too. With names in a manifest, families are compared with them (adjusted Rand
index, Hubert and Arabie 1985, doi:10.1007/BF01908075). It goes on where it was stopped, in DIR.
"""

import argparse
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

from benchmarks.children.child_process import Child, ChildError  # noqa: E402
from benchmarks.children.copied_parts import KINDS  # noqa: E402
from benchmarks.machine import machine  # noqa: E402
from thinpart_workbench.api.libraries import Libraries, duplicates, families  # noqa: E402
from thinpart_workbench.core.errors import ThinPartError  # noqa: E402
from thinpart_workbench.storage.info.info_file import SUFFIX  # noqa: E402
from thinpart_workbench.storage.info.stored_records import stored_records  # noqa: E402

COUNT, BEST = 200, 10
COPIED = (".step", ".stp", ".brep")


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", required=True, metavar="FOLDER")
    parser.add_argument("--count", type=int, default=COUNT, metavar="N", help=f"copies (default: {COUNT})")
    parser.add_argument("--folder", metavar="DIR", help="where copies and info files are kept (default: a temporary one)")
    parser.add_argument("--stored", action="store_true", help="let duplicates go by what info files keep, without geometry")
    parser.add_argument("--markdown", action="store_true", help="print tables in Markdown")
    options = parser.parse_args()
    print(json.dumps(machine()), file=sys.stderr)
    with tempfile.TemporaryDirectory(prefix="thinpart-copies-") as temporary:
        folder = Path(options.folder or temporary)
        made = _copies(sorted(Path(options.parts).iterdir()), folder / "copies", options.count)
        for library in (options.parts, folder / "copies"):
            subprocess.run([sys.executable, "-m", "thinpart_workbench", "classify", library, "--no-thumbnails", "--info-dir",
                            folder / "info" / Path(library).name], cwd=ROOT, stdout=subprocess.DEVNULL, check=False)
        _print(_found(made, folder / "info", options), options.markdown)
        manifest = Path(options.parts).parent / "manifest.csv"
        if manifest.is_file():
            print(_agreement(manifest, folder / "info"))


def _copies(files, folder, count):
    """Copies that are made: dict of (original, kind) by name. Each kind has its own originals."""
    folder.mkdir(parents=True, exist_ok=True)
    listed = folder / "copies.json"
    made = json.loads(listed.read_text()) if listed.is_file() else {}
    originals = {original for original, _ in made.values()}
    kinds = list(KINDS)
    with Child(sys.executable, "copied_parts") as freecad:
        for file in files:
            if len(made) >= count:
                break
            if file.suffix.lower() not in COPIED or file.name in originals:
                continue
            kind = kinds[len(made) % len(kinds)]
            try:
                copy = freecad.ask("copy", file=str(file), folder=str(folder), kind=kind)["file"]
            except ChildError as error:
                print(f"{file.name}: {error}", file=sys.stderr)
                continue
            if copy is not None:
                made[Path(copy).name] = file.name, kind
                listed.write_text(json.dumps(made))
    return made


def _found(made, info, options):
    """By kind: copies, those with a closed surface, those that similar and duplicates have found; and false pairs."""
    rows = {kind: dict.fromkeys(("copies", "read", "similar", "duplicates", "as alike"), 0) for kind in KINDS}
    copies = {info / "copies" / f"{name}{SUFFIX}": (original, kind) for name, (original, kind) in made.items()}
    with Libraries([info]) as libraries:
        for path, (original, kind) in copies.items():
            rows[kind]["copies"] += 1
            record = _record(path)
            if record is None:
                continue
            rows[kind]["read"] += 1
            found = libraries.similar(record, BEST, excluding=(os.path.realpath(path), record["name"])).parts
            rows[kind]["similar"] += any(Path(part.file).name == original for part in found)
    false = []
    for group in duplicates([info], reads_documents=not options.stored).groups:
        names = [Path(part.file).name for part in group.parts]
        for name in names[1:]:
            original, kind = made.get(name) or made.get(names[0]) or (None, None)
            is_pair = original in (name, names[0]) or {made.get(each, (each,))[0] for each in (name, names[0])} == {original}
            if is_pair and group.kind != "alike":
                rows[kind]["duplicates"] += group.kind in (KINDS[kind], "identical")
            elif is_pair:
                rows[kind]["as alike"] += 1
            elif group.kind == "identical":
                false.append((names[0], name))
    return rows, false


def _record(path):
    try:
        record, = stored_records(path)
    except (ThinPartError, OSError, ValueError):
        return None
    return record if record["descriptors"]["volume_mm3"] is not None else None


def _print(found, markdown):
    rows, false = found
    columns = list(next(iter(rows.values())))
    line = ("| {} |" + " {} |" * len(columns)) if markdown else "{:<16}" + " {:>10}" * len(columns)
    print(line.format("copy", *columns))
    if markdown:
        print("|---" * (len(columns) + 1) + "|")
    for kind, values in rows.items():
        print(line.format(kind, *values.values()))
    print(f"different parts called identical: {len(false)}", *(f"{one} and {other}" for one, other in false), sep="\n  ")


def _agreement(manifest, info):
    """How well families agree with the names of a library of standard parts: a sentence."""
    from sklearn.metrics import adjusted_rand_score

    with open(manifest, encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["source_repo"].startswith("j-wiedemann/FreeCAD-library")
                and row["source_path"].startswith("Mechanical Parts/Fasteners/")]
    named = {Path(row["file"]).name: _family_name(Path(row["source_path"]).stem) for row in rows}
    found = {}
    for number, family in enumerate(families([info]).families):
        found.update((Path(part.file).name, number) for part in family.parts)
    names = sorted(named)
    labels = [found.get(name, -1 - place) for place, name in enumerate(names)]
    score = adjusted_rand_score([named[name] for name in names], labels)
    return f"families of {len(names)} fasteners against their names: adjusted Rand index {score:.2f}"


def _family_name(stem):
    """The words of a name, without norm, class and size."""
    words = re.split(r"[_\W]+", re.sub(r"(ISO|DIN|ANSI|ASME)[-.\d]*[A-Z]?\d*(?=_|DIN|$|\W)", "", stem))
    return " ".join(re.sub(r"^M\d+", "", word) for word in words if not re.fullmatch(r"M?\d[\dx]*|CLASS|[A-Z]|B18|", word))


if __name__ == "__main__":
    main()
