# SPDX-License-Identifier: LGPL-2.1-or-later
"""The risk of the automatic mesh: how probable it is that a mesh of a tenth of the diagonal goes wrong, and why.

The model is data, ``resources/mesh_risk.json``, learned from parts that were meshed and solved (benchmarks/mesh_risk.py).
"""

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from ..judging.probability import OFFSET, TERM, WeightedQuantity, logistic, weighted_quantity
from ..kinds.compound_kinds import ListOf, Record
from ..kinds.json_file import read_json
from ..kinds.value_kinds import Number, Text, Whole
from ..record.record_types import MeshRiskRecord
from ..tolerances import TOLERANCES

SHIPPED = Path(__file__).resolve().parents[3] / "resources" / "mesh_risk.json"

_MODEL = Record({
    "format": Text(), "version": Whole(), "about": Text(), "source": Text(), "date": Text(), "parts": Whole(0),
    "repositories": Whole(0), "trouble": Whole(0), "intercept": Number(),
    "terms": ListOf(Record({**TERM, "usual": Number()}, OFFSET), least=1, most=20),
}, {"left_out": Record({"auc": Number(0, 1), "calibration_error": Number(0, 1)})})

RAISES = 0.2
"""A term is a reason where it raises the logarithm of the odds by more than this over a part whose mesh is good: the odds
by a fifth."""


@dataclass(frozen=True)
class RiskTerm:
    """A term of the model.

    Attributes
    ----------
    quantity : WeightedQuantity
    usual : float
        Its weighted value in parts whose automatic mesh is good.
    """

    quantity: WeightedQuantity
    usual: float


@dataclass(frozen=True)
class MeshRisk:
    """A logistic regression on few quantities.

    Attributes
    ----------
    intercept : float
    terms : tuple of RiskTerm
    """

    intercept: float
    terms: tuple

    def judge(self, descriptors) -> MeshRiskRecord:
        """The risk of a part, and what raises it, the most first: MeshRiskRecord. It is None where a quantity is unknown.

        Parameters
        ----------
        descriptors : Descriptors
        """
        values = [term.quantity.value(descriptors, TOLERANCES.floor) for term in self.terms]
        if None in values:
            return {"risk": None, "reasons": []}
        raised = sorted(((value - term.usual, term.quantity.quantity) for value, term in zip(values, self.terms)),
                        key=lambda each: -each[0])
        return {
            "risk": round(logistic(self.intercept + math.fsum(values)), 4),
            "reasons": [{"quantity": quantity.symbol, "value": _rounded(quantity.evaluate(descriptors, TOLERANCES.floor)),
                         "raises": round(by, 3)} for by, quantity in raised if by > RAISES],
        }


def _rounded(value):
    return float(f"{value:.9g}")


def read_mesh_risk(path):
    """Read a model: MeshRisk; raises ValueError, a sentence that says what is wrong in the file."""
    content = read_json(path)
    fault = _MODEL.fault(content, "mesh_risk")
    if fault:
        raise ValueError(fault)
    return MeshRisk(float(content["intercept"]), tuple(
        RiskTerm(weighted_quantity(term, f"terms[{number}]"), float(term["usual"]))
        for number, term in enumerate(content["terms"])))


@cache
def shipped_mesh_risk():
    """The model that comes with ThinPart: MeshRisk."""
    return read_mesh_risk(SHIPPED)


def judged_risk(descriptors) -> MeshRiskRecord:
    """The risk of the automatic mesh of a part, for its record; see `MeshRisk.judge`."""
    return shipped_mesh_risk().judge(descriptors)
