"""``thinpart note``: what is kept with a part, shown or set."""

import json
import os

from ..storage.kept_content import KEPT
from ..workflow.kept_notes import keep_with_part, mesh_settings, stored_records
from .terminal_table import printable


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("path", metavar="PART", help="a document that was classified, or its info file")
    parser.add_argument("--part", metavar="NAME",
                        help="name or label of the part, where the document has several")
    parser.add_argument("--set", dest="notes", metavar="TEXT",
                        help="keep this text with the part; empty removes it")
    parser.add_argument("--mesh", metavar="FILE-or-JSON",
                        help="keep mesh settings: a JSON object, a JSON file, or the name of any other file")
    parser.add_argument("--link", metavar="TEXT", help="keep an address or a file name")
    parser.add_argument("--info-dir", metavar="DIR",
                        help="where the info file lies, if not beside the document")
    parser.add_argument("--json", action="store_true", help="print one JSON object per part")


def run(options):
    """Set what was given, show what is kept, and return the exit status."""
    given = {
        "notes": options.notes,
        "mesh": None if options.mesh is None else mesh_settings(options.mesh),
        "link": options.link,
    }
    if all(value is None for value in given.values()):
        records = stored_records(options.path, options.part, options.info_dir)
    else:
        records = [keep_with_part(options.path, options.part, options.info_dir, **given)]
    for record in records:
        kept = {key: record.get(key) or None for key in KEPT}
        if options.json:
            print(json.dumps({"file": os.fspath(options.path), "name": record["name"], "label": record["label"],
                              **kept}, ensure_ascii=False))
        else:
            _show(record["label"], kept)
    return 0


def _show(label, kept):
    label = printable(label)
    print(f"{label}:" if any(kept.values()) else f"{label}: nothing is kept")
    for line in (kept["notes"] or "").splitlines():
        print("  " + printable(line))
    if kept["mesh"]:
        settings = kept["mesh"].get("settings")
        told = kept["mesh"]["file"] if settings is None else json.dumps(settings, ensure_ascii=False)
        print(f"  mesh settings: {printable(told)}")
    if kept["link"]:
        print(f"  {printable(kept['link'])}")
