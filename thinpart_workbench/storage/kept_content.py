"""What people keep with a part in its info file: the methods that proved right for it."""

KEPT = ("notes", "mesh", "link")
"""Keys of a part record that people set: a text; mesh settings or the name of a file with them; a link."""

ORPHANS = "kept_of_missing_parts"
"""Key of an info file: what was kept with parts that the document no longer has."""


def is_kept(part):
    """Whether anything is kept with a part."""
    return any(part.get(key) for key in KEPT)


def set_kept(part, **values):
    """Set or, with an empty value, remove what is kept with a part.

    Parameters
    ----------
    part : dict
        Part record; changed.
    values
        By key of `KEPT`; None leaves as it is.

    Returns
    -------
    bool
        Whether something changed.
    """
    before = {key: part.get(key) for key in KEPT}
    for key, value in values.items():
        if key not in KEPT:
            raise KeyError(key)
        if value is None:
            continue
        if value:
            part[key] = value
        elif key == "notes":
            part[key] = ""
        else:
            part.pop(key, None)
    return before != {key: part.get(key) for key in KEPT}


def carry_kept(content, old):
    """Carry what was kept over to a new analysis of the same document.

    Parameters
    ----------
    content : dict
        New content of the info file; changed.
    old : dict
        Its content so far.

    Notes
    -----
    What belonged to a part that is gone stays in the file, and is given back when a part of that name
    is there again.
    """
    kept = {each["name"]: each for each in (*old.get(ORPHANS, ()), *old["parts"]) if is_kept(each)}
    for part in content["parts"]:
        mine = kept.pop(part["name"], None)
        if mine is not None and not is_kept(part):
            set_kept(part, **{key: mine.get(key) for key in KEPT})
    orphans = [{key: each[key] for key in ("name", "label", *KEPT) if each.get(key)}
               for each in kept.values()]
    if orphans:
        content[ORPHANS] = orphans
