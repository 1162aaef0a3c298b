# SPDX-License-Identifier: LGPL-2.1-or-later
"""The probabilities that a profile states, fitted to labels by scikit-learn."""

from dataclasses import replace

import numpy as np

from ...core.errors import ThinPartError
from ...core.message import message

REGULARISATION = 1.0
"""scikit-learn's C: weights of standardised terms are pulled to 0 as by a normal distribution of variance 1."""


def check_scikit_learn():
    """Check before reading that probabilities can be fitted; raises ThinPartError of kind ``unsupported``."""
    try:
        _regression()
    except ImportError as error:
        raise ThinPartError(
            message("Learning needs the Python package scikit-learn ({problem}): install it (Debian: 'apt-get install "
                    "python3-sklearn', elsewhere: 'python -m pip install scikit-learn').", problem=error),
            "unsupported") from None


def _regression():
    # Imported here: only this command needs scikit-learn, which takes a second to import.
    from sklearn.linear_model import LogisticRegression

    return LogisticRegression


class ProbabilityFit:
    """Fits the weights of a model to labels.

    Parameters
    ----------
    model : ProbabilityModel
        Its terms are taken, and its weights where labels do not speak.
    descriptors : list of Descriptors, of length n
    truth : ndarray of shape (n, categories + 1)
        How far each category is right on each part, in the order of the model, normal last; rows sum to the part's
        weight.
    area_floor : float
    """

    def __init__(self, model, descriptors, truth, area_floor):
        self._model, self._truth = model, truth
        self._values = [
            np.array([[replace(term, weight=1.0).value(part, area_floor) for term in step.terms] for part in descriptors],
                     dtype=float).reshape(len(descriptors), len(step.terms)) for step in model.steps]

    def content(self, chosen):
        """Fit to some of the parts: dict, entry ``probability`` of a profile.

        Parameters
        ----------
        chosen : ndarray of bool, shape (n,)
        """
        steps = []
        for number, step in enumerate(self._model.steps):
            rows = chosen & np.isfinite(self._values[number]).all(axis=1) & self._truth[:, number:].any(axis=1)
            yes = self._truth[rows, number]
            no = self._truth[rows, number + 1:].sum(axis=1)
            intercept, weights = step.intercept, [term.weight for term in step.terms]
            if step.terms and yes.any() and no.any():
                intercept, weights = fitted_logistic(self._values[number][rows], yes, no)
            steps.append({"category": step.category, "intercept": _readable(intercept), "terms": [
                {"quantity": term.quantity.symbol, **({} if term.log_offset is None else {"log_offset": term.log_offset}),
                 "weight": _readable(weight)} for term, weight in zip(step.terms, weights)]})
        return {"unsure_under": self._model.unsure_under, "steps": steps}


def fitted_logistic(values, yes, no):
    """Intercept, float, and weights, list of float, of a logistic regression.

    Parameters
    ----------
    values : ndarray of shape (n, k)
    yes, no : ndarray of shape (n,)
        Weights of each row as an example for and against what is foretold.
    """
    centre, scale = values.mean(axis=0), values.std(axis=0)
    scale = np.where(scale > 1e-9, scale, 1.0)
    scaled = (values - centre) / scale
    examples = np.concatenate([scaled, scaled])
    answers, weights = np.repeat([1, 0], len(scaled)), np.concatenate([yes, no])
    model = _regression()(C=REGULARISATION, max_iter=1000).fit(examples, answers, weights)
    slopes = model.coef_[0] / scale
    return float(model.intercept_[0] - slopes @ centre), slopes.tolist()


def _readable(value):
    return float(f"{value:.3g}")
