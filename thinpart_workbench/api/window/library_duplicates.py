# SPDX-License-Identifier: LGPL-2.1-or-later
"""What libraries have more than once, and their families, as rows of a table."""

from ...core.analysis_limits import Limits
from ...core.reuse.likeness import ALIKE
from ...core.run_control import seldom
from ...workflow.reuse.evidence import GEOMETRY
from ...workflow.reuse.kept_part import why_kept
from ..found_parts import stored_row
from ..libraries import duplicates, families


def duplicate_rows(roots, reads_documents=True, jobs=0, seconds=Limits.seconds, megabytes=Limits.megabytes, control=None,
                   report=None):
    """Find what libraries have more than once.

    Parameters
    ----------
    roots : list of str
        Folders of the libraries.
    reads_documents, control, report
        See `duplicates`.
    jobs : int, optional
        Number of worker processes; 0 for one per processor.
    seconds : float, optional
    megabytes : int, optional

    Returns
    -------
    dict
        ``rows``: of each part of each group a `stored_row` with ``group``, its number; ``kind``, one of `likeness.KINDS`;
        ``is_kept``, whether it is the one to keep, and then ``says``, why; otherwise the evidence: ``says``,
        ``greatest_mm``, ``same_share``, ``scale`` and ``mirrored``, see docs/reuse.md, and ``kept``, file, info file and
        name of the one to keep. ``compared`` and ``without_form`` as of `DuplicateGroups`; ``problems``, list of str.

    Raises
    ------
    ThinPartError
        kind ``missing`` if none of the folders exists.

    Examples
    --------
    >>> duplicate_rows([samples], reads_documents=False)["compared"]
    2
    """
    found = duplicates(roots, reads_documents=reads_documents, jobs=jobs or None, timeout=seconds, memory=megabytes,
                       control=control, report=seldom(report))
    rows = []
    for number, group in enumerate(found, 1):
        first = group.parts[0].stored
        common = {"group": number, "kind": group.kind}
        rows.append({**stored_row(first), **common, "is_kept": True, "kept": None, "scale": 1.0, "mirrored": False,
                     "says": why_kept([part.stored for part in group.parts]), "greatest_mm": None, "same_share": None})
        kept = {"file": first.file, "info_file": first.info_file, "name": first.name}
        rows += [{**stored_row(part.stored), **common, "is_kept": False, "kept": kept,
                  **{key: part.evidence[key] for key in ("says", "same_share", "scale", "mirrored")},
                  "greatest_mm": _greatest(part)} for part in group.parts[1:]]
    problems = [problem.message for problem in found.problems] + [each["error"]["message"] for each in found.failures]
    return {"rows": rows, "compared": found.compared, "without_form": found.without_form, "problems": problems}


def family_rows(roots):
    """Find the families of libraries.

    Returns
    -------
    dict
        ``rows``: of each part of each family a `stored_row` with ``group``, its number, and ``dimensions``, mm, those that
        vary, by name. ``problems``, list of str.

    Raises
    ------
    ThinPartError
        kind ``missing`` if none of the folders exists.

    Examples
    --------
    >>> family_rows([samples])["rows"]
    []
    """
    found = families(roots)
    rows = [{**stored_row(part), "group": number,
             "dimensions": {name: values[place] for name, values in family.varies.items()}}
            for number, family in enumerate(found, 1) for place, part in enumerate(family.parts)]
    return {"rows": rows, "problems": [problem.message for problem in found.problems]}


def _greatest(part):
    """How far the surfaces are apart; None where only points of outlines are known, of which some have nothing near by."""
    is_known = part.kind != ALIKE or part.evidence["compared"] == GEOMETRY
    return part.evidence["greatest_mm"] if is_known else None
