# SPDX-License-Identifier: LGPL-2.1-or-later
"""Annotations: what people store with a part in its info file, such as the methods that proved right for it."""

from datetime import datetime, timezone

from ...core.record.record_types import Annotations
from ...core.record.region_notes import notes_of_regions

ANNOTATION_KEYS = ("notes", *Annotations.__annotations__)
"""Keys of a part record that people set."""

ORPHANS = "kept_of_missing_parts"
"""Key of an info file: annotations of parts that the document no longer has."""


def has_annotation(part):
    """Whether a part has any annotation."""
    return any(part.get(key) for key in ANNOTATION_KEYS)


def set_annotation(part, **values):
    """Set annotations of a part, or remove those whose value is empty; says whether something changed, bool.

    Parameters
    ----------
    part : PartRecord
        Changed in place.
    values
        By key of `ANNOTATION_KEYS`; None leaves the annotation unchanged.
    """
    before = {key: part.get(key) for key in ANNOTATION_KEYS}
    for key, value in values.items():
        if key not in ANNOTATION_KEYS:
            raise KeyError(key)
        if value is None:
            continue
        if value:
            part[key] = value
        elif key == "notes":
            part[key] = ""
        else:
            part.pop(key, None)
    return before != {key: part.get(key) for key in ANNOTATION_KEYS}


def set_label(part, person, category, is_sure=True):
    """Set what a person says of a part, or remove it; says whether that changed: the same answer again is no change.

    Parameters
    ----------
    part : PartRecord
        Changed in place. Answers of others stay.
    person : str
    category : str
        Empty removes the answer of this person.
    is_sure : bool, optional
    """
    earlier = next((label for label in part.get("labels", ()) if label["person"] == person), None)
    if earlier is None and not category:
        return False
    if earlier is not None and (earlier["category"], earlier["sure"]) == (category, is_sure):
        return False
    others = [label for label in part.get("labels", ()) if label["person"] != person]
    own = [{"person": person, "category": category, "sure": is_sure,
            "when": datetime.now(timezone.utc).isoformat(timespec="seconds")}] if category else []
    return set_annotation(part, labels=others + own)


def set_region_note(part, regions, person, excluded=None, mesh_size_mm=None):
    """Set what a person says of wall regions, or remove it; says whether something changed, bool.

    Parameters
    ----------
    part : PartRecord
        Changed in place.
    regions : list of dict
        Regions of a part record, possibly of another measurement of the part.
    person : str
    excluded : str, optional
        Why they are left out; empty includes them again, None changes nothing.
    mesh_size_mm : float, optional
        Wanted element size; 0 removes it, None changes nothing.
    """
    now = datetime.now(timezone.utc).isoformat(timespec="seconds")
    given = {key: value for key, value in (("excluded", excluded), ("mesh_size_mm", mesh_size_mm)) if value is not None}
    notes = list(part.get("region_notes", ()))
    for region, known in zip(regions, notes_of_regions(regions, notes)):
        said = {} if known is None else {key: known[key] for key in ("excluded", "mesh_size_mm") if key in known}
        changed = {key: value for key, value in {**said, **given}.items() if value}
        if changed == said:
            continue
        new = {"place": region["place"], "faces": region["faces"], "person": person, "when": now, **changed}
        at = len(notes) if known is None else next(number for number, note in enumerate(notes) if note is known)
        notes[at:at + 1] = [new] if changed else []
    return set_annotation(part, region_notes=notes)


def set_face_limit(part, faces, person, reason="", min_mm=None, max_mm=None):
    """Set limits of the wall for faces of a part, or remove them where none is given; says whether something changed, bool.

    Parameters
    ----------
    part : PartRecord
        Changed in place.
    faces : list of str
        Names, such as ``Face3``. A name without a face removes a limit only.
    person, reason : str
    min_mm, max_mm : float, optional
    """
    now = datetime.now(timezone.utc).isoformat(timespec="seconds")
    given = {key: value for key, value in (("min_mm", min_mm), ("max_mm", max_mm)) if value is not None}
    known = {face["face"]: face for face in part["faces"]}
    kept = [limit for limit in part.get("face_limits", ()) if limit["face"] not in faces]
    if given:
        kept += [{"face": name, "area_mm2": known[name]["area_mm2"], "surface": known[name].get("surface"), "person": person,
                  "when": now, "reason": reason, **given} for name in faces if name in known]
    return set_annotation(part, face_limits=kept)


def carry_annotations(content, old):
    """Copy annotations to a new analysis of the same document.

    Annotations of a part that is gone stay in the file, and return when the document has a part of that
    name again.

    Parameters
    ----------
    content : dict
        New content of the info file; changed in place.
    old : dict
        Its previous content.
    """
    annotated = {part["name"]: part for part in (*old.get(ORPHANS, ()), *old["parts"]) if has_annotation(part)}
    for part in content["parts"]:
        old_part = annotated.pop(part["name"], None)
        if old_part is not None and not has_annotation(part):
            set_annotation(part, **{key: old_part.get(key) for key in ANNOTATION_KEYS})
    orphans = [{key: part[key] for key in ("name", "label", *ANNOTATION_KEYS) if part.get(key)}
               for part in annotated.values()]
    if orphans:
        content[ORPHANS] = orphans
