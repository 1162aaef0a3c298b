# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walls of a part as they are shown: regions with what people say of them, thin faces by a limit."""

from ...core.record.region_groups import features_of, region_groups
from ...core.record.region_notes import notes_of_regions
from ...core.record.thin_faces import with_limit


def noted_sizes(record, notes):
    """Element sizes that people want on wall regions.

    Parameters
    ----------
    record : PartRecord
    notes : list of dict
        See ``region_notes`` of a part record.

    Returns
    -------
    dict of int to float or None
        mm by number of the listed region, from 0; None for one that is left out. Regions without a wish are not in it.

    Examples
    --------
    >>> wall = record["regions"]["listed"][0]
    >>> noted_sizes(record, [{"place": wall["place"], "faces": wall["faces"], "mesh_size_mm": 0.5}])
    {0: 0.5}
    """
    found = enumerate(notes_of_regions(record["regions"]["listed"], notes))
    return {number: None if note.get("excluded") else note["mesh_size_mm"] for number, note in found
            if note is not None and (note.get("excluded") or note.get("mesh_size_mm"))}


def grouped_walls(record, notes=None, features=()):
    """The wall regions of a part, equal ones together; those of which people say something else are apart.

    Parameters
    ----------
    record : PartRecord
    notes : list of dict, optional
        ``region_notes`` of the part; by default those in the record.
    features : list of str, optional
        The feature that made each face, by face number; empty where that is not known.

    Returns
    -------
    list of (RegionGroup, list of str)
        The thinnest first, each with the features that made it, the one with most of its area first.

    Examples
    --------
    >>> [group.count for group, _ in grouped_walls(record)]
    [1]
    """
    return [(group, features_of(group, record, features) if features else []) for group in region_groups(record, notes)]


def shown_record(record, thin_limit_mm, thin_shares):
    """A record as it is shown where the preferences have a thin limit of their own; it is never stored.

    The limit is in mm; by it, each face has one of the shares.

    Examples
    --------
    >>> shown_record(record, 9.0, [0.5] * 6)["thin_limit_mm"]
    9.0
    """
    return with_limit(record, thin_limit_mm, thin_shares)
