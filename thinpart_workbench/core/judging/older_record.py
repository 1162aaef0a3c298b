# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of earlier versions, which lack what is measured since: whether they are enough to judge and to show."""

from ..categories import UNKNOWN
from ..descriptors.descriptor_table import QUANTITIES
from .classification import classify
from .criteria import profile_from

_KEYS = frozenset(quantity.record_key for quantity in QUANTITIES)
_NOTHING: frozenset = frozenset()


def lacking(record):
    """The keys of a record's ``descriptors`` from which quantities are read and which it lacks: frozenset of str."""
    keys = record["descriptors"].keys()
    return _NOTHING if _KEYS <= keys else _KEYS - keys


def is_to_be_measured(record, classification):
    """Whether the verdict on a record is ``unknown`` because an earlier version did not measure what decides: bool."""
    lacks = lacking(record)
    if not lacks or classification.category != UNKNOWN:
        return False
    undecided = [row for row in classification.checked if row.holds is None]
    # Those of the first category that is undecided make it so.
    return any(condition.holds is None and condition.condition.quantity.record_key in lacks
               for row in undecided if row.criterion.category == undecided[0].criterion.category
               for condition in row.conditions)


def is_enough(record, profile):
    """Whether a record has the thinnest wall of all, the form, and all that a profile judges by, or what it lacks cannot
    turn the verdict: bool.

    Parameters
    ----------
    record : PartRecord
    profile : dict
        Content of the profile.
    """
    if "thinnest" not in record or "form" not in record:  # it knew parallel walls only, or could not be compared
        return False
    lacks = lacking(record)
    if not lacks:
        return True
    judged_by = profile_from(profile)
    steps = () if judged_by.probability is None else judged_by.probability.steps
    named = {condition.quantity.record_key for criterion in judged_by.criteria for condition in criterion.conditions}
    named.update(term.quantity.record_key for step in steps for term in step.terms)
    if not named & lacks:
        return True
    # Imported here since it needs numpy, which files of this version do not.
    from ..record.part_record import descriptors_of

    classification = classify(descriptors_of(record), judged_by)
    if classification.category == UNKNOWN or not classification.is_certain:
        return False
    if judged_by.probability is not None and classification.probabilities is None:
        return False
    # What is computed from less than was measured later has an error, or it is not known how far it is off.
    return all(condition.value is None or condition.error is not None
               for row in classification.checked for condition in row.conditions
               if condition.condition.quantity.record_key in lacks)
