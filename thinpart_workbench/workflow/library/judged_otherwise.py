# SPDX-License-Identifier: LGPL-2.1-or-later
"""Info files that a shipped profile has judged by other thresholds than it has in this version."""

from typing import TypedDict

from ...core.judging.criteria import shipped_versions


class JudgedOtherwise(TypedDict):
    """Name of a shipped profile, its `profile_version` of today, and the number of info files that another has judged."""

    profile: str
    version: str
    files: int


def judged_otherwise(index) -> list[JudgedOtherwise]:
    """What other versions of the shipped profiles have judged in the library of a LibraryIndex, most info files first."""
    today = shipped_versions()
    files: dict[str, int] = {}
    counts = index.query("SELECT profile, profile_version, count(*) FROM files GROUP BY profile, profile_version")
    for profile, version, count in counts:
        if profile in today and version != today[profile]:
            files[profile] = files.get(profile, 0) + count
    return [{"profile": profile, "version": today[profile], "files": count}
            for profile, count in sorted(files.items(), key=lambda item: (-item[1], item[0]))]
