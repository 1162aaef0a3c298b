# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles to choose from, the one that the preferences name, and what people call their criteria."""

import os
from typing import NamedTuple

from ...core.errors import ThinPartError
from ...core.judging.criteria import PAPER, PROFILES, load_profile, profile_from
from ...core.judging.impossible_conditions import impossible_conditions
from ...freecad_adapter.preferences import preference
from ...storage.user_profiles import user_profiles


class ProfileChoice(NamedTuple):
    """A profile in a list: ``name`` of a shipped one, or path of a file, and its ``title``."""

    name: str
    title: str


def profile_choices():
    """The shipped profiles and the user's own: list of ProfileChoice.

    Examples
    --------
    >>> [choice.name for choice in profile_choices()][:2]
    ['calibrated', 'paper']
    """
    return [profile_choice(name) for name in (*sorted(path.stem for path in PROFILES.glob("*.json")),
                                              *map(str, user_profiles()))]


def profile_choice(name):
    """A profile as it stands in a list: ProfileChoice; of one that cannot be read, the title is the name of its file.

    Examples
    --------
    >>> profile_choice("/parts/own.json").title
    'own.json'
    """
    try:
        return ProfileChoice(name, load_profile(name).title)
    except ThinPartError:
        return ProfileChoice(name, os.path.basename(name))  # the error is reported when the profile is used


def shipped_file(name):
    """Path of the file of a shipped profile: str; empty where a name is none of those.

    Examples
    --------
    >>> os.path.basename(shipped_file("paper")), shipped_file("/parts/own.json")
    ('paper.json', '')
    """
    file = PROFILES / f"{name}.json"
    return str(file) if file.is_file() else ""


def preferred_profile():
    """The profile that the preferences name: Profile. Raises a ThinPartError, kind ``profile``, if it cannot be used.

    Examples
    --------
    >>> preferred_profile().name
    'calibrated'
    """
    return load_profile(preference("Profile"))


def profile_for_titles():
    """`preferred_profile`, or the default one where that cannot be used: for the titles of verdicts that are there.

    Examples
    --------
    >>> [category.name for category in profile_for_titles().categories]
    ['thin', 'thin_features']
    """
    try:
        return preferred_profile()
    except ThinPartError:
        return load_profile()  # the error is reported when the profile is used


def known_criteria(profile):
    """Titles of criteria by their ids as texts: those of a profile, and of the ones that come with ThinPart.

    Results that were judged by another profile name its criteria.

    Examples
    --------
    >>> sorted(known_criteria(preferred_profile()))[:2]
    ['1', '2']
    """
    return {str(criterion.id): criterion.title
            for known in (load_profile(PAPER), load_profile(), profile) for criterion in known.criteria}


def never_met(content):
    """Conditions of a profile that no part can meet together.

    Parameters
    ----------
    content : dict
        Of the profile.

    Returns
    -------
    dict of (int, int, int) to Message
        What is wrong, by the numbers of category, criterion and condition, from 0.

    Raises
    ------
    ThinPartError
        kind ``profile`` if it is not well formed.

    Examples
    --------
    >>> never_met(profile)
    {}
    """
    return {(each.category, each.criterion, each.condition): each.problem
            for each in impossible_conditions(profile_from(content))}
