# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the paper would say of a part, in one sentence, where the profile that judged it says something else."""

from ..categories import NORMAL, UNKNOWN
from ..descriptors.quantity import THICK_FROM, AreaShare, BoxFill
from ..figures import Length, Share
from ..message import Message, message
from .classification import classify
from .criteria import PAPER, load_profile

_WORDS = {
    "thin": message("thin"),
    "thin_features": message("thin features"),
    NORMAL: message("normal"),
}


def paper_sentence(record, profile):
    """The verdict by the criteria of Giannini, Petton, Pernot (TMCE 2012), tables 1 and 2, and the figure that decides it.

    Returns a Message; an empty str where the verdict is the same, and where the profile is the paper's own.

    Parameters
    ----------
    record : PartRecord
        Judged again from its descriptors.
    profile : Profile
        That the record was judged by.
    """
    if profile.name == PAPER or record["paper"]["category"] == record["category"]:
        return ""
    from ..record.part_record import descriptors_of  # imports numpy, which most commands need for no other reason

    descriptors = descriptors_of(record)
    verdict = classify(descriptors, load_profile(PAPER))
    if verdict.category == record["category"]:
        return ""
    if verdict.category == UNKNOWN:
        return message("By the paper's criteria: unknown. {reason}", reason=verdict.reason)
    category = _WORDS[verdict.category]
    deciding = [row for row in verdict.checked if row.holds and row.criterion.category == verdict.category]
    if not deciding:
        return message("By the paper's criteria: {category} (no criterion holds).", category=category)
    first, *others = deciding
    number, figures = first.criterion.id, _figures(first, descriptors)
    if not others:
        return message("By the paper's criteria: {category} (criterion {number}: {figures}).",
                       category=category, number=number, figures=figures)
    return message("By the paper's criteria: {category} (criterion {number}: {figures}; also {others}).",
                   category=category, number=number, figures=figures,
                   others=", ".join(str(row.criterion.id) for row in others))


def _figures(checked, descriptors) -> Message:
    """What a criterion found, with the figure of the condition that says most about walls."""
    rows = checked.conditions
    diagonal = descriptors.box.diagonal
    for row in rows:
        quantity = row.condition.quantity
        if quantity.is_wall_distance:
            low, high = quantity.bounds
            return message("walls at {low:g} to {high:g} degrees as near as {nearest}",
                           low=low, high=high, nearest=Length(row.value * diagonal))
    thin = [row for row in rows if isinstance(row.condition.quantity, AreaShare)
            and row.condition.quantity.bounds[1] < THICK_FROM]
    if thin:
        return _of_walls(thin[0], diagonal)
    if len(rows) == 1 and isinstance(rows[0].condition.quantity, BoxFill):
        return message("it fills {share} of its box", share=Share(rows[0].value))
    long, middle, short = (Length(float(side)) for side in descriptors.box.dimensions)
    return message("its box is flat, {long} by {middle} by {short}", long=long, middle=middle, short=short)


def _of_walls(row, diagonal):
    low, high = row.condition.quantity.bounds
    share, most = Share(row.value), Length(high * diagonal)
    if low == 0.0:
        return message("{share} of the surface over walls thinner than {most}", share=share, most=most)
    return message("{share} of the surface over walls of {least} to {most}, beside a thick body",
                   share=share, least=Length(low * diagonal), most=most)
