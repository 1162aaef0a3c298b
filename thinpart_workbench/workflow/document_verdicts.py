"""The verdicts on the parts of a document in short, and what differs between two of them."""


def document_verdicts(records, profile):
    """What a window shows of part records, small enough to be handed to it.

    Parameters
    ----------
    records : list of dict
        Part records.
    profile : dict
        Content of the profile by which they were judged.

    Returns
    -------
    dict
        By the part's name: ``label``, ``category`` and its ``title``, ``reason``, ``evidence`` without
        the conditions, ``thickness`` (of the thinnest wall, mm, or None) and its ``error_bound``.
    """
    titles = {each["name"]: each.get("title", each["name"]) for each in profile["categories"]}
    return {record["name"]: _verdict(record, titles) for record in records}


def _verdict(record, titles):
    walls = record["descriptors"]["thickness_mm"]
    return {
        "label": record["label"],
        "category": record["category"],
        "title": titles.get(record["category"], record["category"]),
        "reason": record["reason"],
        "evidence": [{key: row[key] for key in ("criterion", "category", "title", "holds")}
                     for row in record["evidence"]],
        "thickness": walls["min"],
        "error_bound": walls["error_bound"],
    }


def category_changes(before, now):
    """Parts that have another category than before.

    Parameters
    ----------
    before : dict or None
        From `document_verdicts`; None for a document that was not classified before.
    now : dict

    Returns
    -------
    list of tuple
        The old and the new verdict on a part.
    """
    pairs = [((before or {}).get(name), verdict) for name, verdict in now.items()]
    return [(old, new) for old, new in pairs
            if old is not None and old["category"] != new["category"]]


def walls_newly_under(before, now, limit):
    """Parts whose thinnest wall has come under a limit.

    Parameters
    ----------
    before, now
        As for `category_changes`. A part that was not there before counts when it is under the limit.
    limit : float, mm

    Returns
    -------
    list of dict
        The verdicts on them.
    """
    return [new for name, new in now.items()
            if _is_under(new, limit) and not _is_under((before or {}).get(name), limit)]


def _is_under(verdict, limit):
    # A wall that is drawn with just this thickness must not be under it by the error of measuring.
    return (verdict is not None and verdict["thickness"] is not None
            and verdict["thickness"] + verdict["error_bound"] < limit)
