# SPDX-License-Identifier: LGPL-2.1-or-later
"""What editing does to a profile besides what the user has changed: probabilities, name, title and source."""

from ...core.kinds.file_marks import PROFILE
from ...core.message import message


def judging_part(content):
    """What of a profile's content verdicts depend on: categories, conditions and area floor, without names for people."""
    categories = [
        (category["name"], [
            (criterion["id"], [(each["quantity"], each["comparison"], each["value"]) for each in criterion["conditions"]])
            for criterion in category["criteria"]])
        for category in content["categories"]]
    return categories, content.get("area_floor", 1e-4)


def loses_probabilities(content, start):
    """Whether a profile had probabilities at the start of editing that do not belong to its thresholds any more.

    They state how often people agreed with a verdict by the thresholds that they were fitted with.

    Parameters
    ----------
    content, start : dict
        Of the profile now, and when it was opened.
    """
    return "probability" in start and judging_part(content) != judging_part(start)


def named_content(content, start, name):
    """The content under another name, dict.

    A title that is still that of the start becomes the name, and where thresholds were changed, a source that is still that
    of the start says so.
    """
    content = {**content, "name": name}
    if name != start.get("name") and content.get("title") == start.get("title"):
        content["title"] = name
    if judging_part(content) != judging_part(start) and content.get("source") == start.get("source"):
        before = start.get("title") or start.get("name", "")
        content["source"] = message("Changed by hand from: {title}. {source}", title=before, source=start.get("source", ""))
    return content


def new_criterion(content):
    """A criterion to begin with, with an id that the profile does not use: dict."""
    taken = {str(each["id"]) for category in content["categories"] for each in category["criteria"]}
    return {"id": free_name("own_{}", taken), "title": "", "conditions": [new_condition()]}


def new_condition():
    """A condition to begin with: dict."""
    return {"quantity": "K[0;0.1]", "comparison": ">", "value": 0.5}


def new_category(content):
    """A category to begin with, with a name that the profile does not use: dict."""
    name = free_name("category_{}", {category["name"] for category in content["categories"]})
    return {"name": name, "title": "", "meaning": "", "criteria": [new_criterion(content)]}


def empty_profile():
    """The content of a profile without categories: dict."""
    return {"format": PROFILE.format, "version": 1, "name": "", "categories": []}


def free_name(pattern, taken):
    """The pattern with the least number, from 1, that makes a name which is not taken: str."""
    number = 1
    while pattern.format(number) in taken:
        number += 1
    return pattern.format(number)
