# SPDX-License-Identifier: LGPL-2.1-or-later
"""What both kinds of pages say about a part, in the language of the page."""

from ... import __version__
from .html_elements import element, own_file

TIMES = "\u00d7"


class PageWords:
    """Texts of a page.

    Parameters
    ----------
    language : PageLanguage
    titles : dict
        Titles of the categories by their names.
    """

    def __init__(self, language, titles):
        self.language, self.length = language, language.length
        self.text, self.sentence = language.text, language.sentence
        self.number, self.percent = language.number, language.percent
        self._titles = titles

    def head(self, title, *more):
        """The element ``head``."""
        # What marks a page as ThinPart's stands near its beginning: see `file_marks.PAGE`.
        return element(
            "head", element("meta", charset="utf-8"),
            element("meta", name="viewport", content="width=device-width, initial-scale=1"),
            element("meta", name="generator", content=f"ThinPart {__version__}"),
            *more, element("title", title), own_file("style"))

    def category(self, name):
        """A category as a headline."""
        _ = self.text
        known = {"thin": _("Thin part"), "thin_features": _("Part with thin features"), "normal": _("Normal part"),
                 "unknown": _("Unknown")}
        return known.get(name) or self.sentence(self._titles.get(name, name))

    def headline(self, name, between):
        """The verdict; where it is unsure, `named_between` has the two categories between which it is."""
        return self._unsure(between) if between else self.category(name)

    def headline_word(self, name, between):
        """The same within a table."""
        return self._unsure(between) if between else self.category_word(name)

    def _unsure(self, between):
        return self.text("Unsure: {category} or {other}", category=self.category_word(between[0]),
                         other=self.category_word(between[1]))

    def category_word(self, name):
        """A category within a table."""
        _ = self.text
        known = {"thin": _("thin"), "thin_features": _("thin features"), "normal": _("normal"), "unknown": _("unknown"),
                 "failed": _("failed")}
        return known.get(name) or self.sentence(self._titles.get(name, name))

    def criterion(self, row):
        """The name of a criterion; numbers, as the paper has them, stand beside it."""
        _ = self.text
        title, number = self.sentence(row["title"]), str(row["criterion"])
        return _("{title} (rule {number})", title=title, number=number) if number.isdecimal() else title

    def why(self, reason, deciding):
        """What decided."""
        _ = self.text
        if reason:
            return self.sentence(reason)
        if not deciding:
            return _("No criterion holds: its walls are thick all over.")
        return f"{_('Why:')} {', '.join(map(self.criterion, deciding))}."

    def how_sure(self, part, other, chances):
        """How near the verdict is to another one."""
        _ = self.text
        if part["margin"] is None:
            return _("How near it is to another category cannot be told.")
        if chances:
            own, others = self.percent(chances.own), self.percent(chances.others)
            likely = self.category(chances.other)
            if part["borderline"]:
                return _("Unsure: “{category}” ({probability}) or “{other}” ({others}).",
                         category=self.category(part["category"]), probability=own, other=likely, others=others)
            return _("Probability: {probability}, next “{other}” with {others}.", probability=own, other=likely,
                     others=others)
        margin = self.percent(part["margin"])
        if part["borderline"]:
            return _("Borderline: close to “{other}” ({margin} from the limit).", other=self.category(other), margin=margin)
        return _("Clear verdict: {margin} from the limit.", margin=margin)

    def place(self, kind):
        """What the thinnest wall is, as `thinnest_kind` has it."""
        _ = self.text
        return {"taper": _("in a taper"), "edge": _("beside a sharp edge")}.get(kind, "")

    def wall(self, kind):
        """A kind of wall."""
        _ = self.text
        return {"plate": _("plate"), "tube": _("tube"), "bar": _("bar"), "block": _("block"), "taper": _("taper"),
                "tooth": _("tooth"), "thread": _("thread"), "rib": _("rib")}.get(kind, kind)

    def holds(self, value):
        """Whether something holds: a mark and a word."""
        _ = self.text
        if value is None:
            return f"? {_('unknown')}"
        return f"\u2713 {_('yes')}" if value else f"\u2717 {_('no')}"

    def accuracy(self, name):
        """How finely a part was measured."""
        _ = self.text
        return {"verdict": _("for the verdict"), "standard": _("standard"), "fine": _("fine")}.get(name, name)

    def profile_title(self, profile):
        """The title of a profile, or its name where it has none."""
        return self.sentence(profile.get("title", profile["name"]))

    def box(self, sides):
        """The dimensions of a box."""
        return f" {TIMES} ".join(map(self.length.number, sides))
