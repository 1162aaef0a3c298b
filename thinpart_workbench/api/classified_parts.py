# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a classification: parts with their records, and failures."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Optional

from ..core.errors import KINDS, ThinPartError
from ..core.judging.wall_check import check_walls
from ..core.judging.wall_limits import chosen_limits
from ..core.record.record_types import FailureRecord, PartRecord
from ..core.record.verdict_chances import named_between
from ..storage.user_limits import known_limits
from ..workflow.workers.reported_failure import reported_failure

if TYPE_CHECKING:
    from ..core.thickness.measurement import Measurement


@dataclass(frozen=True)
class ClassifiedPart:
    """A part with its category and all its measurements.

    Attributes
    ----------
    record : PartRecord
        The record as stored in info files; see docs/info-file.md.
    file : str or None
        The file that the part was read from.
    measurement : Measurement or None
        Includes the thickness under every sample; None if another process measured the part.
    """

    record: PartRecord
    file: Optional[str] = None
    measurement: Optional["Measurement"] = field(default=None, repr=False, compare=False)

    def __repr__(self):
        return f"<ClassifiedPart {self.label!r}: {self.category}>"

    @property
    def name(self):
        """str: unique name within the document."""
        return self.record["name"]

    @property
    def label(self):
        """str: the label that people see."""
        return self.record["label"]

    @property
    def instances(self):
        """int: number of occurrences of the part."""
        return self.record["instances"]

    @property
    def category(self):
        """str: ``thin``, ``thin_features`` or another one of the profile, ``normal`` or ``unknown``."""
        return self.record["category"]

    @property
    def criteria(self):
        """tuple of int or str: ids of the criteria that hold."""
        return tuple(self.record["criteria"])

    @property
    def evidence(self):
        """list of EvidenceRow: each criterion with its quantities."""
        return self.record["evidence"]

    @property
    def borderline(self):
        """Whether the part is near another category."""
        return self.record["borderline"]

    @property
    def between(self):
        """tuple of str: the two categories that an unsure verdict leaves open, the likelier first; else empty."""
        return named_between(self.record)

    @property
    def margin(self):
        """float or None: distance from another category, relative to the thresholds."""
        return self.record["margin"]

    @property
    def reason(self):
        """str: why the category is ``unknown``; empty otherwise."""
        return self.record["reason"]

    @property
    def warnings(self):
        """list of str: one sentence per warning."""
        return self.record["warnings"]

    @property
    def thinnest_mm(self):
        """float or None: the least distance between parallel walls."""
        return self.record["descriptors"]["thickness_mm"]["min"]

    @property
    def error_mm(self):
        """float: error bound of a thickness."""
        return self.record["descriptors"]["thickness_mm"]["error_bound"]

    @property
    def box_mm(self):
        """tuple of float: sides of the bounding box, longest first."""
        return tuple(self.record["descriptors"]["box_mm"])

    @property
    def volume_mm3(self):
        """float or None: None if the surface is not watertight."""
        return self.record["descriptors"]["volume_mm3"]

    @property
    def area_mm2(self):
        """float: area of the surface."""
        return self.record["descriptors"]["area_mm2"]

    @property
    def faces(self):
        """list of FaceRecord: the walls under each face."""
        return self.record["faces"]

    @property
    def regions(self):
        """list of RegionRecord: connected walls of like thickness, the thinnest first."""
        return self.record.get("regions", {}).get("listed", [])

    def faces_thinner_than(self, millimetres):
        """Faces with a parallel wall under a thickness: list of FaceRecord."""
        return [face for face in self.faces if face["min"] is not None and face["min"] < millimetres]

    def check(self, process, limits=None):
        """Check the walls against the limits of a process.

        Parameters
        ----------
        process : str
            ``FDM``, or with a material ``die_casting:zinc``; docs/limits.md lists them.
        limits : str or Path, optional
            A file with limits of your own; by default the user's own, if there are some, beside the shipped ones.

        Returns
        -------
        WallCheck
            Its ``holds`` is whether the part passes, None where that cannot be told.

        Raises
        ------
        ThinPartError
            kind ``usage`` if there is no such process, or the file cannot be used.
        """
        chosen, = chosen_limits(known_limits(limits), [process.strip() or "?"])
        return check_walls(self.record, chosen)

    def value(self, quantity):
        """Value of a quantity such as ``V/VBB``, ``d2_d3`` or ``F[0;0.25]``; docs/info-file.md lists all quantities.

        Returns
        -------
        float or None
            None if it could not be measured.

        Raises
        ------
        ThinPartError
            kind ``usage`` if there is no such quantity.
        """
        return self._descriptors.named_value(quantity)

    @cached_property
    def _descriptors(self):
        from ..core.record.part_record import descriptors_of

        return descriptors_of(self.record)


@dataclass(frozen=True)
class PartFailure:
    """A part, or a whole file, that could not be classified.

    Attributes
    ----------
    kind : str
        A key of `thinpart_workbench.core.errors.KINDS`.
    message : str
        One sentence.
    part, label : str or None
        Name and label of the part; None if the whole file failed.
    file : str or None
    """

    kind: str
    message: str
    part: Optional[str] = None
    label: Optional[str] = None
    file: Optional[str] = None

    @classmethod
    def of(cls, failure: FailureRecord, file=None):
        """Make a failure from a failure record."""
        return cls(failure["kind"], failure["message"], failure.get("part"), failure.get("label"), file)

    @classmethod
    def of_exception(cls, error, part=None, label=None, file=None):
        """Make a failure from an exception; the traceback of one that nobody foresaw goes to standard error."""
        reported = reported_failure(error, label)
        return cls(reported["kind"], reported["message"], part, label, file)

    def error(self):
        """The failure as a ThinPartError that can be raised."""
        return ThinPartError(self.message, self.kind if self.kind in KINDS else "failed")


@dataclass(frozen=True)
class ClassifiedParts(Sequence):
    """The parts of one file, document or shape: a sequence of `ClassifiedPart`.

    Attributes
    ----------
    parts : tuple of ClassifiedPart
    failures : tuple of PartFailure
        Further parts that could not be classified.
    file : str or None
    reused : bool
        Whether the result was taken from the info file, because nothing has changed.
    seconds : float or None
        Time that the classification took.
    """

    parts: tuple[ClassifiedPart, ...]
    failures: tuple[PartFailure, ...] = ()
    file: Optional[str] = None
    reused: bool = False
    seconds: Optional[float] = None

    @classmethod
    def of_outcome(cls, outcome):
        """The parts of a file.

        Parameters
        ----------
        outcome : dict
            From `worker_pool.analyse_files`.
        """
        file = outcome["file"]
        failures = [outcome["error"]] if "error" in outcome else outcome["failures"]
        return cls(tuple(ClassifiedPart(record, file) for record in outcome.get("parts", ())),
                   tuple(PartFailure.of(failure, file) for failure in failures),
                   file, bool(outcome.get("reused")), outcome.get("seconds"))

    def __len__(self):
        return len(self.parts)

    def __getitem__(self, index):
        return self.parts[index]
