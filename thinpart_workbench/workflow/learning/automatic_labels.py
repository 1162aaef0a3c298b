# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels without a person: what a program has trouble with is thin, where walls are thin against its elements."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import asdict, dataclass

from ...core.descriptors.descriptor_table import Descriptors
from ...core.message import message
from ...storage.labels_file import Label

LOCAL = 0.05
"""Share of the surface that counts: strays on 2 % are there in plain blocks too."""

SPREAD = 0.5
"""Share of the surface from which trouble is spread over the part."""

THIN, THIN_FEATURES = "thin", "thin_features"


@dataclass(frozen=True)
class AutomaticLabel:
    """What a program made of a part, and what that says of it.

    Attributes
    ----------
    file, part : str
        Path of the document below the library; name of the part.
    has_trouble : bool
    category : str
    second : str
        A second answer that is right too; empty where there is none.
    is_sure : bool
    figures : Mapping
        JSON values by name, and as ``reason`` why they are not known; it is empty where they are.
    descriptors : Descriptors
    """

    file: str
    part: str
    has_trouble: bool
    category: str
    second: str
    is_sure: bool
    figures: Mapping
    descriptors: Descriptors

    def label(self, person):
        """The `Label` of the part."""
        return Label(message("{file}, part {part}", file=self.file, part=self.part), self.file, self.part, self.category,
                     self.second, self.is_sure, person, None)

    def row(self):
        """All as JSON values."""
        return {"file": self.file, "part": self.part, "category": self.category, "sure": self.is_sure,
                "trouble": self.has_trouble, **self.figures}


class Labelling(ABC):
    """A way of labelling parts by a program. Workers are given it, so it can be pickled."""

    cache = ""
    """Name of the folder within the cache."""

    kinds: Mapping = {}
    """What is measured of a part: kinds by name, with ``reason``."""

    columns: tuple = ()
    """Names of the figures of a label."""

    @property
    @abstractmethod
    def person(self):
        """str: the programs and their versions."""

    @property
    @abstractmethod
    def part_seconds(self):
        """float: that a part may take by the clock."""

    @abstractmethod
    def settings(self):
        """dict of JSON values: what the labels depend on."""

    @abstractmethod
    def key(self):
        """list of JSON values: what the figures depend on."""

    @abstractmethod
    def measured(self, shape, diagonal, folder):
        """What `kinds` describes, dict. Runs in a worker.

        Parameters
        ----------
        shape : str
            BREP file of the part, in `folder`.
        diagonal : float, mm
            Of its box.
        folder : str
            Working directory, temporary.
        """

    @abstractmethod
    def labelled(self, file, part, measured, descriptors):
        """The AutomaticLabel of a part; raises ThinPartError where there is none."""


@dataclass(frozen=True)
class AutomaticLabels:
    """What a program made of the parts of a library, and which quantities foretell trouble.

    Attributes
    ----------
    labelling : Labelling
    results : tuple of AutomaticLabel
    failures : tuple of dict
        ``file``, ``part`` and ``message`` of what has no label.
    quantities : tuple of Foretelling
        The best first; empty where all parts have trouble, or none.
    seconds : float
    """

    labelling: Labelling
    results: tuple
    failures: tuple
    quantities: tuple
    seconds: float

    def as_dict(self):
        """All as JSON values."""
        return {**self.labelling.settings(), "seconds": self.seconds, "parts": [result.row() for result in self.results],
                "failures": list(self.failures), "quantities": [asdict(each) for each in self.quantities]}

    @property
    def labels(self):
        """list of Label"""
        return [result.label(self.labelling.person) for result in self.results]
