# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of info files that cannot be used: by name, a function from the text of a good one to what stands there."""

import json

HUGE = 10 ** 40


def _changed(*changes):
    """As the good one, but for some values: pairs of a place such as "parts.0.label" and a value."""
    def bad(text):
        content = json.loads(text)
        for place, value in changes:
            *above, key = (int(each) if each.isdecimal() else each for each in place.split("."))
            target = content
            for each in above:
                target = target[each]
            target[key] = value
        return json.dumps(content)

    return bad


def _without(place):
    def bad(text):
        content = json.loads(text)
        *above, key = (int(each) if each.isdecimal() else each for each in place.split("."))
        target = content
        for each in above:
            target = target[each]
        del target[key]
        return json.dumps(content)

    return bad


def _instead(old, new):
    """As the good one, but for a piece of its text: what `json` would not write."""
    def bad(text):
        assert old in text
        return text.replace(old, new, 1)

    return bad


def _deep(levels):
    return json.loads("[" * levels + "]" * levels)


def _twice(text):
    content = json.loads(text)
    content["parts"] *= 2
    return json.dumps(content)


_MEASURED = "parts.0.descriptors"

BAD = {
    # no JSON
    "empty": lambda text: "",
    "truncated": lambda text: text[:len(text) // 2],
    "one_brace": lambda text: "{",
    "zeros": lambda text: b"\0" * 1000,
    "no_utf8": lambda text: b"\xff\xfe\xfa" + text.encode(),
    "latin_1": lambda text: text.replace('"notes": ""', '"notes": "caf\xe9"', 1).encode("latin-1"),
    "raw_surrogate": lambda text: text.encode().replace(b'"notes": ""', b'"notes": "\xed\xa0\x80"', 1),
    "deep_lists": lambda text: "[" * 100_000,
    "deep_objects": lambda text: '{"a":' * 100_000,
    "deep_inside": lambda text: text.replace('"warnings": []', '"warnings": ' + "[" * 5000 + "]" * 5000, 1),
    "number_of_10000_digits": _instead('"instances": 1', '"instances": 1' + "0" * 10_000),
    # not ours
    "a_list": lambda text: "[1, 2]",
    "a_text": lambda text: '"thinpart-info"',
    "null": lambda text: "null",
    "foreign": lambda text: '{"format": "something else"}',
    "format_is_a_list": _changed(("format", ["thinpart-info"])),
    "newer": _changed(("version", 2)),
    "version_is_true": _changed(("version", True)),
    "version_is_deep": _changed(("version", _deep(500))),
    # numbers
    "borderline_1e999": _instead('"borderline": false', '"borderline": 1e999'),
    "margin_nan": _instead('"margin": ', '"margin": NaN, "x": '),
    "margin_infinity": _instead('"margin": ', '"margin": -Infinity, "x": '),
    "margin_1e999": _instead('"margin": ', '"margin": 1e999, "x": '),
    "volume_is_huge": _changed((f"{_MEASURED}.volume_mm3", 10 ** 400)),
    "area_1e999": _instead('"area_mm2": ', '"area_mm2": -1e999, "x": '),
    "unknown_key_1e999": _instead('"margin": ', '"something_new": [1e999], "margin": '),
    "instances_is_huge": _changed(("parts.0.instances", HUGE)),
    "instances_is_half": _changed(("parts.0.instances", 0.5)),
    "instances_is_true": _changed(("parts.0.instances", True)),
    "triangles_are_negative": _changed(("parts.0.triangles", -1)),
    "box_of_zeros": _changed((f"{_MEASURED}.box_mm", [0, 0, 0])),
    "box_is_negative": _changed((f"{_MEASURED}.box_mm", [10.0, 10.0, -1.0])),
    "box_of_two": _changed((f"{_MEASURED}.box_mm", [10.0, 10.0])),
    "box_of_texts": _changed((f"{_MEASURED}.box_mm", ["10", "10", "10"])),
    "box_is_a_text": _changed((f"{_MEASURED}.box_mm", "abc")),
    "box_is_null": _changed((f"{_MEASURED}.box_mm", None)),
    "diagonal_is_zero": _changed((f"{_MEASURED}.diagonal_mm", 0)),
    "share_of_seven": _changed((f"{_MEASURED}.shares.parallel", 7.0)),
    "share_is_a_flag": _changed((f"{_MEASURED}.shares.unmet", False)),
    "axes_are_flat": _changed((f"{_MEASURED}.box_axes", [1, 0, 0])),
    "bin_out_of_range": _changed((f"{_MEASURED}.distribution.bins.0", 99_999)),
    "bin_is_negative": _changed((f"{_MEASURED}.distribution.bins.0", -1)),
    "bin_is_a_fraction": _changed((f"{_MEASURED}.distribution.bins.0", 1.5)),
    "bins_without_areas": _changed((f"{_MEASURED}.distribution.area", [])),
    "area_beyond_float32": _changed((f"{_MEASURED}.distribution.area.0", 1e300)),
    "angle_of_400": _changed((f"{_MEASURED}.nonparallel", {"bins": [1], "angles": [400], "area": [0.1]})),
    "thickness_is_a_list": _changed((f"{_MEASURED}.thickness_mm", [1, 2, 3, 0])),
    "thinnest_is_a_text": _changed((f"{_MEASURED}.thickness_mm.min", "2 mm")),
    # types
    "parts_are_a_number": _changed(("parts", 7)),
    "parts_are_an_object": _changed(("parts", {"Mesh": {}})),
    "parts_are_texts": _changed(("parts", ["Mesh"])),
    "parts_are_none": _changed(("parts", [])),
    "part_is_empty": _changed(("parts", [{}])),
    "part_twice": _twice,
    "name_is_a_number": _changed(("parts.0.name", 5)),
    "label_is_a_list": _changed(("parts.0.label", ["a"])),
    "label_is_a_lone_surrogate": _changed(("parts.0.label", "a\ud800b")),
    "key_is_a_lone_surrogate": _changed(("parts.0.\udfff", 1)),
    "category_is_null": _changed(("parts.0.category", None)),
    "criteria_are_objects": _changed(("parts.0.criteria", [{}])),
    "evidence_is_an_object": _changed(("parts.0.evidence", {"a": 1})),
    "condition_is_missing": _without("parts.0.evidence.0.conditions"),
    "faces_are_missing": _without("parts.0.faces"),
    "witness_of_one_point": _changed(("parts.0.faces.0.witness", {
        "distance": 1.0, "points": [[0, 0, 0]], "opposite_face": "Face1"})),
    "warning_is_a_number": _changed(("parts.0.warnings", [5])),
    "notes_are_a_list": _changed(("parts.0.notes", ["a"])),
    "mesh_is_a_text": _changed(("parts.0.mesh", "fine")),
    "mesh_is_empty": _changed(("parts.0.mesh", {})),
    "mesh_is_deep": _changed(("parts.0.mesh", {"settings": {"a": _deep(500)}})),
    "link_is_an_object": _changed(("parts.0.link", {"href": "x"})),
    "seconds_are_a_number": _changed(("parts.0.seconds", 3)),
    "descriptors_are_empty": _changed(("parts.0.descriptors", {})),
    "source_is_a_text": _changed(("source", "x")),
    "source_file_is_a_lone_surrogate": _changed(("source.file", "\ud800")),
    "source_file_holds_a_nul": _changed(("source.file", "a\0b.stl")),
    "source_folder_is_a_number": _changed(("source.folder", 4)),
    "source_links_are_texts": _changed(("source.links", ["a.FCStd"])),
    "source_link_holds_a_nul": _changed(("source.links", [
        {"file": "\0", "sha256": None, "bytes": None, "modified": None}])),
    "hash_leads_elsewhere": _changed(("source.sha256", "../../../x")),
    "bytes_are_huge": _changed(("source.bytes", HUGE)),
    "modified_is_a_number": _changed(("source.modified", 20_261_122)),
    "settings_are_a_list": _changed(("settings", [])),
    "profile_is_null": _changed(("profile", None)),
    "profile_without_categories": _without("profile.categories"),
    "profile_name_is_a_list": _changed(("profile.name", [1])),
    "profile_is_deep": _changed(("profile.title", "x"), ("profile.more", _deep(500))),
    "software_is_a_text": _changed(("software", "ThinPart")),
    "failures_are_texts": _changed(("failures", ["broken"])),
    "failure_without_a_message": _changed(("failures", [{"part": None, "label": None, "kind": "no_solid"}])),
    "kept_is_a_text": _changed(("kept_of_missing_parts", "a note")),
    "kept_has_no_name": _changed(("kept_of_missing_parts", [{"notes": "a"}])),
}
