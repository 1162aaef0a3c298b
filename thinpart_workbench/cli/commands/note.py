# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart note``: show or set the annotations of a part."""

import os

from ...api.annotations import annotate_part, label_part, limit_faces, mesh_settings
from ...core.errors import ThinPartError
from ...core.foreign_text import json_text, printable
from ...storage.info.annotations import ANNOTATION_KEYS
from ...storage.info.stored_records import stored_records


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("path", metavar="PART", help="a document that was classified, or its info file")
    parser.add_argument("--part", metavar="NAME",
                        help="name or label of the part, where the document has several")
    parser.add_argument("--set", dest="notes", metavar="TEXT",
                        help="store this text with the part; an empty one removes it")
    parser.add_argument("--mesh", metavar="FILE-or-JSON",
                        help="store mesh settings: a JSON object, a JSON file, or the name of any other file")
    parser.add_argument("--link", metavar="TEXT", help="store an address or a file name")
    parser.add_argument("--label", metavar="CATEGORY",
                        help="keep what the part is in your eyes: thin, thin_features, normal or a category of your "
                             "profile; an empty one removes your label")
    parser.add_argument("--unsure", action="store_true", help="you are not sure of the label")
    parser.add_argument("--face", metavar="NAME", action="append", default=[],
                        help="set limits of the wall for these faces, which checks respect: Face3, several with commas "
                             "between them; without --at-least and --at-most, their limits are removed")
    parser.add_argument("--at-least", type=float, metavar="MM", help="the least wall that the faces may have")
    parser.add_argument("--at-most", type=float, metavar="MM", help="the greatest wall that the faces may have")
    parser.add_argument("--reason", metavar="TEXT", default="", help="why the faces have limits of their own")
    parser.add_argument("--person", metavar="NAME", default="",
                        help="who says so (default: your name on this computer)")
    parser.add_argument("--info-dir", metavar="DIR",
                        help="folder of the info file, if it is not beside the document")
    parser.add_argument("--json", action="store_true", help="print one JSON object per part")


def run(options):
    """Set the given annotations, show all of them, and return the exit status."""
    given = {
        "notes": options.notes,
        "mesh": None if options.mesh is None else mesh_settings(options.mesh),
        "link": options.link,
    }
    if options.label is None and (options.unsure or options.person and not options.face):
        raise ThinPartError("--unsure and --person go with --label.", "usage")
    if not options.face and (options.at_least is not None or options.at_most is not None or options.reason):
        raise ThinPartError("--at-least, --at-most and --reason go with --face.", "usage")
    records = None
    if options.face:
        faces = [name.strip() for names in options.face for name in names.split(",") if name.strip()]
        records = [limit_faces(options.path, faces, options.reason, options.at_least, options.at_most, options.person,
                               options.part, options.info_dir)]
    if options.label is not None:
        records = [label_part(options.path, options.label, options.person, not options.unsure, options.part,
                              options.info_dir)]
    if any(value is not None for value in given.values()):
        records = [annotate_part(options.path, options.part, options.info_dir, **given)]
    if records is None:
        records = stored_records(options.path, options.part, options.info_dir)
    for record in records:
        annotations = {key: record.get(key) or None for key in ANNOTATION_KEYS}
        if options.json:
            print(json_text({"file": os.fspath(options.path), "name": record["name"], "label": record["label"],
                              **annotations}))
        else:
            _show(record["label"], annotations)
    return 0


def _show(label, annotations):
    label = printable(label)
    print(f"{label}:" if any(annotations.values()) else f"{label}: no notes, mesh settings, link or labels")
    for line in (annotations["notes"] or "").splitlines():
        print("  " + printable(line))
    if annotations["mesh"]:
        settings = annotations["mesh"].get("settings")
        settings_text = annotations["mesh"]["file"] if settings is None else json_text(settings)
        print(f"  mesh settings: {printable(settings_text)}")
    if annotations["link"]:
        print(f"  {printable(annotations['link'])}")
    for each in annotations["region_notes"] or ():
        said = [f"excluded: {each['excluded']}" if "excluded" in each else "",
                f"element size {each['mesh_size_mm']:g} mm" if "mesh_size_mm" in each else ""]
        faces = ", ".join(each["faces"][:4]) + (f" and {len(each['faces']) - 4} more" if len(each["faces"]) > 4 else "")
        print(printable(f"  wall of {faces}: {'; '.join(filter(None, said))} ({each['person']}, {each['when'][:10]})"))
    for each in annotations["face_limits"] or ():
        limits = [f"at least {each['min_mm']:g} mm" if "min_mm" in each else "",
                  f"at most {each['max_mm']:g} mm" if "max_mm" in each else ""]
        print(printable(f"  {each['face']}: {', '.join(filter(None, limits))}: {each['reason']} "
                        f"({each['person']}, {each['when'][:10]})"))
    for each in annotations["labels"] or ():
        sure = "" if each["sure"] else ", not sure"
        print(f"  {printable(each['person'])}: {printable(each['category'])}{sure} ({printable(each['when'][:10])})")
